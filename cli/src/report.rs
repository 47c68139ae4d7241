//! What was done, why, and how long it took: for a person and as JSON.

use serde::Serialize;
use sh_bake::{BasisReport, FitReport, SurfaceReport};
use sh_scene::Plan;
use std::fmt;
use std::path::PathBuf;
use std::time::Instant;

/// One stage of the work and the time it took.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stage {
    /// Its name; passes have the plan's names.
    pub stage: &'static str,
    /// Seconds.
    pub seconds: f64,
}

/// A pass of the plan and why it is there.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Planned {
    /// Its name.
    pub pass: &'static str,
    /// A sentence.
    pub reason: String,
}

/// The passes of a plan.
pub fn planned(plan: &Plan) -> Vec<Planned> {
    let passes = plan.passes.iter();
    passes
        .map(|p| Planned {
            pass: p.name(),
            reason: p.reason.clone(),
        })
        .collect()
}

/// Times of stages, in the order in which they first ran.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Times(pub Vec<Stage>);

impl Times {
    /// Runs `work` and adds its time to a stage.
    pub fn measure<T>(&mut self, stage: &'static str, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let result = work();
        self.add(stage, start.elapsed().as_secs_f64());
        result
    }

    /// Adds seconds to a stage.
    pub fn add(&mut self, stage: &'static str, seconds: f64) {
        match self.0.iter_mut().find(|s| s.stage == stage) {
            Some(known) => known.seconds += seconds,
            None => self.0.push(Stage { stage, seconds }),
        }
    }
}

/// A mesh of the scene and the spheres that block light in its place.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Triangles.
    pub triangles: usize,
    /// Spheres.
    pub spheres: usize,
    /// The volume of the spheres outside the mesh over the mesh's volume; where the mesh is open, over that of what
    /// it encloses by more than half, or none.
    pub outside_volume_ratio: Option<f32>,
    /// Whether the spheres come from the cache.
    pub cached: bool,
}

impl Body {
    /// From what fitting found.
    pub fn new(fit: &FitReport) -> Self {
        let FitReport {
            name,
            triangles,
            spheres,
            outside_volume_ratio,
            cached,
            ..
        } = fit.clone();
        Self {
            name,
            triangles,
            spheres,
            outside_volume_ratio,
            cached,
        }
    }
}

/// The surface samples of a body, which say how bright its spheres are as lights.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Surface {
    /// The body's name.
    pub name: String,
    /// Its spheres.
    pub spheres: usize,
    /// Points around all of them.
    pub points: usize,
    /// What they take in memory.
    pub bytes: usize,
    /// Whether they come from the cache.
    pub cached: bool,
}

impl Surface {
    /// From what sampling found.
    pub fn new(found: &SurfaceReport) -> Self {
        Self {
            name: found.name.clone(),
            spheres: found.spheres,
            points: found.points,
            bytes: found.bytes,
            cached: found.cached,
        }
    }
}

/// The functions in which a body's irradiance is told.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Basis {
    /// The body's name.
    pub name: String,
    /// How many functions; 0 where nothing of it can be lit, and it sends nothing on.
    pub functions: usize,
    /// What they tell of the light that they were found by, 0 to 1.
    pub held: f32,
    /// What they take in memory, patches included.
    pub bytes: usize,
    /// Whether they come from the cache.
    pub cached: bool,
}

impl Basis {
    /// From what was found.
    pub fn new(found: &BasisReport) -> Self {
        Self {
            name: found.name.clone(),
            functions: found.functions,
            held: found.held,
            bytes: found.bytes,
            cached: found.cached,
        }
    }
}

/// Frames that were rendered.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sequence {
    /// The number of the first.
    pub first: u32,
    /// How many there are.
    pub count: usize,
    /// How many make a second of motion.
    pub fps: f64,
}

