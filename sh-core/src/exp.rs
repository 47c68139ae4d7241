//! The exponential of a log visibility.
//!
//! | | is | cost |
//! |---|---|---|
//! | [`Routines::exp_saturating`] | a bounded function of samples; what the shadow pass uses, with [`Routines::cap_log_saturating`] | one pass over a rule |
//! | [`Routines::exp_sampled`] | e^x of samples, clamped | the same and an exponential a sample |
//! | [`product_series`] | PS-p: the product series | p − 1 products |
//! | [`ps_star`] | PS*-p: the factored series, scaled and squared | (p+1)/2 products, log₂‖f̂‖ + 3 squares |
//! | [`optimal_linear`] | OL: a·1 + b·f̂ | none |
//! | [`hyb`] | HYB: OL, scaled and squared | log₂‖f̂‖ + 3 squares |
//!
//! The methods here are those of Ren et al. 2006, section 4, that are made of SH products; their
//! logarithm is that of [`Routines::cap_log`]. (Their eigenanalysis, eq. 28, is [`crate::log::exp`].) All but the plain series
//! isolate DC analytically (eq. 20: f = f̂ + f₀/√(4π) · 1). PS* and HYB then divide f̂ by 2^p, approximate its
//! exponential there, and square the result p times (eq. 21), with p = max(0, ⌊log₂‖f̂‖⌋ + 3), so that
//! ‖f̂‖/2^p < 1/4. p has no upper limit here: the cost grows with log₂‖f̂‖.
//!
//! What they promise: ‖f̂‖² must not overflow (‖f̂‖ < 1e19 in f32). Squares truncate to order n each time: for
//! heavily overlapping blockers (‖f̂‖ above about 10 at order 4) the error of the series grows beyond the
//! visibility itself, although each operation is accurate. Results are finite while they are smaller than the
//! largest float; no bound in [0, 1] is promised. For a result that is bounded whatever goes in, use
//! [`Routines::exp_saturating`].
//!
//! Products and squares are hundreds to thousands of operations. The functions by plain names have them inlined
//! wherever they are used; where that is too much code, or where a routine must be entered in an instruction set
//! of its own, say with the functions `..._by` how they are to be called ([`Calls`]).
//!
//! ```
//! use sh_core::{Sh4d, cap, exp};
//! // Behind three blockers in a row: add their logarithms, exponentiate once.
//! let log = |d| Sh4d::zonal(cap::log_fitted::<16>(0.3), d);
//! let sum = log([0.0, 0.6, 0.8]) + log([0.0, 1.0, 0.0]) + log([0.0, 0.6, -0.8]);
//! let visible = exp::hyb(&sum.0)[0] / Sh4d::ONE[0];
//! assert!(visible > 0.9 && visible < 0.97, "{visible}");
//! ```

use crate::{Lane, ROOT_FOUR_PI, Routines};

/// Halvings that bring any finite norm of f32 (2^128) or f64 (2^1024) below 1/4.
const MOST_HALVINGS: u32 = 1026;

/// How [`Routines::square`] and [`Routines::product`] are called.
///
/// ```
/// use sh_core::exp::{Calls, Inlined, Outlined};
/// let f = [0.1_f64, 0.2, 0.3, 0.4];
/// assert_eq!(Outlined::square(&f), <Inlined as Calls<f64, 4>>::square(&f));
/// ```
pub trait Calls<L: Lane, const C: usize> {
    /// The square of `f`.
    ///
    /// See [`Routines::square`].
    ///
    /// ```
    /// use sh_core::{Routines, exp::{Calls, Outlined}};
    /// let f = [0.1_f64, 0.2, 0.3, 0.4];
    /// assert_eq!(Outlined::square(&f), f.square());
    /// ```
    fn square(f: &[L; C]) -> [L; C];
    /// The product of `f` and `g`.
    ///
    /// See [`Routines::product`].
    ///
    /// ```
    /// use sh_core::{Routines, exp::{Calls, Outlined}};
    /// let f = [0.1_f64, 0.2, 0.3, 0.4];
    /// assert_eq!(Outlined::product(&f, &f), f.product(&f));
    /// ```
    fn product(f: &[L; C], g: &[L; C]) -> [L; C];
}

/// Copied to the place of use: fast, and the only way that takes over a caller's instruction set.
///
/// ```
/// use sh_core::exp::{self, Inlined};
/// let f = [-0.3_f32; 16];
/// assert_eq!(exp::hyb_by::<Inlined, _, _>(&f), exp::hyb(&f));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Inlined;

impl<L: Lane, const C: usize> Calls<L, C> for Inlined
where
    [L; C]: Routines<L>,
{
    #[inline(always)]
    fn square(f: &[L; C]) -> [L; C] {
        f.square()
    }

    #[inline(always)]
    fn product(f: &[L; C], g: &[L; C]) -> [L; C] {
        f.product(g)
    }
}

