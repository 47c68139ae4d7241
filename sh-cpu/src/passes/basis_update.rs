//! The `basis_update` pass: what bodies send on, told in few functions (Iwasaki et al. 2007, sections 5.2 and 5.3).
//!
//! What falls on a body's points, of light, of what other bodies and what it itself has sent, gives the weights of its
//! functions; these tell what each patch sends on. Of a region it is an SH vector, by direction:
//!
//! ```text
//! I(ω) = Σ over patches of L lobe(ω)        lobe = A ∫ V cos θ y over directions, in the mean of its samples
//! ```

use crate::device::patch_lights::{Lit, PatchLights};
use crate::device::spherical_lights::Points;
use crate::error::Error;
use rayon::prelude::*;
use sh_core::{ORDERS, OrderError};
use sh_scene::basis::REGION_PATCHES;
use sh_scene::{BasisBody, IrradianceBasis};

/// Forgets what bodies have sent.
pub(crate) fn dark<'a>(bodies: impl Iterator<Item = BasisBody<'a>>, lights: &mut PatchLights) {
    lights.bodies.clear();
    lights.bodies.extend(bodies.map(|_| Lit::default()));
}

/// Finds what all bodies send on in this SH order of the light on their points.
///
/// # Errors
/// Where there is no such order, or there are not as many points as the bodies have.
pub(crate) fn basis_update<'a>(
    points: &Points,
    bodies: impl Iterator<Item = BasisBody<'a>>,
    order: usize,
    lights: &mut PatchLights,
) -> Result<(), Error> {
    if !ORDERS.contains(&order) {
        return Err(OrderError(order).into());
    }
    let bases: Vec<&IrradianceBasis> = bodies.map(|body| body.basis).collect();
    let all: usize = bases.iter().map(|basis| basis.patches()).sum();
    let few: usize = bases.iter().map(|basis| basis.few()).sum();
    for (expected, found) in [(all, points.radiance.len()), (few, points.sent.len())] {
        if found != expected || bases.len() != lights.bodies.len() {
            return Err(Error::Length {
                buffer: "light of patches",
                expected,
                found,
            });
        }
    }
    lights.coefficients = order * order;
    let coefficients = lights.coefficients;
    // Of all bodies the few come first.
    let starts = bases.iter().scan([0, few], |next, basis| {
        let starts = *next;
        *next = [
            starts[0] + basis.few(),
            starts[1] + basis.patches() - basis.few(),
        ];
        Some(starts)
    });
    let starts: Vec<[usize; 2]> = starts.collect();
    let each = lights
        .bodies
        .par_iter_mut()
        .zip(bases.into_par_iter().zip(starts));
    each.for_each(|(lit, (basis, [first, rest]))| {
        let few = first..first + basis.few();
        let rest = rest..rest + basis.patches() - basis.few();
        let light = [&points.radiance[few.clone()], &points.radiance[rest]];
        lit.update(basis, &light.concat(), &points.sent[few], coefficients);
    });
    let radiance = lights.bodies.iter().flat_map(|lit| &lit.radiance);
    lights.brightest = radiance.fold([0.0; 3], |most, of| {
        std::array::from_fn(|c| of[c].max(most[c]))
    });
    Ok(())
}

impl Lit {
    /// Of light on all points, in their order, and of what bodies have sent on the few.
    fn update(
        &mut self,
        basis: &IrradianceBasis,
        light: &[[f32; 3]],
        sent: &[[f32; 3]],
        coefficients: usize,
    ) {
        let mut all = std::mem::take(&mut self.own);
        all.resize(basis.patches(), [0.0; 3]);
        for (light, patch) in light.iter().zip(basis.order()) {
            all[*patch] = sum((light, &all[*patch]));
        }
        let told = basis.weights(&all);
        let others = basis.weights_of_few(sent);
        self.weights = told.iter().zip(&others).map(sum).collect();
        self.own = basis.bounced(&self.weights);
        self.radiance = basis.sent(&self.weights);
        let regions = basis.shape().regions.len();
        self.emission.clear();
        self.emission.resize(regions * coefficients, [0.0; 3]);
        for (m, (radiance, lobe)) in self.radiance.iter().zip(basis.lobes()).enumerate() {
            let region = &mut self.emission[m / REGION_PATCHES * coefficients..][..coefficients];
            for (sum, y) in region.iter_mut().zip(lobe) {
                for (sum, radiance) in sum.iter_mut().zip(radiance) {
                    *sum += radiance * y;
                }
            }
        }
    }
}

fn sum((a, b): (&[f32; 3], &[f32; 3])) -> [f32; 3] {
    std::array::from_fn(|c| a[c] + b[c])
}
