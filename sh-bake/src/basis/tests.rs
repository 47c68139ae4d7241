use super::field::by_rays;
use super::{IrradianceField, irradiance_basis};
use crate::shapes;
use glam::{Vec3, vec3};
use sh_core::Routines;
use sh_scene::basis::REGION_PATCHES;
use sh_scene::{IrradianceBasis, Material, Mesh};
use std::f32::consts::TAU;

const WHITE: Material = Material::diffuse([1.0; 3]);

fn bake(mesh: &Mesh, count: usize) -> IrradianceBasis {
    irradiance_basis(&[(mesh, &WHITE)], count, &|_| {}).expect("it has triangles")
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
    let at_points: Vec<_> = irradiance.iter().step_by(4).copied().collect();
    let weights = basis.weights(&at_points);
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
    assert!(nine < 0.04 && sixteen < 0.04, "{nine} {sixteen}");
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
        weights = basis.weights(&basis.bounced(&weights));
    }
    for sample in 0..basis.samples().len() {
        let [r, ..] = basis.irradiance(&weights, sample);
        assert!((r - 1.0).abs() < 1e-3, "{sample}: {r}");
    }
    let gray = Material::diffuse([0.5, 0.25, 0.0]);
    let basis = irradiance_basis(&[(&room(), &gray)], 16, &|_| {}).unwrap();
    weights = vec![[0.0; 3]; basis.count()];
    weights[0] = [1.0; 3];
    for [r, g, b] in basis.bounced(&weights) {
        assert!((r - 0.5).abs() < 1e-3 && (g - 0.25).abs() < 1e-3 && b == 0.0);
    }
    // Of even light a patch sends on what its albedo leaves.
    for [r, g, b] in basis.sent(&weights) {
        assert!((r - 0.5).abs() < 1e-5 && (g - 0.25).abs() < 1e-5 && b == 0.0);
    }
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
        assert!(irradiance_basis(&[(&nothing, &WHITE)], 16, &|_| {}).is_none());
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

/// The error of a field at places of some distances, over the field: roots of mean squares.
fn field_error(mesh: &Mesh, weights: &[[f32; 3]]) -> Vec<(f32, f64)> {
    let parts = [(mesh, &WHITE)];
    let basis = irradiance_basis(&parts, weights.len(), &|_| {}).unwrap();
    let field = IrradianceField::bake(&parts, &basis, &|_| {}).unwrap();
    let lit = field.lit(weights);
    let (center, radius) = (field.center, field.radius);
    let mut errors = Vec::new();
    for far in [1.2, 1.4, 2.0, 4.0, 7.5] {
        let (mut off, mut all) = (0.0, 0.0);
        for k in 0..40 {
            let place = (center + around(k, 40) * far * radius).to_array();
            let truth = by_rays(&parts, &basis, weights, place);
            for (seen, truth) in lit.seen(place).iter().flatten().zip(truth.iter().flatten()) {
                off += (f64::from(*seen) - truth).powi(2);
                all += truth * truth;
            }
        }
        errors.push((far, (off / all).sqrt()));
    }
    println!("{errors:?}, {} bytes", field.bytes());
    errors
}

/// The same of patches and of regions.
fn parts_error(mesh: &Mesh, weights: &[[f32; 3]]) -> Vec<(f32, [f64; 2])> {
    let parts = [(mesh, &WHITE)];
    let basis = irradiance_basis(&parts, weights.len(), &|_| {}).unwrap();
    let (shape, sent) = (basis.shape(), basis.sent(weights));
    let by_patches = |place: Vec3| {
        let mut seen = [[0.0; 16]; 3];
        for (patch, sent) in basis.parts().patches.iter().zip(&sent) {
            let to = Vec3::from(patch.whole.disc.center) - place;
            let u = to.normalize();
            let shown = (-u.dot(patch.whole.disc.normal.into())).max(0.0)
                * patch.whole.escape().seen((-u).to_array());
            add(
                &mut seen,
                u,
                sent.map(|l| l * patch.whole.disc.area * shown / to.length_squared()),
            );
        }
        seen
    };
    let by_regions = |place: Vec3| {
        let mut seen = [[0.0; 16]; 3];
        for (r, region) in shape.regions.iter().enumerate() {
            let to = Vec3::from(region.center) - place;
            let y = <[f32; 36]>::basis((-to.normalize()).to_array());
            let mut intensity = [0.0; 3];
            for m in r * REGION_PATCHES..(r + 1) * REGION_PATCHES {
                let value: f32 = basis.lobes()[m].iter().zip(y).map(|(a, b)| a * b).sum();
                for (sum, sent) in intensity.iter_mut().zip(sent[m]) {
                    *sum += value * sent;
                }
            }
            add(
                &mut seen,
                to.normalize(),
                intensity.map(|i| i / to.length_squared()),
            );
        }
        seen
    };
    let mut errors = Vec::new();
    for far in [1.2, 1.4, 2.0, 4.0, 7.5] {
        let (mut off, mut all) = ([0.0; 2], 0.0);
        for k in 0..40 {
            let place = shape.center + around(k, 40) * far * shape.radius;
            let truth = by_rays(&parts, &basis, weights, place.to_array());
            let truth = truth.iter().flatten();
            all += truth.clone().map(|x| x * x).sum::<f64>();
            for (off, seen) in off.iter_mut().zip([by_patches(place), by_regions(place)]) {
                let pairs = seen.iter().flatten().zip(truth.clone());
                *off += pairs.map(|(a, b)| (f64::from(*a) - b).powi(2)).sum::<f64>();
            }
        }
        errors.push((far, off.map(|off| (off / all).sqrt())));
    }
    println!("{errors:?}, {} bytes", basis.bytes());
    errors
}

