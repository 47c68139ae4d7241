//! What surface samples take, and how well they follow a mesh that bends:
//! `cargo run -p sh-bake --example surface -- fox.glb [spheres]`.
//!
//! First the points, their bytes, and the time for sampling on all cores. Then a row a clip: how far points are from the
//! mesh as it bends, over 25 frames, relative to the radius of their spheres: root mean square, all but 1 % of them, and
//! at most.

use glam::Vec3;
use sh_bake::{Figure, SphereSet, bake_surface, bind_spheres, grow_spheres, load_mesh};
use sh_scene::motion::{Motion, Pose, Rig};
use sh_scene::{Camera, EnvironmentMap, Mesh, Object, Scene, Settings, Sphere, SurfaceSamples};
use std::sync::Arc;
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("which mesh file?")?;
    let count = arguments.next().map_or(Ok(64), |n| n.parse())?;
    let model = load_mesh(file.as_ref())?;
    let meshes: Vec<&Mesh> = model.parts.iter().map(|part| &part.mesh).collect();
    let parts: Vec<_> = model.parts.iter().map(|p| (&p.mesh, &p.material)).collect();
    let spheres = SphereSet::fit(&meshes, count).spheres;
    let start = Instant::now();
    let surface = bake_surface(&parts, &spheres);
    let ms = start.elapsed().as_secs_f64() * 1e3;
    let most = (0..spheres.len()).map(|i| surface.of(i).len()).max();
    println!(
        "{} spheres, {} points ({} of a sphere at most), {} bytes, {ms:.0} ms",
        spheres.len(),
        surface.points.len(),
        most.unwrap_or(0),
        surface.bytes()
    );
    let Some(figure) = &model.figure else {
        return Ok(());
    };
    println!("{:<10} {:>8} {:>8} {:>8}", "clip", "rms", "99 %", "most");
    for number in 0..figure.clips.len() {
        let rig = rig(figure, number, &meshes, &spheres)?;
        let mut grown = spheres.clone();
        grow_spheres(&rig, &meshes, &mut grown)?;
        let surface = bake_surface(&parts, &grown);
        let body = |(i, part): (usize, &sh_bake::Part)| Object {
            name: part.name.clone(),
            mesh: part.mesh.clone(),
            material: part.material.clone(),
            spheres: if i == 0 { grown.clone() } else { Vec::new() },
            surface: if i == 0 {
                surface.clone()
            } else {
                SurfaceSamples::default()
            },
            ..Object::default()
        };
        let scene = Scene {
            punctual: Vec::new(),
            objects: model.parts.iter().enumerate().map(body).collect(),
            environment: EnvironmentMap::constant([1.0; 3]),
            lights: Vec::new(),
            ground: None,
            camera: Camera::framing(Vec3::ZERO, Vec3::ONE, Camera::FOV),
            settings: Settings::default(),
        };
        let name = rig.clip().name.clone();
        let [rms, nearly, most] = stray(rig, scene);
        println!(
            "{name:<10} {:>7.1}% {:>7.1}% {:>7.1}%",
            100.0 * rms,
            100.0 * nearly,
            100.0 * most
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
    let (bones, skins) = (figure.bones.clone(), figure.skins.clone());
    Ok(Rig::new(skeleton, bones, clip, skins, anchors)?)
}

/// How far points are from the surface, in radii: root mean square, 99th percentile, most.
fn stray(rig: Rig, mut scene: Scene) -> [f64; 3] {
    const FRAMES: u32 = 25;
    let duration = f64::from(rig.clip().duration());
    let mut motion = Motion::default();
    motion.add_rig(0, Arc::new(rig));
    motion.add_surfaces(&scene.objects);
    let mut all = Vec::new();
    for frame in 0..FRAMES {
        motion.pose(duration * f64::from(frame) / f64::from(FRAMES), &mut scene);
        let triangles: Vec<[Vec3; 3]> = scene
            .objects
            .iter()
            .flat_map(|o| {
                let corner = |i: u32| Vec3::from(o.mesh.positions[i as usize]);
                o.mesh.triangles.iter().map(move |t| t.map(corner))
            })
            .collect();
        let body = &scene.objects[0];
        for (i, sphere) in body.spheres.iter().enumerate() {
            for point in body.surface.of(i) {
                let p = Vec3::from(point.position);
                let away = |t: &[Vec3; 3]| p.distance(nearest(*t, p));
                let least = triangles.iter().map(away).fold(f32::INFINITY, f32::min);
                all.push(f64::from(least / sphere.radius));
            }
        }
    }
    all.sort_by(f64::total_cmp);
    let count = all.len().max(1) as f64;
    let rms = (all.iter().map(|a| a * a).sum::<f64>() / count).sqrt();
    let at = |part: f64| {
        all.get((part * (count - 1.0)) as usize)
            .copied()
            .unwrap_or(0.0)
    };
    [rms, at(0.99), at(1.0)]
}

/// The point of a triangle that is nearest to another: within, or on one of its edges.
fn nearest([a, b, c]: [Vec3; 3], p: Vec3) -> Vec3 {
    let normal = (b - a).cross(c - a);
    let inside = |a: Vec3, b: Vec3| (b - a).cross(p - a).dot(normal) >= 0.0;
    if inside(a, b) && inside(b, c) && inside(c, a) {
        return p - normal * ((p - a).dot(normal) / normal.length_squared());
    }
    let on = |a: Vec3, b: Vec3| {
        let edge = b - a;
        a + edge * ((p - a).dot(edge) / edge.length_squared()).clamp(0.0, 1.0)
    };
    let edges = [on(a, b), on(b, c), on(c, a)];
    let away = |q: &Vec3| q.distance_squared(p);
    let [x, y, z] = edges;
    let near = if away(&y) < away(&x) { y } else { x };
    if away(&z) < away(&near) { z } else { near }
}
