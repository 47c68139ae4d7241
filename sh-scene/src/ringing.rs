//! Windows that are as wide as ringing allows.
//!
//! What an SH vector shows of a small bright light overshoots below zero around it; surfaces there, and the shadows
//! that fall there, would be lit by less than nothing. The cosine window `cos(π/2 · l/h)` of Ren et al. 2006,
//! section 7, dims the high bands that do it, and blurs the light: a width of h = 2n suits skies, a small h suns.
//! Here h is the largest, up to 2n, with which the light is nowhere below −[`LIMIT`] times its brightest.

use sh_core::{Routines, for_order};

/// How far below zero a light may ring, in parts of its brightest.
pub const LIMIT: f64 = 0.1;

/// Widths that are looked at first, and steps of bisection after that: h to 2n/2¹⁶.
const SCAN: usize = 64;
const STEPS: u32 = 10;

/// What a window of width `h` leaves of band `l`: 1 for an infinite width.
///
/// ```
/// assert_eq!(sh_scene::ringing::gain(0, 4.0), 1.0);
/// assert!((sh_scene::ringing::gain(2, 4.0) - 0.5_f32.sqrt()).abs() < 1e-6);
/// assert_eq!(sh_scene::ringing::gain(4, 4.0), 0.0);
/// ```
pub fn gain(l: usize, h: f32) -> f32 {
    let part = l as f32 / h;
    if part < 1.0 {
        (std::f32::consts::FRAC_PI_2 * part).cos()
    } else {
        0.0
    }
}

/// The width for a light whose luminance has these coefficients (n² of them, n in 2 to 6), which are not windowed
/// yet.
///
/// # Panics
/// If there is no such order.
pub fn width(luminance: &[f64]) -> f32 {
    let order = luminance.len().isqrt();
    let points = directions();
    // By band and direction, so that a width costs n multiplications a direction.
    let bands: Vec<[f64; 6]> = points
        .iter()
        .map(|&d| {
            let mut bands = [0.0; 6];
            for (i, product) in basis_products(luminance, d).into_iter().enumerate() {
                bands[i.isqrt()] += product;
            }
            bands
        })
        .collect();
    widest(order, |h| {
        let gains: Vec<f64> = (0..order).map(|l| f64::from(gain(l, h))).collect();
        let value = |b: &[f64; 6]| b.iter().zip(&gains).map(|(b, g)| b * g).sum::<f64>();
        let values = || bands.iter().map(value);
        (
            values().fold(f64::INFINITY, f64::min),
            values().fold(f64::NEG_INFINITY, f64::max),
        )
    })
}

/// The width for a light that is small in the sky, a sun or a lamp far off: the worst there is.
///
/// ```
/// // Narrower than twice the order.
/// assert!(sh_scene::ringing::of_small_light(4) < 6.0);
/// ```
pub fn of_small_light(order: usize) -> f32 {
    widest(order, |h| {
        let at = |x: f64| {
            let (mut before, mut now, mut sum) = (0.0, 1.0, 0.0);
            for l in 0..order {
                sum += (2 * l + 1) as f64 * f64::from(gain(l, h)) * now;
                // (l + 1) P_(l+1) = (2l + 1) x P_l − l P_(l−1)
                let next = ((2 * l + 1) as f64 * x * now - l as f64 * before) / (l + 1) as f64;
                (before, now) = (now, next);
            }
            sum
        };
        let low = (0..=400).map(|i| at(f64::from(i) / 200.0 - 1.0));
        (low.fold(f64::INFINITY, f64::min), at(1.0))
    })
}

/// The largest width, up to 2n, for which `extremes` finds a least value of not below −[`LIMIT`] times the largest.
fn widest(order: usize, extremes: impl Fn(f32) -> (f64, f64)) -> f32 {
    let rings = |h: f32| {
        let (low, high) = extremes(h);
        low < -LIMIT * high
    };
    let most = 2.0 * order as f32;
    if !rings(most) {
        return most;
    }
    // With a width of 1 there is but the mean. Between, ringing may come and go: from above the first width without.
    let step = (most - 1.0) / SCAN as f32;
    let good = (0..SCAN)
        .map(|i| 1.0 + step * i as f32)
        .rfind(|&h| !rings(h));
    let mut good = good.unwrap_or(1.0);
    let mut bad = good + step;
    for _ in 0..STEPS {
        let middle = 0.5 * (good + bad);
        *(if rings(middle) { &mut bad } else { &mut good }) = middle;
    }
    good
}

/// Directions evenly over the sphere, a few degrees apart: the bands that there are change little between them
/// (spiral points of Vogel 1979).
fn directions() -> Vec<[f64; 3]> {
    const COUNT: u32 = 1500;
    let golden = std::f64::consts::PI * (3.0 - 5.0_f64.sqrt());
    (0..COUNT)
        .map(|i| {
            let y = 1.0 - 2.0 * (f64::from(i) + 0.5) / f64::from(COUNT);
            let (sin, cos) = (golden * f64::from(i)).sin_cos();
            let flat = (1.0 - y * y).sqrt();
            [flat * cos, y, flat * sin]
        })
        .collect()
}

/// Each coefficient times its basis function.
fn basis_products(f: &[f64], d: [f64; 3]) -> Vec<f64> {
    fn products<const C: usize>(f: &[f64], d: [f64; 3]) -> Vec<f64>
    where
        [f64; C]: Routines<f64>,
    {
        assert_eq!(f.len(), C, "coefficients of an order");
        let y = <[f64; C]>::basis(d);
        y.as_ref().iter().zip(f).map(|(y, f)| y * f).collect()
    }
    for_order!(f.len().isqrt(), C => products::<C>(f, d))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small light about a direction, on top of an even sky.
    fn sun(order: usize, sky: f64) -> Vec<f64> {
        let c = order * order;
        let ones = vec![1.0; c];
        let mut f = basis_products(&ones, [0.6, 0.64, 0.48]);
        f.truncate(c);
        f[0] += sky;
        f
    }

    #[test]
    fn both_ways_to_a_width_agree_on_a_small_light() {
        for order in 2..=6 {
            let (one, other) = (of_small_light(order), width(&sun(order, 0.0)));
            // Directions are sampled, the profile nearly not.
            assert!((one / other - 1.0).abs() < 0.02, "{order}: {one} {other}");
            assert!(one > 1.0 && one < 2.0 * order as f32, "{order}: {one}");
        }
    }

    #[test]
    fn a_brighter_sky_allows_a_wider_window_up_to_twice_the_order() {
        for order in 2..=6 {
            let widths = [0.0, 0.3, 1.0, 30.0].map(|sky| width(&sun(order, sky)));
            assert!(widths.is_sorted(), "{order}: {widths:?}");
            assert_eq!(widths[3], 2.0 * order as f32);
            assert!(widths[0] < widths[2]);
        }
    }

    #[test]
    fn the_width_keeps_the_limit_and_no_wider_one_does() {
        for order in 2..=6 {
            let f = sun(order, 0.1);
            let h = width(&f);
            let rings = |h: f32| {
                let values = directions().into_iter().map(|d| {
                    let parts = basis_products(&f, d).into_iter().enumerate();
                    parts
                        .map(|(i, x)| x * f64::from(gain(i.isqrt(), h)))
                        .sum::<f64>()
                });
                let values: Vec<f64> = values.collect();
                let high = values.iter().copied().fold(f64::MIN, f64::max);
                let low = values.iter().copied().fold(f64::MAX, f64::min);
                -low / high
            };
            assert!(
                rings(h) <= LIMIT + 1e-9 && rings(h * 1.02) > LIMIT,
                "{order}"
            );
        }
    }
}
