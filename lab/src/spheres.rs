//! `gaunt-lab spheres`: how tightly sphere sets bound meshes, beside simpler ways to make them.

use gaunt::Error;
use gaunt::image::Output;
use gaunt::progress::Progress;
use serde::Serialize;
use sh_bake::{SphereSet, is_closed, load_mesh, shapes};
use sh_reference::raycast::{self, Triangle};
use sh_reference::spheres::{Ball, lloyd, octree, outside};
use sh_scene::Mesh;
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What to fit.
#[derive(Clone, Debug)]
pub struct Options {
    /// Mesh files; none for a box and a torus knot made by code.
    pub meshes: Vec<PathBuf>,
    /// Numbers of spheres.
    pub counts: Vec<usize>,
    /// Where all rows go as JSON.
    pub json: Option<PathBuf>,
}

/// One way to bound a mesh by spheres.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Set {
    /// How many spheres it came to; never more than asked for.
    pub spheres: usize,
    /// Their volume outside the mesh over the mesh's volume (Ren et al. 2006, equation 35).
    pub outside_volume_ratio: f64,
    /// Seconds to make it.
    pub seconds: f64,
}

/// A mesh with one number of spheres.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The mesh file, or what the mesh made by code is.
    pub mesh: String,
    /// How many triangles it has.
    pub triangles: usize,
    /// Whether it has no border. The simple sets are made and measured for closed meshes only.
    pub closed: bool,
    /// How many spheres were asked for.
    pub count: usize,
    /// What [`SphereSet::fit`] makes; none for a mesh that encloses nothing.
    pub fit: Option<Set>,
    /// The leaves of an octree.
    pub octree: Option<Set>,
    /// Plain clustering.
    pub lloyd: Option<Set>,
}

/// A mesh in parts, and what it is called.
type Named = (String, Vec<Mesh>);

/// Fits all meshes with all counts, writes the rows where that is asked for, and returns the table.
///
/// # Errors
/// Where a mesh cannot be loaded or the file cannot be written.
pub fn run(options: &Options) -> Result<String, Error> {
    let json = options.json.as_deref().map(Output::create).transpose()?;
    let rows = rows(options)?;
    if let (Some(output), Some(path)) = (json, &options.json) {
        let text = serde_json::to_string_pretty(&rows)?;
        output.finish(|file| {
            let written = writeln!(file, "{text}");
            written.map_err(|source| Error::file("write to", path.display(), source))
        })?;
    }
    Ok(table(&rows))
}

/// Fits all meshes with all counts.
fn rows(options: &Options) -> Result<Vec<Row>, Error> {
    let meshes: Vec<Named> = if options.meshes.is_empty() {
        made_by_code()
    } else {
        options
            .meshes
            .iter()
            .map(|path| load(path))
            .collect::<Result<_, _>>()?
    };
    let progress = Progress::new("fitting spheres");
    let total = meshes.len() * options.counts.len();
    let mut all = Vec::new();
    for mesh in &meshes {
        for &count in &options.counts {
            let done = all.len() as f32;
            all.push(row(mesh, count, &|part| {
                progress.set((done + part) / total as f32)
            }));
        }
    }
    progress.finish();
    Ok(all)
}

fn made_by_code() -> Vec<Named> {
    let size = glam::Vec3::new(0.9, 0.7, 0.9);
    vec![
        ("box".into(), vec![shapes::rounded_box(size, 0.0)]),
        (
            "torus knot".into(),
            vec![shapes::torus_knot(2, 3, 0.52, 0.2, 0.12)],
        ),
    ]
}

fn load(path: &Path) -> Result<Named, Error> {
    let name = path.file_name().unwrap_or(path.as_os_str());
    let model = load_mesh(path)?;
    let parts = model.parts.into_iter().map(|part| part.mesh).collect();
    Ok((name.to_string_lossy().into(), parts))
}

fn row((name, parts): &Named, count: usize, progress: &(dyn Fn(f32) + Sync)) -> Row {
    let parts: Vec<&Mesh> = parts.iter().collect();
    let triangles: Vec<Triangle> = parts
        .iter()
        .flat_map(|mesh| raycast::triangles(mesh))
        .collect();
    let closed = is_closed(&parts);
    let volume = outside::volume(&triangles);
    let measured = |balls: &[Ball], start: Instant| Set {
        spheres: balls.len(),
        seconds: start.elapsed().as_secs_f64(),
        outside_volume_ratio: balls
            .iter()
            .map(|ball| outside::outside(ball, &triangles))
            .sum::<f64>()
            / volume,
    };
    let simple = |make: fn(&[Triangle], usize) -> Vec<Ball>| {
        closed.then(|| {
            let start = Instant::now();
            measured(&make(&triangles, count), start)
        })
    };
    let start = Instant::now();
    let set = SphereSet::fit_with(&parts, count, progress);
    let seconds = start.elapsed().as_secs_f64();
    let ball = |s: &sh_scene::Sphere| Ball {
        center: s.center.map(f64::from),
        radius: s.radius.into(),
    };
    let fit = if closed {
        let balls: Vec<Ball> = set.spheres.iter().map(ball).collect();
        Some(Set {
            seconds,
            ..measured(&balls, start)
        })
    } else {
        set.outside_volume_ratio.map(|ratio| Set {
            spheres: set.spheres.len(),
            outside_volume_ratio: ratio.into(),
            seconds,
        })
    };
    Row {
        mesh: name.clone(),
        triangles: triangles.len(),
        closed,
        count,
        fit,
        octree: simple(octree::spheres),
        lloyd: simple(lloyd::spheres),
    }
}

/// The rows as a table.
fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "Volume of the spheres outside the mesh over the volume of the mesh, and how many spheres it came to\n\n\
         mesh              asked          fit   seconds         octree          Lloyd",
    );
    let cell = |set: &Option<Set>| match set {
        Some(set) => format!("{:.3} ({:>3})", set.outside_volume_ratio, set.spheres),
        None => "-".into(),
    };
    for row in rows {
        let seconds = row
            .fit
            .as_ref()
            .map_or("-".into(), |set| format!("{:.1}", set.seconds));
        write!(
            text,
            "\n{:<18}{:>5}{:>13}{seconds:>10}{:>15}{:>15}",
            row.mesh,
            row.count,
            cell(&row.fit),
            cell(&row.octree),
            cell(&row.lloyd),
        )
        .expect("writing to a string");
    }
    let mut open: Vec<&str> = rows
        .iter()
        .filter(|row| !row.closed)
        .map(|row| row.mesh.as_str())
        .collect();
    open.dedup();
    for mesh in open {
        write!(
            text,
            "\n{mesh} is not closed: its volume is what it encloses by more than half, and the simple sets are left out."
        )
        .expect("writing to a string");
    }
    text
}
