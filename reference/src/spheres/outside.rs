//! Volumes of a closed mesh and of what a ball has outside it, in closed form.
//!
//! As in section 6.2 of Ren et al. 2006 (after Wang et al. 2006) the volume is a sum over triangles. Along a ray
//! from the ball's centre, a ball of radius r has ∫₀ʳ w(t) t² dt inside, with w the winding number. Each crossing
//! at distance t, outward (+) or inward (−), changes that by ± min(t, r)³ / 3. So a triangle counts
//!
//! V = ± ∫ min(t(ω), r)³ / 3 dω over the directions ω in which it is seen.
//!
//! In the triangle's plane, at distance h from the centre with foot q, the ball cuts a disc of radius ρ = √(r² −
//! h²). Inside the disc t < r, and the integral is that of the pyramid over the area; outside it is r³ / 3 times
//! the solid angle. Both are sums over the triangle's edges, each edge with q a triangle of its own, in which
//! all integrals over the angle φ at q are elementary.

use super::Ball;
use crate::raycast::Triangle;
use crate::vec3::{Vec3, cross, dot, length, scale, sub};
use std::f64::consts::PI;

/// The volume inside a closed mesh, each point as often as its winding number says.
///
/// ```
/// use sh_reference::{raycast, spheres::outside};
/// let mesh = sh_bake::shapes::rounded_box(glam::Vec3::new(1.0, 2.0, 3.0), 0.0);
/// let volume = outside::volume(&raycast::triangles(&mesh));
/// assert!((volume - 6.0).abs() < 1e-12);
/// ```
pub fn volume(triangles: &[Triangle]) -> f64 {
    let origin = triangles.first().map_or([0.0; 3], |t| t[0]);
    triangles
        .iter()
        .map(|t| t.map(|p| sub(p, origin)))
        .map(|[a, b, c]| dot(a, cross(b, c)) / 6.0)
        .sum()
}

/// The volume of the ball that lies outside a closed mesh: exact to rounding where winding numbers are 0 or 1.
pub fn outside(ball: &Ball, triangles: &[Triangle]) -> f64 {
    if ball.radius <= 0.0 {
        return 0.0;
    }
    let inside: f64 = triangles.iter().map(|t| within(ball, t)).sum();
    4.0 / 3.0 * PI * ball.radius.powi(3) - inside
}

/// The winding number of a mesh about a point, not on the surface: how often the surface goes around it. A whole
/// number where the mesh is closed, the share of directions that see its back, less those that see its front,
/// where it is open (Jacobson, Kavan and Sorkine-Hornung 2013, "Robust inside-outside segmentation using
/// generalized winding numbers", equation 5; the solid angle of a triangle after van Oosterom and Strackee 1983).
pub fn winding(point: [f64; 3], triangles: &[Triangle]) -> f64 {
    let angle = |t: &Triangle| {
        let [a, b, c] = t.map(|p| sub(p, point));
        let [la, lb, lc] = [a, b, c].map(length);
        let lower = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
        dot(a, cross(b, c)).atan2(lower)
    };
    triangles.iter().map(angle).sum::<f64>() / (2.0 * PI)
}

/// What one triangle adds to the volume of the ball inside the mesh.
fn within(ball: &Ball, triangle: &Triangle) -> f64 {
    let [a, b, c] = triangle.map(|p| sub(p, ball.center));
    let across = cross(sub(b, a), sub(c, a));
    let double_area = length(across);
    if double_area == 0.0 {
        return 0.0;
    }
    let normal = scale(across, 1.0 / double_area);
    let height = dot(normal, a);
    let foot = scale(normal, height);
    let flat = [a, b, c].map(|p| sub(p, foot));
    let sum: f64 = [(0, 1), (1, 2), (2, 0)]
        .map(|(i, j)| edge(flat[i], flat[j], normal, height.abs(), ball.radius))
        .iter()
        .sum();
    sum * height.signum()
}

