//! The upsample pass: light at half resolution to samples, by a joint bilateral filter, and which samples have to be
//! shaded by themselves. The rule and its constants are those of [`sh_scene::upsample`].

use super::gbuffer::Gbuffer;
use super::shares::shares;
use crate::device::check::check_length;
use crate::error::Error;
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::upsample::{CORNER, MAX_SPREAD, MIN_WEIGHT, NORMAL_FROM, footprint};
use sh_scene::{Receiver, Tiles, View};
use std::ops::Range;

/// What is known at half resolution: of the whole grid [`View::halves`], in the order of its tiles.
#[derive(Clone, Debug, Default)]
pub struct Halves {
    /// What the grid's rays see.
    pub receivers: Vec<Receiver>,
    /// The share of its light that each receiver gets through the blockers, in three channels.
    pub shares: Vec<[f32; 3]>,
    /// Radiance that comes by way of other bodies, which is no share of anything: of each receiver, or none at all.
    pub sent: Vec<[f32; 3]>,
}

impl Halves {
    /// From the radiance with and without blockers; 1 where there is no light.
    ///
    /// # Errors
    /// Where there is not one of each for a receiver.
    pub fn new(
        receivers: Vec<Receiver>,
        shadowed: &[[f32; 3]],
        open: &[[f32; 3]],
    ) -> Result<Self, Error> {
        check_length("shadowed", receivers.len(), shadowed.len())?;
        let mut shared = shadowed.to_vec();
        shares(&mut shared, open)?;
        Ok(Self {
            receivers,
            shares: shared,
            sent: Vec::new(),
        })
    }

    /// With the radiance that comes by way of other bodies.
    ///
    /// # Errors
    /// Where there is not one of each for a receiver.
    pub fn with_sent(self, sent: Vec<[f32; 3]>) -> Result<Self, Error> {
        check_length("sent", self.receivers.len(), sent.len())?;
        Ok(Self { sent, ..self })
    }
}

/// Samples that half resolution does not do for. Their memory is kept from band to band.
#[derive(Clone, Debug, Default)]
pub struct Failed {
    /// Which samples, tile by tile.
    pub indices: Vec<u32>,
    /// The samples.
    pub receivers: Vec<Receiver>,
    /// Those of each tile that has any.
    pub clusters: Vec<Range<usize>>,
    flags: Vec<bool>,
}

