//! From a scene file to a scene.

use crate::error::Error;
use crate::mesh::{Model, load_mesh};
use crate::scene_file::{ObjectEntry, SceneFile};
use crate::{SphereSet, load_environment};
use glam::{Affine3A, EulerRot, Quat, Vec3};
use rayon::prelude::*;
use sh_scene::{Camera, Ground, Mesh, Object, Scene, Sky};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// What loading a scene found and took.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What was wrong and has been put right: sentences that name the file.
    pub warnings: Vec<String>,
    /// The mesh files with their sphere sets, each mesh with the same count once.
    pub fits: Vec<FitReport>,
    /// Time for reading files, and for the sky where there is no map.
    pub read_time: Duration,
    /// Time for fitting all sphere sets.
    pub fit_time: Duration,
}

/// A sphere set, as far as a person wants to know.
#[derive(Clone, Debug)]
pub struct FitReport {
    /// The mesh file, or the name of a mesh made by code.
    pub name: String,
    /// How many triangles it has.
    pub triangles: usize,
    /// How many spheres bound it.
    pub spheres: usize,
    /// Their outside volume relative to the mesh's volume; none for an open mesh.
    pub outside_volume_ratio: Option<f32>,
    /// Time for fitting.
    pub time: Duration,
}

/// How far loading has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress<'a> {
    /// What is being done.
    pub stage: &'a str,
    /// Steps done.
    pub done: usize,
    /// Steps in all.
    pub total: usize,
}

/// Loads a scene: a TOML file as the README describes, or a mesh file, which then is the scene's only
/// object. Whatever the file leaves out gets a sensible value: an analytic sky, ground under the lowest
/// point, a camera that frames the objects.
///
/// # Errors
/// A sentence that names the file and the field, where any of the files cannot be read or is wrong.
pub fn load_scene(path: &Path) -> Result<(Scene, Report), Error> {
    load_scene_with(path, &|_| {})
}

