//! What the person has chosen.

use super::options::Options;
use super::orbit::Orbit;
use super::wish::{Overlay, Wish};
use crate::render::Backend;
use sh_bake::Loaded;
use sh_scene::{Indirect, Settings};
use std::path::Path;

/// What does not change while the window is open.
#[derive(Clone, Debug)]
pub(super) struct Facts {
    /// The scene's file, or what the built-in one is called.
    pub name: String,
    /// How many spheres the scene asks for.
    pub spheres: usize,
    /// Seconds after which the motion begins again, more or less; none where nothing moves.
    pub length: Option<f64>,
    /// What moves, and what was wrong with the files: sentences.
    pub sentences: Vec<String>,
}

impl Facts {
    /// Of a scene that was loaded.
    pub fn new(scene: Option<&Path>, loaded: &Loaded) -> Self {
        /// Of a motion that has no end of its own.
        const ENDLESS: f64 = 10.0;
        let report = &loaded.report;
        let period = loaded.motion.period();
        let length = if period > 0.0 { period } else { ENDLESS };
        let name = scene.and_then(Path::file_name);
        Self {
            name: name.map_or("The built-in scene".into(), |name| {
                name.to_string_lossy().into_owned()
            }),
            spheres: loaded.scene.objects.iter().map(|o| o.spheres.len()).sum(),
            length: (!loaded.motion.is_still()).then_some(length),
            sentences: report
                .moves
                .iter()
                .chain(&report.warnings)
                .cloned()
                .collect(),
        }
    }
}

/// What the person has chosen.
#[derive(Clone, Debug)]
pub(super) struct State {
    pub settings: Settings,
    /// What indirect light is switched back on to.
    pub indirect: Indirect,
    pub orbit: Orbit,
    pub playing: bool,
    pub seconds: f64,
    /// In degrees.
    pub turn: f32,
    pub spheres: f32,
    /// What the slider for them says, until it is let go.
    pub spheres_wanted: f32,
    pub stops: f32,
    pub overlay: Overlay,
    pub backend: Backend,
}

impl State {
    /// What a scene says.
    pub fn new(loaded: &Loaded, options: &Options) -> Self {
        let settings = loaded.scene.settings;
        Self {
            settings,
            indirect: settings.indirect.unwrap_or_default(),
            orbit: Orbit::new(loaded.scene.camera),
            playing: !loaded.motion.is_still(),
            seconds: 0.0,
            turn: 0.0,
            spheres: 1.0,
            spheres_wanted: 1.0,
            stops: 0.0,
            overlay: options.overlay,
            backend: options.backend,
        }
    }

    /// The picture of this state, of a size in pixels.
    pub fn wish(&self, size: [u32; 2], rests: bool) -> Wish {
        Wish {
            settings: self.settings,
            backend: self.backend,
            camera: self.orbit.camera,
            size,
            seconds: self.seconds,
            turn: self.turn.to_radians(),
            spheres: self.spheres,
            stops: self.stops,
            overlay: self.overlay,
            rests,
        }
    }
}
