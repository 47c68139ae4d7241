//! Rooms whose bodies send light to and fro by their patches: vertices are what is lit, as in Iwasaki et al. 2007, section 7.

use super::times::{Stage, median};
use crate::rooms::{self, WALLS};
use gaunt::Error;
use gaunt::progress::Progress;
use glam::{Affine3A, Quat, Vec3};
use rayon::prelude::*;
use serde::Serialize;
use sh_cpu::{Frames, Path, lane_count};
use sh_scene::{Clusters, Indirect, Plan, Receiver, Scene};
use std::fmt;
use std::ops::Range;
use std::time::Instant;

/// Frames that are timed of each kind.
const FRAMES: usize = 24;

/// Receivers of a cluster.
const CLUSTER: usize = 256;

/// What changes from frame to frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Change {
    Light,
    View,
    OneBody,
    AllBodies,
}

impl Change {
    const ALL: [Self; 4] = [Self::Light, Self::View, Self::OneBody, Self::AllBodies];

    fn name(self) -> &'static str {
        match self {
            Self::Light => "the light changes",
            Self::View => "the view moves",
            Self::OneBody => "one body moves",
            Self::AllBodies => "all bodies move",
        }
    }
}

/// Frames of one kind.
#[derive(Clone, Debug, Serialize)]
struct Kind {
    change: Change,
    frames_per_s: f64,
    stages: Vec<Stage>,
}

/// What a run found.
#[derive(Clone, Debug, Serialize)]
struct Report {
    scene: &'static str,
    device: String,
    threads: usize,
    receivers: usize,
    clusters: usize,
    bodies: usize,
    spheres: usize,
    patches: usize,
    functions: usize,
    bounces: u32,
    /// Seconds to make the scene: spheres, their weights, functions; of all bodies that differ, on all threads.
    baked_s: f64,
    /// Bytes of what is known of the bodies' light.
    bytes: usize,
    kinds: Vec<Kind>,
    /// What one bounce more takes, over a frame where all bodies move.
    bounce_share: f64,
}

/// Times a room; the report as text.
///
/// # Errors
/// Where the room cannot be lit, which does not happen.
pub fn run(name: &'static str, make: fn() -> Scene, json: bool) -> Result<String, Error> {
    let start = Instant::now();
    let scene = make();
    let baked_s = start.elapsed().as_secs_f64();
    let report = measure(name, scene, baked_s)?;
    if json {
        return Ok(serde_json::to_string(&report)?);
    }
    Ok(report.to_string())
}

/// Vertices of a body in its own space, cluster by cluster.
struct Vertices {
    receivers: Vec<Receiver>,
    clusters: Vec<Range<usize>>,
}

impl Vertices {
    fn of(scene: &Scene, object: usize) -> Self {
        let mesh = &scene.objects[object].mesh;
        let vertices = mesh.positions.iter().zip(&mesh.normals);
        let own: Vec<Receiver> = vertices
            .map(|(position, normal)| Receiver {
                position: *position,
                covered: 1,
                normal: *normal,
                object: scene.body(object),
            })
            .collect();
        let groups = Clusters::new(&own, own.len().div_ceil(CLUSTER));
        Self {
            receivers: groups.sorted(&own),
            clusters: groups.ranges,
        }
    }
}

/// A scene and all that is lit of it.
struct Lit {
    scene: Scene,
    /// Where its objects stand, and the radiance of its lamps, before anything changes.
    rest: (Vec<Affine3A>, Vec<[f32; 3]>),
    bodies: Vec<Vertices>,
    receivers: Vec<Receiver>,
    clusters: Vec<Range<usize>>,
}

impl Lit {
    fn new(scene: Scene) -> Self {
        let count = scene.objects.len();
        let bodies: Vec<Vertices> = (0..count)
            .into_par_iter()
            .map(|object| Vertices::of(&scene, object))
            .collect();
        let mut first = 0;
        let mut clusters = Vec::new();
        for body in &bodies {
            let own = body.clusters.iter();
            clusters.extend(own.map(|range| range.start + first..range.end + first));
            first += body.receivers.len();
        }
        Self {
            rest: (
                scene.objects.iter().map(|o| o.transform).collect(),
                scene.lights.iter().map(|light| light.radiance).collect(),
            ),
            receivers: Vec::with_capacity(first),
            scene,
            bodies,
            clusters,
        }
    }

    /// Frame number `frame` of a kind: in each something is other than in the one before.
    fn change(&mut self, change: Change, frame: usize) {
        let time = (frame + 1) as f32 / 30.0;
        let (places, radiance) = &self.rest;
        match change {
            Change::Light => {
                for (light, rest) in self.scene.lights.iter_mut().zip(radiance) {
                    light.radiance = rest.map(|c| c * (1.0 + 0.1 * time.sin()));
                }
            }
            Change::View => self.scene.camera.eye += Vec3::new(0.01, 0.0, -0.01),
            Change::OneBody | Change::AllBodies => {
                let last = match change {
                    Change::OneBody => WALLS + 1,
                    _ => places.len(),
                };
                for (i, rest) in places.iter().enumerate().take(last).skip(WALLS) {
                    let turn = Quat::from_rotation_y(time * (1.0 + 0.1 * i as f32));
                    self.scene.objects[i].transform = *rest * Affine3A::from_quat(turn);
                }
            }
        }
    }

