//! The functions in which a body's irradiance is written.

use super::parts::{BasisParts, BasisSample};
use super::shape::Shape;
use super::weights;
use sh_core::constants::{MOST_COEFFICIENTS, PATCH_SAMPLES, REGION_PATCHES};

/// Functions on a body's surface in which its irradiance is written: Ψ₀ = 1, and others that are at right angles to it and
/// to each other, in the order of how much they tell. The mean of Ψᵢ² over the surface is 1.
///
/// `sh_bake::irradiance_basis` finds them.
#[derive(Clone, Debug, PartialEq)]
pub struct IrradianceBasis {
    parts: BasisParts,
    /// All patches: those first that take light that bodies have sent.
    order: Vec<usize>,
    /// How many these are.
    few: usize,
    /// Of each function, at all points: what the weights of irradiance are found with.
    dual: Vec<f32>,
    /// The same at the few.
    few_dual: Vec<f32>,
    /// What each patch sends on of each function, patch by patch.
    sends: Vec<[f32; 3]>,
    /// Lobes times their patches' areas.
    lobes: Vec<[f32; MOST_COEFFICIENTS]>,
    shape: Shape,
}

impl IrradianceBasis {
    /// The most functions there may be.
    pub const MOST: usize = 64;

    /// Of what is known of a body; none where that does not fit together, or is no number.
    pub fn new(parts: BasisParts) -> Option<Self> {
        let (samples, count) = (parts.samples.len(), parts.held.len());
        let patches = samples / PATCH_SAMPLES;
        let fits = samples > 0
            && samples.is_multiple_of(PATCH_SAMPLES * REGION_PATCHES)
            && (1..=Self::MOST).contains(&count)
            && parts.values.len() == count * samples
            && parts.patches.len() == patches
            && parts.lobes.len() == patches
            && (parts.own.is_empty() || parts.own.len() == patches * count);
        let numbers = parts.values.iter().chain(parts.own.as_flattened());
        let mut numbers = numbers.chain(parts.lobes.as_flattened());
        if !fits || !numbers.all(|x| x.is_finite()) {
            return None;
        }
        let area = parts.area * PATCH_SAMPLES as f32;
        let lobes = parts.lobes.iter();
        let few = weights::few(patches, count);
        let order = weights::order(patches, few);
        Some(Self {
            sends: weights::sends(&parts, count),
            lobes: lobes.map(|lobe| lobe.map(|y| area * y)).collect(),
            dual: weights::dual(&parts.values, count, &(0..patches).collect::<Vec<_>>())?,
            few_dual: weights::dual(&parts.values, count, &order[..few])?,
            order,
            few,
            shape: Shape::of(&parts),
            parts,
        })
    }

    /// How many functions there are.
    pub fn count(&self) -> usize {
        self.parts.held.len()
    }

    /// How many patches there are, and as many points.
    pub fn patches(&self) -> usize {
        self.parts.patches.len()
    }

    /// What it was made of.
    pub fn parts(&self) -> &BasisParts {
        &self.parts
    }

    /// The samples, each for as much area as the others.
    pub fn samples(&self) -> &[BasisSample] {
        &self.parts.samples
    }

    /// Those at which light is looked up: one a patch.
    pub fn points(&self) -> impl ExactSizeIterator<Item = &BasisSample> {
        self.parts
            .samples
            .chunks_exact(PATCH_SAMPLES)
            .map(|s| &s[0])
    }

    /// All patches in the order in which their points are lit: the [few](Self::few) come first.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// How many of the patches' points take the light that bodies have sent: less than all, since it varies less.
    pub fn few(&self) -> usize {
        self.few
    }

    /// What each patch gives of each function times albedo, in the mean of its samples: patch by patch.
    pub fn sends(&self) -> &[[f32; 3]] {
        &self.sends
    }

    /// The integral of the basis over the directions in which each patch is seen, times the area that is seen: coefficients
    /// of order 6, by the direction from the patch.
    pub fn lobes(&self) -> &[[f32; MOST_COEFFICIENTS]] {
        &self.lobes
    }

    /// What is seen of the body: its regions, and the ball around them.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// The values of function `i`, sample by sample.
    pub fn function(&self, i: usize) -> &[f32] {
        let samples = self.parts.samples.len();
        &self.parts.values[i * samples..][..samples]
    }

    /// How much of the lights that the body was taught by the first `count` functions tell: the share of their mean square,
    /// 0 to 1.
    pub fn held(&self, count: usize) -> f32 {
        self.parts.held[count.clamp(1, self.count()) - 1]
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.parts.samples[..])
            + size_of_val(&self.parts.values[..])
            + size_of_val(&self.parts.patches[..])
            + size_of_val(&self.parts.lobes[..])
            + size_of_val(&self.parts.own[..])
            + size_of_val(&self.order[..])
            + size_of_val(&self.dual[..])
            + size_of_val(&self.few_dual[..])
            + size_of_val(&self.sends[..])
            + size_of_val(&self.lobes[..])
            + self.shape.bytes()
    }

    /// The weights of irradiance that is told at [all points](Self::points): the best, by least squares. Even light is
    /// told exactly, other light that the functions can tell to a thousandth.
    ///
    /// Cost: a multiply-add a point, function and channel.
    pub fn weights(&self, irradiance: &[[f32; 3]]) -> Vec<[f32; 3]> {
        weights::found(&self.dual, self.patches(), irradiance)
    }

    /// The same of irradiance that is told at the [few](Self::few) of them, in their [order](Self::order).
    pub fn weights_of_few(&self, irradiance: &[[f32; 3]]) -> Vec<[f32; 3]> {
        weights::found(&self.few_dual, self.few, irradiance)
    }

    /// Irradiance at a sample, by the weights of the first functions.
    pub fn irradiance(&self, weights: &[[f32; 3]], sample: usize) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for (i, weight) in weights.iter().enumerate().take(self.count()) {
            let value = self.function(i)[sample];
            for (sum, weight) in sum.iter_mut().zip(weight) {
                *sum += value * weight;
            }
        }
        sum
    }

    /// Radiance that each patch sends on, where irradiance has these weights; nowhere below 0, which a sum of functions may be.
    pub fn sent(&self, weights: &[[f32; 3]]) -> Vec<[f32; 3]> {
        weights::told(&self.sends, weights)
    }

    /// The light that the body sends each of its patches itself, where irradiance of these weights is reflected once; nothing
    /// where it sends itself none.
    pub fn bounced(&self, weights: &[[f32; 3]]) -> Vec<[f32; 3]> {
        weights::told(&self.parts.own, weights)
    }

    /// For each function what irradiance at every point is multiplied with, function by function.
    pub fn dual(&self) -> &[f32] {
        &self.dual
    }

    /// The same at the [few](Self::few).
    pub fn few_dual(&self) -> &[f32] {
        &self.few_dual
    }
}
