//! Generated routines as functions of their own.
//!
//! Generated routines are inlined so that they take over the caller's instruction set. The largest of them,
//! some thousand operations, must not be copied into every place that uses them: the compiler's time grows
//! faster than the function (two products of order 6 inlined in 16 lanes take it minutes). Here each becomes
//! one function per lane type that enters its instruction set by itself; the call passes vectors through
//! memory, which costs little beside the routine.

use super::accumulate::{Blockers, Point, accumulated};
use super::behind::{Change, parted};
use super::emission::Emission;
use super::emitters::emitted;
use super::gloss::Gloss;
use super::light_cut::LightCut;
use super::light_discs::{Disc, discs};
use super::light_sums::sums;
use super::logs::{Logs, ratio_logs};
use super::patch_cut::PatchCut;
use super::patch_hiding::Hidden;
use super::patch_lights::{PatchLights, Placed};
use super::patches::patches;
use crate::lanes::{Lanes1, Lanes4, Lanes8, Lanes16};
use fearless_simd::Simd;
use sh_core::constants::ROOM;
use sh_core::{Lane, Routines};
use sh_scene::Emitter;

/// A lane type with the large routines of `C` coefficients out of line. Implemented for `f32`, `f64` and the
/// vector lanes, for orders 2 to 6; [`OutlineAll`] stands for all five orders.
pub trait Outline<const C: usize>: Lane
where
    [Self; C]: Routines<Self>,
{
    /// `sum`, on the scale of [`Routines::accumulate_blocker`], plus the log visibilities of all `blockers`.
    fn accumulate(sum: &[Self; C], point: &Point<Self>, blockers: Blockers) -> [Self; C];

    /// `sum`, on the same scale, as a lamp has it that some of the blockers are behind.
    fn parted(
        sum: &[Self; C],
        point: &Point<Self>,
        emitter: &Emitter,
        changes: &[Change],
    ) -> [Self; C];

    /// F_l(θ) P_l(s · axis) of each band l, with F the logarithm `of` a ball of this radius and s the direction
    /// `towards` it; 0 beyond the order. Sums of it are ratio vectors.
    fn ratio_logs(towards: [Self; 3], radius: Self, axis: [Self; 3], of: Logs) -> [Self; 6];

    /// The visibility past all blockers of a sum by [`Routines::accumulate_blocker_saturating`]: [`Routines::exp_saturating`]
    /// of [`Routines::accumulated_log`].
    fn visibility(sum: &[Self; C]) -> [Self; C];

    /// The first `N` coefficients of [`Routines::transfer`] of [`Routines::accumulated_log`] of such a sum.
    fn transfer<const N: usize>(sum: &[Self; C], normal: [Self; 3]) -> [Self; N];

    /// The lobe in which receivers at a position with a normal, seen from an eye, mirror light.
    fn gloss(
        position: [Self; 3],
        normal: [Self; 3],
        eye: [Self; 3],
        roughness: Self,
    ) -> Gloss<Self>;

    /// What of that is seen past all blockers of such a sum.
    fn mirrored(sum: &[Self; C], gloss: &Gloss<Self>) -> [Self; C];

    /// Radiance in three channels that `emitters` give through `transfer`, each between 0 and what it gives through
    /// `open`. Bit i of `dark` says that emitter i gives nothing.
    fn emitted(
        transfer: &[Self; C],
        open: &[Self; C],
        point: &Point<Self>,
        emitters: &[Emitter],
        dark: u64,
    ) -> [Self; 3];

    /// Radiance in three channels that a cut's spheres send on, whose visibilities are those of discs.
    fn gathered_discs(
        point: &Point<Self>,
        cut: &LightCut,
        lights: &Emission,
        kept: &mut [Disc<Self>; ROOM],
    ) -> [Self; 3];

    /// Radiance in three channels that a cut's patches send on; `own`: what receivers' own body gives itself among it.
    fn gathered_patches(
        point: &Point<Self>,
        cut: &PatchCut,
        sending: (&[Placed], &PatchLights),
        own: bool,
        kept: &mut [Hidden<Self>; ROOM],
    ) -> [Self; 3];

    /// Radiance that a cut's spheres send on, whose visibilities are differences of exponentials.
    fn gathered_sums(point: &Point<Self>, cut: &LightCut, lights: &Emission) -> [Self; 3];
}

/// A lane type with [`Outline`] for orders 2 to 6.
pub trait OutlineAll: Outline<4> + Outline<9> + Outline<16> + Outline<25> + Outline<36> {}

impl<L> OutlineAll for L where L: Outline<4> + Outline<9> + Outline<16> + Outline<25> + Outline<36> {}

