//! What is seen of a ball: means over the part of its surface that is in sight.
//!
//! A ball of angular radius θ is seen from the distance 1; s = sin θ is its radius, α the angle at its centre from the
//! viewer to a point of its surface. The means of P_l(cos α) say how bright a ball looks that emits differently in
//! different directions: Σ_l mean_l Σ_m y_lm(d) L_lm, with d towards the viewer (Guerrero et al., "Real-time Indirect
//! Illumination and Soft Shadows in Dynamic Scenes Using Spherical Lights", 2008, section 6.1).

use crate::quadrature::gauss_legendre;

/// Nodes of the integrals; the integrands are smooth, but for a bend where s nears 1.
const NODES: usize = 200;

/// P_l(x).
///
/// ```
/// // (3 x² − 1) / 2
/// assert!((sh_reference::ball::legendre(2, 0.5) + 0.125).abs() < 1e-15);
/// ```
pub fn legendre(band: usize, x: f64) -> f64 {
    let (mut before, mut now) = (0.0, 1.0);
    for l in 0..band {
        let l = l as f64;
        (before, now) = (now, ((2.0 * l + 1.0) * x * now - l * before) / (l + 1.0));
    }
    now
}

/// The mean of P_l(cos α) by solid angle: over all directions in which the viewer sees the ball, of which each counts
/// the same. That is what an average of radiance is.
///
/// A line of sight at the angle β from the centre's direction meets the ball where, with μ = cos β and
/// s w = √(μ² − cos² θ), cos α = s (1 − w²) + μ w. Error below 1e-9 for s up to 0.9999.
///
/// ```
/// // From far away it is the cosine of the surface's slope that counts: 2/3 = ∫ x·x / ∫ x.
/// assert!((sh_reference::ball::mean(1, 0.0) - 2.0 / 3.0).abs() < 1e-12);
/// // On the surface, one point is all there is.
/// assert!((sh_reference::ball::mean(3, 1.0 - 1e-9) - 1.0).abs() < 1e-3);
/// ```
pub fn mean(band: usize, sine: f64) -> f64 {
    means(band + 1, sine)[band]
}

/// [`mean`] of all bands below `order`.
///
/// ```
/// use sh_reference::ball::{mean, means};
/// assert_eq!(means(3, 0.4), [1.0, mean(1, 0.4), mean(2, 0.4)]);
/// ```
pub fn means(order: usize, sine: f64) -> Vec<f64> {
    let (mut sums, mut whole) = (vec![0.0; order], 0.0);
    for (w, weight) in gauss_legendre(NODES, 0.0, 1.0) {
        let mu = (1.0 - sine * sine * (1.0 - w * w)).sqrt();
        let area = weight * w / mu;
        for (band, sum) in sums.iter_mut().enumerate() {
            *sum += area * legendre(band, sine * (1.0 - w * w) + mu * w);
        }
        whole += area;
    }
    sums.iter().map(|sum| sum / whole).collect()
}

/// The mean of P_l(cos α) as Guerrero et al. weigh it (equation 16): over the ball's surface by the cosine of the angle at
/// which it is seen, (cos α − s)/√(1 − 2 s cos α + s²), whatever its distance.
///
/// ```
/// use sh_reference::ball::{mean, mean_by_slope};
/// // From far away both are the same, near by the paper's looks too much at the rim.
/// assert!((mean(2, 0.0) - mean_by_slope(2, 0.0)).abs() < 1e-9);
/// assert!(mean(1, 0.8) > mean_by_slope(1, 0.8) + 0.02);
/// ```
pub fn mean_by_slope(band: usize, sine: f64) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    for (x, weight) in gauss_legendre(NODES, sine, 1.0) {
        let area = weight * (x - sine) / (1.0 - 2.0 * sine * x + sine * sine).sqrt();
        sum += area * legendre(band, x);
        whole += area;
    }
    sum / whole
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadrature::Rule;
    use crate::zonal::evaluate;

    /// Lines of sight over the disc that the ball covers, cast one by one.
    #[test]
    fn means_are_those_of_rays() {
        let zonal = [0.3, -0.7, 0.5, 0.2, -0.4];
        for sine in [0.1_f64, 0.5, 0.9] {
            let axis = [0.0, 0.0, 1.0];
            let rule = Rule::zone(axis, (1.0 - sine * sine).sqrt(), 1.0, 400);
            let (mut seen, mut area) = (0.0, 0.0);
            for (ray, weight) in rule.nodes() {
                let mu = ray[2];
                let away = mu - (mu * mu - 1.0 + sine * sine).max(0.0).sqrt();
                // The point's direction from the centre at (0, 0, 1), towards the viewer at the origin.
                let cosine = (1.0 - away * mu) / sine;
                seen += weight * evaluate(&zonal, cosine);
                area += weight;
            }
            let expected = seen / area;
            let by_bands: f64 = zonal
                .iter()
                .enumerate()
                .map(|(l, z)| {
                    let norm = ((2 * l + 1) as f64 / (4.0 * std::f64::consts::PI)).sqrt();
                    z * norm * mean(l, sine)
                })
                .sum();
            assert!(
                (by_bands - expected).abs() < 1e-5,
                "{sine}: {by_bands} {expected}"
            );
        }
    }
}
