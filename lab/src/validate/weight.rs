//! How bright a light looks: the mean over the part of a ball that is seen, in two ways.
//!
//! The true light from a ball is the integral of its radiance times the cosine at the receiver, over the ball's disc in
//! the sky. The passes take the mean radiance by solid angle times the disc's own share; the paper weighs by the slope
//! of the surface (equations 16 and 17). Balls here send on, diffusely, light from one side: what they emit is in
//! proportion to max(0, n·l), cut off at order 4.

use serde::Serialize;
use sh_reference::ball::{mean, mean_by_slope};
use sh_reference::basis::{basis, evaluate};
use sh_reference::quadrature::Rule;

/// Errors of both means at one distance.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Row {
    /// The ball's radius over its distance.
    pub sine: f64,
    /// RMS over directions of the light and the receiver's normal, in parts of the RMS of the truth: by solid angle.
    pub solid_angle: f64,
    /// By slope.
    pub slope: f64,
}

/// One row for each distance.
pub(super) fn rows() -> Vec<Row> {
    [0.2, 0.4, 0.6, 0.8, 0.9, 0.95].map(row).into()
}

const ORDER: usize = 4;

fn row(sine: f64) -> Row {
    // The receiver is in the origin, the ball's centre at +Z in the distance 1. Nodes are where the ball is seen.
    let limit = (1.0 - sine * sine).sqrt();
    let disc: Vec<_> = Rule::zone([0.0, 0.0, 1.0], limit, 1.0, 60)
        .nodes()
        .collect();
    let [mut truth, mut solid, mut slope] = [0.0; 3];
    let spread = |count: u32| (0..=count).map(move |i| f64::from(i) / f64::from(count));
    for light in spread(8).map(|t| t * std::f64::consts::PI) {
        let light = [light.sin(), 0.0, light.cos()];
        let emission = Rule::hemisphere(light, 20).project(ORDER, |d| dot(d, light));
        let means = [mean, mean_by_slope].map(|mean| {
            let towards = basis(ORDER, [0.0, 0.0, -1.0]);
            let terms = emission.iter().zip(&towards).enumerate();
            terms
                .map(|(i, (e, y))| mean(i.isqrt(), sine) * e * y)
                .sum::<f64>()
        });
        // Normals whose horizon the ball does not reach, as the passes see to.
        let highest = limit.acos();
        for tilt in spread(4).map(|t| t * (std::f64::consts::FRAC_PI_2 - highest)) {
            let normal = [tilt.sin(), 0.0, tilt.cos()];
            let (mut exact, mut form) = (0.0, 0.0);
            for (ray, weight) in &disc {
                let mu = ray[2];
                let away = mu - (mu * mu - limit * limit).max(0.0).sqrt();
                let point = [0, 1, 2].map(|k| (away * ray[k] - [0.0, 0.0, 1.0][k]) / sine);
                let cosine = weight * dot(*ray, normal).max(0.0);
                exact += cosine * evaluate(&emission, point);
                form += cosine;
            }
            truth += exact * exact;
            solid += (means[0] * form - exact).powi(2);
            slope += (means[1] * form - exact).powi(2);
        }
    }
    Row {
        sine,
        solid_angle: (solid / truth).sqrt(),
        slope: (slope / truth).sqrt(),
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    #[test]
    fn both_are_right_from_afar_and_solid_angle_is_nearer_close_by() {
        let far = super::row(0.01);
        assert!(far.solid_angle < 1e-2 && far.slope < 1e-2, "{far:?}");
        for row in super::rows() {
            assert!(row.solid_angle < row.slope, "{row:?}");
        }
    }
}
