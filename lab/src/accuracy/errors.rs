//! Errors of the methods against true visibilities.

use super::methods::{Logarithm, Method, all};
use super::operations::{Operations, of_method};
use super::sets::{HEAVY_SETS, RANDOM_SETS, Sets};
use super::times::Times;
use super::{Row, times};
use gaunt::exponential::{Exponential, eigen_log};
use rayon::prelude::*;
use sh_core::cap::{self, Fit};
use sh_core::exp::{Calls, Outlined};
use sh_core::log::{CLIP, Logarithm as Eigen, clipped_samples};
use sh_core::{ROOT_FOUR_PI, Routines};
use sh_reference::quadrature::Rule;
use sh_reference::visibility::Cap;

/// Random sets that the exact exponential is taken of.
const EXACT_SETS: usize = 100;

/// Degree of the rule for the exact exponential of a band-limited function, of which the largest here changes by
/// less than 1e-6 with a finer one.
const EXACT_DEGREE: usize = 80;

/// A zonal function of the angular radius at every tenth of a degree up to 60, interpolated between.
struct Table(Vec<Vec<f64>>);

impl Table {
    const STEPS: f64 = 10.0;

    fn new(at: impl Fn(f64) -> Vec<f64> + Sync) -> Self {
        Self(
            (0..=600)
                .into_par_iter()
                .map(|i| at((f64::from(i) / Self::STEPS).to_radians()))
                .collect(),
        )
    }

    fn at(&self, angle: f64, band: usize) -> f64 {
        let place = (angle.to_degrees() * Self::STEPS).min(599.0);
        let (row, t) = (place as usize, place.fract());
        self.0[row][band] * (1.0 - t) + self.0[row + 1][band] * t
    }
}

/// Sums of logarithms over the blockers of a set, for every kind of logarithm.
struct Sums<'a> {
    sets: &'a Sets,
    eigen: Table,
    samples: Table,
}

impl Sums<'_> {
    fn of<const C: usize>(&self, set: usize, logarithm: Logarithm, fit: Fit) -> [f64; C]
    where
        [f64; C]: Routines<f64>,
    {
        let mut sum = [0.0; C];
        for cap in &self.sets.caps[set] {
            let mut zonal = cap::log_fitted_to::<C>(fit, cap.angle);
            for (l, z) in zonal.as_mut().iter_mut().enumerate() {
                match logarithm {
                    Logarithm::Eigen => *z = self.eigen.at(cap.angle, l),
                    Logarithm::Samples => *z = self.samples.at(cap.angle, l),
                    Logarithm::Fitted | Logarithm::None => {}
                }
            }
            let turned = <[f64; C]>::zonal(zonal, cap.axis);
            sum.iter_mut().zip(turned).for_each(|(s, t)| *s += t);
        }
        sum
    }
}

/// The product of the visibilities of all blockers, one after the other.
fn chain<const C: usize>(caps: &[Cap]) -> [f64; C]
where
    [f64; C]: Routines<f64>,
{
    let single = |cap: &Cap| <[f64; C]>::zonal(cap::visibility::<C>(cap.angle), cap.axis);
    caps[1..].iter().fold(single(&caps[0]), |product, cap| {
        <Outlined as Calls<f64, C>>::product(&product, &single(cap))
    })
}

/// The same in single precision.
fn chain_single<const C: usize>(caps: &[Cap]) -> [f32; C]
where
    [f32; C]: Routines<f32>,
    [f64; C]: Routines<f64>,
{
    let single = |cap: &Cap| -> [f32; C] {
        <[f64; C]>::zonal(cap::visibility::<C>(cap.angle), cap.axis).map(|x| x as f32)
    };
    caps[1..].iter().fold(single(&caps[0]), |product, cap| {
        <Outlined as Calls<f32, C>>::product(&product, &single(cap))
    })
}

fn norm(a: impl Iterator<Item = f64>) -> f64 {
    a.map(|x| x * x).sum::<f64>().sqrt()
}

/// Mean, 95th percentile and maximum. What is not a number counts as infinite.
fn summary(errors: &[f64]) -> [f64; 3] {
    let mut sorted: Vec<f64> = errors
        .iter()
        .map(|e| if e.is_nan() { f64::INFINITY } else { *e })
        .collect();
    sorted.sort_by(f64::total_cmp);
    let mean = sorted.iter().sum::<f64>() / sorted.len() as f64;
    let p95 = sorted[(sorted.len() * 95).div_ceil(100) - 1];
    [mean, p95, sorted[sorted.len() - 1]]
}

/// What a method makes of every set.
struct Evaluation<const C: usize> {
    visibility: Vec<[f64; C]>,
    rounding: f64,
    from_exact: Option<f64>,
    operations: Operations,
}

