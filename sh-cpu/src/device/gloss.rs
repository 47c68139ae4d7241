//! Polished receivers: the lobe in which they mirror light towards the eye.
//!
//! With the normal n, the direction v to the eye, a light in the direction l and h half way between these, a surface of GGX
//! roughness α mirrors of its radiance L over a small solid angle ω
//!
//! ```text
//! L ω (n · l) D(n · h) V(n · l, n · v)          D = α² / (π ((n · h)² (α² − 1) + 1)²)
//!                                               V = 1 / (2 (n · l) √(α² + (1 − α²)(n · v)²) + 2 (n · v) √(α² + (1 − α²)(n · l)²))
//! ```
//!
//! times Fresnel's reflectance (Walter et al. 2007, equation 33; Heitz 2014, equation 99, for V). Divided by what it mirrors of an
//! even sky, E, that is a mean over the lobe: what this gives. `resolve` multiplies with the reflectance.
//!
//! What a light of some size gives, a sphere, a patch or a lamp, is D at its middle, blurred by its size: in the place of α² is
//! α² + sin² θ / (4 h · v), θ its angular radius: h turns half as far as l does within the plane of both, and half as far over h · v
//! across it. A light in the mirrored direction that is much larger than the lobe then gives all of its radiance, as it should, and a small
//! one is as GGX has it.
//! Patches, which lie side by side, are blurred by sin² θ / h · v: less would leave them single spots, and together they give as much.
//! So highlights are sharp however low the order of light is. The environment is an SH vector and takes an SH lobe, the means
//! of P_l over the true one ([`Routines::gloss_lobe`]) about its axis; of a surface that is smoother than the order can tell, those of the
//! smoothest that it can ([`Routines::gloss_told`]).

use super::vectors::{dot, each};
use sh_core::constants::{FACING, NEAREST, SMOOTHEST};
use sh_core::{Lane, Routines};

/// How receivers mirror light.
#[derive(Clone, Copy, Debug)]
pub struct Gloss<L> {
    /// The unit vector to the eye.
    pub(crate) view: [L; 3],
    /// That of the lobe that the order of the light can tell.
    told: L,
    /// α².
    square: L,
    /// n · v, at least [`FACING`].
    facing: L,
    /// The middle of the lobe.
    axis: [L; 3],
    /// 1/E.
    whole: L,
}

impl<L: Lane> Gloss<L> {
    /// Of receivers at a position with a unit normal, seen from `eye`, under light of `C` coefficients.
    #[inline(always)]
    pub(crate) fn new<const C: usize>(
        position: [L; 3],
        normal: [L; 3],
        eye: [L; 3],
        roughness: L,
    ) -> Self
    where
        [L; C]: Routines<L>,
        [L; 4]: Routines<L>,
    {
        let (one, least) = (roughness.lift(1.0), roughness.lift(FACING));
        let away = each(
            #[inline(always)]
            |k| eye[k] - position[k],
        );
        let inverse = one / dot(away, away).sqrt().max(one.lift(NEAREST));
        let view = each(
            #[inline(always)]
            |k| away[k] * inverse,
        );
        let along = dot(view, normal);
        let facing = along.max(least).min(one);
        let told = <[L; C]>::gloss_told(roughness);
        let tilt = <[L; 4]>::gloss_tilt(told, facing);
        // Away from the eye in the plane of the surface, as long as the sine.
        let aside = each(
            #[inline(always)]
            |k| along.mul_add(normal[k], -view[k]) * tilt,
        );
        let up = (one - dot(aside, aside)).max(one.lift(0.0)).sqrt();
        let axis = each(
            #[inline(always)]
            |k| up.mul_add(normal[k], aside[k]),
        );
        let alpha = (roughness * roughness).max(one.lift(SMOOTHEST));
        let [energy, _] = <[L; 4]>::gloss_energy(roughness, facing);
        Self {
            view,
            told,
            square: alpha * alpha,
            facing,
            axis,
            whole: one / energy,
        }
    }

    /// The lobe as an SH vector.
    #[inline(always)]
    pub(crate) fn lobe<const C: usize>(&self) -> [L; C]
    where
        [L; C]: Routines<L>,
    {
        let mut lobe = <[L; C]>::basis(self.axis);
        let bands = <[L; C]>::gloss_lobe(self.told, self.facing);
        for (l, band) in bands.as_ref().iter().enumerate() {
            for y in &mut lobe[l * l..(l + 1) * (l + 1)] {
                *y = *y * *band;
            }
        }
        lobe
    }

    /// The same behind blockers, whose logarithm this is.
    #[inline(always)]
    pub(crate) fn transfer<const C: usize>(&self, log: &[L; C]) -> [L; C]
    where
        [L; C]: Routines<L>,
    {
        let bands = <[L; C]>::gloss_lobe(self.told, self.facing);
        log.transfer_lobe(self.axis, bands)
    }

    /// What of a light is mirrored, over what is reflected diffusely at albedo 1: π D V / E. The light lies in a direction of
    /// which the cosines with the normal and with the view are given, and what its size adds to α², over h · v.
    #[inline(always)]
    pub(crate) fn mirrors(&self, height: L, along: L, size: L) -> L {
        let (zero, one) = (height.lift(0.0), height.lift(1.0));
        let height = height.max(zero);
        let facing = self.facing;
        // (n · h)², of h = l + v, whose length squared is 2 + 2 l · v.
        let both = height + facing;
        let two = (along + along + one.lift(2.0)).max(one.lift(NEAREST));
        let half = (both * both / two).min(one);
        // h · v is half of that length.
        let wide = (size * one.lift(2.0) / two.sqrt() + self.square).min(one);
        let fall = half.mul_add(wide - one, one);
        let rest = one - self.square;
        let from = rest.mul_add(facing * facing, self.square).sqrt();
        let to = rest.mul_add(height * height, self.square).sqrt();
        let shade = (height * from + facing * to) * one.lift(2.0);
        wide * self.whole / (fall * fall * shade.max(one.lift(NEAREST)))
    }
}