/// One function each for a type of number, for plain numbers: quick to compile.
///
/// ```
/// use sh_core::exp::{self, Outlined};
/// let f = [-0.3_f32; 16];
/// assert_eq!(exp::hyb_by::<Outlined, _, _>(&f), exp::hyb(&f));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Outlined;

impl<L: Lane, const C: usize> Calls<L, C> for Outlined
where
    [L; C]: Routines<L>,
{
    #[inline(never)]
    fn square(f: &[L; C]) -> [L; C] {
        f.square()
    }

    #[inline(never)]
    fn product(f: &[L; C], g: &[L; C]) -> [L; C] {
        f.product(g)
    }
}

/// exp*(f) by the product series of degree `degree`: PS-p of Ren et al. 2006 (eq. 17).
///
/// Without scaling it needs a degree above ‖f‖ to come near; odd and even degrees then err to opposite sides.
///
/// ```
/// use sh_core::{Sh4d, exp};
/// let g = exp::product_series(&(Sh4d::ONE * -0.5).0, 12);
/// assert!((g[0] - (-0.5_f64).exp() * Sh4d::ONE[0]).abs() < 1e-12);
/// ```
#[inline(always)]
pub fn product_series<L: Lane, const C: usize>(f: &[L; C], degree: usize) -> [L; C]
where
    [L; C]: Routines<L>,
{
    product_series_by::<Inlined, L, C>(f, degree)
}

/// [`product_series`] with products called by `P`.
///
/// ```
/// use sh_core::exp::{self, Outlined};
/// let f = [-0.3_f64; 16];
/// assert_eq!(exp::product_series_by::<Outlined, _, _>(&f, 3), exp::product_series(&f, 3));
/// ```
#[inline(always)]
pub fn product_series_by<P: Calls<L, C>, L: Lane, const C: usize>(
    f: &[L; C],
    degree: usize,
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let zero = f[0].lift(0.0);
    let mut sum = <[L; C]>::filled(zero);
    sum[0] = zero.lift(ROOT_FOUR_PI);
    let mut term = *f;
    for k in 1..=degree {
        if k > 1 {
            term = P::product(&term, f).map(|x| x * zero.lift(1.0 / k as f64));
        }
        for (a, b) in sum.iter_mut().zip(term) {
            *a = *a + b;
        }
    }
    sum
}

/// exp*(f) by a factored product series of degree `degree` after scaling: PS*-p of Ren et al. 2006.
///
/// Even and odd powers are kept apart (eq. 22), so that degree p costs about (p+1)/2 products; degree 2
/// costs one square. Then comes one square for each halving.
///
/// ```
/// use sh_core::{Sh4d, exp};
/// let g = exp::ps_star(&(Sh4d::ONE * -0.5).0, 2);
/// assert!((g[0] - (-0.5_f64).exp() * Sh4d::ONE[0]).abs() < 1e-15);
/// ```
#[inline(always)]
pub fn ps_star<L: Lane, const C: usize>(f: &[L; C], degree: usize) -> [L; C]
where
    [L; C]: Routines<L>,
{
    ps_star_by::<Inlined, L, C>(f, degree)
}

/// [`ps_star`] with products and squares called by `P`.
///
/// ```
/// use sh_core::exp::{self, Outlined};
/// let f = [-0.3_f64; 16];
/// assert_eq!(exp::ps_star_by::<Outlined, _, _>(&f, 2), exp::ps_star(&f, 2));
/// ```
#[inline(always)]
pub fn ps_star_by<P: Calls<L, C>, L: Lane, const C: usize>(f: &[L; C], degree: usize) -> [L; C]
where
    [L; C]: Routines<L>,
{
    scaled::<P, L, C>(f, |h, _| series::<P, L, C>(h, degree))
}

/// exp*(f) by the optimal linear approximation: OL of Ren et al. 2006 (eq. 23), with a and b of circles.
///
/// Without scaling it blurs where much is blocked; accurate as far as circles of any place agree on a and b
/// (‖f̂‖ < 4.8 at order 4).
///
/// ```
/// use sh_core::{Sh4d, exp};
/// let f = Sh4d::basis([0.0, 0.0, 1.0]) * -0.05;
/// let (linear, series) = (exp::optimal_linear(&f.0), exp::ps_star(&f.0, 6));
/// assert!(linear.iter().zip(series).all(|(a, b)| (a - b).abs() < 2e-2));
/// ```
#[inline(always)]
pub fn optimal_linear<L: Lane, const C: usize>(f: &[L; C]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let mut rest = *f;
    rest[0] = f[0].lift(0.0);
    let [a, b] = <[L; C]>::optimal_linear_wide(rest.dot(&rest).sqrt());
    let mean = (f[0] * f[0].lift(1.0 / ROOT_FOUR_PI)).exp();
    let mut g = rest.map(|x| x * b * mean);
    g[0] = a * mean * f[0].lift(ROOT_FOUR_PI);
    g
}