macro_rules! routines {
    ($c:literal, $inline:meta, $enter:expr) => {
        #[$inline]
        fn accumulate(sum: &[Self; $c], point: &Point<Self>, blockers: Blockers) -> [Self; $c] {
            $enter(
                point.object,
                #[inline(always)]
                || accumulated(sum, point, blockers),
            )
        }

        #[$inline]
        fn parted(
            sum: &[Self; $c],
            point: &Point<Self>,
            emitter: &Emitter,
            changes: &[Change],
        ) -> [Self; $c] {
            $enter(
                point.object,
                #[inline(always)]
                || parted(sum, point, emitter, changes),
            )
        }

        #[$inline]
        fn ratio_logs(towards: [Self; 3], radius: Self, axis: [Self; 3], of: Logs) -> [Self; 6] {
            $enter(
                radius,
                #[inline(always)]
                || ratio_logs::<Self, $c>(towards, radius, axis, of),
            )
        }

        #[$inline]
        fn visibility(sum: &[Self; $c]) -> [Self; $c] {
            $enter(
                sum[0],
                #[inline(always)]
                || sum.accumulated_log().exp_saturating(),
            )
        }

        #[$inline]
        fn transfer<const N: usize>(sum: &[Self; $c], normal: [Self; 3]) -> [Self; N] {
            $enter(
                sum[0],
                #[inline(always)]
                || first(&sum.accumulated_log().transfer(normal)),
            )
        }

        #[$inline]
        fn gloss(
            position: [Self; 3],
            normal: [Self; 3],
            eye: [Self; 3],
            roughness: Self,
        ) -> Gloss<Self> {
            $enter(
                roughness,
                #[inline(always)]
                || Gloss::new::<$c>(position, normal, eye, roughness),
            )
        }

        #[$inline]
        fn mirrored(sum: &[Self; $c], gloss: &Gloss<Self>) -> [Self; $c] {
            $enter(
                sum[0],
                #[inline(always)]
                || gloss.transfer(&sum.accumulated_log()),
            )
        }

        #[$inline]
        fn emitted(
            transfer: &[Self; $c],
            open: &[Self; $c],
            point: &Point<Self>,
            emitters: &[Emitter],
            dark: u64,
        ) -> [Self; 3] {
            $enter(
                point.object,
                #[inline(always)]
                || emitted(transfer, open, point, emitters, dark),
            )
        }

        #[$inline]
        fn gathered_discs(
            point: &Point<Self>,
            cut: &LightCut,
            lights: &Emission,
            kept: &mut [Disc<Self>; ROOM],
        ) -> [Self; 3] {
            $enter(
                point.object,
                #[inline(always)]
                || discs::<Self, $c>(point, cut, lights, kept),
            )
        }

        #[$inline]
        fn gathered_patches(
            point: &Point<Self>,
            cut: &PatchCut,
            sending: (&[Placed], &PatchLights),
            own: bool,
            kept: &mut [Hidden<Self>; ROOM],
        ) -> [Self; 3] {
            $enter(
                point.object,
                #[inline(always)]
                || patches::<Self, $c>(point, cut, sending, own, kept),
            )
        }

        #[$inline]
        fn gathered_sums(point: &Point<Self>, cut: &LightCut, lights: &Emission) -> [Self; 3] {
            $enter(
                point.object,
                #[inline(always)]
                || {
                    sums(
                        point,
                        cut,
                        lights,
                        #[inline(always)]
                        |sum: &[Self; $c]| <Self as Outline<$c>>::visibility(sum),
                    )
                },
            )
        }
    };
}

/// The first of many; what is not among them is not computed, once this is inlined.
#[inline(always)]
fn first<L: Lane, const C: usize, const N: usize>(all: &[L; C]) -> [L; N] {
    let mut some = [all[0].lift(0.0); N];
    for (some, all) in some.iter_mut().zip(all) {
        *some = *all;
    }
    some
}

/// Calls `work` as it is.
#[inline(always)]
fn plainly<L, R>(_: L, work: impl FnOnce() -> R) -> R {
    work()
}

macro_rules! scalar {
    ($t:ty, $c:literal) => {
        impl Outline<$c> for $t {
            routines!($c, inline, plainly);
        }
    };
}

macro_rules! vector {
    ($lanes:ident, $c:literal) => {
        impl<S: Simd> Outline<$c> for $lanes<S> {
            routines!($c, inline(never), Self::within);
        }
    };
}

macro_rules! orders {
    ($($c:literal)*) => { $(
        // No pass computes with plain numbers: compiled where somebody does.
        scalar!(f32, $c);
        scalar!(f64, $c);
        vector!(Lanes1, $c);
        vector!(Lanes4, $c);
        vector!(Lanes8, $c);
        vector!(Lanes16, $c);
    )* };
}

orders!(4 9 16 25 36);