    /// Puts all vertices where they are now.
    fn place(&mut self) {
        self.receivers.clear();
        for (body, object) in self.bodies.iter().zip(&self.scene.objects) {
            let place = object.transform;
            self.receivers
                .extend(body.receivers.iter().map(|receiver| Receiver {
                    position: place.transform_point3(receiver.position.into()).into(),
                    normal: place.transform_vector3(receiver.normal.into()).into(),
                    ..*receiver
                }));
        }
    }
}

type Times = Vec<(&'static str, f64)>;

/// A frame: how long each stage took.
fn frame(lit: &mut Lit, frames: &mut Frames, plan: &Plan) -> Result<Times, Error> {
    let start = Instant::now();
    lit.place();
    let mut times = vec![("vertices", start.elapsed().as_secs_f64() * 1e3)];
    let light = frames.light(&lit.scene, plan, &lit.receivers, &lit.clusters)?;
    let stages = light.stages.iter();
    times.extend(stages.map(|(name, time)| (*name, time.as_secs_f64() * 1e3)));
    Ok(times)
}

fn sum(times: &Times) -> f64 {
    times.iter().map(|(_, ms)| ms).sum()
}

fn measure(name: &'static str, scene: Scene, baked_s: f64) -> Result<Report, Error> {
    let mut lit = Lit::new(scene);
    let plan = Plan::of_receivers(&lit.scene);
    let mut frames = Frames::default();
    frame(&mut lit, &mut frames, &plan)?;
    let progress = Progress::new("timing frames");
    let all = (Change::ALL.len() * FRAMES + FRAMES) as f32;
    let mut done = 0.0;
    let mut kinds = Vec::new();
    for change in Change::ALL {
        let mut spent = Vec::new();
        for number in 0..FRAMES {
            lit.change(change, number);
            spent.push(frame(&mut lit, &mut frames, &plan)?);
            done += 1.0;
            progress.set(done / all);
        }
        let names = spent.first().into_iter().flatten().map(|(name, _)| *name);
        let of = |times: &Times, name| times.iter().filter(|t| t.0 == name).map(|t| t.1).sum();
        let stages = names.map(|name| Stage {
            name,
            ms: median(spent.iter().map(|times| of(times, name))),
        });
        kinds.push(Kind {
            change,
            frames_per_s: 1e3 / median(spent.iter().map(sum)),
            stages: stages.collect(),
        });
    }
    // One bounce more and one less in turns, since machines are shared.
    let indirect = lit.scene.settings.indirect.unwrap_or_default();
    let (less, mut more) = (lit.scene.settings, lit.scene.settings);
    more.indirect = Some(Indirect {
        bounces: indirect.bounces + 1,
        ..indirect
    });
    lit.scene.settings = more;
    let deeper = Plan::of_receivers(&lit.scene);
    let mut others = Frames::default();
    let mut shares = Vec::new();
    for number in 0..FRAMES {
        lit.change(Change::AllBodies, number);
        let mut whole = |settings, frames: &mut Frames, plan| {
            lit.scene.settings = settings;
            frame(&mut lit, frames, plan).map(|times| sum(&times))
        };
        let shallow = whole(less, &mut frames, &plan)?;
        let deep = whole(more, &mut others, &deeper)?;
        shares.push((deep - shallow) / shallow);
        done += 1.0;
        progress.set(done / all);
    }
    progress.finish();
    let bases = lit.scene.objects.iter().flat_map(|o| &o.basis);
    let patches = bases.map(|basis| basis.patches()).sum();
    Ok(Report {
        scene: name,
        device: format!(
            "the CPU, {} lanes, {} threads",
            lane_count(Path::best()),
            rayon::current_num_threads()
        ),
        threads: rayon::current_num_threads(),
        receivers: lit.receivers.len(),
        clusters: lit.clusters.len(),
        bodies: lit.scene.objects.len(),
        spheres: lit.scene.objects.iter().map(|o| o.spheres.len()).sum(),
        patches,
        functions: rooms::FUNCTIONS,
        bounces: indirect.bounces,
        baked_s,
        bytes: rooms::bytes(&lit.scene.objects),
        kinds,
        bounce_share: median(shares.into_iter()),
    })
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{}: {} receivers in {} clusters, {} bodies, {} spheres, {} patches, {} functions a body,\n\
             {} bounces. Shaded by {}; made in {:.1} s, {:.1} MB.\n",
            self.scene,
            self.receivers,
            self.clusters,
            self.bodies,
            self.spheres,
            self.patches,
            self.functions,
            self.bounces,
            self.device,
            self.baked_s,
            self.bytes as f64 / 1e6,
        )?;
        for kind in &self.kinds {
            writeln!(
                f,
                "{}: {:.1} frames a second",
                kind.change.name(),
                kind.frames_per_s
            )?;
            for Stage { name, ms } in &kind.stages {
                writeln!(f, "  {name:<16} {ms:>8.2} ms")?;
            }
        }
        write!(
            f,
            "one bounce more: {:+.1} % of a frame",
            100.0 * self.bounce_share
        )
    }
}
