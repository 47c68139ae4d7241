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
    /// All of it, again in each of several turns.
    Turn(u32),
}

impl Part {
    /// The number of the band; 0 where it is all there is.
    pub fn band(self) -> u32 {
        match self {
            Self::Whole | Self::Turn(_) => 0,
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
    /// pixels or the rest goes along with the samples it belongs to. What bodies do to each other comes before all bands, turn
    /// by turn.
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
        for phase in [Phase::Bodies, Phase::Brought] {
            let passes = self.passes.iter().filter(|p| p.at.phase() == phase);
            let turns = passes.map(|planned| planned.turns.end).max().unwrap_or(0);
            for turn in 0..turns {
                let part = match turns {
                    1 => Part::Whole,
                    _ => Part::Turn(turn),
                };
                self.add(phase, turn, part, &mut steps);
            }
        }
        for (phase, bands) in [(Phase::Coarse, halves), (Phase::Fine, samples)] {
            for band in 0..bands {
                self.add(phase, 0, Part::Band(band), &mut steps);
            }
        }
        steps
    }

    /// Adds what of a phase runs in a turn.
    fn add(&self, phase: Phase, turn: u32, part: Part, steps: &mut Vec<Step>) {
        let passes = self.passes.iter().enumerate();
        let now = passes
            .filter(|(_, planned)| planned.at.phase() == phase && planned.turns.contains(&turn));
        steps.extend(now.map(|(pass, _)| Step { pass, part }));
    }
}
