//! From a scene file to a scene.

use crate::bodies::{self, BasisReport, Fit, Found, SurfaceReport, WeightReport, once};
use crate::cache::Cache;
use crate::choices::Choices;
use crate::environment::load_environment;
use crate::error::{Error, file_name};
use crate::mesh::load_mesh;
use crate::model::{Model, ModelCamera, Part};
use crate::motion::{self, ClipChoice, Rigs};
use crate::objects::ObjectEntry;
use crate::progress::Progress;
use crate::scene_file::{CameraName, SceneFile};
use crate::spheres::{SphereSet, is_closed};
use glam::{Affine3A, Quat, Vec3};
use sh_scene::motion::Motion;
use sh_scene::{
    AreaLight, Camera, EnvironmentMap, Ground, Mesh, Method, Object, PunctualLight, PunctualShape,
    Scene, Sky,
};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A scene, and how it moves.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// As it is at time 0.
    pub scene: Scene,
    /// What takes it to other times.
    pub motion: Motion,
    /// What loading found and took.
    pub report: Report,
}

/// What loading a scene found and took.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// What was wrong and has been put right: sentences that name the file.
    pub warnings: Vec<String>,
    /// The mesh files with their sphere sets, each mesh with the same count once.
    pub fits: Vec<FitReport>,
    /// The weights of each body's spheres.
    pub weights: Vec<WeightReport>,
    /// The surface samples of each body; empty where the scene has no indirect light.
    pub surfaces: Vec<SurfaceReport>,
    /// The functions that tell each body's irradiance; empty where the scene's method is another.
    pub bases: Vec<BasisReport>,
    /// What moves: sentences.
    pub moves: Vec<String>,
    /// Time for reading files, and for the sky where there is no map.
    pub read_time: Duration,
    /// Time for fitting all sphere sets.
    pub fit_time: Duration,
    /// Time for finding all weights.
    pub weight_time: Duration,
    /// Time for sampling all surfaces.
    pub surface_time: Duration,
    /// Time for finding all functions.
    pub basis_time: Duration,
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
    /// Their outside volume relative to the mesh's volume, or, where it is open, to what it encloses by more than
    /// half; none where it encloses nothing.
    pub outside_volume_ratio: Option<f32>,
    /// Time for fitting, or for finding the set in the cache.
    pub time: Duration,
    /// Whether the set comes from the cache.
    pub cached: bool,
}

/// Loads a scene: a TOML file as the README describes, or a mesh file, which then is the scene's only
/// object and stands still. Whatever the file leaves out gets a sensible value: an analytic sky, ground under
/// the lowest point, a camera that frames the objects; where they move, the lowest point and all places that
/// they reach.
///
/// # Errors
/// A sentence that names the file and the field, where any of the files cannot be read or is wrong.
pub fn load_scene(path: &Path) -> Result<Loaded, Error> {
    load_scene_with(path, ClipChoice::None, None, &|_| {})
}

