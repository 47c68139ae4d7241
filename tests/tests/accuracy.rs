//! Every generated routine against the truth, in f64, f32 and vector lanes.

use sh_codegen::routines::{ORDERS, ROUTINES};
use sh_tests::accuracy::{Number, Table, error};
use sh_tests::{call::call, case, truth::truth};

const CASES: usize = 60;

/// The largest error over all orders and cases, in units. Arguments are rounded to the number type first:
/// what is measured is the routine's rounding, not its arguments'.
fn measure(routine: &sh_codegen::routines::Routine, number: Number) -> f64 {
    let mut worst = 0.0_f64;
    for order in ORDERS {
        let mut random = case::Random::new(order as u64);
        for i in 0..CASES {
            let exact = case::arguments(routine, order, &mut random, i);
            let round = |x: &f64| {
                if number == Number::F64 {
                    *x
                } else {
                    f64::from(*x as f32)
                }
            };
            let arguments: Vec<Vec<f64>> = exact
                .iter()
                .map(|a| a.iter().map(round).collect())
                .collect();
            let want = truth(routine.name, order, &arguments)
                .unwrap_or_else(|| panic!("`{}` has no truth in tests/src/truth.rs", routine.name));
            let got: Vec<f64> = if number == Number::F64 {
                call(routine.name, order, &arguments)
            } else {
                let narrow: Vec<Vec<f32>> = arguments
                    .iter()
                    .map(|a| a.iter().map(|x| *x as f32).collect())
                    .collect();
                call(routine.name, order, &narrow)
                    .into_iter()
                    .map(f64::from)
                    .collect()
            };
            worst = worst.max(error(&got, &want, number, case::scale(routine, &arguments)));
        }
    }
    worst
}

/// Permitted errors hold, and every exception from the default is still necessary.
#[test]
fn routines_against_truth() {
    let table = Table::load();
    let mut failures = Vec::new();
    for routine in ROUTINES {
        for number in [Number::F64, Number::F32] {
            let measured = measure(routine, number);
            let permitted = table.permitted(routine.name, number);
            println!(
                "{:16} {number:?}: {measured:6.2} of {permitted} units",
                routine.name
            );
            if measured > permitted {
                failures.push(format!(
                    "{} in {number:?}: {measured:.1} units, {permitted} permitted",
                    routine.name
                ));
            }
            if table.exception(routine.name, number).is_some() && measured <= table.default(number)
            {
                failures.push(format!(
                    "{} in {number:?} needs no exception: {measured:.1}",
                    routine.name
                ));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// The table names routines that exist.
#[test]
fn exceptions_name_routines() {
    for name in Table::load().exceptions.keys() {
        assert!(
            ROUTINES.iter().any(|r| r.name == name),
            "accuracy.toml: no routine `{name}`"
        );
    }
}
