//! The scene that needs no file.

use crate::bodies::{self, Fit, once};
use crate::cache::Cache;
use crate::choices::Choices;
use crate::load::{FitReport, Report};
use crate::progress::Progress;
use crate::shapes;
use glam::{Affine3A, Quat, Vec3};
use sh_scene::motion::Motion;
use sh_scene::{Camera, Ground, Material, Mesh, Object, Scene, Settings, Sky};
use std::f32::consts::{FRAC_PI_2, TAU};
use std::time::Instant;

/// One body: name, mesh, spheres, albedo, how it is turned, and the point it rests on.
struct Piece(&'static str, Mesh, usize, [f32; 3], Quat, Vec3);

/// A still life on a ground plane under an analytic sky: a torus knot, a box with a ball on it, a twisted
/// column, a cone, a capsule, a torus and some balls. Everything is made by code and stands on the ground
/// or on something else. With a cache, sphere sets that it has are taken from there, and others put into it.
///
/// ```no_run
/// let (scene, report) = sh_bake::default_scene(None, &|_| {});
/// println!("{} objects, {:?} for spheres", scene.objects.len(), report.fit_time);
/// ```
pub fn default_scene(
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> (Scene, Report) {
    default_scene_with(Choices::default(), cache, progress)
}

/// [`default_scene`] with more or fewer spheres, or surface samples. It has no clips.
pub fn default_scene_with(
    choices: Choices,
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> (Scene, Report) {
    let start = Instant::now();
    let pieces = pieces();
    let environment = Sky::default().map(512, 256);
    let mut report = Report {
        read_time: start.elapsed(),
        ..Report::default()
    };

    let start = Instant::now();
    let fits = pieces.iter().map(|piece| Fit {
        parts: vec![&piece.1],
        count: choices.count(piece.2),
    });
    let fits = once(&fits.collect::<Vec<_>>(), cache, progress);
    report.fit_time = start.elapsed();

    let mut objects = Vec::new();
    for (Piece(name, mesh, _, albedo, turn, place), fitted) in pieces.into_iter().zip(fits) {
        report
            .fits
            .push(FitReport::new(name.into(), std::iter::once(&mesh), &fitted));
        let mut object = Object {
            name: name.into(),
            mesh,
            material: Material::diffuse(albedo),
            transform: Affine3A::from_quat(turn),
            spheres: fitted.what.spheres.clone(),
            ..Object::default()
        };
        let lowest = object.bounds().map_or(0.0, |[low, _]| low.y);
        object.transform = Affine3A::from_rotation_translation(turn, place - Vec3::Y * lowest);
        objects.push(object);
    }
    if choices.surfaces {
        let start = Instant::now();
        let each: Vec<_> = (0..objects.len()).map(|i| i..i + 1).collect();
        report.surfaces = bodies::sample(&mut objects, &each, cache, progress);
        report.surface_time = start.elapsed();
    }
    let whole: Vec<_> = (0..objects.len()).map(|i| i..i + 1).collect();
    let mut scene = Scene {
        punctual: Vec::new(),
        objects,
        environment,
        lights: Vec::new(),
        ground: Some(Ground {
            height: 0.0,
            albedo: [0.50, 0.48, 0.45],
        }),
        camera: Camera {
            eye: Vec3::new(1.3, 2.0, 7.4),
            target: Vec3::new(0.0, 0.94, 0.0),
            fov: 30.0_f32.to_radians(),
        },
        settings: Settings::default(),
    };
    let start = Instant::now();
    let mut still = Motion::default();
    report.weights = bodies::weigh(&mut scene, &mut still, &whole, cache, progress);
    report.weight_time = start.elapsed();
    (scene, report)
}

fn pieces() -> Vec<Piece> {
    let upright = Quat::IDENTITY;
    let about_y = |turns: f32| Quat::from_rotation_y(turns * TAU);
    let at = Vec3::new;
    vec![
        Piece(
            "torus knot",
            shapes::torus_knot(2, 3, 0.52, 0.2, 0.12),
            80,
            [0.72, 0.30, 0.18],
            about_y(0.06) * Quat::from_rotation_x(FRAC_PI_2),
            at(-0.25, 0.0, 0.35),
        ),
        Piece(
            "box",
            shapes::rounded_box(at(0.9, 0.7, 0.9), 0.06),
            36,
            [0.80, 0.77, 0.70],
            about_y(0.07),
            at(1.35, 0.0, -0.1),
        ),
        Piece(
            "ball on the box",
            shapes::ball(0.3, 4),
            1,
            [0.16, 0.42, 0.44],
            upright,
            at(1.35, 0.7, -0.1),
        ),
        Piece(
            "twisted column",
            shapes::twisted_column(0.24, 2.1, TAU * 0.3),
            48,
            [0.40, 0.47, 0.32],
            about_y(0.03),
            at(-1.45, 0.0, -0.75),
        ),
        Piece(
            "cone",
            shapes::cone(0.42, 1.05),
            40,
            [0.82, 0.58, 0.16],
            upright,
            at(0.55, 0.0, -1.15),
        ),
        Piece(
            "capsule",
            shapes::capsule(0.2, 0.6),
            8,
            [0.24, 0.30, 0.50],
            about_y(0.1) * Quat::from_rotation_z(FRAC_PI_2),
            at(-1.35, 0.0, 0.75),
        ),
        Piece(
            "torus",
            shapes::torus_knot(1, 0, 0.3, 0.0, 0.1),
            20,
            [0.50, 0.20, 0.30],
            upright,
            at(0.75, 0.0, 1.05),
        ),
        Piece(
            "ball in the torus",
            shapes::ball(0.19, 4),
            1,
            [0.85, 0.83, 0.80],
            upright,
            at(0.75, 0.06, 1.05),
        ),
        Piece(
            "small ball",
            shapes::ball(0.15, 4),
            1,
            [0.72, 0.30, 0.18],
            upright,
            at(-0.55, 0.0, 1.35),
        ),
        Piece(
            "smallest ball",
            shapes::ball(0.1, 4),
            1,
            [0.16, 0.42, 0.44],
            upright,
            at(-0.15, 0.0, 1.55),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_stands_on_the_ground_and_is_bounded() {
        let (scene, report) = default_scene(None, &|_| {});
        assert_eq!(scene.objects.len(), report.fits.len());
        let [low, high] = scene.bounds().unwrap();
        assert!(low.y.abs() < 1e-5 && high.y > 1.5, "{low} {high}");
        for (object, fit) in scene.objects.iter().zip(&report.fits) {
            let set = crate::SphereSet {
                spheres: object.spheres.clone(),
                outside_volume_ratio: fit.outside_volume_ratio,
            };
            assert_eq!(set.uncovered(&[&object.mesh]), None, "{}", object.name);
            let ratio = fit.outside_volume_ratio.expect("shapes are closed");
            assert!(ratio < 1.0, "{}: {ratio}", object.name);
        }
    }
}