/// [`load_scene`] with a clip for a mesh file, or other [`Choices`], telling `progress` how far it is: from several threads, in any
/// order. With a cache, sphere sets and surface samples that it has are taken from there, and others put into it; the
/// scene is the same, bit by bit.
///
/// # Errors
/// As [`load_scene`], and where the file has no such clip, or is a scene file and one is named.
pub fn load_scene_with<'a>(
    path: &Path,
    choices: impl Into<Choices<'a>>,
    cache: Option<&Cache>,
    progress: &(dyn Fn(Progress) + Sync),
) -> Result<Loaded, Error> {
    let start = Instant::now();
    let choices: Choices = choices.into();
    let clip = choices.clip;
    let ending = path
        .extension()
        .and_then(|e| e.to_str())
        .unwrap_or("")
        .to_ascii_lowercase();
    let mut file = match ending.as_str() {
        "obj" | "gltf" | "glb" => SceneFile::of_mesh(path),
        _ if matches!(clip, ClipChoice::Named(_)) => {
            return Err(Error::file(
                path,
                "a clip can be chosen for a mesh file; a scene says clip = \"...\" under [[objects]].",
            ));
        }
        _ => SceneFile::read(path)?,
    };
    for entry in &mut file.objects {
        entry.spheres = choices.count(entry.spheres);
    }
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
    let clips = motion::clips(path, &file, &models, clip)?;
    progress(Progress {
        stage: "reading the environment",
        done: 0,
        total: 1,
    });
    let mut environment = match &file.map {
        _ if !file.sky => EnvironmentMap::constant([0.0; 3]),
        Some(map) => load_environment(map)?,
        None => Sky::default().map(512, 256),
    };
    for light in &mut file.lights {
        light.load()?;
    }
    report.read_time = start.elapsed();

    let start = Instant::now();
    let mut wanted: Vec<(&Path, usize)> = file
        .objects
        .iter()
        .filter(|entry| entry.spheres > 0)
        .map(|entry| (entry.mesh.as_path(), entry.spheres))
        .collect();
    wanted.sort();
    wanted.dedup();
    let fits = wanted.iter().map(|&(mesh, count)| Fit {
        parts: models[mesh].parts.iter().map(|p| &p.mesh).collect(),
        count,
    });
    let fits = once(&fits.collect::<Vec<_>>(), cache, progress);
    let mut sets = BTreeMap::new();
    for (&(mesh, count), fitted) in wanted.iter().zip(fits) {
        let name = file_name(mesh);
        report.fits.push(FitReport::new(
            name,
            models[mesh].parts.iter().map(|p| &p.mesh),
            &fitted,
        ));
        sets.insert((mesh, count), fitted.what);
    }
    let blocking = |mesh: &Path| wanted.iter().any(|(of, _)| *of == mesh);
    for (mesh, model) in models.iter().filter(|(mesh, _)| blocking(mesh)) {
        let parts: Vec<&Mesh> = model.parts.iter().map(|p| &p.mesh).collect();
        if !is_closed(&parts) {
            report.warnings.push(format!(
                "{}: the mesh is not closed; shadows take as solid what is more than half enclosed.",
                crate::error::shown(mesh)
            ));
        }
    }

    let (mut objects, mut motion) = (Vec::new(), Motion::default());
    // Bodies, and which of them send light on by their patches.
    let (mut whole, mut by_patches) = (Vec::new(), Vec::new());
    let method = file.settings.indirect.map(|indirect| indirect.method);
    let mut rigs = Rigs::default();
    let no_spheres = SphereSet::none();
    for (entry, clip) in file.objects.iter().zip(clips) {
        let (first, mesh) = (objects.len(), entry.mesh.as_path());
        let model = &models[mesh];
        let bends = clip.is_some() && model.figure.is_some();
        let asked = entry.method.or(method) == Some(Method::BasisIrradiance);
        by_patches.push(asked && !bends);
        if let (Some(own), None) = (entry.method, method) {
            report.warnings.push(format!(
                "{} asks for method = \"{}\", but without [indirect] no light is sent on.",
                file_name(mesh),
                own.name()
            ));
        }
        if bends && entry.method == Some(Method::BasisIrradiance) {
            report.warnings.push(format!(
                "{} bends, so it sends light on by its spheres and not by patches, as method = \"basis-irradiance\" asks.",
                file_name(mesh)
            ));
        }
        let set = sets.get(&(mesh, entry.spheres));
        let mut set: &SphereSet = set.map_or(&no_spheres, |set| set);
        if let (Some(clip), Some(figure)) = (clip, &model.figure) {
            let moving = rigs.moving((mesh, entry.spheres, clip), model, figure, set)?;
            report.moves.push(moving.sentence.clone());
            motion.add_rig(first, Arc::clone(&moving.rig));
            set = &moving.set;
        }
        objects.extend(of_entry(entry, model, set, first));
        whole.push(first..objects.len());
        if let Some(keys) = &entry.keys {
            let (name, seconds) = (file_name(mesh), keys.duration());
            report.moves.push(format!(
                "{name} moves along its keys, which take {seconds} s."
            ));
            motion.add_keys(first..objects.len(), keys.clone());
        }
    }
    report.fit_time = start.elapsed();
    if file.settings.indirect.is_some() || choices.surfaces {
        let (told, sampled): (Vec<_>, Vec<_>) =
            (whole.iter().cloned().zip(by_patches)).partition(|(_, by_patches)| *by_patches);
        let [told, sampled] =
            [told, sampled].map(|all| all.into_iter().map(|(body, _)| body).collect::<Vec<_>>());
        let start = Instant::now();
        report.bases = bodies::tell(&mut objects, &told, file.functions, cache, progress);
        report.basis_time = start.elapsed();
        let start = Instant::now();
        let spheres = |body: &Range<usize>| !objects[body.start].spheres.is_empty();
        let (sampled, silent): (Vec<_>, Vec<_>) = sampled.into_iter().partition(spheres);
        // Where surfaces are sampled in case, nobody has asked for light by way of bodies.
        let asked = file.settings.indirect.is_some();
        for body in silent.into_iter().filter(|_| asked) {
            report.warnings.push(format!(
                "{} has no spheres, so it sends no light on; with method = \"basis-irradiance\" and no clip it would.",
                objects[body.start].name
            ));
        }
        report.surfaces = bodies::sample(&mut objects, &sampled, cache, progress);
        motion.add_surfaces(&objects);
        report.surface_time = start.elapsed();
    }
    let mut lifted = None;
    if file.lift {
        let map = file.map.as_deref();
        let name = map.map_or("the built-in sky".into(), file_name);
        match environment.lift_sun() {
            Some(found) => {
                report.warnings.push(format!(
                    "The sun of {name}, {:.0} % of its light, is a light with sharp shadows; the camera does not see it.",
                    100.0 * found.share
                ));
                environment = found.map;
                let turn = Quat::from_rotation_y(file.rotation);
                lifted = Some(found.sun.turned(turn).scaled(file.intensity));
            }
            None => report.warnings.push(format!(
                "{name} has no sun: no part of it is that small and bright, so nothing was lifted."
            )),
        }
    }
    let environment = if file.turn == 0.0 {
        environment.rotated(file.rotation).scaled(file.intensity)
    } else {
        let degrees = file.turn;
        report.moves.push(format!(
            "The environment turns by {degrees} degrees a second."
        ));
        let environment = environment.scaled(file.intensity);
        let (start, rate) = (f64::from(file.rotation), f64::from(degrees).to_radians());
        motion.turn_environment(environment.clone(), start, rate);
        environment
    };
    let lights = file.lights.iter().map(|light| light.bound(&whole));
    let lights = lights.collect();
    let punctual = file.punctual.iter().map(|light| light.bound(&whole));
    let mut punctual: Vec<_> = lifted.into_iter().chain(punctual).collect();
    for (entry, body) in file.objects.iter().zip(&whole) {
        let model = &models[entry.mesh.as_path()];
        let lights = model.lights.iter().filter(|_| entry.lights);
        punctual.extend(lights.map(|light| of_file(light, entry, body.start)));
    }
    let lights = (lights, punctual);
    let view = match &file.view {
        Some(name) => Some(camera(path, name, &file, &models)?),
        None => None,
    };
    let seen = (environment, view);
    let mut loaded = assemble(&file, objects, lights, seen, motion, report);
    let Loaded {
        scene,
        motion,
        report,
    } = &mut loaded;
    let start = Instant::now();
    whole.retain(|body| !scene.objects[body.start].spheres.is_empty());
    report.weights = bodies::weigh(scene, motion, &whole, cache, progress);
    report.weight_time = start.elapsed();
    Ok(loaded)
}