/// How a picture came about.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Where the picture is; for frames, the pattern of their names.
    pub picture: PathBuf,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Which frames were rendered; none for a single picture.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frames: Option<Sequence>,
    /// `cpu` or `gpu`.
    pub backend: &'static str,
    /// What computed.
    pub device: String,
    /// Why that backend: a sentence.
    pub reason: String,
    /// SH order of the light.
    pub order: usize,
    /// SH order in which the blockers' logarithms are accumulated.
    pub accumulation: usize,
    /// The factor between radiance and the tone curve; EXR files do not have it.
    pub exposure: f32,
    /// The meshes; one that is used several times is listed once.
    pub objects: Vec<Body>,
    /// The surface samples of bodies that send light on; none where none do.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub surfaces: Vec<Surface>,
    /// The functions of bodies that send light on by their patches; none where none do.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub bases: Vec<Basis>,
    /// What moves: sentences.
    pub moves: Vec<String>,
    /// What was wrong with the files and has been put right: sentences.
    pub warnings: Vec<String>,
    /// The passes, in order.
    pub plan: Vec<Planned>,
    /// The stages, in order, each over all frames.
    pub stages: Vec<Stage>,
    /// Seconds from beginning to end.
    pub seconds: f64,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (picture, width, height) = (self.picture.display(), self.width, self.height);
        let device = &self.device;
        match self.frames {
            None => writeln!(
                f,
                "{picture}: {width} x {height} pixels, rendered by {device}."
            )?,
            Some(Sequence { first, count, fps }) => {
                let last = first as usize + count - 1;
                let frames = if count == 1 { "frame" } else { "frames" };
                writeln!(
                    f,
                    "{picture}: {count} {frames}, {first} to {last}, {fps} a second, {width} x {height} pixels each, \
                     rendered by {device}."
                )?;
            }
        }
        writeln!(f, "{}", self.reason)?;
        write!(f, "Light of SH order {}", self.order)?;
        if self.plan.iter().any(|planned| planned.pass == "shadow") {
            write!(f, ", shadows accumulated in order {}", self.accumulation)?;
        }
        writeln!(f, ".")?;
        for sentence in &self.moves {
            writeln!(f, "{sentence}")?;
        }
        if self.frames.is_some() && self.moves.is_empty() {
            writeln!(f, "Nothing in the scene moves: all frames are alike.")?;
        }
        for warning in &self.warnings {
            writeln!(f, "Note: {warning}")?;
        }
        writeln!(f, "\nSpheres (outside volume over the mesh's volume)")?;
        for Body {
            name,
            spheres,
            outside_volume_ratio,
            cached,
            ..
        } in &self.objects
        {
            let ratio = outside_volume_ratio.map_or("open mesh".into(), |r| format!("{r:.3}"));
            let cached = if *cached { "   from the cache" } else { "" };
            writeln!(f, "  {name:<20} {spheres:>4}   {ratio}{cached}")?;
        }
        if !self.surfaces.is_empty() {
            writeln!(f, "\nSurface samples (points, memory)")?;
        }
        for Surface {
            name,
            points,
            bytes,
            cached,
            ..
        } in &self.surfaces
        {
            let cached = if *cached { "   from the cache" } else { "" };
            let kilobytes = bytes.div_ceil(1000);
            writeln!(f, "  {name:<20} {points:>4}   {kilobytes} kB{cached}")?;
        }
        if !self.bases.is_empty() {
            writeln!(f, "\nFunctions of irradiance (what they tell, memory)")?;
        }
        for Basis {
            name,
            functions,
            held,
            bytes,
            cached,
        } in &self.bases
        {
            let cached = if *cached { "   from the cache" } else { "" };
            let (held, kilobytes) = (100.0 * held, bytes.div_ceil(1000));
            writeln!(
                f,
                "  {name:<20} {functions:>4}   {held:.1} %   {kilobytes} kB{cached}"
            )?;
        }
        writeln!(f, "\nPlan")?;
        for Planned { pass, reason } in &self.plan {
            writeln!(f, "  {pass:<12} {reason}")?;
        }
        match self.frames {
            None => writeln!(f, "\nTime")?,
            Some(Sequence { count, .. }) => writeln!(f, "\nTime of all {count} frames")?,
        }
        for Stage { stage, seconds } in &self.stages {
            writeln!(f, "  {stage:<12} {:>9.1} ms", seconds * 1e3)?;
        }
        write!(f, "  {:<12} {:>9.1} ms", "total", self.seconds * 1e3)
    }
}
