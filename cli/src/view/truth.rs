//! How far the picture is from the truth: paths are traced, round after round, while nothing moves.

use super::layer::{heat, veil};
use super::wish::{Layer, Legend, Wish};
use crate::Error;
use crate::compare::{Figures, Seen, ours::ours, scale};
use crate::truth::{self, Source};
use sh_reference::paths;
use sh_scene::Scene;
use std::sync::Arc;

/// Receivers across at most: the truth takes long.
const ACROSS: u32 = 320;

/// Paths a receiver in one round.
const ROUND: u32 = 8;

/// Rounds, after which the noise is small beside the errors.
const ROUNDS: u32 = 128;

/// Receivers between two looks whether something else is wished for.
const PORTION: usize = 4096;

/// The error that the brightest colour stands for, in parts of the mean radiance.
const WORST: f64 = 0.25;

/// The sums of two independent halves of all rounds.
struct Sums {
    halves: [Vec<[f64; 3]>; 2],
    rounds: [u32; 2],
}

/// Traces rounds until `stop` says so or the truth is good enough, and hands a layer to `improve` after each even one.
pub(super) fn trace(
    scene: &Scene,
    wish: &Wish,
    stop: &dyn Fn() -> bool,
    improve: &dyn Fn(Layer),
) -> Result<(), Error> {
    let [width, height] = wish.size;
    let coarse = width.div_ceil(ACROSS).max(1);
    let seen = Seen::new(scene, [width, height].map(|side| (side / coarse).max(1)))?;
    let ours = ours(scene, &seen)?.parts.total();
    let bounces = truth::bounces(&scene.settings);
    let options = paths::Options {
        bounces,
        ground_reflects: false,
        light: Source::Map.into(),
    };
    let tracer = truth::tracer(scene, options)?;
    let receivers = seen.receivers();
    let nothing = vec![[0.0; 3]; receivers.len()];
    let mut sums = Sums {
        halves: [nothing.clone(), nothing],
        rounds: [0; 2],
    };
    for round in 0..ROUNDS {
        let half = (round % 2) as usize;
        for (portion, receivers) in receivers.chunks(PORTION).enumerate() {
            if stop() {
                return Ok(());
            }
            let from = portion * PORTION;
            let first = round as usize * seen.receivers().len() + from;
            let found = truth::trace(&tracer, receivers, first, ROUND, &|_| {});
            for (sum, found) in sums.halves[half][from..].iter_mut().zip(found) {
                for (sum, found) in sum.iter_mut().zip(found.total()) {
                    *sum += found;
                }
            }
        }
        sums.rounds[half] += 1;
        // Layers cost little beside a round, but nobody can tell the 100th from the 99th.
        if half == 1 && (round < 16 || round % 8 == 7) {
            improve(layer(&seen, &ours, &sums, bounces));
        }
    }
    Ok(())
}

/// What is known after some rounds, as many of one half as of the other.
fn layer(seen: &Seen, ours: &[[f32; 3]], sums: &Sums, bounces: u32) -> Layer {
    let [a, b] = &sums.halves;
    let rounds = f64::from(sums.rounds[0].max(1));
    let both = |sign: f64| -> Vec<[f32; 3]> {
        let pairs = a.iter().zip(b);
        let one = |(a, b): (&[f64; 3], &[f64; 3])| {
            truth::narrow([0, 1, 2].map(|c| 0.5 * (a[c] + sign * b[c]) / rounds))
        };
        pairs.map(one).collect()
    };
    let (truth, errors) = (both(1.0), both(-1.0));
    let mean = scale(&seen.covered(&truth));
    let figures = Figures::new(
        &seen.covered(ours),
        &seen.covered(&truth),
        &seen.covered(&errors),
        mean,
    );
    let tiles = seen.tiles();
    let image = veil(seen.width, seen.height, |x, y| {
        let at = tiles.index(x, y);
        let off = [0, 1, 2].map(|c| f64::from(ours[at][c] - truth[at][c]).powi(2));
        let off = (off.iter().sum::<f64>() / 3.0).sqrt() / mean;
        (seen.receivers()[at].covered != 0).then(|| heat((off / WORST) as f32))
    });
    let paths = ROUND * (sums.rounds[0] + sums.rounds[1]);
    let light = match bounces {
        0 => "direct light".into(),
        1 => "one bounce".into(),
        n => format!("{n} bounces"),
    };
    Layer {
        image: Arc::new(image),
        legend: Legend {
            title: "Error against the path tracer".into(),
            ends: Some(["0 %".into(), format!("{:.0} % of the mean", 100.0 * WORST)]),
            notes: vec![
                format!(
                    "{:.1} % RMS, {:.1} % noise",
                    100.0 * figures.rms,
                    100.0 * figures.noise
                ),
                format!("{paths} paths a receiver, {light}, the map as it is"),
                format!("{} × {} receivers", seen.width, seen.height),
            ],
        },
    }
}
