//! Generated routines by name and order.

use sh_core::Routines;

fn array<L: Copy, const N: usize>(values: &[L]) -> [L; N] {
    values.try_into().expect("a case has the routine's shapes")
}

include!(concat!(env!("OUT_DIR"), "/call.rs"));

/// [`call`] in f64, compiled once for all tests.
pub fn call_f64(routine: &str, order: usize, a: &[Vec<f64>]) -> Vec<f64> {
    call(routine, order, a)
}

/// [`call`] in f32, compiled once for all tests.
pub fn call_f32(routine: &str, order: usize, a: &[Vec<f32>]) -> Vec<f32> {
    call(routine, order, a)
}

/// [`call_f32`] of arguments that are rounded to f32 first.
pub fn call_rounded(routine: &str, order: usize, a: &[Vec<f64>]) -> Vec<f64> {
    let narrow: Vec<Vec<f32>> = a
        .iter()
        .map(|a| a.iter().map(|x| *x as f32).collect())
        .collect();
    call_f32(routine, order, &narrow)
        .into_iter()
        .map(f64::from)
        .collect()
}
