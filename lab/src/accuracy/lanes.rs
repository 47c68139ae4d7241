//! The methods in vector lanes: 8 receivers side by side in the registers of AVX2.
//!
//! Each function enters the instruction set by itself and is compiled once: what is inlined into it takes the
//! instruction set over.

use fearless_simd::Simd;
use gaunt::exponential::Exponential;
use sh_codegen::sampled::Fineness;
use sh_core::Routines;
use sh_core::exp::{self, Calls};
use sh_cpu::lanes::Lanes8;

/// Receivers side by side.
pub const WIDTH: usize = 8;

/// One blocker for each of several receivers: sine and cosine of its angular radius, and its direction.
#[derive(Clone, Copy)]
pub struct Blockers<L> {
    pub sin: L,
    pub cos: L,
    pub axis: [L; 3],
}

macro_rules! entered {
    ($(fn $name:ident($f:ident $(, $argument:ident: $type:ty)*) $body:expr)*) => { $(
        #[inline(never)]
        fn $name<S: Simd, const C: usize>($f: &[Lanes8<S>; C] $(, $argument: $type)*) -> [Lanes8<S>; C]
        where
            [Lanes8<S>; C]: Routines<Lanes8<S>>,
        {
            let simd = $f[0].0.simd;
            simd.vectorize(
                #[inline(always)]
                || $body,
            )
        }
    )* };
}

entered! {
    fn square(f) f.square()
    fn product(f, g: &[Lanes8<S>; C]) f.product(g)
    fn saturating(f) f.exp_saturating()
    fn coarse(f) f.exp_sampled_coarse()
    fn medium(f) f.exp_sampled()
    fn fine(f) f.exp_sampled_fine()
    fn series(f, degree: usize) exp::product_series_by::<Entered, _, C>(f, degree)
    fn factored(f, degree: usize) exp::ps_star_by::<Entered, _, C>(f, degree)
    fn hybrid(f) exp::hyb_by::<Entered, _, C>(f)
    fn optimal_linear(f) exp::optimal_linear(f)
    fn add_all(f, blockers: &[Blockers<Lanes8<S>>]) {
        let mut sum = *f;
        for b in blockers {
            sum = sum.add_cap_log(b.sin, b.cos, b.axis);
        }
        sum
    }
    fn add_all_saturating(f, blockers: &[Blockers<Lanes8<S>>]) {
        let mut sum = *f;
        for b in blockers {
            sum = sum.add_cap_log_saturating(b.sin, b.cos, b.axis);
        }
        sum
    }
    fn multiply_all(f, blockers: &[Blockers<Lanes8<S>>]) {
        let mut sum = *f;
        for b in blockers {
            let zonal = <[Lanes8<S>; C]>::cap_visibility(b.cos, b.sin);
            sum = product(&sum, &<[Lanes8<S>; C]>::zonal(zonal, b.axis));
        }
        sum
    }
}

/// Products and squares, each entering the instruction set.
struct Entered;

impl<S: Simd, const C: usize> Calls<Lanes8<S>, C> for Entered
where
    [Lanes8<S>; C]: Routines<Lanes8<S>>,
{
    #[inline(always)]
    fn square(f: &[Lanes8<S>; C]) -> [Lanes8<S>; C] {
        square(f)
    }

    #[inline(always)]
    fn product(f: &[Lanes8<S>; C], g: &[Lanes8<S>; C]) -> [Lanes8<S>; C] {
        product(f, g)
    }
}

/// The exponential of a group of vectors; none where lanes have none.
pub fn exponential<S: Simd, const C: usize>(
    method: Exponential,
    f: &[Lanes8<S>; C],
) -> Option<[Lanes8<S>; C]>
where
    [Lanes8<S>; C]: Routines<Lanes8<S>>,
{
    Some(match method {
        Exponential::Saturating => saturating(f),
        Exponential::Sampled(Fineness::Coarse) => coarse(f),
        Exponential::Sampled(Fineness::Medium) => medium(f),
        Exponential::Sampled(Fineness::Fine) => fine(f),
        Exponential::Series(degree) => series(f, degree),
        Exponential::Factored(degree) => factored(f, degree),
        Exponential::OptimalLinear => optimal_linear(f),
        Exponential::Hybrid => hybrid(f),
        Exponential::Eigen => return None,
    })
}

/// All blockers taken together: by the sum of their logarithms, or by the product of their visibilities.
pub fn together<S: Simd, const C: usize>(
    method: Option<Exponential>,
    f: &[Lanes8<S>; C],
    blockers: &[Blockers<Lanes8<S>>],
) -> [Lanes8<S>; C]
where
    [Lanes8<S>; C]: Routines<Lanes8<S>>,
{
    match method {
        None => multiply_all(f, blockers),
        Some(Exponential::Saturating) => add_all_saturating(f, blockers),
        Some(_) => add_all(f, blockers),
    }
}

/// Groups of vectors, an incomplete last one left out.
pub fn groups<S: Simd, const C: usize>(simd: S, vectors: &[[f32; C]]) -> Vec<[Lanes8<S>; C]> {
    let group = |group: &[[f32; C]]| {
        std::array::from_fn(|i| Lanes8::from_array(simd, std::array::from_fn(|k| group[k][i])))
    };
    vectors.chunks_exact(WIDTH).map(group).collect()
}

/// One blocker for each receiver of a group.
pub fn blocker<S: Simd>(simd: S, of: impl Fn(usize) -> Blockers<f32>) -> Blockers<Lanes8<S>> {
    let number = |field: &dyn Fn(Blockers<f32>) -> f32| {
        Lanes8::from_array(simd, std::array::from_fn(|k| field(of(k))))
    };
    Blockers {
        sin: number(&|b| b.sin),
        cos: number(&|b| b.cos),
        axis: [0, 1, 2].map(|i| number(&|b| b.axis[i])),
    }
}

/// Nothing summed yet.
pub fn nothing<S: Simd, const C: usize>(simd: S) -> [Lanes8<S>; C] {
    [Lanes8::splat(simd, 0.0); C]
}
