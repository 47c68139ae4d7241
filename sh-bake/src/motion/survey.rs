//! What a motion shows before the first frame: whether it stays within bounds, how far it reaches, and how much
//! larger spheres have to be to hold a mesh that bends.

use crate::spheres::proof::{self, Ball};
use glam::{DVec3, Vec3};
use sh_scene::motion::{Motion, Pose, Rig};
use sh_scene::{Mesh, Scene, Sphere};

/// Frames of a clip that are looked at.
const FRAMES: usize = 48;
/// Coordinates beyond this leave what `f32` can square.
const FARTHEST: f32 = 1e9;

/// Grows spheres until they hold the meshes of a rig in every one of 48 frames of its clip: a radius that
/// bounds the mesh at rest is too small where it bends (Ren et al. 2006 keep it). Triangles are held as wholes,
/// but for gaps smaller than 1/500 of the mesh. `meshes` has one for each skin; of the spheres only the radii
/// change.
///
/// # Errors
/// A sentence, where the clip takes a vertex out of what can be computed with.
pub fn grow_spheres(rig: &Rig, meshes: &[&Mesh], spheres: &mut [Sphere]) -> Result<(), String> {
    let (points, triangles) = crate::spheres::joined(meshes);
    let size = crate::spheres::extent(&points, &triangles);
    let mut meshes: Vec<Mesh> = meshes.iter().map(|mesh| (*mesh).clone()).collect();
    let (mut pose, mut moved) = (Pose::default(), spheres.to_vec());
    for frame in 0..FRAMES {
        let seconds = f64::from(rig.clip().duration()) * frame as f64 / FRAMES as f64;
        rig.set(seconds, &mut pose);
        rig.anchors().pose(pose.bones(), &mut moved);
        let ball = |(moved, sphere): (&Sphere, &Sphere)| Ball {
            center: DVec3::from(moved.center.map(f64::from)),
            radius: f64::from(sphere.radius),
        };
        let mut balls: Vec<Ball> = moved.iter().zip(&*spheres).map(ball).collect();
        for (skin, mesh) in rig.skins().iter().zip(&mut meshes) {
            skin.pose(pose.bones(), mesh);
            for t in &mesh.triangles {
                let corners = t.map(|i| mesh.positions[i as usize]);
                let mut coordinates = corners.as_flattened().iter();
                if let Some(far) = coordinates.find(|c| !c.is_finite() || c.abs() > FARTHEST) {
                    return Err(format!(
                        "the clip takes a vertex to the coordinate {far} at {seconds:.3} seconds, and \
                         coordinates have to be finite and within ±{FARTHEST:e}."
                    ));
                }
                let corners = corners.map(|p| DVec3::from(p.map(f64::from)));
                proof::ensure(&mut balls, corners, 2e-3 * size);
            }
        }
        for (sphere, ball) in spheres.iter_mut().zip(&balls) {
            if ball.radius > f64::from(sphere.radius) {
                sphere.radius = (ball.radius * (1.0 + 1e-6) + 1e-6 * size) as f32;
            }
        }
    }
    Ok(())
}

/// The lowest and the highest corner of all that the scene's objects pass through, and the scene as it is at
/// time 0.
pub(crate) fn reach(motion: &mut Motion, scene: &mut Scene) -> Option<[Vec3; 2]> {
    let mut reach: Option<[Vec3; 2]> = None;
    // Where only the sky turns there is nothing to see.
    let frames = if motion.period() > 0.0 { FRAMES } else { 1 };
    for frame in (0..frames).rev() {
        let seconds = motion.period() * frame as f64 / FRAMES as f64;
        motion.pose(seconds, scene);
        let seen = scene.bounds();
        reach = match (reach, seen) {
            (Some([a, b]), Some([c, d])) => Some([a.min(c), b.max(d)]),
            (reach, seen) => reach.or(seen),
        };
    }
    reach
}
