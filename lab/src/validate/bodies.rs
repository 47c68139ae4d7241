//! Bodies of the scenes: meshes by code, with spheres fitted to them and their surface sampled.

use crate::meshes::finer;
use glam::{Affine3A, Quat, Vec3};
use sh_bake::shapes::{self, Bend, Limb};
use sh_bake::{SphereSet, bake_surface, weights};
use sh_scene::{Material, Mesh, Object};
use std::f32::consts::FRAC_PI_2;

/// A body of at most so many spheres, its lowest point at a height above the ground and the rest of its place as given.
pub(super) fn body(
    name: &str,
    mesh: Mesh,
    count: usize,
    albedo: [f32; 3],
    turn: Quat,
    place: Vec3,
) -> Object {
    let spheres = SphereSet::fit(&[&mesh], count).spheres;
    let material = Material::diffuse(albedo);
    let surface = bake_surface(&[(&mesh, &material)], &spheres);
    let up = turn.inverse() * Vec3::Y;
    let weights = weights(&[&mesh], &spheres, up.into());
    let object = Object {
        name: name.into(),
        mesh,
        material,
        transform: Affine3A::from_quat(turn),
        spheres,
        weights,
        surface,
        ..Object::default()
    };
    stood(object, place)
}

/// The object with its lowest point at the height of `place`.
pub(super) fn stood(mut object: Object, place: Vec3) -> Object {
    object.transform.translation = Vec3::ZERO.into();
    let lowest = object.bounds().map_or(0.0, |[low, _]| low.y);
    object.transform.translation = (place - Vec3::Y * lowest).into();
    object
}

/// A body bent as a soft deformation (section 7.1): each vertex by itself; each sphere with its samples rigidly, by the
/// rotation and the translation at its centre, which are about the averages of what is around it.
pub(super) fn bent(mut object: Object, bend: Bend) -> Object {
    for (p, n) in object
        .mesh
        .positions
        .iter_mut()
        .zip(&mut object.mesh.normals)
    {
        *n = (bend.turn(p[1]) * Vec3::from(*n)).to_array();
        *p = bend.place((*p).into()).to_array();
    }
    let surface = &mut object.surface;
    for (i, sphere) in object.spheres.iter_mut().enumerate() {
        let center = Vec3::from(sphere.center);
        let (turn, moved) = (bend.turn(center.y), bend.place(center));
        sphere.center = moved.to_array();
        let [start, end] = [i, i + 1].map(|k| surface.starts[k] as usize);
        for point in &mut surface.points[start..end] {
            point.position = (moved + turn * (Vec3::from(point.position) - center)).to_array();
            point.normal = (turn * Vec3::from(point.normal)).to_array();
        }
        surface.rotations[i] = (turn * Quat::from_array(surface.rotations[i])).to_array();
    }
    object
}

/// Length and radius of the cylinder that is bent, in metres.
const CYLINDER: [f32; 2] = [2.4, 0.2];

/// How the cylinder is bent by an angle.
pub(super) fn bend(angle: f32) -> Bend {
    Bend {
        length: CYLINDER[0],
        angle,
    }
}

/// A cylinder that stands along +Y, cut finely enough to be bent.
pub(super) fn cylinder() -> Mesh {
    let [length, radius] = CYLINDER;
    let mesh = shapes::cylinder(radius, length);
    finer(mesh, |a, b| (a.y - b.y).abs(), length / 40.0)
}

/// How the bent cylinder lies: an arch with its ends down.
pub(super) fn arch() -> Quat {
    Quat::from_rotation_y(0.35) * Quat::from_rotation_z(-FRAC_PI_2)
}

/// A sitting squirrel, 1.2 m high, that looks towards +X.
pub(super) fn squirrel() -> Mesh {
    let mut limbs = vec![
        Limb::new([[-0.05, 0.38, 0.0], [0.1, 0.62, 0.0]], [0.26, 0.19]),
        Limb::new([[0.2, 0.88, 0.0], [0.34, 0.84, 0.0]], [0.17, 0.09]),
        Limb::new([[0.12, 0.62, 0.0], [0.18, 0.8, 0.0]], [0.15, 0.12]),
    ];
    for side in [-1.0, 1.0] {
        limbs.extend([
            Limb::new([[-0.08, 0.2, 0.15 * side]; 2], [0.2; 2]),
            Limb::new(
                [[-0.05, 0.07, 0.18 * side], [0.25, 0.06, 0.2 * side]],
                [0.07, 0.06],
            ),
            Limb::new(
                [[0.16, 0.98, 0.08 * side], [0.12, 1.12, 0.11 * side]],
                [0.055, 0.035],
            ),
            Limb::new(
                [[0.15, 0.62, 0.14 * side], [0.38, 0.54, 0.07 * side]],
                [0.075, 0.05],
            ),
        ]);
    }
    let tail = [
        ([-0.24, 0.14, 0.0], 0.09),
        ([-0.48, 0.28, 0.0], 0.14),
        ([-0.58, 0.62, 0.0], 0.18),
        ([-0.5, 0.95, 0.0], 0.17),
        ([-0.66, 1.14, 0.0], 0.09),
    ];
    let links = tail.windows(2);
    limbs.extend(links.map(|link| Limb::new([link[0].0, link[1].0], [link[0].1, link[1].1])));
    shapes::merged(&limbs, 0.02, 0.05)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_closed_and_bending_takes_spheres_along() {
        assert!(sh_bake::is_closed(&[&squirrel()]) && sh_bake::is_closed(&[&cylinder()]));
        let straight = body("c", cylinder(), 8, [0.5; 3], Quat::IDENTITY, Vec3::ZERO);
        let bent = bent(straight.clone(), bend(1.5));
        // A point keeps its distance from its sphere's centre, and the bend's middle stays.
        for (i, (before, after)) in straight.spheres.iter().zip(&bent.spheres).enumerate() {
            let pairs = straight.surface.of(i).iter().zip(bent.surface.of(i));
            for (p, q) in pairs {
                let from = Vec3::from(p.position).distance(before.center.into());
                let to = Vec3::from(q.position).distance(after.center.into());
                assert!((from - to).abs() < 1e-5);
            }
        }
    }
}