impl FitReport {
    pub(crate) fn new<'a>(
        name: String,
        meshes: impl Iterator<Item = &'a Mesh>,
        fitted: &Found<SphereSet>,
    ) -> Self {
        Self {
            name,
            triangles: meshes.map(|mesh| mesh.triangles.len()).sum(),
            spheres: fitted.what.spheres.len(),
            outside_volume_ratio: fitted.what.outside_volume_ratio,
            time: fitted.time,
            cached: fitted.cached,
        }
    }
}

/// A camera of one of the scene's files, by its name or number, where its object has it.
fn camera(
    path: &Path,
    wanted: &CameraName,
    file: &SceneFile,
    models: &BTreeMap<&Path, Model>,
) -> Result<Camera, Error> {
    let all = file.objects.iter().flat_map(|entry| {
        let cameras = models[entry.mesh.as_path()].cameras.iter();
        cameras.map(move |camera| (camera, Affine3A::from(entry.place)))
    });
    let number = wanted.name.parse::<usize>();
    let called = |(index, (camera, _)): &(usize, (&ModelCamera, Affine3A))| {
        camera.name == wanted.name || number == Ok(*index)
    };
    let Some((_, (found, place))) = all.clone().enumerate().find(called) else {
        let names: Vec<String> = all
            .map(|(camera, _)| format!("{:?}", camera.name))
            .collect();
        let known = match names.is_empty() {
            true => "the files have none".into(),
            false => format!("the files have {}", names.join(", ")),
        };
        return Err(Error::Scene {
            path: path.to_path_buf(),
            line: wanted.line,
            message: format!("camera.name is {:?}, but {known}.", wanted.name),
        });
    };
    let eye = place.transform_point3(found.eye);
    let ahead = place
        .transform_vector3(found.ahead)
        .normalize_or(Vec3::NEG_Z);
    Ok(Camera {
        eye,
        target: eye + ahead * (2.0 * Camera::nearest(eye)).max(1.0),
        fov: file.fov.unwrap_or(found.fov),
    })
}

