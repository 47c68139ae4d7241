//! The little vector algebra the other modules need, in f64.

pub(crate) type Vec3 = [f64; 3];

pub(crate) fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scale(a: Vec3, k: f64) -> Vec3 {
    [a[0] * k, a[1] * k, a[2] * k]
}

pub(crate) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(crate) fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

pub(crate) fn normalize(a: Vec3) -> Vec3 {
    scale(a, 1.0 / length(a))
}

pub(crate) fn widen(a: [f32; 3]) -> Vec3 {
    a.map(f64::from)
}

/// Angle between two unit vectors; exact to rounding near 0 and π too, where an arc cosine is not.
pub(crate) fn angle(a: Vec3, b: Vec3) -> f64 {
    length(cross(a, b)).atan2(dot(a, b))
}

/// Two unit vectors `u`, `v` such that `u`, `v`, `axis` are orthonormal and right-handed.
pub(crate) fn frame(axis: Vec3) -> [Vec3; 2] {
    let aside = if axis[0].abs() < 0.6 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    let u = normalize(cross(aside, axis));
    [u, cross(axis, u)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_orthonormal_and_right_handed() {
        for axis in crate::testing::directions(50) {
            let [u, v] = frame(axis);
            assert!(
                dot(u, v).abs() < 1e-15 && dot(u, axis).abs() < 1e-15 && dot(v, axis).abs() < 1e-15
            );
            assert!((length(u) - 1.0).abs() < 1e-15 && length(sub(cross(u, v), axis)) < 1e-15);
        }
    }

    #[test]
    fn angle_is_right_where_an_arc_cosine_is_not() {
        let tilt: f64 = 1e-9;
        let tilted = [tilt.sin(), 0.0, tilt.cos()];
        assert!((angle([0.0, 0.0, 1.0], tilted) - tilt).abs() < 1e-24);
    }
}
