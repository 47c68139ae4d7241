//! The steps of a frame.

use super::Plan;
use super::resource::Phase;

/// What of a pass a step does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// All of it.
    Whole,
    /// One of the horizontal bands that a grid of receivers is divided into, from the top.
    Band(u32),
}

impl Part {
    /// The number of the band; 0 where it is all there is.
    pub fn band(self) -> u32 {
        match self {
            Self::Whole => 0,
            Self::Band(band) => band,
        }
    }
}

/// One thing to do: a backend does a plan's steps one after the other and asks nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Step {
    /// Index of the pass in [`Plan::passes`].
    pub pass: usize,
    /// What of it.
    pub part: Part,
}

impl Plan {
    /// The steps of a frame whose grids are divided into so many bands: at half resolution, and of samples. What runs over
    /// pixels or the rest goes along with the samples it belongs to.
    ///
    /// ```
    /// # use sh_scene::*;
    /// # fn steps_of(plan: &Plan) {
    /// for Step { pass, part } in plan.steps(1, 4) {
    ///     println!("{} {part:?}", plan.passes[pass].name());
    /// }
    /// # }
    /// ```
    pub fn steps(&self, halves: u32, samples: u32) -> Vec<Step> {
        let mut steps = Vec::new();
        let phases = [
            (Phase::Once, None),
            (Phase::Coarse, Some(halves)),
            (Phase::Fine, Some(samples)),
        ];
        for (phase, bands) in phases {
            for band in 0..bands.unwrap_or(1) {
                let part = match bands {
                    None => Part::Whole,
                    Some(_) => Part::Band(band),
                };
                let passes = self.passes.iter().enumerate();
                let passes = passes.filter(|(_, planned)| planned.at.phase() == phase);
                steps.extend(passes.map(|(pass, _)| Step { pass, part }));
            }
        }
        steps
    }
}