/// [`load_scene`], telling `progress` how far it is: from several threads, in any order.
///
/// # Errors
/// As [`load_scene`].
pub fn load_scene_with(
    path: &Path,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<(Scene, Report), Error> {
    let start = Instant::now();
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or("")
        .to_ascii_lowercase();
    let file = match ending.as_str() {
        "obj" | "gltf" | "glb" => SceneFile::of_mesh(path),
        _ => SceneFile::read(path)?,
    };
    let mut report = Report::default();

    let mut models: BTreeMap<&Path, Model> = BTreeMap::new();
    for (done, entry) in file.objects.iter().enumerate() {
        progress(Progress {
            stage: "reading meshes",
            done,
            total: file.objects.len(),
        });
        if !models.contains_key(entry.mesh.as_path()) {
            let model = load_mesh(&entry.mesh)?;
            report.warnings.extend_from_slice(&model.warnings);
            models.insert(&entry.mesh, model);
        }
    }
    progress(Progress {
        stage: "reading the environment",
        done: 0,
        total: 1,
    });
    let environment = match &file.map {
        Some(map) => load_environment(map)?,
        None => Sky::default().map(512, 256),
    };
    let environment = environment.rotated(file.rotation).scaled(file.intensity);
    report.read_time = start.elapsed();

    let start = Instant::now();
    let mut wanted: Vec<(&Path, usize)> = file
        .objects
        .iter()
        .map(|entry| (entry.mesh.as_path(), entry.spheres))
        .collect();
    wanted.sort();
    wanted.dedup();
    let fits = fit_all(
        wanted
            .iter()
            .map(|&(mesh, count)| (models[mesh].parts.iter().map(|p| &p.mesh).collect(), count)),
        progress,
    );
    report.fit_time = start.elapsed();
    let mut sets = BTreeMap::new();
    for (&(mesh, count), (set, time)) in wanted.iter().zip(fits) {
        let name = file_name(mesh);
        report.fits.push(FitReport::new(
            name,
            models[mesh].parts.iter().map(|p| &p.mesh),
            &set,
            time,
        ));
        sets.insert((mesh, count), set);
    }

    let mut objects = Vec::new();
    for entry in &file.objects {
        let set = &sets[&(entry.mesh.as_path(), entry.spheres)];
        objects.extend(bodies(entry, &models[entry.mesh.as_path()], set));
    }
    Ok((assemble(&file, objects, environment), report))
}

/// Fits spheres to several meshes, each given as parts and a count, side by side.
pub(crate) fn fit_all<'a>(
    meshes: impl Iterator<Item = (Vec<&'a Mesh>, usize)>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Vec<(SphereSet, Duration)> {
    let meshes: Vec<_> = meshes.collect();
    let (done, total) = (AtomicUsize::new(0), meshes.len());
    progress(Progress {
        stage: "fitting spheres",
        done: 0,
        total,
    });
    meshes
        .par_iter()
        .map(|(parts, count)| {
            let start = Instant::now();
            let set = SphereSet::fit(parts, *count);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress(Progress {
                stage: "fitting spheres",
                done,
                total,
            });
            (set, start.elapsed())
        })
        .collect()
}

impl FitReport {
    pub(crate) fn new<'a>(
        name: String,
        meshes: impl Iterator<Item = &'a Mesh>,
        set: &SphereSet,
        time: Duration,
    ) -> Self {
        Self {
            name,
            triangles: meshes.map(|mesh| mesh.triangles.len()).sum(),
            spheres: set.spheres.len(),
            outside_volume_ratio: set.outside_volume_ratio,
            time,
        }
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(
        || PathBuf::from(path).display().to_string(),
        |n| n.to_string_lossy().into(),
    )
}

/// One object of the file as bodies: one for each of its parts. The first carries the spheres of all.
fn bodies(entry: &ObjectEntry, model: &Model, set: &SphereSet) -> Vec<Object> {
    let [x, y, z] = entry.rotate.map(f32::to_radians);
    let transform = Affine3A::from_scale_rotation_translation(
        Vec3::splat(entry.scale),
        // About x first, so z is the outermost.
        Quat::from_euler(EulerRot::ZYX, z, y, x),
        Vec3::from(entry.translate),
    );
    let file = file_name(&entry.mesh);
    let body = |(i, part): (usize, &crate::Part)| {
        let name = if part.name.is_empty() {
            file.clone()
        } else {
            format!("{file}: {}", part.name)
        };
        let mut material = part.material.clone();
        material.albedo = entry.albedo.unwrap_or(material.albedo);
        let spheres = if i == 0 {
            set.spheres.clone()
        } else {
            Vec::new()
        };
        Object {
            name,
            mesh: part.mesh.clone(),
            material,
            transform,
            spheres,
        }
    };
    model.parts.iter().enumerate().map(body).collect()
}

/// Puts everything together, and a value where the file has none.
fn assemble(
    file: &SceneFile,
    objects: Vec<Object>,
    environment: sh_scene::EnvironmentMap,
) -> Scene {
    let bounds = objects
        .iter()
        .filter_map(Object::bounds)
        .reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    let [low, high] = bounds.unwrap_or([Vec3::ZERO; 2]);
    let fov = file.fov.unwrap_or(Camera::FOV);
    let framing = Camera::framing(low, high, fov);
    let camera = match (file.eye.map(Vec3::from), file.target.map(Vec3::from)) {
        (Some(eye), target) => {
            let target = target.unwrap_or(framing.target);
            let near = eye.distance(target) < Camera::nearest(target);
            // An eye in the very middle looks ahead.
            let ahead = || eye - Vec3::Z * eye.abs().max_element().max(1.0);
            Camera {
                eye,
                target: if near { ahead() } else { target },
                fov,
            }
        }
        (None, Some(target)) => {
            let away = framing.eye - framing.target;
            let grown = (Camera::nearest(target) / away.length()).max(1.0);
            Camera {
                eye: target + away * grown,
                target,
                fov,
            }
        }
        (None, None) => framing,
    };
    Scene {
        objects,
        environment,
        ground: file.ground.then(|| Ground {
            height: file.ground_height.unwrap_or(low.y),
            albedo: file.ground_albedo,
        }),
        camera,
        settings: file.settings,
    }
}
