//! The cost of a scene as its effects are switched on one by one, while it moves: at rest a frame does again only what a
//! picture needs, and what bodies send on, in any number of bounces, is found once.

use super::backend::{measure, view};
use super::options::Options;
use super::report::{Report, megabytes};
use crate::Error;
use crate::render::Choice;
use glam::Vec3;
use serde::Serialize;
use sh_bake::{Loaded, bake_surface};
use sh_scene::motion::{Keys, Place};
use sh_scene::{AreaLight, Indirect, Limits, Plan, PunctualLight, PunctualShape, Scene};
use std::fmt::Write;

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
struct Row {
    /// What is on, beside all that is in the rows above.
    effect: &'static str,
    /// Milliseconds of a frame.
    ms: f64,
    /// By how many of them frames differ.
    spread_ms: f64,
    /// Memory of all passes.
    bytes: u64,
    /// Dispatches of all passes.
    dispatches: u64,
    /// Pipelines that a GPU compiles.
    shaders: usize,
    /// The passes.
    passes: Vec<&'static str>,
    /// Those of them that had nothing to do.
    idle: Vec<&'static str>,
    /// Why the effect does not cost time, where it does not.
    free: Option<&'static str>,
}

/// Why a frame takes no longer than without the effect, if it does not; both frames by their time and spread. An effect that
/// is there to save time says so.
fn free(name: &str, without: [f64; 2], with: [f64; 2]) -> Option<&'static str> {
    let [more, noise] = [with[0] - without[0], without[1] + with[1]];
    if SAVING.contains(&name) && more < -noise {
        Some("it saves time")
    } else if more <= noise {
        Some("no more than frames differ by")
    } else {
        None
    }
}

/// Seconds of motion given to a scene that has none, and how far its bodies rise meanwhile, over its size.
const RISE: (f32, f32) = (1.0, 0.05);

/// Lets all bodies of a scene rise, if nothing in it moves.
fn set_in_motion(loaded: &mut Loaded) {
    if !loaded.motion.is_still() {
        return;
    }
    let [low, high] = loaded.scene.bounds().unwrap_or([Vec3::ZERO; 2]);
    let rise = Vec3::Y * (high - low).length() * RISE.1;
    for (index, object) in loaded.scene.objects.iter().enumerate() {
        let (scale, rotation, translation) = object.transform.to_scale_rotation_translation();
        let place = Place {
            translation,
            rotation: rotation.normalize(),
            scale: scale.x,
        };
        let above = Place {
            translation: translation + rise,
            ..place
        };
        // A body without extent stays where it is.
        if let Ok(keys) = Keys::new(vec![(0.0, place), (RISE.0, above)], true) {
            loaded.motion.add_keys(index..index + 1, keys);
        }
    }
}

/// An effect: its name, and what it changes.
type Effect = (&'static str, fn(&mut Scene));

const EFFECTS: [Effect; 8] = [
    ("environment light", |_| {}),
    ("+ shadows, sphere by sphere", |scene| {
        scene.settings.shadows = true;
        scene.settings.limits = Limits::LEAVES;
    }),
    ("+ clusters with cuts of a tree", |scene| {
        scene.settings.limits = Limits::default();
    }),
    ("+ a lamp", |scene| scene.lights.push(lamp(scene))),
    ("+ half resolution", |scene| {
        scene.settings.half_resolution = true;
    }),
    ("+ a sun with sharp shadows", |scene| {
        let shape = PunctualShape::Sun {
            direction: Vec3::new(0.4, 1.0, 0.3),
            angle: 0.005,
        };
        scene.punctual.push(PunctualLight::new(shape, [1.0; 3]));
    }),
    ("+ indirect light, 1 bounce", |scene| {
        scene.settings.indirect = Some(Indirect::default());
    }),
    ("+ a second bounce", |scene| {
        scene.settings.indirect = Some(Indirect {
            bounces: 2,
            ..Indirect::default()
        });
    }),
];

/// Those that are there to save time.
const SAVING: [&str; 2] = ["+ clusters with cuts of a tree", "+ half resolution"];

/// Runs all of them; the table, or its rows as JSON.
pub(super) fn table(
    mut loaded: Loaded,
    choice: &Choice,
    options: &Options,
) -> Result<String, Error> {
    for object in &mut loaded.scene.objects {
        if object.surface.is_empty() {
            let parts = [(&object.mesh, &object.material)];
            object.surface = bake_surface(&parts, &object.spheres);
        }
    }
    set_in_motion(&mut loaded);
    let scene = &mut loaded.scene;
    scene.lights.clear();
    scene.punctual.clear();
    let settings = &mut scene.settings;
    (
        settings.shadows,
        settings.half_resolution,
        settings.indirect,
    ) = (false, false, None);
    let mut rows: Vec<Row> = Vec::new();
    for (effect, switch_on) in EFFECTS {
        switch_on(&mut loaded.scene);
        let plan = Plan::new(&loaded.scene);
        let view = view(&loaded.scene, options.size);
        let measured = measure(&mut loaded, &plan, &view, choice)?;
        let estimates = vec![0.0; plan.passes.len()];
        let report = Report::new(String::new(), &plan, &view, choice, measured, estimates);
        let time = [report.frame_ms, report.spread_ms];
        let before = rows.last().map(|row| [row.ms, row.spread_ms]);
        let idle = report.passes.iter().filter(|pass| pass.dispatches == 0);
        rows.push(Row {
            effect,
            ms: report.frame_ms,
            spread_ms: report.spread_ms,
            idle: idle.map(|pass| pass.name).collect(),
            free: before.and_then(|before| free(effect, before, time)),
            bytes: report.bytes,
            dispatches: report.dispatches(),
            shaders: report.shaders.len(),
            passes: report.passes.iter().map(|pass| pass.name).collect(),
        });
    }
    if options.json {
        return Ok(serde_json::to_string_pretty(&rows)?);
    }
    let mut text = String::from(
        "| effect | ms a frame | ± | memory | dispatches | shaders | passes | costs no time |\n|---|---|---|---|---|---|---|---|",
    );
    for row in rows {
        let (effect, ms, dispatches) = (row.effect, row.ms, row.dispatches);
        let (spread, free) = (row.spread_ms, row.free.unwrap_or_default());
        let (bytes, shaders) = (megabytes(row.bytes), row.shaders);
        let passes = row.passes.join(", ");
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n| {effect} | {ms:.1} | {spread:.1} | {bytes} | {dispatches} | {shaders} | {passes} | {free} |"
        );
    }
    Ok(text)
}

/// A small warm lamp above the middle of all bodies.
fn lamp(scene: &Scene) -> AreaLight {
    let [low, high] = scene.bounds().unwrap_or([Vec3::ZERO; 2]);
    let size = (high - low).length().max(1e-3);
    AreaLight::local(
        (low + high) * 0.5 + Vec3::Y * size * 0.6,
        size * 0.05,
        [60.0, 45.0, 25.0],
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_costs_no_time_says_why() {
        let of = |name, more| free(name, [100.0, 2.0], [100.0 + more, 3.0]);
        assert_eq!(of("+ a lamp", 8.0), None);
        assert_eq!(of("+ a lamp", 4.0), Some("no more than frames differ by"));
        assert_eq!(of("+ a lamp", -40.0), Some("no more than frames differ by"));
        assert_eq!(of("+ half resolution", -40.0), Some("it saves time"));
        assert_eq!(of("+ half resolution", 40.0), None);
    }
}
