//! The irradiance pass: light that nothing blocks.

use crate::device::accumulate::Point;
use crate::device::check::check_light;
use crate::device::drive::{Kernel, Place, Work, drive};
use crate::device::lamps::with_emitters;
use crate::device::light::unblocked;
use crate::device::outline::{Outline, OutlineAll};
use crate::error::Error;
use crate::lanes::group::Group;
use crate::lanes::path::Path;
use sh_core::{Lane, Routines};
use sh_scene::{Light, Receiver};

/// Writes the radiance that albedo 1 reflects at every receiver under `light` alone: for each channel
/// max(0, L · H(N)), with the cosine lobe H of Ramamoorthi and Hanrahan 2001 and its 1/π, for the environment and each
/// analytic light. Receivers that are not covered get 0.
///
/// ```
/// use sh_scene::{Light, Receiver};
/// // A sky of radiance 1 from everywhere: only the constant coefficient, √(4π).
/// let mut light = Light { order: 2, coefficients: vec![[0.0; 3]; 4], emitters: vec![] };
/// light.coefficients[0] = [12.566_371_f32.sqrt(); 3];
/// let receiver = Receiver { position: [0.0; 3], covered: 1, normal: [0.0, 1.0, 0.0], object: 0 };
/// let mut radiance = [[0.0; 3]];
/// sh_cpu::irradiance(&[receiver], &light, &mut radiance)?;
/// assert!((radiance[0][0] - 1.0).abs() < 1e-6);
/// # Ok::<(), sh_cpu::Error>(())
/// ```
pub fn irradiance(
    receivers: &[Receiver],
    light: &Light,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    irradiance_on(Path::best(), receivers, light, radiance)
}

/// Writes the mean of what receivers see of the light in the lobe in which they mirror it towards `eye`. Receivers without a
/// roughness ([`Receiver::roughness`]) get 0.
pub(crate) fn mirrored(
    receivers: &[Receiver],
    light: &Light,
    eye: [f32; 3],
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    seen(Path::best(), receivers, light, radiance, Some(eye))
}

/// [`irradiance`] on a vector path of the caller's choice.
pub fn irradiance_on(
    path: Path,
    receivers: &[Receiver],
    light: &Light,
    radiance: &mut [[f32; 3]],
) -> Result<(), Error> {
    seen(path, receivers, light, radiance, None)
}

fn seen(
    path: Path,
    receivers: &[Receiver],
    light: &Light,
    radiance: &mut [[f32; 3]],
    eye: Option<[f32; 3]>,
) -> Result<(), Error> {
    check_light(light)?;
    let all = 0..receivers.len();
    let work = Work {
        path,
        receivers,
        clusters: std::slice::from_ref(&all),
        radiance,
        eye,
    };
    drive(work, light.order, &Unblocked { light })
}

struct Unblocked<'a> {
    light: &'a Light,
}

impl Kernel for Unblocked<'_> {
    type Room<L: Lane> = ();

    #[inline(always)]
    fn room<L: Lane>(_: L) {}

    #[inline(always)]
    fn shade<L: Group + OutlineAll + Outline<C>, const C: usize>(
        &self,
        _: &Place<L>,
        point: &Point<L>,
        (): &mut (),
    ) -> [L; 3]
    where
        [L; C]: Routines<L>,
    {
        let lobe = <[L; C]>::cosine(point.normal);
        let environment = match &point.gloss {
            None => unblocked(&lobe, &self.light.coefficients),
            Some(gloss) => unblocked(&gloss.lobe::<C>(), &self.light.coefficients),
        };
        with_emitters(environment, &lobe, &lobe, point, (self.light, 0))
    }
}
