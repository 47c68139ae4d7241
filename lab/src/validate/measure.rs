//! A scene's truth, and how far the passes are from it.

use gaunt::Error;
use gaunt::compare::ours::{Ours, ours};
use gaunt::compare::twice::Truth;
use gaunt::compare::{Figures, Parts, Radiance, Seen, scale};
use sh_reference::paths;
use sh_scene::Scene;

/// How a truth is traced.
#[derive(Clone, Copy, Debug)]
pub(super) struct Traced {
    /// Pixels across and down.
    pub size: [u32; 2],
    /// Paths a pixel.
    pub paths: u32,
}

/// What is seen of a scene, and its true light with as many bounces as it asks for: bodies are the only reflectors.
pub(super) struct Sight {
    pub seen: Seen,
    pub truth: Truth,
    /// Mean radiance, and that of indirect light alone.
    pub means: [f64; 2],
}

/// Figures of one way to light a sight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Errors {
    /// In parts of the mean radiance.
    pub direct: Figures,
    /// In parts of the mean radiance.
    pub indirect: Figures,
    /// Indirect light's RMS and bias in parts of the mean indirect light.
    pub relative: [f64; 2],
    /// The share of indirect light.
    pub share: f64,
    /// Indirect light on the ground and on bodies, each in parts of its own mean.
    pub places: [Figures; 2],
    /// The same of direct light.
    pub direct_places: [Figures; 2],
}

impl Sight {
    /// Traces a scene.
    pub fn new(scene: &Scene, traced: Traced, light: paths::Source) -> Result<Self, Error> {
        let seen = Seen::new(scene, traced.size)?;
        let truth = trace(scene, &seen, traced, light)?;
        let means = [&truth.parts.total(), &truth.parts.indirect].map(|p| scale(&seen.covered(p)));
        Ok(Self { seen, truth, means })
    }

    /// What the passes make of a scene whose surfaces are those of this sight.
    pub fn ours(&self, scene: &Scene) -> Result<Ours, Error> {
        ours(scene, &self.seen)
    }

    /// How far parts are from the truth.
    pub fn errors(&self, ours: &Parts) -> Errors {
        let [direct, indirect, _] = self.truth.figures(&self.seen, ours, self.means[0]);
        let share = self.means[1] / self.means[0];
        Errors {
            direct,
            indirect,
            relative: [indirect.rms / share, indirect.bias / share],
            share,
            places: self.places(ours, |parts| &parts.indirect),
            direct_places: self.places(ours, |parts| &parts.direct),
        }
    }

    /// Figures of one kind of light on the ground and on bodies, each in parts of the mean there.
    fn places(&self, ours: &Parts, of: fn(&Parts) -> &Radiance) -> [Figures; 2] {
        [false, true].map(|on_bodies| {
            let only = |parts: &Parts| -> Radiance {
                let pairs = self.seen.receivers().iter().zip(of(parts));
                let there = pairs.filter(|(r, _)| r.covered != 0 && (r.object != 0) == on_bodies);
                there.map(|(_, light)| *light).collect()
            };
            let truth = only(&self.truth.parts);
            let errors = only(&self.truth.errors);
            Figures::new(&only(ours), &truth, &errors, scale(&truth))
        })
    }
}

/// The light of a scene at the places that are seen, which may be those of another.
pub(super) fn trace(
    scene: &Scene,
    seen: &Seen,
    traced: Traced,
    light: paths::Source,
) -> Result<Truth, Error> {
    let options = paths::Options {
        bounces: scene.settings.indirect.map_or(0, |i| i.bounces),
        ground_reflects: false,
        light,
    };
    Truth::trace(scene, seen, options, traced.paths, &|_| {})
}
