//! The share of the machine's multiply-add peak that the inner loop reaches.

use super::world::ORDER;
use gaunt::Error;
use sh_codegen::routines;
use sh_cpu::{CutOptions, Cuts, Path, Shadow, multiply_adds_per_second, shadow_clusters};
use sh_scene::{Forest, Light, Limits, Receiver, Sphere};
use std::time::Instant;

/// What the accumulation of blockers takes.
#[derive(Clone, Copy, Debug)]
pub struct Inner {
    /// Nanoseconds a receiver and blocker, on one thread, for blockers wholly in front.
    pub front_ns: f64,
    /// The same for blockers to which the self-shadow rule has to be applied.
    pub across_ns: f64,
    /// Useful operations of the generated routine over what the processor could do in `front_ns`: twice its fused
    /// multiply-adds.
    pub share: f64,
    /// The same for `across_ns`: the self-shadow rule's own operations do not count.
    pub across_share: f64,
}

/// Times the shadow pass for a patch of floor under few blockers and under many: the difference is what blockers
/// cost. Call it on a pool of one thread.
///
/// # Errors
/// Where the pass refuses what it is given, which does not happen.
pub fn inner(path: Path) -> Result<Inner, Error> {
    const SIDE: usize = 32;
    const FEW: usize = 16;
    const MANY: usize = 144;
    const ROUNDS: usize = 40;
    let receivers: Vec<Receiver> = (0..SIDE * SIDE)
        .map(|i| Receiver {
            position: [0.1 * (i % SIDE) as f32, 0.0, 0.1 * (i / SIDE) as f32],
            covered: 1,
            normal: [0.0, 1.0, 0.0],
            object: 0,
        })
        .collect();
    // Above the floor, or across it.
    let balls = |height: fn(f32) -> f32| -> Vec<Sphere> {
        let ball = |i: usize| {
            let t = i as f32;
            let [x, z] = [1.7, 2.3].map(|k| 3.0 * (k * t).sin());
            Sphere {
                center: [x, height(t), z],
                radius: 0.3,
            }
        };
        (0..MANY).map(ball).collect()
    };
    let (above, across) = (balls(|t| 1.5 + t.cos()), balls(|t| 0.25 * t.cos()));
    let light = Light {
        order: ORDER,
        coefficients: vec![[1.0, 0.9, 0.8]; ORDER * ORDER],
        emitters: Vec::new(),
    };
    let everything = 0..receivers.len();
    let clusters = std::slice::from_ref(&everything);
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    let cuts = |count: usize, cut: bool| {
        if cut {
            return Cuts::everything(&across[..count], receivers.len(), &light);
        }
        let balls = &above[..count];
        let mut cuts = Cuts::default();
        let options = CutOptions {
            limits: Limits::LEAVES,
            ratios: true,
            accumulation: ORDER,
        };
        let forest = Forest::new(balls, &[count]);
        cuts.bound(&receivers, clusters, 0..1);
        cuts.find(path, &forest, &light, options);
        cuts
    };
    let sets = [false, true].map(|across| [FEW, MANY].map(|count| cuts(count, across)));
    let mut best = [[f64::INFINITY; 2]; 2];
    let mut peak = 0.0_f64;
    // Interleaved, so that a busy moment of the machine hits all alike; the least time of each counts.
    for round in 0..ROUNDS {
        for (sets, best) in sets.iter().zip(&mut best) {
            for (cuts, best) in sets.iter().zip(best) {
                let shadow = Shadow {
                    clusters,
                    cuts,
                    light: &light,
                    accumulation: ORDER,
                    baked: None,
                    eye: None,
                };
                let start = Instant::now();
                shadow_clusters(path, &receivers, &shadow, &mut radiance)?;
                *best = best.min(start.elapsed().as_secs_f64());
            }
        }
        if round % 10 == 0 {
            peak = peak.max(multiply_adds_per_second(path));
        }
    }
    let pairs = (receivers.len() * (MANY - FEW)) as f64;
    let [front, across] = best.map(|[few, many]| (many - few) / pairs);
    let routine = routines::find("accumulate_blocker");
    let ops = routine.map_or(0, |routine| {
        let ops = routine.ops(ORDER);
        ops.mul + ops.add
    });
    let ideal = ops as f64 / (2.0 * peak);
    Ok(Inner {
        front_ns: front * 1e9,
        across_ns: across * 1e9,
        share: ideal / front,
        across_share: ideal / across,
    })
}
