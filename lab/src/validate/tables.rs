//! How the error falls, and where it comes from.

use super::measure::{Errors, Sight, Traced, trace};
use super::scenes::{Case, animal, arched_anew, boxed, case};
use crate::meshes::add;
use crate::rooms::{FUNCTIONS, told};
use gaunt::Error;
use gaunt::compare::Figures;
use glam::Vec3;
use serde::Serialize;
use sh_bake::shapes;
use sh_reference::paths::Source;
use sh_scene::{Blocking, Indirect, Mesh, Method, Object, Scene, SurfaceSamples};
use std::f32::consts::{FRAC_PI_2, PI};

/// Errors of one way to light a scene; `relative` ones in parts of the mean indirect light, others of the mean radiance.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The scene, with what is special about it.
    pub name: String,
    /// Spheres of all bodies.
    pub spheres: usize,
    /// SH order.
    pub order: usize,
    /// The truth's light.
    pub light: &'static str,
    /// RMS of direct light.
    pub direct: f64,
    /// RMS of indirect light.
    pub indirect: f64,
    /// RMS of indirect light, relative.
    pub relative: f64,
    /// Mean of ours less the truth, relative.
    pub relative_bias: f64,
    /// The truth's noise in indirect light, relative; RMS are without it.
    pub relative_noise: f64,
    /// RMS of indirect light by differences of exponentials (equation 23) in place of discs, relative.
    pub runs: f64,
    /// The bias of that.
    pub runs_bias: f64,
    /// The share of indirect light in all.
    pub share: f64,
    /// RMS and bias of direct light on the ground and on bodies, in parts of its mean there.
    pub direct_places: [[f64; 2]; 2],
    /// RMS and bias of indirect light on the ground, in parts of its mean there.
    pub ground: [f64; 2],
    /// The same on bodies.
    pub bodies: [f64; 2],
    /// By equation 23, on the ground.
    pub runs_ground: [f64; 2],
    /// By equation 23, on bodies.
    pub runs_bodies: [f64; 2],
    /// RMS and bias of indirect light by patches whose irradiance is told in 16 functions, relative.
    pub patches: [f64; 2],
    /// The same on the ground, in parts of its mean there.
    pub patches_ground: [f64; 2],
    /// The same on bodies.
    pub patches_bodies: [f64; 2],
}

/// What is known of the light on the ground around a body when the body is replaced step by step; relative RMS.
#[derive(Clone, Debug, Serialize)]
pub struct Step {
    /// Which body.
    pub name: String,
    /// Its spheres.
    pub spheres: usize,
    /// Indirect light: paths among the spheres, against paths among the true surfaces.
    pub fit: f64,
    /// Ours against paths among the true surfaces.
    pub whole: f64,
}

/// A scene with another way of blocking.
fn blocked(scene: &Scene, blocking: Blocking) -> Scene {
    let mut scene = scene.clone();
    scene.settings.indirect = Some(Indirect {
        blocking,
        ..Indirect::default()
    });
    scene
}

/// A scene whose bodies send light by their patches.
pub(super) fn patched(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.settings.indirect = Some(Indirect {
        method: Method::BasisIrradiance,
        ..Indirect::default()
    });
    for object in &mut scene.objects {
        object.surface = SurfaceSamples::default();
    }
    told(&mut scene.objects, FUNCTIONS);
    scene
}

/// The row of a scene seen.
pub(super) fn row(name: &str, scene: &Scene, sight: &Sight, light: Source) -> Result<Row, Error> {
    let errors = sight.errors(&sight.ours(scene)?.parts);
    let runs = sight.ours(&blocked(scene, Blocking::Runs))?;
    let patches = sight.ours(&patched(scene))?;
    let others = [runs, patches].map(|ours| sight.errors(&ours.parts));
    Ok(with(name, scene, light, errors, others))
}

fn with(
    name: &str,
    scene: &Scene,
    light: Source,
    discs: Errors,
    [runs, patches]: [Errors; 2],
) -> Row {
    let places = |errors: &Errors| errors.places.map(|figures| [figures.rms, figures.bias]);
    let [[ground, bodies], [runs_ground, runs_bodies]] = [&discs, &runs].map(places);
    let [patches_ground, patches_bodies] = places(&patches);
    Row {
        name: name.into(),
        spheres: scene.objects.iter().map(|o| o.spheres.len()).sum(),
        order: scene.settings.order,
        light: match light {
            Source::Map => "map",
            Source::Projected => "projected",
        },
        direct: discs.direct.rms,
        indirect: discs.indirect.rms,
        relative: discs.relative[0],
        relative_bias: discs.relative[1],
        relative_noise: discs.indirect.noise / discs.share,
        runs: runs.relative[0],
        runs_bias: runs.relative[1],
        share: discs.share,
        direct_places: discs
            .direct_places
            .map(|figures| [figures.rms, figures.bias]),
        ground,
        bodies,
        runs_ground,
        runs_bodies,
        patches: patches.relative,
        patches_ground,
        patches_bodies,
    }
}