/// Adds the rows of all methods that accumulate in the order of `C` coefficients.
pub(super) fn order<const C: usize>(
    sets: &Sets,
    rows: &mut Vec<Row>,
    progress: &(dyn Fn(f32) + Sync),
) where
    [f64; C]: Eigen,
    [f32; C]: Routines<f32>,
    for<'a> Times<'a>: times::Measure<C>,
{
    let sums = Sums {
        sets,
        eigen: Table::new(eigen_log::<C>),
        samples: Table::new(|angle| {
            let zonal = clipped_samples::<C>(cap::visibility::<C>(angle), CLIP);
            zonal.as_ref().to_vec()
        }),
    };
    progress(0.1);
    let accumulation = <[f64; C]>::ORDER;
    let methods = all();
    let mut times = Times::new(sets);
    for (i, method) in methods.iter().enumerate() {
        let Evaluation {
            visibility,
            rounding,
            from_exact,
            operations,
        } = evaluate::<C>(&sums, method);
        let heavy_end = RANDOM_SETS + HEAVY_SETS;
        for order in 2..=accumulation {
            let errors: Vec<f64> = visibility
                .iter()
                .zip(&sets.truth)
                .map(|(g, truth)| {
                    let each = g[..order * order].iter().zip(truth);
                    norm(each.map(|(g, t)| g - t)) / ROOT_FOUR_PI
                })
                .collect();
            let [mean, p95, max] = summary(&errors[..RANDOM_SETS]);
            let [heavy, ..] = summary(&errors[RANDOM_SETS..heavy_end]);
            let [.., stacked] = summary(&errors[heavy_end..]);
            for (backend, ns) in times.of::<C>(method) {
                rows.push(Row {
                    order,
                    exponential: method.name(accumulation),
                    logarithm: method.logarithm.name().into(),
                    accumulation_order: accumulation,
                    backend: backend.into(),
                    mean,
                    p95,
                    max,
                    rounding,
                    mul: operations.mul,
                    add: operations.add,
                    exp: operations.exp,
                    ns,
                    heavy,
                    stacked,
                    from_exact,
                });
            }
        }
        progress(0.1 + 0.9 * (i + 1) as f32 / methods.len() as f32);
    }
}

fn evaluate<const C: usize>(sums: &Sums, method: &Method) -> Evaluation<C>
where
    [f64; C]: Eigen,
    [f32; C]: Routines<f32>,
{
    let caps = &sums.sets.caps;
    let blockers = sums.sets.mean_blockers();
    let difference = |a: &[f64; C], b: &[f32; C]| {
        norm(a.iter().zip(b).map(|(a, b)| a - f64::from(*b))) / ROOT_FOUR_PI
    };
    let Some(exponential) = method.exponential else {
        let both: Vec<([f64; C], f64)> = caps
            .par_iter()
            .map(|caps| {
                let g = chain::<C>(caps);
                (g, difference(&g, &chain_single::<C>(caps)))
            })
            .collect();
        return Evaluation {
            rounding: worst(both[..RANDOM_SETS].iter().map(|b| b.1)),
            visibility: both.into_iter().map(|b| b.0).collect(),
            from_exact: None,
            operations: of_method(method, <[f64; C]>::ORDER, blockers, 0.0),
        };
    };
    let logs: Vec<[f64; C]> = (0..caps.len())
        .into_par_iter()
        .map(|i| sums.of::<C>(i, method.logarithm, exponential.fit()))
        .collect();
    let visibility: Vec<[f64; C]> = logs.par_iter().map(|f| exponential.of(f)).collect();
    let rounding = logs[..RANDOM_SETS]
        .par_iter()
        .zip(&visibility)
        .map(|(f, g)| difference(g, &exponential.of(&f.map(|x| x as f32))))
        .collect::<Vec<_>>();
    let from_exact = (exponential != Exponential::Saturating).then(|| {
        let order = <[f64; C]>::ORDER;
        let rule = Rule::sphere(EXACT_DEGREE);
        let errors: Vec<f64> = logs[..EXACT_SETS]
            .par_iter()
            .zip(&visibility)
            .map(|(f, g)| {
                let exact: Vec<f64> =
                    rule.project(order, |s| sh_reference::basis::evaluate(f, s).exp());
                norm(g.iter().zip(exact).map(|(g, e)| g - e)) / ROOT_FOUR_PI
            })
            .collect();
        summary(&errors)[0]
    });
    let halvings: f64 = logs[..RANDOM_SETS]
        .iter()
        .map(|f| f64::from(sh_reference::exp::squarings(f)))
        .sum();
    Evaluation {
        visibility,
        rounding: worst(rounding.into_iter()),
        from_exact,
        operations: of_method(
            method,
            <[f64; C]>::ORDER,
            blockers,
            halvings / RANDOM_SETS as f64,
        ),
    }
}

fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |worst: f64, v| {
        if v.is_nan() {
            f64::INFINITY
        } else {
            worst.max(v)
        }
    })
}
