//! Moving frames of a scene: the time of each stage, against one lane on one thread.

use super::device::{Clock, Shadows};
use super::peak::{self, Inner};
use super::scenes::{self, Name};
use super::times::{Stage, median};
use super::world::{GATHER, ORDER, SHADOW, STAGES, World};
use fearless_simd::Level;
use gaunt::Error;
use gaunt::progress::Progress;
use gaunt::render::{Backend, Choice, choose};
use rayon::{ThreadPool, ThreadPoolBuilder};
use serde::Serialize;
use sh_cpu::{Path, lane_count};
use sh_gpu::ShadowOptions;
use std::fmt;

/// Frames that are timed, a thirtieth of a second apart.
const FRAMES: usize = 60;

/// Of these, every so many is timed with one lane on one thread as well.
const SCALAR_EVERY: usize = 4;

/// Milliseconds of each of [`STAGES`].
type Stages = [f64; STAGES.len()];

/// What a run found.
#[derive(Clone, Debug, Serialize)]
struct Report {
    scene: &'static str,
    backend: &'static str,
    /// What shades.
    device: String,
    /// What the time of the shadow stage was taken with.
    clock: &'static str,
    threads: usize,
    lanes: usize,
    /// Of a frame with all stages.
    frames_per_s: f64,
    stages: Vec<Stage>,
    receivers: usize,
    moving_receivers: usize,
    spheres: usize,
    /// Those that send light on, and lamps.
    lights: usize,
    clusters: usize,
    /// Bytes of GPU memory that the shadow pass and its buffers take.
    #[serde(skip_serializing_if = "Option::is_none")]
    gpu_bytes: Option<u64>,
    spheres_per_receiver: f64,
    /// Pairs of a receiver and a blocker of its cut, over the time of the shadow stage, exponential and lights
    /// included.
    receiver_spheres_per_s: f64,
    /// Of the inner loop, for blockers in front of the tangent plane.
    fma_peak_share: Option<f64>,
    /// The same where the self-shadow rule is applied; its operations do not count as useful.
    self_shadow_fma_peak_share: Option<f64>,
    /// Nanoseconds a receiver and blocker in front, one thread.
    inner_loop_ns: Option<f64>,
    /// The same where the self-shadow rule is applied.
    self_shadow_ns: Option<f64>,
    /// A frame's time with one fused lane on one thread, over this.
    speedup_over_scalar: f64,
    /// The same for the shadow stage alone.
    shadow_speedup_over_scalar: f64,
    /// Where spheres send light on.
    #[serde(flatten)]
    sent: Option<SentOn>,
}

/// What is measured of light that spheres send on.
#[derive(Clone, Copy, Debug, Serialize)]
struct SentOn {
    /// Points on the surfaces that spheres stand for.
    surface_points: usize,
    /// Spheres that may hide a part of a light, and are looked at.
    hiders_per_light: f32,
    /// Spheres of a cut in a run: 1 where what has been summed up always serves on, 0 where nothing is summed up.
    run_length: f32,
    /// Pairs of a receiver and a light of its cut, over the time of the stage that gathers them.
    receiver_lights_per_s: f64,
    /// Time of that stage with one lane on one thread, over this.
    gather_speedup_over_scalar: f64,
}

/// Runs a scene; the report as text.
///
/// # Errors
/// Where threads cannot be started.
pub fn run(scene: Name, backend: Backend, json: bool) -> Result<String, Error> {
    let report = measure(scene, backend)?;
    if json {
        return Ok(serde_json::to_string(&report)?);
    }
    Ok(report.to_string())
}

fn pool(threads: usize) -> Result<ThreadPool, Error> {
    let built = ThreadPoolBuilder::new().num_threads(threads).build();
    built.map_err(|e| Error::Usage(format!("threads cannot be started: {e}")))
}