/// The animal and the box by numbers of spheres.
pub(super) fn counts(traced: Traced) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for (name, make) in bodies() {
        let Some(case) = case(name) else { continue };
        let mut sight = None;
        for count in [1, 8, 16, 32, 64] {
            let scene = case.with(make(count));
            let sight = match &mut sight {
                Some(sight) => sight,
                none => none.insert(Sight::new(&scene, traced, Source::Projected)?),
            };
            rows.push(row(body_name(name), &scene, sight, Source::Projected)?);
        }
    }
    Ok(rows)
}

type Make = fn(usize) -> Vec<Object>;

fn bodies() -> [(&'static str, Make); 2] {
    [("animal", animal), ("box-8", boxed)]
}

fn body_name(case: &str) -> &str {
    if case == "animal" { "animal" } else { "box" }
}

/// Two scenes by orders, against the light of the order and against the map.
pub(super) fn orders(traced: Traced) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for name in ["spheres", "animal"] {
        let Some(case) = case(name) else { continue };
        let mut scene = case.scene();
        let settings = scene.settings;
        let map = Sight::new(&scene, traced, Source::Map)?;
        for order in 3..=6 {
            scene.settings = settings.with_order(order);
            let same = Sight::new(&scene, traced, Source::Projected)?;
            rows.push(row(name, &scene, &same, Source::Projected)?);
            rows.push(row(name, &scene, &map, Source::Map)?);
        }
    }
    Ok(rows)
}

/// The bent cylinder, its spheres taken along or fitted anew.
pub(super) fn bends(traced: Traced) -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    for (name, angle) in [("bend-90", FRAC_PI_2), ("bend-180", PI)] {
        let Some(case) = case(name) else { continue };
        let taken = case.scene();
        let sight = Sight::new(&taken, traced, Source::Projected)?;
        let anew = case.with(arched_anew(angle, 12));
        for (how, scene) in [("taken along", &taken), ("fitted anew", &anew)] {
            let name = format!("{name}, {how}");
            rows.push(row(&name, scene, &sight, Source::Projected)?);
        }
    }
    Ok(rows)
}

/// Steps from a body to what stands for it.
pub(super) fn steps(traced: Traced) -> Result<Vec<Step>, Error> {
    let mut steps = Vec::new();
    for (name, make, counts) in [
        ("box-8", boxed as Make, &[1, 8, 64][..]),
        ("animal", animal, &[8, 32, 64]),
    ] {
        let Some(case) = case(name) else { continue };
        for count in counts {
            steps.push(step(case, body_name(name), make(*count), traced)?);
        }
    }
    Ok(steps)
}

fn step(case: &Case, name: &str, objects: Vec<Object>, traced: Traced) -> Result<Step, Error> {
    let scene = case.with(objects);
    let light = Source::Projected;
    let sight = Sight::new(&scene, traced, light)?;
    let balls = trace(&as_balls(&scene), &sight.seen, traced, light)?;
    let spheres = scene.world_spheres();
    let receivers = sight.seen.receivers().iter();
    let on_ground: Vec<bool> = receivers
        .map(|r| {
            let outside = spheres
                .iter()
                .all(|s| Vec3::from(r.position).distance(s.center.into()) > s.radius);
            r.covered != 0 && r.object == 0 && outside
        })
        .collect();
    let only = |all: &[[f32; 3]]| -> Vec<[f32; 3]> {
        let pairs = all.iter().zip(&on_ground);
        pairs.filter(|(_, on)| **on).map(|(r, _)| *r).collect()
    };
    let [bodies, body_errors] =
        [&sight.truth.parts, &sight.truth.errors].map(|p| only(&p.indirect));
    let [traced_balls, ball_errors] = [&balls.parts, &balls.errors].map(|p| only(&p.indirect));
    let ours = only(&sight.ours(&scene)?.parts.indirect);
    let mean = gaunt::compare::scale(&bodies);
    // Both are traced with the same random numbers: their errors belong together.
    let pairs = body_errors.iter().zip(&ball_errors);
    let errors: Vec<[f32; 3]> = pairs
        .map(|(a, b)| std::array::from_fn(|c| a[c] - b[c]))
        .collect();
    let rms = |a: &[[f32; 3]], b: &[[f32; 3]], e: &[[f32; 3]]| Figures::new(a, b, e, mean).rms;
    Ok(Step {
        name: name.into(),
        spheres: spheres.len(),
        fit: rms(&traced_balls, &bodies, &errors),
        whole: rms(&ours, &bodies, &body_errors),
    })
}

/// The scene with its spheres as bodies: each body's mesh is the balls that stand for it.
fn as_balls(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for object in &mut scene.objects {
        let mut mesh = Mesh::default();
        for sphere in &object.spheres {
            let ball = shapes::ball(sphere.radius, 4);
            add(&mut mesh, ball, sphere.center.into());
        }
        object.surface = SurfaceSamples::default();
        object.mesh = mesh;
    }
    scene
}
