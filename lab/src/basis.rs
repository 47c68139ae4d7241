//! `gaunt-lab basis`: in how few functions the irradiance of a body can be written (Iwasaki et al. 2007, figure 10).
//!
//! A lamp stands in turn in several places around the body, under a dim sky. What falls on the body is traced
//! ([`sh_reference::paths`], which shares nothing with what teaches [`IrradianceBasis`]); what functions leave of it, each
//! with its best weight, is told as a root mean square over the mean.

use gaunt::Error;
use gaunt::image::Output;
use gaunt::progress::Progress;
use glam::Vec3;
use rayon::prelude::*;
use serde::Serialize;
use sh_bake::{irradiance_basis, load_mesh, shapes};
use sh_core::Routines;
use sh_reference::paths::{Options as Tracing, PathTracer};
use sh_scene::{
    AreaLight, BasisSample, Camera, EnvironmentMap, IrradianceBasis, Material, Mesh, Object, Scene,
    Settings,
};
use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What to measure.
#[derive(Clone, Debug)]
pub struct Options {
    /// Mesh files; none for three made by code.
    pub meshes: Vec<PathBuf>,
    /// Where all rows go as JSON.
    pub json: Option<PathBuf>,
}

/// Numbers of functions.
pub const COUNTS: [usize; 7] = [1, 4, 9, 16, 25, 36, 64];

/// Places of the lamp, over the body's radius from its centre, and its own radius.
const PLACES: usize = 12;
const DISTANCE: f32 = 2.5;
const RADIUS: f32 = 0.3;

/// Paths a point; and how bright the sky is beside the lamp.
const PATHS: u32 = 128;
const SKY: f32 = 0.1;

/// A body with one number of functions: what they leave of its irradiance, over the mean.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// The mesh file, or what the mesh made by code is.
    pub mesh: String,
    /// How many functions.
    pub count: usize,
    /// Products of cosines along the axes of the box around the body.
    pub cosines: f64,
    /// Spherical harmonics of the direction from its centre.
    pub harmonics: f64,
    /// [`IrradianceBasis`].
    pub basis: f64,
    /// What of its own lights that tells.
    pub held: f32,
    /// Seconds to find it.
    pub seconds: f64,
}

/// Measures all bodies, writes the rows where that is asked for, and returns the table.
///
/// # Errors
/// Where a mesh cannot be loaded or has no triangle, or the file cannot be written.
pub fn run(options: &Options) -> Result<String, Error> {
    let json = options.json.as_deref().map(Output::create).transpose()?;
    let bodies = if options.meshes.is_empty() {
        made_by_code()
    } else {
        let loaded = options.meshes.iter().map(|path| load(path));
        loaded.collect::<Result<_, _>>()?
    };
    let progress = Progress::new("tracing");
    let total = (bodies.len() * PLACES) as f32;
    let mut rows = Vec::new();
    for (index, body) in bodies.iter().enumerate() {
        let tell = |place: usize| progress.set((index * PLACES + place) as f32 / total);
        rows.extend(measure(body, PLACES, PATHS, &tell)?);
    }
    progress.finish();
    if let (Some(output), Some(path)) = (json, &options.json) {
        let text = serde_json::to_string_pretty(&rows)?;
        output.finish(|file| {
            let written = writeln!(file, "{text}");
            written.map_err(|source| Error::file("write to", path.display(), source))
        })?;
    }
    Ok(table(&rows))
}

/// A body in parts, and what it is called.
type Named = (String, Vec<(Mesh, Material)>);

fn made_by_code() -> Vec<Named> {
    let white = Material::diffuse([0.8; 3]);
    let bodies = [
        ("ball", shapes::ball(0.6, 4)),
        (
            "rounded box",
            shapes::rounded_box(Vec3::new(0.9, 0.7, 0.9), 0.05),
        ),
        ("torus knot", shapes::torus_knot(2, 3, 0.52, 0.2, 0.12)),
    ];
    bodies
        .map(|(name, mesh)| (name.into(), vec![(mesh, white.clone())]))
        .into()
}

fn load(path: &Path) -> Result<Named, Error> {
    let name = path.file_name().unwrap_or(path.as_os_str());
    let model = load_mesh(path)?;
    let parts = model.parts.into_iter();
    let parts = parts.map(|part| (part.mesh, part.material)).collect();
    Ok((name.to_string_lossy().into(), parts))
}

