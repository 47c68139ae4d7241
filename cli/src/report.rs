//! What was done, why, and how long it took: for a person and as JSON.

use serde::Serialize;
use sh_bake::FitReport;
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
            pass: p.kind.name(),
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
    /// The volume of the spheres outside the mesh over the mesh's volume; none for an open mesh.
    pub outside_volume_ratio: Option<f32>,
}

impl Body {
    /// From what fitting found.
    pub fn new(fit: &FitReport) -> Self {
        let FitReport {
            name,
            triangles,
            spheres,
            outside_volume_ratio,
            ..
        } = fit.clone();
        Self {
            name,
            triangles,
            spheres,
            outside_volume_ratio,
        }
    }
}

/// How a picture came about.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// Where the picture is.
    pub picture: PathBuf,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
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
    /// What was wrong with the files and has been put right: sentences.
    pub warnings: Vec<String>,
    /// The passes, in order.
    pub plan: Vec<Planned>,
    /// The stages, in order.
    pub stages: Vec<Stage>,
    /// Seconds from beginning to end.
    pub seconds: f64,
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (picture, width, height) = (self.picture.display(), self.width, self.height);
        writeln!(
            f,
            "{picture}: {width} x {height} pixels, rendered by {}.",
            self.device
        )?;
        writeln!(f, "{}", self.reason)?;
        write!(f, "Light of SH order {}", self.order)?;
        if self.plan.iter().any(|planned| planned.pass == "shadow") {
            write!(f, ", shadows accumulated in order {}", self.accumulation)?;
        }
        writeln!(f, ".")?;
        for warning in &self.warnings {
            writeln!(f, "Note: {warning}")?;
        }
        writeln!(f, "\nSpheres (outside volume over the mesh's volume)")?;
        for Body {
            name,
            spheres,
            outside_volume_ratio,
            ..
        } in &self.objects
        {
            let ratio = outside_volume_ratio.map_or("open mesh".into(), |r| format!("{r:.3}"));
            writeln!(f, "  {name:<20} {spheres:>4}   {ratio}")?;
        }
        writeln!(f, "\nPlan")?;
        for Planned { pass, reason } in &self.plan {
            writeln!(f, "  {pass:<12} {reason}")?;
        }
        writeln!(f, "\nTime")?;
        for Stage { stage, seconds } in &self.stages {
            writeln!(f, "  {stage:<12} {:>9.1} ms", seconds * 1e3)?;
        }
        write!(f, "  {:<12} {:>9.1} ms", "total", self.seconds * 1e3)
    }
}
