//! How well spheres follow a mesh that bends: `cargo run -p sh-bake --example follow -- fox.glb [spheres]`.
//!
//! A row a clip: how far vertices come out of the spheres as fitted, at most and (their root mean square over all
//! frames), relative to the mesh's longest side; what the spheres' volume grows by until none does; how far out
//! vertices are then, in frames between those that were looked at; and how long that took.

use sh_bake::{Figure, SphereSet, bind_spheres, grow_spheres, load_mesh};
use sh_scene::motion::{Pose, Rig};
use sh_scene::{Mesh, Sphere};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("which mesh file?")?;
    let count = arguments.next().map_or(Ok(64), |n| n.parse())?;
    let model = load_mesh(file.as_ref())?;
    let figure = model.figure.as_ref().ok_or("the file has no clips")?;
    let meshes: Vec<&Mesh> = model.parts.iter().map(|part| &part.mesh).collect();
    let spheres = SphereSet::fit(&meshes, count).spheres;
    println!(
        "{:<10} {:>10} {:>10} {:>10} {:>10} {:>8}",
        "clip", "outside", "mean", "volume", "then", "ms"
    );
    for number in 0..figure.clips.len() {
        let start = Instant::now();
        let rig = rig(figure, number, &meshes, &spheres)?;
        let before = outside(&rig, &meshes, &spheres);
        let mut grown = spheres.clone();
        grow_spheres(&rig, &meshes, &mut grown)?;
        let after = outside(&rig, &meshes, &grown);
        let volume = |spheres: &[Sphere]| spheres.iter().map(|s| s.radius.powi(3)).sum::<f32>();
        println!(
            "{:<10} {:>9.3}% {:>9.4}% {:>9.1}% {:>9.4}% {:>8.0}",
            rig.clip().name,
            100.0 * before.0,
            100.0 * before.1,
            100.0 * (volume(&grown) / volume(&spheres) - 1.0),
            100.0 * after.0,
            start.elapsed().as_secs_f64() * 1e3
        );
    }
    Ok(())
}

fn rig(
    figure: &Figure,
    clip: usize,
    meshes: &[&Mesh],
    spheres: &[Sphere],
) -> Result<Rig, Box<dyn std::error::Error>> {
    let mut still = Pose::default();
    still.set(&figure.skeleton, &figure.bones, None);
    let anchors = bind_spheres(meshes, &figure.skins, still.bones(), spheres);
    let (skeleton, clip) = (figure.skeleton.clone(), figure.clips[clip].clone());
    Ok(Rig::new(
        skeleton,
        figure.bones.clone(),
        clip,
        figure.skins.clone(),
        anchors,
    )?)
}

/// How far vertices are outside all spheres over 101 frames of the clip, at most and root mean square, relative
/// to the longest side of the mesh's bounding box.
fn outside(rig: &Rig, meshes: &[&Mesh], spheres: &[Sphere]) -> (f64, f64) {
    let all = meshes.iter().flat_map(|mesh| &mesh.positions);
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in all {
        for k in 0..3 {
            low[k] = low[k].min(p[k]);
            high[k] = high[k].max(p[k]);
        }
    }
    let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f32::max);
    let (mut pose, mut spheres) = (Pose::default(), spheres.to_vec());
    let mut meshes: Vec<Mesh> = meshes.iter().map(|mesh| (*mesh).clone()).collect();
    let (mut most, mut sum, mut count) = (0.0_f64, 0.0, 0);
    for frame in 0..101 {
        rig.set(
            f64::from(rig.clip().duration()) * f64::from(frame) / 101.0,
            &mut pose,
        );
        rig.anchors().pose(pose.bones(), &mut spheres);
        for (skin, mesh) in rig.skins().iter().zip(&mut meshes) {
            skin.pose(pose.bones(), mesh);
            for p in &mesh.positions {
                let depth = spheres.iter().map(|s| {
                    let d: f32 = (0..3).map(|k| (p[k] - s.center[k]).powi(2)).sum();
                    d.sqrt() - s.radius
                });
                let out = f64::from(depth.fold(f32::INFINITY, f32::min).max(0.0) / size);
                most = most.max(out);
                sum += out * out;
                count += 1;
            }
        }
    }
    (most, (sum / f64::from(count)).sqrt())
}