fn measure(scene: Name, backend: Backend) -> Result<Report, Error> {
    let plan = scenes::plan(scene);
    // What sends light on is timed on the CPU.
    let backend = match (plan.indirect, backend) {
        (Some(_), Backend::Auto) => Backend::Cpu,
        (Some(_), Backend::Gpu) => {
            return Err(Error::Usage(format!(
                "`gaunt-lab bench {}` has no stages for the GPU: leave --backend out",
                scene.name()
            )));
        }
        _ => backend,
    };
    let Choice { gpu, .. } = choose(backend)?;
    let progress = Progress::new("timing frames");
    let threads = rayon::current_num_threads();
    let (all, one) = (pool(threads)?, pool(1)?);
    let mut world = World::new(plan)?;
    let (best, scalar) = (Path::best(), Path::One(Level::new()));
    let shadows = gpu.as_ref().map(|gpu| {
        let options = ShadowOptions {
            order: ORDER,
            accumulation: ORDER,
            max_blockers: world.spheres.len() as u32,
            max_emitters: world.light.emitters.len() as u32,
            ..ShadowOptions::default()
        };
        Shadows::new(gpu, world.receivers.len(), &world.clusters, options)
    });
    let shadows = shadows.transpose()?;
    let frame = |world: &mut World, seconds: f32| -> Result<Stages, Error> {
        let Some(shadows) = &shadows else {
            return all.install(|| world.frame(best, seconds));
        };
        let set_out = all.install(|| world.set_out(seconds))?;
        let World {
            receivers,
            forest,
            limits,
            light: lit,
            ..
        } = world;
        let shadow = shadows.frame(receivers, forest, *limits, lit)?;
        let mut spent = [0.0; STAGES.len()];
        spent[..3].copy_from_slice(&set_out);
        spent[SHADOW] = shadow;
        Ok(spent)
    };
    // Memory is touched and processors wake up.
    frame(&mut world, 0.0)?;
    one.install(|| world.frame(scalar, 0.0))?;
    frame(&mut world, 0.0)?;
    let (mut fast, mut slow) = (Vec::new(), Vec::new());
    let mut pairs = Vec::new();
    for index in 0..FRAMES {
        progress.set(index as f32 / FRAMES as f32);
        let seconds = index as f32 / 30.0;
        fast.push(frame(&mut world, seconds)?);
        if index % SCALAR_EVERY == 0 {
            slow.push(one.install(|| world.frame(scalar, seconds))?);
            pairs.push(world.cuts.pairs() as f64);
        }
    }
    progress.finish();
    let inner = match gpu {
        None => Some(one.install(|| peak::inner(best))?),
        Some(_) => None,
    };
    let total = |frames: &[Stages]| median(frames.iter().map(|stages| stages.iter().sum()));
    let of = |frames: &[Stages], i: usize| median(frames.iter().map(|stages| stages[i]));
    let stages = STAGES.iter().enumerate().map(|(i, name)| Stage {
        name,
        ms: of(&fast, i),
    });
    // On the GPU cuts are found within the shadow pass; where nothing is sent on there is nothing to gather.
    let stages = stages.filter(|stage| gpu.is_none() || stage.name != "cut");
    let stages = stages.filter(|stage| world.sent.is_some() || !stage.name.starts_with("light_"));
    let pairs = median(pairs.into_iter());
    let sent = world.sent.as_ref().map(|sent| SentOn {
        surface_points: sent.points(),
        hiders_per_light: sent.cuts.hiders_per_light(),
        run_length: sent.cuts.run_length(),
        receiver_lights_per_s: sent.cuts.pairs() as f64 / (of(&fast, GATHER) * 1e-3),
        gather_speedup_over_scalar: of(&slow, GATHER) / of(&fast, GATHER),
    });
    let senders = if sent.is_some() {
        world.spheres.len()
    } else {
        0
    };
    let of_inner = |value: fn(&Inner) -> f64| inner.as_ref().map(value);
    Ok(Report {
        scene: scene.name(),
        backend: if gpu.is_some() { "gpu" } else { "cpu" },
        device: match &gpu {
            Some(gpu) => gpu.name.clone(),
            None => format!("the CPU, {} lanes, {threads} threads", lane_count(best)),
        },
        clock: match shadows.as_ref().map(Shadows::clock) {
            Some(Clock::Device) => "timestamps of the device",
            _ => "wall",
        },
        threads,
        lanes: lane_count(best),
        frames_per_s: 1e3 / total(&fast),
        stages: stages.collect(),
        receivers: world.receivers.len(),
        moving_receivers: world.moving(),
        spheres: world.spheres.len(),
        lights: senders + world.light.emitters.len(),
        clusters: world.clusters.len(),
        gpu_bytes: shadows.as_ref().map(Shadows::bytes),
        spheres_per_receiver: pairs / world.receivers.len() as f64,
        receiver_spheres_per_s: pairs / (of(&fast, SHADOW) * 1e-3),
        fma_peak_share: of_inner(|inner| inner.share),
        self_shadow_fma_peak_share: of_inner(|inner| inner.across_share),
        inner_loop_ns: of_inner(|inner| inner.front_ns),
        self_shadow_ns: of_inner(|inner| inner.across_ns),
        speedup_over_scalar: total(&slow) / total(&fast),
        shadow_speedup_over_scalar: of(&slow, SHADOW) / of(&fast, SHADOW),
        sent,
    })
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            scene,
            device,
            receivers,
            moving_receivers,
            spheres,
            lights,
            clusters,
            clock,
            ..
        } = self;
        writeln!(
            f,
            "{scene}: {receivers} receivers ({moving_receivers} of them move), {spheres} spheres, {clusters} clusters,\n\
             SH order {ORDER}, an environment and {lights} other lights. Shaded by {device}; clock: {clock}.\n"
        )?;
        if let Some(bytes) = self.gpu_bytes {
            writeln!(f, "  {:<12} {bytes:>8} bytes", "GPU memory")?;
        }
        for Stage { name, ms } in &self.stages {
            writeln!(f, "  {name:<12} {ms:>8.3} ms")?;
        }
        writeln!(
            f,
            "\n  frames a second               {:>8.1}",
            self.frames_per_s
        )?;
        writeln!(
            f,
            "  spheres a receiver            {:>8.1}",
            self.spheres_per_receiver
        )?;
        let rate = self.receiver_spheres_per_s * 1e-6;
        writeln!(f, "  million receivers × spheres/s {rate:>8.0}")?;
        let rows = [
            (
                "inner loop, of the peak",
                self.fma_peak_share,
                self.inner_loop_ns,
            ),
            (
                "  with the self-shadow rule",
                self.self_shadow_fma_peak_share,
                self.self_shadow_ns,
            ),
        ];
        for (name, share, ns) in rows {
            if let (Some(share), Some(ns)) = (share, ns) {
                let percent = share * 100.0;
                writeln!(
                    f,
                    "  {name:<29} {percent:>8.1} % ({ns:.2} ns a receiver and sphere, one thread)"
                )?;
            }
        }
        if let Some(sent) = &self.sent {
            let rate = sent.receiver_lights_per_s * 1e-6;
            writeln!(
                f,
                "  surface points                {:>8}",
                sent.surface_points
            )?;
            writeln!(
                f,
                "  hiders a light                {:>8.1}",
                sent.hiders_per_light
            )?;
            writeln!(
                f,
                "  million receivers × lights/s  {rate:>8.0} (over one lane on one thread {:.1} times)",
                sent.gather_speedup_over_scalar
            )?;
        }
        write!(
            f,
            "  over one lane on one thread   {:>8.1} times (the shadow stage {:.1})",
            self.speedup_over_scalar, self.shadow_speedup_over_scalar
        )
    }
}
