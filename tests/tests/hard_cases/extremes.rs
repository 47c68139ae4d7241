//! Numbers at the edges of their range, in every position of every argument of every generated routine.
//!
//! What is promised is one table, `sh_tests::promises`; a routine that it does not name fails.

use sh_codegen::routines::{ORDERS, ROUTINES, Routine};
use sh_tests::accuracy::{Number, Table, error};
use sh_tests::call::{call_f32, call_rounded};
use sh_tests::promises::{LONGEST, MEANT, PROMISES, Poison, Promise, enlarge, promised};
use sh_tests::{case, truth::truth};

/// Arguments of f32 for case `i`.
fn arguments(routine: &Routine, order: usize, i: usize) -> Vec<Vec<f32>> {
    let mut random = case::Random::new(97 + i as u64);
    case::arguments(routine, order, &mut random, i)
        .into_iter()
        .map(|a| a.into_iter().map(|x| x as f32).collect())
        .collect()
}

fn widened(a: &[Vec<f32>]) -> Vec<Vec<f64>> {
    a.iter()
        .map(|a| a.iter().copied().map(f64::from).collect())
        .collect()
}

/// Collects what does not hold, so that one run tells all.
#[derive(Default)]
struct Broken(std::collections::BTreeMap<String, usize>);

impl Broken {
    fn unless(&mut self, holds: bool, what: impl FnOnce() -> String) {
        if !holds {
            *self.0.entry(what()).or_default() += 1;
        }
    }
}

impl Drop for Broken {
    fn drop(&mut self) {
        if !self.0.is_empty() && !std::thread::panicking() {
            let lines: Vec<_> = self
                .0
                .iter()
                .map(|(w, n)| format!("{w} ({n} times)"))
                .collect();
            panic!("{}", lines.join("\n"));
        }
    }
}

/// Every element of every argument in turn, of every routine at every order.
fn each_position(mut f: impl FnMut(&'static Routine, usize, usize, usize, &mut Vec<Vec<f32>>)) {
    for routine in ROUTINES {
        for order in ORDERS {
            for (a, (_, shape)) in routine.arguments.iter().enumerate() {
                for k in 0..shape.len(order) {
                    let mut arguments = arguments(routine, order, 7);
                    f(routine, order, a, k, &mut arguments);
                }
            }
        }
    }
}

/// Zeros of both signs and numbers too small for a full mantissa are numbers like others: the result is that of
/// the exact formula, to what the routine may err.
#[test]
fn zeros_and_denormals_in_every_position() {
    let table = Table::load();
    let mut broken = Broken::default();
    each_position(|routine, order, a, k, arguments| {
        for value in [0.0, -0.0, f32::from_bits(1), -1e-40, f32::MIN_POSITIVE] {
            arguments[a][k] = value;
            let got = call_f32(routine.name, order, arguments);
            broken.unless(got.iter().all(|x| x.is_finite()), || {
                format!("{} is not finite with {value:e}", routine.name)
            });
            // Only vectors stay what they should be with an element replaced.
            if case::is_vector(routine.arguments[a].1) {
                let wide = widened(arguments);
                let want = truth(routine.name, order, &wide).expect("every routine has a truth");
                let got: Vec<f64> = got.into_iter().map(f64::from).collect();
                let off = error(&got, &want, Number::F32, case::scale(routine, &wide));
                broken.unless(off <= table.permitted(routine.name, Number::F32), || {
                    format!("{} errs with {value:e}", routine.name)
                });
            }
        }
    });
}

/// NaN and infinities never come out as a wrong number.
#[test]
fn infinities_and_nan_in_every_position() {
    let mut broken = Broken::default();
    each_position(|routine, order, a, k, arguments| {
        if MEANT.contains(&(routine.name, routine.arguments[a].0)) {
            return;
        }
        let whole = arguments.clone();
        let usual = call_f32(routine.name, order, &whole);
        // Which results depend on the element.
        arguments[a][k] += 0.25;
        let moved = call_f32(routine.name, order, arguments);
        for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            arguments[a][k] = value;
            let got = call_f32(routine.name, order, arguments);
            let name = routine.arguments[a].0;
            match promised(routine).poison {
                Poison::Shows => {
                    for i in 0..got.len() {
                        let depends = (usual[i] - moved[i]).abs() > 1e-3 * usual[i].abs().max(0.1);
                        broken.unless(!depends || !got[i].is_finite(), || {
                            format!("{}: {value} in {name} gives a number", routine.name)
                        });
                    }
                }
                Poison::Bounded(bound) => {
                    let nan = got.iter().any(|x| x.is_nan());
                    let norm = got
                        .iter()
                        .map(|x| f64::from(*x).powi(2))
                        .sum::<f64>()
                        .sqrt();
                    broken.unless(nan || norm <= bound, || {
                        format!("{}: {value} in {name} gives a norm of {norm}", routine.name)
                    });
                }
            }
        }
    });
}

