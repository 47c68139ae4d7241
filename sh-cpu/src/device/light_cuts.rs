//! The spheres that light clusters.

use super::cut::Cuts;
use super::light_cut::LightCut;
use sh_scene::Blocking;

/// The spheres that light each cluster of receivers, in the order in which light meets them. Their memory is kept from
/// frame to frame.
#[derive(Clone, Debug, Default)]
pub struct LightCuts {
    pub(super) cuts: Cuts,
    pub(super) orders: Vec<LightCut>,
    pub(super) blocking: Blocking,
}

impl LightCuts {
    /// How many clusters there are.
    pub fn clusters(&self) -> usize {
        self.orders.len()
    }

    /// How many pairs of a receiver and a sphere there are in all clusters together.
    pub fn pairs(&self) -> usize {
        self.cuts.pairs()
    }

    /// The mean number of spheres in a run, over all clusters: 1 where nothing interlocks, and what has been summed up
    /// always serves on. 0 where there are no runs.
    pub fn run_length(&self) -> f32 {
        let runs = self.orders.iter().flat_map(|order| &order.runs);
        let (count, spheres) = runs.fold((0, 0), |(count, spheres), run| {
            (count + 1, spheres + run.len())
        });
        spheres as f32 / count.max(1) as f32
    }

    /// The mean number of spheres that may hide a part of one, and are looked at for each receiver, over all clusters:
    /// where lights are discs those whose discs may meet, otherwise those that share its run.
    pub fn hiders_per_light(&self) -> f32 {
        let (mut hiders, mut spheres) = (0, 0);
        for order in &self.orders {
            let in_runs = order.runs.iter().map(|run| run.len() * (run.len() - 1));
            hiders += order.hiders.len() + in_runs.sum::<usize>();
            spheres += order.spheres.len();
        }
        hiders as f32 / spheres.max(1) as f32
    }

    /// What hides what.
    pub(crate) fn blocking(&self) -> Blocking {
        self.blocking
    }

    pub(crate) fn of(&self, cluster: usize) -> &LightCut {
        &self.orders[cluster]
    }
}
