use super::*;
use crate::shapes;
use glam::{Vec3, vec3};
use sh_core::Routines;
use sh_scene::Texture;

const WHITE: Material = Material {
    albedo: [1.0; 3],
    texture: None::<Texture>,
};

fn bake(mesh: &Mesh, count: usize) -> IrradianceBasis {
    IrradianceBasis::bake(&[(mesh, &WHITE)], count, &|_| {}).expect("it has triangles")
}

/// A box of which only the inside is there.
fn room() -> Mesh {
    let mut room = shapes::rounded_box(vec3(1.0, 0.7, 1.3), 0.02);
    for normal in &mut room.normals {
        *normal = normal.map(|n| -n);
    }
    for triangle in &mut room.triangles {
        triangle.swap(1, 2);
    }
    room
}

#[test]
fn functions_are_at_right_angles_and_the_first_is_even() {
    for mesh in [
        shapes::torus_knot(2, 3, 1.0, 0.4, 0.25),
        shapes::ball(1.0, 4),
        room(),
    ] {
        let basis = bake(&mesh, 16);
        let count = basis.samples().len() as f32;
        for i in 0..basis.count() {
            for j in 0..basis.count() {
                let pairs = basis.function(i).iter().zip(basis.function(j));
                let mean = pairs.map(|(a, b)| a * b).sum::<f32>() / count;
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((mean - expected).abs() < 1e-4, "{i} {j}: {mean}");
            }
        }
        assert!(basis.function(0).iter().all(|x| *x == 1.0));
        let held: Vec<f32> = (1..=basis.count()).map(|n| basis.held(n)).collect();
        assert!(
            held.is_sorted() && held[basis.count() - 1] <= 1.0 + 1e-6,
            "{held:?}"
        );
    }
}

/// Points are spread by area: a ball's moments are those of the sphere.
#[test]
fn points_are_spread_evenly() {
    let basis = bake(&shapes::ball(2.0, 5), 2);
    let mean = |of: &dyn Fn(Vec3) -> f32| {
        let all = basis
            .samples()
            .iter()
            .map(|s| of(Vec3::from(s.position) / 2.0));
        all.sum::<f32>() / basis.samples().len() as f32
    };
    for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
        assert!(mean(&|p| p.dot(axis)).abs() < 0.01);
        assert!((mean(&|p| p.dot(axis).powi(2)) - 1.0 / 3.0).abs() < 0.01);
    }
    for sample in basis.samples() {
        let out = Vec3::from(sample.position).normalize();
        assert!(out.dot(sample.normal.into()) > 0.99);
    }
}

/// A ball is lit by light of order 4 as the cosine lobe says, and nine functions hold all of that: bands 0 to 2, since the
/// lobe has no third.
#[test]
fn light_from_afar_on_a_ball_is_nine_functions() {
    let basis = bake(&shapes::ball(1.0, 5), 16);
    let mut light = [0.0_f32; 16];
    for (i, c) in light.iter_mut().enumerate() {
        *c = (1.7 * i as f32 + 0.4).sin();
    }
    let irradiance: Vec<[f32; 3]> = basis
        .samples()
        .iter()
        .map(|sample| [<[f32; 16]>::cosine(sample.normal).dot(&light); 3])
        .collect();
    let weights = basis.weights(&irradiance);
    let error = |count: usize| {
        let (mut off, mut all) = (0.0, 0.0);
        for (sample, light) in irradiance.iter().enumerate() {
            off += (basis.irradiance(&weights[..count], sample)[0] - light[0]).powi(2);
            all += light[0].powi(2);
        }
        (off / all).sqrt()
    };
    let [one, four, nine, sixteen] = [1, 4, 9, 16].map(error);
    println!("{one} {four} {nine} {sixteen}");
    assert!(one > 0.3 && four > 0.05, "{one} {four}");
    assert!(nine < 0.05 && sixteen < 0.02, "{nine} {sixteen}");
    // What is convex gives itself nothing.
    let own = basis.bounced(&weights);
    assert!(own.iter().flatten().all(|w| w.abs() < 1e-3), "{own:?}");
}

/// A closed white room is a furnace: of even light nothing is lost from bounce to bounce, and of a grey one its albedo is
/// left.
#[test]
fn a_closed_room_gives_itself_all_that_it_has() {
    let basis = bake(&room(), 16);
    let mut weights = vec![[0.0; 3]; basis.count()];
    weights[0] = [1.0; 3];
    for _ in 0..8 {
        weights = basis.bounced(&weights);
    }
    for sample in 0..basis.samples().len() {
        let [r, ..] = basis.irradiance(&weights, sample);
        assert!((r - 1.0).abs() < 0.01, "{sample}: {r}");
    }
    let gray = Material {
        albedo: [0.5, 0.25, 0.0],
        texture: None,
    };
    let basis = IrradianceBasis::bake(&[(&room(), &gray)], 16, &|_| {}).unwrap();
    weights = vec![[0.0; 3]; basis.count()];
    weights[0] = [1.0; 3];
    let [r, g, b] = basis.bounced(&weights)[0];
    assert!((r - 0.5).abs() < 1e-3 && (g - 0.25).abs() < 1e-3 && b == 0.0);
}

/// A plane, a single triangle, parts without extent and nothing at all.
#[test]
fn little_is_enough_and_nothing_is_none() {
    let triangle = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        normals: vec![[0.0, 1.0, 0.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let basis = bake(&triangle, 16);
    assert!(
        basis.count() > 4 && basis.held(16) > 0.9,
        "{}",
        basis.held(16)
    );
    assert!(basis.samples().iter().all(|s| s.normal[1] > 0.999));
    let flat = Mesh {
        positions: vec![[1.0; 3]; 3],
        ..triangle.clone()
    };
    let broken = Mesh {
        positions: vec![[f32::NAN; 3]; 3],
        ..triangle.clone()
    };
    for nothing in [Mesh::default(), flat, broken] {
        assert!(IrradianceBasis::bake(&[(&nothing, &WHITE)], 16, &|_| {}).is_none());
    }
}

/// Whatever the number of threads.
#[test]
fn threads_change_nothing() {
    let knot = shapes::torus_knot(2, 3, 1.0, 0.4, 0.25);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| bake(&knot, 8))
    };
    assert_eq!(on(1), on(3));
}