/// All numbers of functions for one body.
fn measure(
    (name, parts): &Named,
    places: usize,
    paths: u32,
    tell: &dyn Fn(usize),
) -> Result<Vec<Row>, Error> {
    let start = Instant::now();
    let borrowed: Vec<_> = parts
        .iter()
        .map(|(mesh, material)| (mesh, material))
        .collect();
    let basis = irradiance_basis(&borrowed, IrradianceBasis::MOST, &|_| {});
    let basis =
        basis.ok_or_else(|| Error::Usage(format!("{name} has no triangle of any extent")))?;
    let seconds = start.elapsed().as_secs_f64();
    let (center, radius) = around(basis.samples());
    let mut lit = Vec::new();
    for place in 0..places {
        let away = spread(place, places) * (DISTANCE * radius);
        lit.push(traced(
            parts,
            basis.samples(),
            center + away,
            radius,
            paths,
        )?);
        tell(place + 1);
    }
    let most = COUNTS[COUNTS.len() - 1];
    let ours: Vec<Vec<f64>> = (0..basis.count())
        .map(|i| basis.function(i).iter().map(|x| f64::from(*x)).collect())
        .collect();
    let [cosines, harmonics] = [cosines, harmonics].map(|of| of(basis.samples(), center, most));
    let sets = [cosines, harmonics, ours].map(|functions| left(&functions, &lit));
    let row = |&count: &usize| {
        let [cosines, harmonics, ours] =
            sets.each_ref().map(|left| left[count.min(left.len()) - 1]);
        Row {
            mesh: name.clone(),
            count,
            cosines,
            harmonics,
            basis: ours,
            held: basis.held(count),
            seconds,
        }
    };
    Ok(COUNTS.iter().map(row).collect())
}

/// The ball around all points.
fn around(samples: &[BasisSample]) -> (Vec3, f32) {
    let places = || samples.iter().map(|s| Vec3::from(s.position));
    let low = places().fold(Vec3::INFINITY, Vec3::min);
    let high = places().fold(Vec3::NEG_INFINITY, Vec3::max);
    let center = 0.5 * (low + high);
    let radius = places().map(|p| p.distance(center)).fold(0.0, f32::max);
    (center, radius)
}

/// The k-th of some directions that are spread evenly.
fn spread(k: usize, count: usize) -> Vec3 {
    let height = 1.0 - 2.0 * (k as f32 + 0.5) / count as f32;
    let (sin, cos) = (k as f32 * std::f32::consts::TAU * 0.618_034).sin_cos();
    let wide = (1.0 - height * height).sqrt();
    Vec3::new(wide * cos, height, wide * sin)
}

/// Irradiance at all points (as what albedo 1 reflects) of a lamp at a place and the sky.
fn traced(
    parts: &[(Mesh, Material)],
    samples: &[BasisSample],
    lamp: Vec3,
    radius: f32,
    paths: u32,
) -> Result<Vec<f64>, Error> {
    let object = |(mesh, material): &(Mesh, Material)| Object {
        name: String::new(),
        mesh: mesh.clone(),
        material: material.clone(),
        ..Object::default()
    };
    // So bright that the lamp gives about 1 where it shines straight down.
    let radiance = (DISTANCE / RADIUS).powi(2);
    let scene = Scene {
        punctual: Vec::new(),
        objects: parts.iter().map(object).collect(),
        environment: EnvironmentMap::constant([SKY; 3]),
        lights: vec![AreaLight::local(lamp, RADIUS * radius, [radiance; 3])],
        ground: None,
        camera: Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        settings: Settings::default(),
    };
    let tracer = PathTracer::new(&scene, Tracing::default())?;
    let at = |(index, sample): (usize, &BasisSample)| {
        let [point, normal] = [sample.position, sample.normal].map(|v| v.map(f64::from));
        tracer.radiance(point, normal, paths, index as u32).direct[1]
    };
    Ok(samples.par_iter().enumerate().map(at).collect())
}