/// Adds light from a direction.
fn add(seen: &mut [[f32; 16]; 3], from: Vec3, light: [f32; 3]) {
    let y = <[f32; 16]>::basis(from.to_array());
    for (seen, light) in seen.iter_mut().zip(light) {
        for (seen, y) in seen.iter_mut().zip(y) {
            *seen += light * y;
        }
    }
}

/// The k-th of some directions that are spread evenly.
fn around(k: usize, count: usize) -> Vec3 {
    let (a, b) = (
        2.399_963 * k as f32,
        1.0 - 2.0 * (k as f32 + 0.37) / count as f32,
    );
    let wide = (1.0 - b * b).sqrt();
    vec3(wide * a.sin(), b, wide * a.cos())
}

/// Patches of bodies of any shape in any light are what rays see of them, from 1.4 radii on, and regions from 4: of a body that
/// hides itself as far as a quadratic function can tell.
#[test]
fn patches_and_regions_are_what_rays_see() {
    // Nowhere below 0.
    let weight = |i: usize| match i {
        0 => [1.0; 3],
        i => [0.0, 0.15 * (1.3 * i as f32).cos(), 0.2 / i as f32],
    };
    let weights: Vec<[f32; 3]> = (0..8).map(weight).collect();
    for (mesh, most) in [
        (shapes::torus_knot(2, 3, 1.0, 0.4, 0.25), [0.075, 0.035]),
        (
            shapes::rounded_box(vec3(1.0, 0.4, 0.8), 0.05),
            [0.075, 0.04],
        ),
    ] {
        for (far, errors) in parts_error(&mesh, &weights) {
            assert!(far < 1.4 || errors[0] < most[0], "{far}: {errors:?}");
            assert!(far < 4.0 || errors[1] < most[1], "{far}: {errors:?}");
        }
    }
}

/// Of an evenly lit ball a disc is seen, whose SH vector is known.
#[test]
fn an_even_ball_is_seen_as_a_disc() {
    let ball = shapes::ball(1.5, 5);
    let parts = [(&ball, &WHITE)];
    let basis = irradiance_basis(&parts, 1, &|_| {}).unwrap();
    let field = IrradianceField::bake(&parts, &basis, &|_| {}).unwrap();
    let lit = field.lit(&[[2.0; 3]]);
    for far in [1.2_f32, 1.5, 2.0, 4.0, 8.0, 20.0] {
        let place = vec3(0.3, -0.8, 0.52).normalize() * (1.5 * far);
        // Of each band 2π times the integral of its polynomial over the disc.
        let c = (1.0 - far.powi(-2)).sqrt();
        let polynomials = [1.0, c, 1.5 * c * c - 0.5, (2.5 * c * c - 1.5) * c];
        let fourth = (35.0 * c * c - 30.0) * c * c / 8.0 + 0.375;
        let [p0, p1, p2, p3] = polynomials;
        let bands = [
            p0 - p1,
            (p0 - p2) / 3.0,
            (p1 - p3) / 5.0,
            (p2 - fourth) / 7.0,
        ];
        let towards = <[f32; 16]>::basis((-place.normalize()).to_array());
        let disc: Vec<f32> = (0..16_usize)
            .map(|i| 2.0 * TAU * bands[i.isqrt()] * towards[i])
            .collect();
        let seen = lit.seen(place.to_array())[1];
        let (mut off, mut whole) = (0.0, 0.0);
        for (seen, disc) in seen.iter().zip(&disc) {
            off += (seen - disc).powi(2);
            whole += disc * disc;
        }
        let error = (off / whole).sqrt();
        println!("{far}: {error}");
        assert!(error < 0.02, "{far}: {error}");
    }
    // As near as that nothing is told.
    assert_eq!(lit.seen([0.0, 1.6, 0.0]), [[0.0; 16]; 3]);
    assert_eq!(lit.seen([f32::NAN; 3]), [[0.0; 16]; 3]);
}

/// The series against rays from other places than it was fitted at, of bodies of any shape in any light.
#[test]
fn series_are_what_rays_see() {
    let weights: Vec<[f32; 3]> = (0..8)
        .map(|i| [1.0, (1.3 * i as f32).cos(), 1.0 / (1.0 + i as f32)])
        .collect();
    for mesh in [
        shapes::torus_knot(2, 3, 1.0, 0.4, 0.25),
        shapes::rounded_box(vec3(1.0, 0.4, 0.8), 0.05),
    ] {
        for (far, error) in field_error(&mesh, &weights) {
            let most = match far {
                1.2 => 0.25,
                1.4 => 0.14,
                _ => 0.08,
            };
            assert!(error < most, "{far}: {error}");
        }
    }
}
