//! The pictures of a sheet: what the eye sees of ours, of the truth and of their difference.

use super::measure::{Parts, Radiance};
use super::sheet::Cell;
use super::view::Seen;
use sh_scene::Scene;

/// How much brighter than the rest indirect light is shown.
const INDIRECT: f32 = 3.0;

/// What pictures are made of besides radiance.
pub struct Pictures<'a> {
    /// What is lit.
    pub scene: &'a Scene,
    /// Its receivers.
    pub seen: &'a Seen,
    /// The factor between radiance and the tone curve.
    pub exposure: f32,
}

/// One kind of light.
struct Kind {
    name: &'static str,
    /// How much brighter it is shown.
    factor: f32,
    /// Whether the sky is in it.
    sky: bool,
    of: fn(&Parts) -> Radiance,
}

const KINDS: [Kind; 3] = [
    Kind {
        name: "All light",
        factor: 1.0,
        sky: true,
        of: Parts::total,
    },
    Kind {
        name: "Direct",
        factor: 1.0,
        sky: true,
        of: |parts| parts.direct.clone(),
    },
    Kind {
        name: "Indirect, 3 times",
        factor: INDIRECT,
        sky: false,
        of: |parts| parts.indirect.clone(),
    },
];

impl Pictures<'_> {
    /// A row for each kind of light: ours, the truth, twice their difference; at the end of the first row the spheres,
    /// at the end of the others the truth with the ground reflecting, where there is one.
    pub fn rows(
        &self,
        ours: &Parts,
        truth: &Parts,
        ground: Option<&Parts>,
        spheres: Vec<[f32; 3]>,
    ) -> Vec<Vec<Cell>> {
        let mut rows = KINDS.map(|kind| self.row(&kind, ours, truth, ground));
        rows[0].truncate(3);
        rows[0].push(Cell {
            caption: "The spheres".into(),
            pixels: self.exposed(spheres, 1.0),
        });
        rows.into()
    }

    fn row(&self, kind: &Kind, ours: &Parts, truth: &Parts, ground: Option<&Parts>) -> Vec<Cell> {
        let cell = |what: &str, radiance: &Radiance, factor: f32, sky: bool| Cell {
            caption: format!("{}: {what}", kind.name),
            pixels: self.exposed(self.shaded(radiance, sky), factor * kind.factor),
        };
        let (ours, truth) = ((kind.of)(ours), (kind.of)(truth));
        let pairs = ours.iter().zip(&truth);
        let apart = pairs.map(|(a, b)| std::array::from_fn(|c| (a[c] - b[c]).abs()));
        let mut cells = vec![
            cell("ours", &ours, 1.0, kind.sky),
            cell("the truth", &truth, 1.0, kind.sky),
            cell("difference, twice", &apart.collect(), 2.0, false),
        ];
        if let Some(ground) = ground.map(kind.of) {
            let what = "the truth if the ground reflects too";
            cells.push(cell(what, &ground, 1.0, kind.sky));
        }
        cells
    }

    /// Radiance times albedo, and the sky or nothing behind.
    fn shaded(&self, radiance: &Radiance, sky: bool) -> Vec<[f32; 3]> {
        self.seen.shaded(radiance, |ray| match sky {
            true => self.scene.environment.sample(ray),
            false => [0.0; 3],
        })
    }

    fn exposed(&self, pixels: Vec<[f32; 3]>, factor: f32) -> Vec<[f32; 3]> {
        let factor = factor * self.exposure;
        let pixels = pixels.into_iter().map(|p| p.map(|c| c * factor));
        pixels.collect()
    }
}