/// Takes the radiance of samples from that without blockers to that with them: `rows` of tiles of `view`'s samples.
/// `radiance` comes as [`crate::irradiance`] makes it; what half resolution does not do for is left as it is and
/// gathered in `failed`.
///
/// # Errors
/// Where lengths do not fit; nothing is written then.
pub fn upsample(
    view: &View,
    halves: &Halves,
    rows: Range<u32>,
    samples: &Gbuffer,
    radiance: &mut [[f32; 3]],
    failed: &mut Failed,
) -> Result<(), Error> {
    let (grid, fine) = (view.halves(), view.samples());
    let (tiles, across) = (grid.tiles(), fine.tiles().columns as usize);
    let count = across * rows.len() * Tiles::AREA;
    check_length("halves.receivers", tiles.len(), halves.receivers.len())?;
    check_length("halves.shares", tiles.len(), halves.shares.len())?;
    if !halves.sent.is_empty() {
        check_length("halves.sent", tiles.len(), halves.sent.len())?;
    }
    check_length("samples.receivers", count, samples.receivers.len())?;
    check_length("radiance", count, radiance.len())?;
    failed.flags.clear();
    failed.flags.resize(count, false);

    let eye = Vec3A::from(view.camera.eye);
    let cell = footprint(view);
    let steps = grid.spacing / fine.spacing;
    // The share of its own light, and the radiance sent by others, of a sample whose light is `open`.
    let four = |x: u32, y: u32, sample: &Receiver, open: Vec3A| {
        let place = |i: u32| (i as f32 + 0.5) / steps - 0.5;
        let (hx, hy) = (place(x), place(y));
        let (left, top) = (hx.floor(), hy.floor());
        let (mut total, mut shares, mut sent) = (0.0, Mean::default(), Mean::default());
        for corner in 0..4 {
            let (i, j) = (left + (corner % 2) as f32, top + (corner / 2) as f32);
            if i < 0.0 || j < 0.0 || i >= grid.columns as f32 || j >= grid.rows as f32 {
                continue;
            }
            let at = tiles.index(i as u32, j as u32);
            let weight = (1.0 - (hx - i).abs()) * (1.0 - (hy - j).abs());
            let weight = weight * alike(sample, &halves.receivers[at], eye, cell);
            total += weight;
            shares.add(weight, halves.shares[at]);
            sent.add(weight, halves.sent.get(at).copied().unwrap_or_default());
        }
        // What is sent differs too much if it does so against all light.
        let light = (open + sent.high).max(Vec3A::splat(f32::MIN_POSITIVE));
        let spread = shares.spread().max(sent.spread() / light).max_element();
        (total >= MIN_WEIGHT && spread <= MAX_SPREAD)
            .then(|| (shares.sum / total, sent.sum / total))
    };
    radiance
        .par_chunks_mut(Tiles::AREA)
        .zip(failed.flags.par_chunks_mut(Tiles::AREA))
        .zip(samples.receivers.par_chunks(Tiles::AREA))
        .enumerate()
        .for_each(|(tile, ((radiance, flags), samples))| {
            let side = Tiles::SIDE;
            let left = (tile % across) as u32 * side;
            let top = (rows.start + (tile / across) as u32) * side;
            for (i, sample) in samples.iter().enumerate() {
                if sample.covered == 0 {
                    continue;
                }
                let (x, y) = (left + i as u32 % side, top + i as u32 / side);
                let open = Vec3A::from(radiance[i]);
                match four(x, y, sample, open) {
                    Some((share, sent)) => radiance[i] = (open * share + sent).into(),
                    None => flags[i] = true,
                }
            }
        });
    failed.gather(samples);
    Ok(())
}

/// A weighted sum of corners, and the range of those that count.
struct Mean {
    sum: Vec3A,
    low: Vec3A,
    high: Vec3A,
}

impl Default for Mean {
    fn default() -> Self {
        Self {
            sum: Vec3A::ZERO,
            low: Vec3A::INFINITY,
            high: Vec3A::NEG_INFINITY,
        }
    }
}

impl Mean {
    fn add(&mut self, weight: f32, value: [f32; 3]) {
        let value = Vec3A::from(value);
        self.sum += weight * value;
        if weight > CORNER {
            self.low = self.low.min(value);
            self.high = self.high.max(value);
        }
    }

    fn spread(&self) -> Vec3A {
        self.high - self.low
    }
}

impl Failed {
    fn gather(&mut self, samples: &Gbuffer) {
        self.indices.clear();
        self.receivers.clear();
        self.clusters.clear();
        for (tile, flags) in self.flags.chunks(Tiles::AREA).enumerate() {
            let first = self.indices.len();
            for (i, _) in flags.iter().enumerate().filter(|(_, failed)| **failed) {
                let index = tile * Tiles::AREA + i;
                self.indices.push(index as u32);
                self.receivers.push(samples.receivers[index]);
            }
            if self.indices.len() > first {
                self.clusters.push(first..self.indices.len());
            }
        }
    }
}

/// How much the light of a receiver tells of that of a sample, 0 to 1.
fn alike(sample: &Receiver, receiver: &Receiver, eye: Vec3A, cell: f32) -> f32 {
    if receiver.covered == 0 {
        return 0.0;
    }
    let (p, n) = (Vec3A::from(sample.position), Vec3A::from(sample.normal));
    let (q, m) = (Vec3A::from(receiver.position), Vec3A::from(receiver.normal));
    let apart = q - p;
    let height = apart.dot(n).abs().max(apart.dot(m).abs());
    let part = height / (p.distance(eye) * cell);
    let facing = ((n.dot(m) - NORMAL_FROM) / (1.0 - NORMAL_FROM)).clamp(0.0, 1.0);
    (1.0 - part * part).max(0.0) * facing
}