/// exp*(f) by the optimal linear approximation after scaling: HYB of Ren et al. 2006.
///
/// Where PS* sums a series, HYB takes a·1 + b·f̂ with a and b fitted as functions of ‖f̂‖ (eq. 23–24): no
/// product but the squares.
///
/// ```
/// use sh_core::{Sh4d, exp};
/// let mut f = Sh4d::basis([0.0, 0.0, 1.0]) * -0.05;
/// let (hyb, series) = (exp::hyb(&f.0), exp::ps_star(&f.0, 6));
/// assert!(hyb.iter().zip(series).all(|(a, b)| (a - b).abs() < 1e-2));
/// ```
#[inline(always)]
pub fn hyb<L: Lane, const C: usize>(f: &[L; C]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    hyb_by::<Inlined, L, C>(f)
}

/// [`hyb`] with squares called by `P`.
///
/// ```
/// use sh_core::exp::{self, Outlined};
/// let f = [-0.3_f64; 16];
/// assert_eq!(exp::hyb_by::<Outlined, _, _>(&f), exp::hyb(&f));
/// ```
#[inline(always)]
pub fn hyb_by<P: Calls<L, C>, L: Lane, const C: usize>(f: &[L; C]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let linear = |h: &[L; C], norm: L| {
        let [a, b] = <[L; C]>::optimal_linear(norm);
        let mut g = h.map(|x| x * b);
        g[0] = a * a.lift(ROOT_FOUR_PI);
        g
    };
    scaled::<P, L, C>(f, linear)
}

/// DC isolation and scaling/squaring around an approximation `exp` for vectors without DC of norm < 1/4,
/// which is given the vector and its norm.
///
/// The factor exp(f₀/√(4π)) is spread over the squarings, its 2^p-th root before the first: a sum over
/// hundreds of blockers has a large f̂ and a tiny factor, and exp(f̂) alone would overflow first.
#[inline(always)]
fn scaled<P: Calls<L, C>, L: Lane, const C: usize>(
    f: &[L; C],
    exp: impl Fn(&[L; C], L) -> [L; C],
) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let (zero, one) = (f[0].lift(0.0), f[0].lift(1.0));
    let (half, quarter) = (zero.lift(0.5), zero.lift(0.25));
    let mut rest = *f;
    rest[0] = zero;
    // p by comparisons: exact, and the same in every lane width and on the GPU. Every lane has its own p; the
    // loop ends with the largest. A norm that is not finite ends at the limit instead of never.
    let mut norm = rest.dot(&rest).sqrt();
    let mut scale = one;
    let mut halvings = zero;
    let mut most = 0;
    while most < MOST_HALVINGS {
        let small = norm.lt(quarter);
        let finer = L::select(small, scale, scale * half);
        if !L::any(finer.lt(scale)) {
            break;
        }
        halvings = L::select(small, halvings, halvings + one);
        norm = L::select(small, norm, norm * half);
        scale = finer;
        most += 1;
    }
    let root = (f[0] * scale * zero.lift(1.0 / ROOT_FOUR_PI)).exp();
    let mut g = exp(&rest.map(|x| x * scale), norm).map(|x| x * root);
    let mut done = zero;
    for _ in 0..most {
        let squared = P::square(&g);
        let more = done.lt(halvings);
        for (a, b) in g.iter_mut().zip(squared) {
            *a = L::select(more, b, *a);
        }
        done = done + one;
    }
    g
}

/// Σ_k f^k/k! up to `degree`, even and odd powers apart (eq. 22).
#[inline(always)]
fn series<P: Calls<L, C>, L: Lane, const C: usize>(f: &[L; C], degree: usize) -> [L; C]
where
    [L; C]: Routines<L>,
{
    let zero = f[0].lift(0.0);
    let mut even = <[L; C]>::filled(zero);
    even[0] = zero.lift(ROOT_FOUR_PI);
    if degree < 2 {
        for (a, b) in even.iter_mut().zip(f) {
            *a = if degree == 1 { *a + *b } else { *a };
        }
        return even;
    }
    let squared = P::square(f);
    let mut odd = even;
    let mut power = squared;
    let mut factorial = 1.0;
    for k in 2..=degree {
        factorial *= k as f64;
        let weight = zero.lift(1.0 / factorial);
        let sum = if k % 2 == 0 { &mut even } else { &mut odd };
        for (a, b) in sum.iter_mut().zip(power) {
            *a = b.mul_add(weight, *a);
        }
        if k % 2 == 1 && k < degree {
            power = P::product(&power, &squared);
        }
    }
    // Degree 2 has no odd power but f itself: no product is spent on it.
    let odd = if degree == 2 { *f } else { P::product(f, &odd) };
    for (a, b) in even.iter_mut().zip(odd) {
        *a = *a + b;
    }
    even
}