/// ∫ min(t, r)³ / 3 over the triangle between the foot (the origin) and an edge, signed by its turn about the
/// normal.
fn edge(from: Vec3, to: Vec3, normal: Vec3, height: f64, radius: f64) -> f64 {
    let along = sub(to, from);
    let long = length(along);
    let turn = dot(normal, cross(from, to));
    if long == 0.0 || turn == 0.0 || height == 0.0 {
        return 0.0;
    }
    // The edge's line, at distance d from the foot; s runs along it from the point nearest to the foot.
    let d = turn.abs() / long;
    let [first, last] = [from, to].map(|p| dot(p, along) / long);
    let angle = |s: f64| s.atan2(d);
    // ∫ h / t dφ, from which the solid angle is φ less this.
    let slant = |s: f64| (height * s).atan2(d * (height * height + d * d + s * s).sqrt());
    let disc_squared = (radius * radius - height * height).max(0.0);
    let pyramid = |s: [f64; 2]| height / 6.0 * d * (s[1] - s[0]);
    let beyond = |s: [f64; 2]| {
        let turned = angle(s[1]) - angle(s[0]);
        let solid = turned - (slant(s[1]) - slant(s[0]));
        let solid_of_disc = turned * (1.0 - height.min(radius) / radius);
        height / 6.0 * disc_squared * turned + radius.powi(3) / 3.0 * (solid - solid_of_disc)
    };
    // The part of the edge within the disc, if any.
    let half = (disc_squared - d * d).max(0.0).sqrt();
    let [enter, leave] = [-half, half].map(|s| s.clamp(first, last));
    turn.signum() * (beyond([first, enter]) + pyramid([enter, leave]) + beyond([leave, last]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raycast::triangles;
    use sh_bake::shapes;

    fn ball(center: Vec3, radius: f64) -> Ball {
        Ball { center, radius }
    }

    #[test]
    fn spheres_about_a_box_have_their_known_parts_outside() {
        let cube = triangles(&shapes::rounded_box(glam::Vec3::ONE, 0.0));
        let whole = |r: f64| 4.0 / 3.0 * PI * r.powi(3);
        let share = |b: &Ball| outside(b, &cube) / whole(b.radius);
        for (center, radius, expected) in [
            ([0.0; 3], 0.4, 0.0),
            ([9.0, 0.0, 0.0], 1.0, 1.0),
            ([0.5, 0.1, 0.0], 0.2, 0.5),
            ([0.5, 0.5, 0.1], 0.2, 0.75),
            ([0.5, 0.5, 0.5], 0.2, 0.875),
            ([0.1, 0.2, -0.3], 5.0, 1.0 - 1.0 / whole(5.0)),
        ] {
            let found = share(&ball(center, radius));
            assert!(
                (found - expected).abs() < 1e-12,
                "{center:?}: {found} for {expected}"
            );
        }
        // A cap of height 0.1 stands out of one face.
        let cap = PI * 0.01 * (3.0 * 0.3 - 0.1) / 3.0;
        let found = outside(&ball([0.3, 0.0, 0.05], 0.3), &cube);
        assert!((found - cap).abs() < 1e-12, "{found} for {cap}");
    }

    #[test]
    fn the_sum_agrees_with_counting_points() {
        let knot = triangles(&shapes::torus_knot(2, 3, 1.0, 0.4, 0.15));
        let b = ball([0.9, 0.1, 0.3], 0.6);
        let (mut inside, mut all) = (0, 0);
        let steps = 24;
        for k in 0..steps * steps * steps {
            let at = [k % steps, k / steps % steps, k / steps / steps];
            let offset =
                at.map(|i| (2.0 * (f64::from(i) + 0.5) / f64::from(steps) - 1.0) * b.radius);
            if length(offset) < b.radius {
                all += 1;
                let p = crate::vec3::add(b.center, offset);
                inside += usize::from(winding(p, &knot) > 0.5);
            }
        }
        let expected = 1.0 - inside as f64 / f64::from(all);
        let found = outside(&b, &knot) / (4.0 / 3.0 * PI * b.radius.powi(3));
        assert!((found - expected).abs() < 0.01, "{found} for {expected}");
    }

    #[test]
    fn winding_numbers_are_whole_where_the_mesh_is_closed_and_shares_where_it_is_not() {
        let mut cube = triangles(&shapes::rounded_box(glam::Vec3::ONE, 0.0));
        assert!((winding([0.1, 0.2, 0.3], &cube) - 1.0).abs() < 1e-14);
        assert!(winding([0.1, 0.2, 0.8], &cube).abs() < 1e-14);
        cube.retain(|t| t.iter().any(|p| p[1] < 0.0));
        assert!((winding([0.0; 3], &cube) - 5.0 / 6.0).abs() < 1e-14);
    }
}