/// A window of infinite width lets everything through, and one without a width lets the mean through alone; a
/// norm beyond all is that at the end of the range, and one that is not a number gives no number.
#[test]
fn widths_and_norms_that_are_not_finite() {
    for order in ORDERS {
        let f: Vec<f32> = (1..=order * order).map(|i| i as f32).collect();
        let window = |h: f32| call_f32("window", order, &[f.clone(), vec![h]]);
        assert_eq!(window(f32::INFINITY), f);
        for h in [f32::NAN, f32::NEG_INFINITY, -1.0] {
            let cut = window(h);
            assert!(
                cut[0] == 1.0 && cut[1..].iter().all(|x| *x == 0.0),
                "{h}: {cut:?}"
            );
        }
        let factors = |norm: f32| call_f32("optimal_linear_wide", order, &[vec![norm]]);
        assert_eq!(factors(f32::INFINITY), factors(100.0));
        assert!(factors(f32::NAN).iter().all(|x| x.is_nan()));
    }
}

/// What is promised of vectors of any size: finite and in bounds up to the largest, as accurate as at 1 up to that which the
/// table names, to what is permitted.
#[test]
fn large_vectors_keep_their_accuracy() {
    let table = Table::load();
    let mut broken = Broken::default();
    for routine in ROUTINES {
        let Promise {
            largest,
            accurate,
            poison,
            ..
        } = *promised(routine);
        let permitted = table.permitted(routine.name, Number::F32);
        for order in ORDERS {
            for (i, size) in
                (0..20).flat_map(|i| sizes(accurate, largest).map(move |size| (i, size)))
            {
                let mut arguments = arguments(routine, order, i);
                enlarge(routine, &mut arguments, size);
                let wide = widened(&arguments);
                let got = call_rounded(routine.name, order, &wide);
                broken.unless(got.iter().all(|x| x.is_finite()), || {
                    format!("{} is not finite at {size:e}", routine.name)
                });
                let mut scale = case::scale(routine, &wide);
                if let Poison::Bounded(bound) = poison {
                    let norm = got.iter().map(|x| x * x).sum::<f64>().sqrt();
                    broken.unless(norm <= bound, || {
                        format!("{}: norm {norm} at {size:e}", routine.name)
                    });
                    scale = scale.min(LONGEST);
                }
                if size <= accurate {
                    let want = truth(routine.name, order, &wide).expect("a truth");
                    let off = error(&got, &want, Number::F32, scale);
                    broken.unless(off <= permitted, || {
                        format!("{}: {off:.0} units at {size:e}", routine.name)
                    });
                }
            }
        }
    }
}

/// Magnitudes to test: those at the ends, and some on the way where a sum of squares does not yet hide the rest.
fn sizes(accurate: f32, largest: f32) -> impl Iterator<Item = f32> {
    let between = [1e3, 1e6].into_iter().filter(move |size| *size < accurate);
    between.chain([accurate, largest])
}

/// No routine that exists is left out of the table, and none that is gone is in it.
#[test]
fn promises_name_every_routine() {
    for routine in ROUTINES {
        let _ = promised(routine);
    }
    assert_eq!(PROMISES.len(), ROUTINES.len());
}
