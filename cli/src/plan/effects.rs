//! The cost of a scene as its effects are switched on one by one.

use super::report::megabytes;
use super::{Options, Report, measure, view};
use crate::Error;
use crate::render::Choice;
use glam::Vec3;
use serde::Serialize;
use sh_bake::{Loaded, bake_surface};
use sh_scene::{AreaLight, Indirect, Limits, Plan, Scene};
use std::fmt::Write;

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
struct Row {
    /// What is on, beside all that is in the rows above.
    effect: &'static str,
    /// Milliseconds of a frame.
    ms: f64,
    /// Memory of all passes.
    bytes: u64,
    /// Dispatches of all passes.
    dispatches: u64,
    /// Pipelines that a GPU compiles.
    shaders: usize,
    /// The passes.
    passes: Vec<&'static str>,
}

/// An effect: its name, and what it changes.
type Effect = (&'static str, fn(&mut Scene));

const EFFECTS: [Effect; 7] = [
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
    let scene = &mut loaded.scene;
    scene.lights.clear();
    let settings = &mut scene.settings;
    (
        settings.shadows,
        settings.half_resolution,
        settings.indirect,
    ) = (false, false, None);
    let mut rows = Vec::new();
    for (effect, switch_on) in EFFECTS {
        switch_on(&mut loaded.scene);
        let plan = Plan::new(&loaded.scene);
        let view = view(&loaded.scene, options.size);
        let measured = measure(&mut loaded, &plan, &view, choice)?;
        let estimates = vec![0.0; plan.passes.len()];
        let report = Report::new(String::new(), &plan, &view, choice, measured, estimates);
        rows.push(Row {
            effect,
            ms: report.frame_ms,
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
        "| effect | ms a frame | memory | dispatches | shaders | passes |\n|---|---|---|---|---|---|",
    );
    for row in rows {
        let (effect, ms, dispatches) = (row.effect, row.ms, row.dispatches);
        let (bytes, shaders) = (megabytes(row.bytes), row.shaders);
        let passes = row.passes.join(", ");
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n| {effect} | {ms:.1} | {bytes} | {dispatches} | {shaders} | {passes} |"
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
