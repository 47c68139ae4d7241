//! Weights of blocker spheres: what the logarithm of each is multiplied with.
//!
//! The log visibilities of a body's overlapping spheres add up, though each direction is hidden only once, and bounding
//! spheres hide more than the mesh. So each sphere gets one number, found once, with which the *sum* does to light what the
//! *mesh* does: least squares on the transfer vectors (`sh_core::Routines::transfer`) of receivers on the ground, in the open
//! and on the body itself, against rays. At run time a weight costs nothing: blockers of a cut carry ratio vectors already.
//!
//! One set serves all orders; it is found at order 4. docs/SPHERES.md has figures.

mod places;

mod solve;

pub(crate) use solve::{log, transfer};

use crate::rays::Rays;
use glam::DVec3;
use places::Place;
use sh_scene::{Mesh, Sphere};
use solve::Receiver;

/// Changes whenever the same body may get other weights than before: those that were kept are then of no use.
pub(crate) const WEIGHTS_VERSION: u32 = 2;

/// How much each sphere of a body counts as a blocker.
pub(crate) struct Weights(pub(crate) Vec<f32>);

/// A body in one of its poses.
pub(crate) struct Pose {
    pub(crate) meshes: Vec<Mesh>,
    pub(crate) spheres: Vec<Sphere>,
}

/// Weights for the spheres that block light in the place of `meshes`, all in one space, in which `up` is up: not below 0,
/// one a sphere. Takes about half a second for 64 spheres on two cores; the same input gives the same weights, whatever the
/// number of threads. Of more than 512 spheres neighbours share a weight. Meshes without triangles, and no spheres, give
/// weights of 1.
///
/// ```
/// use sh_bake::{shapes, weights};
/// use sh_scene::Sphere;
/// let ball = Sphere { center: [0.0; 3], radius: 1.0 };
/// // The same ball twice hides what one does.
/// let found = weights(&[&shapes::ball(1.0, 3)], &[ball, ball], [0.0, 1.0, 0.0]);
/// assert!(found.iter().all(|w| (0.35..0.65).contains(w)), "{found:?}");
/// ```
pub fn weights(meshes: &[&Mesh], spheres: &[Sphere], up: [f32; 3]) -> Vec<f32> {
    let pose = Pose {
        meshes: meshes.iter().map(|mesh| (*mesh).clone()).collect(),
        spheres: spheres.to_vec(),
    };
    of_poses(&[pose], DVec3::from(up.map(f64::from)))
}

/// Weights for spheres of a body that only its owner can look at: `blocked` says whether it blocks the ray from a point in a
/// direction, a unit vector. `center` and `radius` are those of a ball around the body, which stands on the ground where that
/// is lowest along `up`. `surface` are points of its own with unit normals that receive light, slightly above it; there may be
/// none.
///
/// ```
/// use sh_bake::weights_by;
/// use sh_scene::Sphere;
/// let ball = Sphere { center: [0.0; 3], radius: 1.0 };
/// // A body that is not there is not to be seen in its spheres.
/// let found = weights_by(&[ball], ball, [0.0, 1.0, 0.0], &[], &|_, _| false);
/// assert!(found[0] < 0.05);
/// ```
pub fn weights_by(
    spheres: &[Sphere],
    around: Sphere,
    up: [f32; 3],
    surface: &[([f32; 3], [f32; 3])],
    blocked: &(dyn Fn([f32; 3], [f32; 3]) -> bool + Sync),
) -> Vec<f32> {
    let wide = |v: [f32; 3]| DVec3::from(v.map(f64::from));
    let (center, radius) = (wide(around.center), f64::from(around.radius));
    let up = wide(up);
    let mut places = places::around(center, radius, |_| -radius, up);
    places.extend(surface.iter().map(|(position, normal)| Place {
        position: wide(*position),
        normal: wide(*normal),
        own: true,
    }));
    let blocks = |from: DVec3, way: DVec3| blocked(from.as_vec3().into(), way.as_vec3().into());
    solve::solve(&receivers(&places, spheres, &blocks), spheres)
}

/// Weights that serve a body in all of these poses, which have the same spheres in other places.
pub(crate) fn of_poses(poses: &[Pose], up: DVec3) -> Vec<f32> {
    let spheres = poses.first().map_or(&[][..], |pose| &pose.spheres);
    let mut all = Vec::new();
    for (i, pose) in poses.iter().enumerate() {
        let Some(rays) = Rays::new(&pose.meshes) else {
            continue;
        };
        let mut places = places::around(rays.center, rays.radius, |d| rays.lowest(d), up);
        places.extend(places::on(&pose.meshes, rays.radius));
        // Of several poses each has its share of the places.
        let own = places
            .into_iter()
            .skip(i)
            .step_by(poses.len())
            .collect::<Vec<_>>();
        all.extend(receivers(&own, &pose.spheres, &|from, way| {
            rays.meet(from, way)
        }));
    }
    solve::solve(&all, spheres)
}

/// What each place gets of light with the body there, and what its spheres do there.
fn receivers(
    places: &[Place],
    spheres: &[Sphere],
    blocked: &(dyn Fn(DVec3, DVec3) -> bool + Sync),
) -> Vec<Receiver> {
    use rayon::prelude::*;
    let of = |(i, place): (usize, &Place)| Receiver::new(i, place, spheres, blocked);
    places.par_iter().enumerate().filter_map(of).collect()
}