/// Products of cosines along three axes, those of low frequency first.
fn cosines(samples: &[BasisSample], _: Vec3, most: usize) -> Vec<Vec<f64>> {
    let places: Vec<Vec3> = samples.iter().map(|s| s.position.into()).collect();
    let low = places.iter().copied().fold(Vec3::INFINITY, Vec3::min);
    let high = places.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
    let size = (high - low).max(Vec3::splat(1e-6));
    let mut waves: Vec<[usize; 3]> = (0..6 * 6 * 6).map(|i| [i / 36, i / 6 % 6, i % 6]).collect();
    waves.sort_by_key(|wave| wave.iter().map(|k| k * k).sum::<usize>());
    let of = |wave: &[usize; 3]| {
        let value = |place: &Vec3| {
            let at = ((*place - low) / size * std::f32::consts::PI).to_array();
            let along = |k: usize| f64::from((wave[k] as f32 * at[k]).cos());
            along(0) * along(1) * along(2)
        };
        places.iter().map(value).collect()
    };
    waves.iter().take(most).map(of).collect()
}

/// Spherical harmonics of the direction from the centre.
fn harmonics(samples: &[BasisSample], center: Vec3, most: usize) -> Vec<Vec<f64>> {
    let basis = |sample: &BasisSample| {
        let out = (Vec3::from(sample.position) - center).normalize_or(Vec3::Y);
        <[f64; 36]>::basis(out.to_array().map(f64::from))
    };
    let values: Vec<[f64; 36]> = samples.iter().map(basis).collect();
    let of = |i: usize| values.iter().map(|all| all[i]).collect();
    (0..most.min(36)).map(of).collect()
}

/// What the first functions leave of what falls on the body, for each number of them: each with its best weight. A root
/// mean square over the mean.
fn left(functions: &[Vec<f64>], lit: &[Vec<f64>]) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let scale: f64 = lit
        .iter()
        .map(|l| l.iter().sum::<f64>() / l.len() as f64)
        .sum();
    let count: usize = lit.iter().map(Vec::len).sum();
    let mut rest = lit.to_vec();
    let mut known: Vec<Vec<f64>> = Vec::new();
    let mut errors = Vec::new();
    for function in functions {
        // At right angles to those before, twice: once leaves what rounding makes of functions that are nearly alike.
        let mut own = function.clone();
        for _ in 0..2 {
            for known in &known {
                let along = dot(&own, known);
                own.iter_mut().zip(known).for_each(|(x, k)| *x -= along * k);
            }
        }
        let size = dot(&own, &own).sqrt();
        if size > 1e-9 * dot(function, function).sqrt() {
            own.iter_mut().for_each(|x| *x /= size);
            for rest in &mut rest {
                let along = dot(rest, &own);
                rest.iter_mut().zip(&own).for_each(|(x, k)| *x -= along * k);
            }
            known.push(own);
        }
        let square: f64 = rest.iter().map(|r| dot(r, r)).sum();
        errors.push((square / count as f64).sqrt() / (scale / lit.len() as f64));
    }
    errors
}

fn table(rows: &[Row]) -> String {
    let mut text = String::from(
        "| body | functions | cosines of position | harmonics of position | basis | held | s |\n|---|---:|---:|---:|---:|---:|---:|",
    );
    for row in rows {
        let [cosines, harmonics, basis] =
            [row.cosines, row.harmonics, row.basis].map(|x| format!("{:.2} %", 100.0 * x));
        let (mesh, count, held, seconds) = (&row.mesh, row.count, 100.0 * row.held, row.seconds);
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n| {mesh} | {count} | {cosines} | {harmonics} | {basis} | {held:.2} % | {seconds:.1} |"
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Those that were found for a body tell more of its light than those that know only places; on a ball harmonics are the
    /// best that there can be, and those are not much worse. Of the constant all know as much.
    #[test]
    fn functions_that_were_found_tell_most() {
        for body in made_by_code() {
            let rows = measure(&body, 4, 32, &|_| {}).expect("bodies made by code");
            println!("{}", table(&rows));
            let one = &rows[0];
            assert!((one.basis - one.cosines).abs() < 1e-6, "{one:?}");
            for row in &rows[1..4] {
                let most = if body.0 == "ball" { 1.25 } else { 1.0 };
                assert!(row.basis < row.cosines.min(row.harmonics) * most, "{row:?}");
            }
            let sixteen = &rows[3];
            assert!(sixteen.basis < 0.35 * one.basis, "{sixteen:?} {one:?}");
        }
    }
}
