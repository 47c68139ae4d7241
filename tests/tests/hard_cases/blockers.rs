//! Blockers whose logarithms are summed and exponentiated as the shadow pass does it, and the truth of them.

use sh_reference::visibility::Cap;
use sh_tests::call::{call_f64, call_rounded};

/// √(4π), the norm of full visibility.
pub const FULL: f64 = sh_core::ROOT_FOUR_PI;

/// A generated routine on flat arguments, in f64 or in f32.
pub type Call = fn(&str, usize, &[Vec<f64>]) -> Vec<f64>;

/// The number types that everything here is tested in.
pub const NUMBERS: [(&str, Call); 2] = [("f64", call_f64), ("f32", call_rounded)];

/// `sum` and the logarithm of one blocker more.
pub fn add(call: Call, order: usize, sum: Vec<f64>, cap: Cap) -> Vec<f64> {
    let (sin, cos) = cap.angle.sin_cos();
    let arguments = [sum, vec![sin], vec![cos], cap.axis.to_vec()];
    call("add_cap_log_saturating", order, &arguments)
}

/// The sum of the blockers' logarithms, one added after the other.
pub fn log(call: Call, order: usize, caps: &[Cap]) -> Vec<f64> {
    caps.iter().fold(vec![0.0; order * order], |sum, cap| {
        add(call, order, sum, *cap)
    })
}

/// The visibility that the shadow pass makes of blockers.
pub fn visibility(call: Call, order: usize, caps: &[Cap]) -> Vec<f64> {
    call("exp_saturating", order, &[log(call, order, caps)])
}

/// The length of a vector.
pub fn norm(f: &[f64]) -> f64 {
    f.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The distance between two vectors, as a part of full visibility.
pub fn error(got: &[f64], want: &[f64]) -> f64 {
    let difference: Vec<f64> = got.iter().zip(want).map(|(a, b)| a - b).collect();
    norm(&difference) / FULL
}

/// `count` axes spread evenly over the sphere (a Fibonacci lattice).
pub fn lattice(count: usize) -> impl Iterator<Item = [f64; 3]> {
    (0..count).map(move |i| {
        let z = 1.0 - (2 * i + 1) as f64 / count as f64;
        let azimuth = i as f64 * std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
        let (sin, cos) = azimuth.sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

/// Axes that coincide with an axis of the samples, and some that do not.
pub fn axes() -> Vec<[f64; 3]> {
    let mut random = sh_tests::case::Random::new(11);
    let mut axes = vec![[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.6, 0.0, 0.8]];
    axes.push([3.0_f64.sqrt().recip(); 3]);
    axes.extend((0..4).map(|_| random.on_sphere::<3>()));
    axes
}