/// A light of a mesh file: it goes where the body does, but for a sun, which is turned as the body is at first.
fn of_file(light: &PunctualLight, entry: &ObjectEntry, body: usize) -> PunctualLight {
    match light.shape {
        PunctualShape::Sun { .. } => light.turned(entry.place.rotation),
        _ => PunctualLight {
            object: Some(body),
            ..*light
        },
    }
}

/// One object of the file as bodies: one for each of its parts. The `first`, as the scene counts them, carries the spheres
/// of all.
fn of_entry(entry: &ObjectEntry, model: &Model, set: &SphereSet, first: usize) -> Vec<Object> {
    let transform = entry.place.into();
    let file = file_name(&entry.mesh);
    let body = |(i, part): (usize, &Part)| {
        let name = if part.name.is_empty() {
            file.clone()
        } else {
            format!("{file}: {}", part.name)
        };
        let material = entry.material(&part.material);
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
            part_of: (i > 0).then_some(first),
            ..Object::default()
        }
    };
    model.parts.iter().enumerate().map(body).collect()
}

/// Puts everything together, and a value where the file has none.
fn assemble(
    file: &SceneFile,
    objects: Vec<Object>,
    (lights, punctual): (Vec<AreaLight>, Vec<PunctualLight>),
    (environment, view): (EnvironmentMap, Option<Camera>),
    mut motion: Motion,
    report: Report,
) -> Loaded {
    let mut scene = Scene {
        punctual,
        objects,
        environment,
        lights,
        ground: None,
        camera: Camera::framing(Vec3::ZERO, Vec3::ZERO, Camera::FOV),
        settings: file.settings,
    };
    let bounds = match motion.is_still() {
        true => scene.bounds(),
        false => motion::reach(&mut motion, &mut scene),
    };
    let [low, high] = bounds.unwrap_or([Vec3::ZERO; 2]);
    let fov = file.fov.unwrap_or(Camera::FOV);
    let framing = Camera::framing(low, high, fov);
    let chosen = match (file.eye.map(Vec3::from), file.target.map(Vec3::from)) {
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
    scene.camera = view.unwrap_or(chosen);
    scene.ground = file.ground.then(|| Ground {
        height: file.ground_height.unwrap_or(low.y),
        albedo: file.ground_albedo,
    });
    Loaded {
        scene,
        motion,
        report,
    }
}
