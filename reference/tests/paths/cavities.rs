//! Inside a sphere every point sees every other alike: the factor between two pieces is their area over the whole.

use super::{assert_near, bounces, dark, even, flatness, lamp, object, trace};
use glam::Vec3;
use sh_bake::shapes;
use sh_scene::AreaShape;

/// A receiver on the inner side of a ball of radius 1, just off its triangles.
fn wall(direction: Vec3, depth: f64) -> ([f64; 3], [f64; 3]) {
    let d = direction.normalize().as_dvec3();
    ((d * (1.0 - 2.0 * depth)).to_array(), (-d).to_array())
}

/// A lamp in the middle of a closed sphere gives L r² everywhere on its wall, and the k-th bounce a^k of that:
/// together (1 − aⁿ⁺¹)/(1 − a).
#[test]
fn a_lamp_in_a_sphere_is_a_geometric_sum() {
    let ball = shapes::ball(1.0, 5);
    let depth = flatness(&ball);
    let (point, normal) = wall(Vec3::new(0.3, -0.8, 0.4), depth);
    let albedo = [0.9_f32, 0.5, 0.2];
    let mut room = dark();
    let (center, radius) = (Vec3::ZERO, 0.3);
    room.lights = vec![lamp(AreaShape::Local { center, radius }, [5.0; 3])];
    room.objects = vec![object(ball, albedo, Vec3::ZERO)];
    let direct = 5.0 * 0.3_f64.powi(2);
    for count in [0, 1, 2, 8] {
        let seen = trace(&room, bounces(count), point, normal);
        // Distances to the wall are short by up to three times the depth of its triangles, light is more by twice that.
        let scene_error = 6.0 * depth;
        assert_near(
            seen.direct,
            seen.direct_error,
            [direct; 3],
            scene_error * direct,
            2e-3,
        );
        let sum = albedo.map(f64::from).map(|a| {
            let bounced = |k: u32| a.powi(k as i32);
            direct * (1..=count).map(bounced).sum::<f64>()
        });
        let most = sum[0].max(direct);
        let scene_error = f64::from(count + 1) * scene_error * most;
        assert_near(
            seen.indirect,
            seen.indirect_error,
            sum,
            scene_error,
            1e-2 * most,
        );
    }
}

/// A sphere with a round hole under an even sky. The hole is a share f of the sphere's area, and every point of the
/// wall sees the sky through it by that factor: f Σ (a (1 − f))^k. White walls end at 1, however small the hole.
#[test]
fn a_sphere_with_a_hole_ends_at_its_closed_form() {
    let mut ball = shapes::ball(1.0, 6);
    let depth = flatness(&ball);
    let height = |t: &[u32; 3]| t.map(|i| ball.positions[i as usize][1]).iter().sum::<f32>() / 3.0;
    let before = ball.triangles.len();
    let kept: Vec<[u32; 3]> = ball
        .triangles
        .iter()
        .copied()
        .filter(|t| height(t) < 0.5)
        .collect();
    // The rim runs along triangles: the hole's share by their solid angles, which are equal within a per cent or two.
    let solid = |triangles: &[[u32; 3]]| {
        let corner = |i: u32| Vec3::from(ball.positions[i as usize]).as_dvec3();
        triangles
            .iter()
            .map(|t| {
                // Van Oosterom and Strackee 1983.
                let [a, b, c] = t.map(corner);
                2.0 * a
                    .cross(b)
                    .dot(c)
                    .abs()
                    .atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
            })
            .sum::<f64>()
    };
    let whole = solid(&ball.triangles);
    assert!((whole / (4.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
    let hole = 1.0 - solid(&kept) / whole;
    assert!((0.24..0.26).contains(&hole) && kept.len() < before);
    ball.triangles = kept;

    for albedo in [1.0_f32, 0.6] {
        let mut cavity = even();
        cavity.objects = vec![object(ball.clone(), [albedo; 3], Vec3::ZERO)];
        for direction in [Vec3::NEG_Y, Vec3::new(1.0, 0.1, 0.3)] {
            let (point, normal) = wall(direction, depth);
            let count = 40;
            let seen = trace(&cavity, bounces(count), point, normal);
            // The corners of the rim's triangles and the depth of all of them.
            let scene_error = 8.0 * depth;
            assert_near(seen.direct, seen.direct_error, [hole; 3], scene_error, 3e-3);
            let step = f64::from(albedo) * (1.0 - hole);
            let sum = hole * (1.0 - step.powi(count as i32 + 1)) / (1.0 - step);
            let error = std::array::from_fn(|c| seen.direct_error[c] + seen.indirect_error[c]);
            assert_near(
                seen.total(),
                error,
                [sum; 3],
                scene_error / (1.0 - step),
                6e-3,
            );
        }
    }
}
