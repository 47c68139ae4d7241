//! Every generated routine against the truth, in f64 and f32.

use sh_codegen::routines::{ORDERS, ROUTINES, Routine};
use sh_tests::accuracy::{Number, Table, error};
use sh_tests::call::{call_f64, call_rounded};
use sh_tests::{case, truth::truth};
use std::collections::BTreeMap;

const CASES: usize = 60;

/// The largest error over all orders and cases, in units. Arguments are rounded to the number type first:
/// what is measured is the routine's rounding, not its arguments'.
fn measure(routine: &Routine, number: Number) -> f64 {
    let mut worst = 0.0_f64;
    for order in ORDERS {
        let mut random = case::Random::new(order as u64);
        for i in 0..CASES {
            let mut arguments = case::arguments(routine, order, &mut random, i);
            if number != Number::F64 {
                arguments
                    .iter_mut()
                    .flatten()
                    .for_each(|x| *x = f64::from(*x as f32));
            }
            let want = truth(routine.name, order, &arguments).expect("every routine has a truth");
            let call = match number {
                Number::F64 => call_f64,
                _ => call_rounded,
            };
            let got = call(routine.name, order, &arguments);
            worst = worst.max(error(&got, &want, number, case::scale(routine, &arguments)));
        }
    }
    worst
}

/// Permitted errors hold, and none permits more than it has to: judged on scalar f32.
#[test]
fn routines_against_truth() {
    let table = Table::load();
    let (mut measured, mut failures) = (BTreeMap::new(), Vec::new());
    for routine in ROUTINES {
        let [double, single] = [Number::F64, Number::F32].map(|number| measure(routine, number));
        measured.insert(routine.name, single);
        let permitted = table.permitted(routine.name, Number::F64);
        println!(
            "{:24} f64 {double:6.2} of {permitted}, f32 {single:6.2}",
            routine.name
        );
        if double > permitted {
            failures.push(format!(
                "{} in f64: {double:.1} units, {permitted} permitted",
                routine.name
            ));
        }
    }
    failures.extend(table.complaints(&measured));
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Every routine has a truth of the right length at every order.
#[test]
fn routines_have_a_truth() {
    let mut without = Vec::new();
    for routine in ROUTINES {
        for order in ORDERS {
            let mut random = case::Random::new(1);
            let arguments = case::arguments(routine, order, &mut random, 5);
            match truth(routine.name, order, &arguments) {
                Some(truth) if truth.len() == routine.result.len(order) => {}
                Some(truth) => without.push(format!(
                    "`{}` of order {order} has a truth of {} numbers",
                    routine.name,
                    truth.len()
                )),
                None => without.push(format!(
                    "`{}` of order {order} has no truth in tests/src/truth.rs",
                    routine.name
                )),
            }
        }
    }
    assert!(without.is_empty(), "{}", without.join("\n"));
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
