//! What samples are worth as a light.

use super::*;
use crate::shapes;
use sh_core::{Sh, Sh4d};
use sh_scene::Texture;
use sh_scene::surface::cell_sums;

fn sphere(center: [f32; 3], radius: f32) -> Sphere {
    Sphere { center, radius }
}

/// A checkered texture over a mesh, seen from +Z, `fields` across a length of 2.
fn checkered(mesh: &mut Mesh, fields: f32) -> Material {
    mesh.uvs = mesh
        .positions
        .iter()
        .map(|p| [p[0] * fields / 4.0, p[1] * fields / 4.0])
        .collect();
    const TEXELS: u32 = 64;
    let texel = |i: u32| {
        let (x, y) = (i % TEXELS < TEXELS / 2, i / TEXELS < TEXELS / 2);
        if x == y {
            [240, 240, 240, 255]
        } else {
            [60, 60, 60, 255]
        }
    };
    let rgba = (0..TEXELS * TEXELS).flat_map(texel).collect();
    let texture = Some(Texture {
        width: TEXELS,
        height: TEXELS,
        rgba,
    });
    Material {
        texture,
        ..Material::default()
    }
}

/// How far the emission of order 4 misses that of many rays, each lit for itself: with mean albedo in each cell, and
/// with the paper's product of vectors; root mean square over all of a body's spheres and some lights, relative to the
/// truth's.
fn misses(mesh: &Mesh, material: &Material, spheres: &[Sphere]) -> [f64; 2] {
    let parts = [(mesh, material)];
    let body = Body::new(&parts, spheres);
    let samples = bake_surface(&parts, spheres);
    let (mut all, mut ours, mut papers) = (0.0, 0.0, 0.0);
    for sun in [
        Vec3::X,
        Vec3::new(0.3, 0.9, 0.3),
        Vec3::new(-0.5, -0.2, 0.8),
        Vec3::NEG_Z,
    ] {
        let light = |normal: Vec3| f64::from(normal.dot(sun.normalize()).max(0.0) + 0.1);
        for i in 0..spheres.len() {
            let mut seat = body.seat(i).unwrap();
            let (mut truth, mut albedo) = (Sh4d::default(), Sh4d::default());
            let rays = 2 * 128 * 256;
            for d in stratified(128, 256) {
                let d = d.as_dvec3().normalize();
                if let Seen::Surface(crossing) = seat.seen(d) {
                    let share = 4.0 * std::f64::consts::PI / rays as f64;
                    let y =
                        Sh4d::basis(d) * (share * f64::from(paint::albedo(&parts[0], &crossing).x));
                    albedo += y;
                    truth += y * light(paint::normal(&parts[0], &crossing, d).as_vec3());
                }
            }
            let (mut emission, mut radiance) = (Sh4d::default(), Sh4d::default());
            for point in samples.of(i) {
                let cell = &cell_sums()[point.direction as usize];
                let y = Sh(std::array::from_fn(|k| f64::from(cell[k])));
                let y = y * light(point.normal.into());
                radiance += y;
                emission += y * f64::from(point.reflectance(false)[0]);
            }
            all += truth.norm().powi(2);
            ours += (emission - truth).norm().powi(2);
            papers += (radiance.product(&albedo) - truth).norm().powi(2);
        }
    }
    [ours, papers].map(|miss: f64| (miss / all).sqrt())
}

#[test]
fn mean_albedo_in_each_cell_is_truer_than_a_product_of_vectors() {
    let mut ball = shapes::ball(1.0, 5);
    let checks = checkered(&mut ball, 5.0);
    let [ours, papers] = misses(&ball, &checks, &[sphere([0.0; 3], 1.0)]);
    println!("ball: ours {ours:.4}, the paper's {papers:.4}");
    assert!(ours < 0.02 && papers > 2.0 * ours, "{ours} {papers}");

    let mut capsule = shapes::capsule(1.0, 2.0);
    let checks = checkered(&mut capsule, 5.0);
    let spheres = [sphere([0.0, 1.0, 0.0], 1.5), sphere([0.0, -1.0, 0.0], 1.5)];
    let [ours, papers] = misses(&capsule, &checks, &spheres);
    println!("capsule: ours {ours:.4}, the paper's {papers:.4}");
    assert!(ours < 0.04 && papers > 2.0 * ours, "{ours} {papers}");
}
