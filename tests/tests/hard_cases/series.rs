//! The exponentials that are made of products: up to which norm of f̂, the vector without its mean, they promise
//! anything. Errors are against the exact exponential of the band-limited function, as parts of full visibility,
//! for logarithms that are nowhere above 0; the worst of orders 2 to 6.

use crate::blockers::{error, lattice, norm};
use sh_core::exp::{self, Outlined};
use sh_core::{Lane, ROOT_FOUR_PI, Routines};
use sh_reference as reference;
use sh_tests::every_order;
use sh_tests::worst::worst;

/// Norms that errors are promised for, and methods with what they promise: beyond the last number, nothing.
const NORMS: [f64; 4] = [0.5, 2.0, 4.0, 16.0];
const METHODS: [(&str, &[f64]); 4] = [
    ("PS*-2", &[0.0025, 0.026, 0.07, 0.22]),
    ("HYB", &[0.022, 0.055, 0.1, 0.22]),
    ("OL", &[0.036, 0.2, 0.31, 0.48]),
    ("PS-21", &[0.0015, 0.026, 0.07]),
];

/// The norm up to which all of them are finite in f32, for a mean of 0 or less.
const FINITE: f64 = 64.0;

#[inline(never)]
fn exponential<L: Lane, const C: usize>(method: &str, f: &[L; C]) -> [L; C]
where
    [L; C]: Routines<L>,
{
    match method {
        "PS*-2" => exp::ps_star_by::<Outlined, L, C>(f, 2),
        "HYB" => exp::hyb_by::<Outlined, L, C>(f),
        "OL" => exp::optimal_linear(f),
        _ => exp::product_series_by::<Outlined, L, C>(f, 21),
    }
}

/// A vector without mean of norm `size`.
fn rest<const C: usize>(random: &mut sh_tests::case::Random, size: f64) -> [f64; C] {
    let mut f: [f64; C] = std::array::from_fn(|_| random.signed());
    f[0] = 0.0;
    let scale = size / norm(&f);
    f.map(|x| x * scale)
}

/// `f` with the mean that makes its largest value 0.
fn log<const C: usize>(mut f: [f64; C]) -> [f64; C]
where
    [f64; C]: Routines<f64>,
{
    let largest = lattice(2000)
        .map(|d| f.dot(&<[f64; C]>::basis(d)))
        .fold(0.0, f64::max);
    f[0] = -largest * ROOT_FOUR_PI;
    f
}

#[test]
fn accuracy_up_to_the_promised_norms() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        let mut random = sh_tests::case::Random::new(5);
        for (i, size) in NORMS.into_iter().enumerate() {
            for _ in 0..5 {
                let f = log(rest::<C>(&mut random, size));
                let exact = reference::exp::exact(&f);
                assert!(exact.error < 1e-6, "{exact:?}");
                for (method, promised) in METHODS {
                    let g = exponential(method, &f);
                    let off = error(&g, &exact.coefficients);
                    let order = <[f64; C]>::ORDER;
                    match promised.get(i) {
                        Some(promised) => assert!(
                            off <= *promised,
                            "{method}, order {order}, norm {size}: {off:.3}, {promised} promised"
                        ),
                        // What is promised ends where it has to.
                        None => {
                            assert!(off > 1.0, "{method}, order {order}, norm {size}: {off:.3}")
                        }
                    }
                }
            }
        }
    }
    every_order!(check);
}

/// Errors over what is promised, at their worst for what is zonal, looked for: a dip, one harmonic, and all between them.
/// They come near to what is promised, which therefore is not more than it has to be.
#[test]
fn the_worst_of_zonal_functions() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        for (i, size) in NORMS.into_iter().enumerate() {
            let over_promised = |bands: [f64; 5]| {
                let mut f = [0.0; C];
                for l in 1..<[f64; C]>::ORDER {
                    f[l * l + l] = bands[l - 1] - 0.5;
                }
                let scale = size / norm(&f).max(1e-9);
                let f = log(f.map(|x| x * scale));
                let exact = reference::exp::exact(&f);
                let of = |(method, promised): (&str, &[f64])| {
                    let Some(promised) = promised.get(i) else {
                        return 0.0;
                    };
                    error(&exponential(method, &f), &exact.coefficients) / promised
                };
                METHODS.map(of).into_iter().fold(0.0, f64::max)
            };
            let (most, bands) = worst(C as u64, 24, over_promised);
            let order = <[f64; C]>::ORDER;
            assert!(most <= 1.0, "order {order}, norm {size}, {bands:?}: {most}");
            assert!(order < 6 || most > 0.6, "norm {size}: {most}");
        }
    }
    every_order!(check);
}

#[test]
fn finite_up_to_the_promised_norm() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
        [f32; C]: Routines<f32>,
    {
        let mut random = sh_tests::case::Random::new(6);
        for _ in 0..20 {
            let f = rest::<C>(&mut random, FINITE).map(|x| x as f32);
            for (method, _) in METHODS {
                let g = exponential(method, &f);
                assert!(g.iter().all(|x| x.is_finite()), "{method}: {g:?}");
            }
        }
    }
    every_order!(check);
}

/// What is not finite, or beyond all bounds, ends and does not pass for a visibility.
#[test]
fn beyond_all_bounds_they_end() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
        [f32; C]: Routines<f32>,
    {
        for (method, _) in METHODS {
            for k in 0..C {
                let mut f = [-0.1_f32; C];
                f[k] = f32::NAN;
                let g = exponential(method, &f);
                assert!(g.iter().any(|x| x.is_nan()), "{method}, {k}: {g:?}");
            }
            for huge in [f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN] {
                exponential(method, &[huge; C]);
            }
        }
    }
    every_order!(check);
}
