//! How much of a patch its own body leaves to be seen, by direction.

use glam::DVec3;
use sh_scene::basis::Escape;

/// A ray from a sample of the patch.
pub(super) struct Ray {
    pub direction: DVec3,
    /// Whether it meets the body.
    pub meets: bool,
}

/// Terms of a quadratic function of a direction, the constant among them.
const TERMS: usize = 9;

/// How much dearer it is to change with the direction than rays are, over their number: where few of them tell, the mean
/// stands.
const STIFF: f64 = 1e-3;

/// The quadratic function that is nearest to what rays find, which go out as the cosine has it.
pub(super) fn hidden<'a>(rays: impl Iterator<Item = &'a Ray>) -> Escape {
    let mut square = [[0.0; TERMS + 1]; TERMS];
    let mut count = 0.0;
    let mut any = false;
    for ray in rays {
        let terms = terms(ray.direction);
        let seen = f64::from(u8::from(!ray.meets));
        any |= ray.meets;
        count += 1.0;
        for (row, a) in square.iter_mut().zip(terms) {
            for (x, b) in row.iter_mut().zip(terms.into_iter().chain([seen])) {
                *x += a * b;
            }
        }
    }
    if !any {
        return Escape::OPEN;
    }
    for (i, row) in square.iter_mut().enumerate().skip(1) {
        row[i] += STIFF * count;
    }
    // Gauss without pivots: the matrix is positive by what was added.
    for i in 0..TERMS {
        let row = square[i];
        for (j, other) in square.iter_mut().enumerate() {
            if j != i && row[i] > 0.0 {
                let factor = other[i] / row[i];
                for (x, own) in other.iter_mut().zip(row) {
                    *x -= factor * own;
                }
            }
        }
    }
    let c: [f32; TERMS] = std::array::from_fn(|i| {
        let value = square[i][TERMS] / square[i][i];
        if value.is_finite() { value as f32 } else { 0.0 }
    });
    let [even, x, y, z, xy, yz, zx, xx_zz, yy_zz] = c;
    Escape {
        linear: [x, y, z],
        // 1 is x² + y² + z², each mixed term stands twice.
        square: [
            even + xx_zz,
            even + yy_zz,
            even - xx_zz - yy_zz,
            0.5 * xy,
            0.5 * yz,
            0.5 * zx,
        ],
    }
}

fn terms(u: DVec3) -> [f64; TERMS] {
    let DVec3 { x, y, z } = u;
    [
        1.0,
        x,
        y,
        z,
        x * y,
        y * z,
        z * x,
        x * x - z * z,
        y * y - z * z,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::samples::even;

    fn found(blocked: impl Fn(DVec3) -> bool) -> Escape {
        let rays = (0..4000).map(|k| even(k, 4000, 0.0));
        let rays: Vec<Ray> = rays
            .map(|direction| Ray {
                direction,
                meets: blocked(direction),
            })
            .collect();
        hidden(rays.iter())
    }

    #[test]
    fn what_is_hidden_on_one_side_is_dark_from_there() {
        assert_eq!(found(|_| false), Escape::OPEN);
        let wall = found(|u| u.x > 0.0);
        let at = |x: f32| wall.seen([x, (1.0 - x * x).sqrt(), 0.0]);
        assert!(
            at(0.8) < 0.15 && at(-0.8) > 0.85,
            "{} {}",
            at(0.8),
            at(-0.8)
        );
        assert!((at(0.0) - 0.5).abs() < 0.1, "{}", at(0.0));
        let cavity = found(|_| true);
        assert!(cavity.seen([0.0, 1.0, 0.0]) < 0.01 && cavity.seen([0.6, 0.8, 0.0]) < 0.01);
    }
}
