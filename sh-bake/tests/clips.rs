//! What moves in files moves in scenes: clips, skins, nodes, keys and the sky, and spheres go along.

use glam::{Affine3A, DMat4, DQuat, DVec3, DVec4, Quat, Vec3};
use sh_bake::{
    ClipChoice, Loaded, Model, SphereSet, bind_spheres, grow_spheres, load_mesh, load_scene,
    load_scene_with,
};
use sh_scene::motion::{Pose, Rig};
use sh_scene::{Mesh, Sphere};
use std::path::{Path, PathBuf};

fn good(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/good")
        .join(name)
}

fn played(path: &Path, clip: &str) -> Loaded {
    load_scene_with(path, ClipChoice::Named(clip), None, &|_| {}).unwrap_or_else(|e| panic!("{e}"))
}

#[track_caller]
fn near(found: [f32; 3], expected: [f32; 3]) {
    let distance = Vec3::from(found).distance(expected.into());
    assert!(distance < 1e-5, "{found:?} is not {expected:?}");
}

/// A folder for one test, gone afterwards.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("sh-bake-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Joints of the tube, one metre apart.
const JOINTS: usize = 6;
/// How far each joint turns at the end of the clip, about z, in degrees.
const DEGREES: f64 = 25.0;

/// Where the ring at height `y` is at the end of the clip: the sum of the bones' transforms, by the joints' own
/// arithmetic.
fn bent(p: [f32; 3], [low, high]: [usize; 2], share: f64) -> DVec3 {
    let turn = DQuat::from_rotation_z(DEGREES.to_radians());
    let bone = |joint: usize| {
        let mut matrix = DMat4::IDENTITY;
        for k in 0..=joint {
            let up = if k == 0 { 0.0 } else { 1.0 };
            matrix *= DMat4::from_rotation_translation(turn, DVec3::Y * up);
        }
        matrix * DMat4::from_translation(DVec3::NEG_Y * joint as f64)
    };
    let p = DVec4::from((DVec3::from(p.map(f64::from)), 1.0));
    (bone(low) * p * (1.0 - share) + bone(high) * p * share).truncate()
}

/// A tube along y as a glTF of a skin with six joints and a clip in which all of them turn; closed by caps, or
/// open. Returns its file, and for each vertex where it is at the clip's end.
fn tube(folder: &Folder, closed: bool) -> (PathBuf, Vec<DVec3>) {
    const RINGS: u16 = 36;
    const AROUND: u16 = 16;
    let (mut positions, mut indices) = (Vec::<[f32; 3]>::new(), Vec::<u16>::new());
    let mut ring = |y: f32, radius: f32| {
        for k in 0..AROUND {
            let (s, c) = (f32::from(k) / f32::from(AROUND) * std::f32::consts::TAU).sin_cos();
            positions.push([radius * c, y, radius * s]);
        }
    };
    let height = |r: u16| f32::from(r) / f32::from(RINGS) * JOINTS as f32;
    if closed {
        ring(0.0, 1e-3);
    }
    for r in 0..=RINGS {
        ring(height(r), 0.4);
    }
    if closed {
        ring(JOINTS as f32, 1e-3);
    }
    let rings = RINGS + if closed { 2 } else { 0 };
    for r in 0..rings {
        for k in 0..AROUND {
            let [a, b] = [k, (k + 1) % AROUND].map(|k| r * AROUND + k);
            let [c, d] = [a + AROUND, b + AROUND];
            indices.extend([a, c, b, b, c, d]);
        }
    }
    if closed {
        for k in 1..AROUND - 1 {
            let last = rings * AROUND;
            indices.extend([0, k, k + 1, last, last + k + 1, last + k]);
        }
    }
    let mut bytes = Vec::new();
    let mut views = Vec::new();
    let mut view = |bytes: &mut Vec<u8>, more: Vec<u8>| {
        views.push(format!(
            r#"{{"buffer":0,"byteOffset":{},"byteLength":{}}}"#,
            bytes.len(),
            more.len()
        ));
        bytes.extend(more);
        bytes.resize(bytes.len().next_multiple_of(4), 0);
    };
    let floats = |f: &[f32]| -> Vec<u8> { f.iter().flat_map(|f| f.to_le_bytes()).collect() };
    let (mut joints, mut weights, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    for p in &positions {
        // Half way between two joints they share a vertex evenly.
        let along = (p[1] - 0.5).clamp(0.0, (JOINTS - 1) as f32);
        let low = (along as usize).min(JOINTS - 2);
        let share = along - low as f32;
        joints.extend([low as u8, low as u8 + 1, 0, 0]);
        weights.extend([1.0 - share, share, 0.0, 0.0]);
        ends.push(bent(*p, [low, low + 1], f64::from(share)));
    }
    let inverses: Vec<f32> = (0..JOINTS)
        .flat_map(|j| Affine3A::from_translation(Vec3::NEG_Y * j as f32).to_cols_array_4())
        .collect();
    let (sine, cosine) = (DEGREES.to_radians() as f32 / 2.0).sin_cos();
    view(&mut bytes, floats(positions.as_flattened()));
    view(
        &mut bytes,
        indices.iter().flat_map(|i| i.to_le_bytes()).collect(),
    );
    view(&mut bytes, joints);
    view(&mut bytes, floats(&weights));
    view(&mut bytes, floats(&inverses));
    view(&mut bytes, floats(&[0.0, 2.0]));
    view(
        &mut bytes,
        floats(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, sine, cosine]),
    );
    let nodes: Vec<String> = (0..JOINTS)
        .map(|j| {
            let up = if j == 0 { 0 } else { 1 };
            let child = match j + 1 < JOINTS {
                true => format!(r#","children":[{}]"#, j + 1),
                false => String::new(),
            };
            format!(r#"{{"translation":[0,{up},0]{child}}}"#)
        })
        .collect();
    let channels: Vec<String> = (0..JOINTS)
        .map(|j| format!(r#"{{"sampler":0,"target":{{"node":{j},"path":"rotation"}}}}"#))
        .collect();
    let joints: Vec<String> = (0..JOINTS).map(|j| j.to_string()).collect();
    let (count, corners) = (positions.len(), indices.len());
    let accessor = |view: usize, kind: u32, count: usize, shape: &str| {
        format!(
            r#"{{"bufferView":{view},"componentType":{kind},"count":{count},"type":"{shape}"}}"#
        )
    };
    let accessors = [
        format!(
            r#"{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3","min":[-1,0,-1],"max":[1,6,1]}}"#
        ),
        accessor(1, 5123, corners, "SCALAR"),
        accessor(2, 5121, count, "VEC4"),
        accessor(3, 5126, count, "VEC4"),
        accessor(4, 5126, JOINTS, "MAT4"),
        r#"{"bufferView":5,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[2]}"#
            .to_string(),
        accessor(6, 5126, 2, "VEC4"),
    ];
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0,{JOINTS}]}}],
"nodes":[{},{{"mesh":0,"skin":0}}],
"skins":[{{"joints":[{}],"inverseBindMatrices":4}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3}},"indices":1}}]}}],
"animations":[{{"name":"Bend","channels":[{}],"samplers":[{{"input":5,"output":6}}]}}],
"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{},"uri":"tube.bin"}}]}}"#,
        nodes.join(","),
        joints.join(","),
        channels.join(","),
        accessors.join(","),
        views.join(","),
        bytes.len()
    );
    let path = folder.0.join("tube.gltf");
    std::fs::write(folder.0.join("tube.bin"), bytes).unwrap();
    std::fs::write(&path, text).unwrap();
    (path, ends)
}

/// A matrix as glTF stores it.
trait Columns {
    fn to_cols_array_4(&self) -> [f32; 16];
}

impl Columns for Affine3A {
    fn to_cols_array_4(&self) -> [f32; 16] {
        glam::Mat4::from(*self).to_cols_array()
    }
}

/// The tube's mesh, spheres and rig, the spheres as fitted.
fn rigged(model: &Model, count: usize) -> (Vec<&Mesh>, Vec<Sphere>, Rig) {
    let figure = model.figure.as_ref().expect("a clip");
    let meshes: Vec<&Mesh> = model.parts.iter().map(|part| &part.mesh).collect();
    let spheres = SphereSet::fit(&meshes, count).spheres;
    let mut still = Pose::default();
    still.set(&figure.skeleton, &figure.bones, None);
    let anchors = bind_spheres(&meshes, &figure.skins, still.bones(), &spheres);
    let rig = Rig::new(
        figure.skeleton.clone(),
        figure.bones.clone(),
        figure.clips[0].clone(),
        figure.skins.clone(),
        anchors,
    );
    (meshes, spheres, rig.unwrap())
}

/// The largest distance of a vertex from the spheres that hold it, in metres, at a time.
fn outside(rig: &Rig, mesh: &Mesh, spheres: &[Sphere], seconds: f64) -> f32 {
    let (mut pose, mut mesh, mut spheres) = (Pose::default(), mesh.clone(), spheres.to_vec());
    rig.set(seconds, &mut pose);
    rig.anchors().pose(pose.bones(), &mut spheres);
    rig.skins()[0].pose(pose.bones(), &mut mesh);
    let out = |p: &[f32; 3]| {
        let of = |s: &Sphere| Vec3::from(*p).distance(s.center.into()) - s.radius;
        spheres.iter().map(of).fold(f32::INFINITY, f32::min)
    };
    mesh.positions.iter().map(out).fold(0.0, f32::max)
}

#[test]
fn a_skinned_tube_bends_as_its_joints_turn() {
    let folder = Folder::new("bend");
    let (path, ends) = tube(&folder, true);
    let mut loaded = played(&path, "Bend");
    let still = load_scene(&path).unwrap();
    assert!(still.motion.is_still() && still.report.moves.is_empty());
    assert_eq!(
        loaded.scene.objects[0].mesh.positions.len(),
        still.scene.objects[0].mesh.positions.len()
    );
    assert_eq!(loaded.motion.period(), 2.0);
    let sentence = &loaded.report.moves[0];
    let start = "tube.gltf plays its clip `Bend`, which takes 2.000 s; to hold it, its spheres are larger by ";
    assert!(sentence.starts_with(start), "{sentence}");
    // At time 0 the tube is straight, as it is where nothing moves.
    let meshes = [&loaded.scene, &still.scene].map(|s| &s.objects[0].mesh.positions);
    for (a, b) in meshes[0].iter().zip(meshes[1]) {
        near(*a, *b);
    }
    // A hair before the end: at the end it begins anew.
    loaded.motion.pose(2.0 - 1e-9, &mut loaded.scene);
    // The vertices were split for their normals: each has to be where one of the ends is.
    let mesh = &loaded.scene.objects[0].mesh;
    for p in &mesh.positions {
        let p = DVec3::from(p.map(f64::from));
        let miss = ends
            .iter()
            .map(|e| e.distance(p))
            .fold(f64::INFINITY, f64::min);
        assert!(miss < 1e-4, "{p} is off by {miss}");
    }
    // Normals are computed from the mesh at rest and turn with it: outwards in the bent mesh too.
    for t in &mesh.triangles {
        let [a, b, c] = t.map(|i| Vec3::from(mesh.positions[i as usize]));
        let facing = (b - a).cross(c - a).normalize();
        for i in t {
            let n = Vec3::from(mesh.normals[*i as usize]);
            assert!(
                (n.length() - 1.0).abs() < 1e-5 && n.dot(facing) > 0.7,
                "{n} {facing}"
            );
        }
    }
}

#[test]
fn spheres_hold_a_bending_tube_in_every_frame() {
    for closed in [true, false] {
        let folder = Folder::new(if closed { "closed" } else { "open" });
        let (path, _) = tube(&folder, closed);
        let mut loaded = played(&path, "Bend");
        let size = JOINTS as f32;
        for frame in 0..96 {
            // Every second one was looked at when the spheres grew, the others were not.
            loaded
                .motion
                .pose(f64::from(frame) / 48.0, &mut loaded.scene);
            let object = &loaded.scene.objects[0];
            let more = if frame % 2 == 0 { 0.0 } else { 2e-3 * size };
            let set = SphereSet {
                spheres: object
                    .spheres
                    .iter()
                    .map(|s| Sphere {
                        radius: s.radius + more,
                        ..*s
                    })
                    .collect(),
                outside_volume_ratio: None,
            };
            let hole = set.uncovered(&[&object.mesh]);
            assert_eq!(hole, None, "closed: {closed}, frame {frame}");
        }
    }
}

#[test]
fn spheres_as_fitted_nearly_hold_a_bending_tube() {
    let folder = Folder::new("nearly");
    let (path, _) = tube(&folder, true);
    let model = load_mesh(&path).unwrap();
    let (meshes, spheres, rig) = rigged(&model, 24);
    let worst = (0..40)
        .map(|frame| outside(&rig, meshes[0], &spheres, f64::from(frame) * 0.05))
        .fold(0.0, f32::max)
        / JOINTS as f32;
    // If the centres stayed at rest, the tube's end alone would be metres away.
    assert!(
        worst > 0.0 && worst < 0.02,
        "vertices leave by {worst} of the length"
    );
    let mut grown = spheres.clone();
    grow_spheres(&rig, &meshes, &mut grown).unwrap();
    let volume = |spheres: &[Sphere]| spheres.iter().map(|s| s.radius.powi(3)).sum::<f32>();
    let ratio = volume(&grown) / volume(&spheres);
    assert!((1.0..1.5).contains(&ratio), "{ratio}");
    let centers = |spheres: &[Sphere]| spheres.iter().map(|s| s.center).collect::<Vec<_>>();
    assert_eq!(centers(&grown), centers(&spheres));
    // At rest every sphere is where it was fitted.
    let (mut pose, mut rest) = (Pose::default(), spheres.clone());
    rig.set(0.0, &mut pose);
    rig.anchors().pose(pose.bones(), &mut rest);
    for (a, b) in rest.iter().zip(&spheres) {
        near(a.center, b.center);
    }
}

#[test]
fn a_sphere_hangs_on_few_bones_and_its_weights_sum_to_one() {
    for closed in [true, false] {
        let folder = Folder::new(if closed { "few" } else { "few-open" });
        let (path, _) = tube(&folder, closed);
        let model = load_mesh(&path).unwrap();
        let (_, spheres, rig) = rigged(&model, 16);
        let mut count = 0;
        for anchors in rig.anchors().each() {
            count += 1;
            assert!((1..=8).contains(&anchors.len()));
            let sum: f32 = anchors.iter().map(|a| a.weight).sum();
            assert!((sum - 1.0).abs() < 1e-5, "{sum}");
        }
        assert_eq!(count, spheres.len());
        // What moves all joints alike moves the spheres alike: here, a turn of them all and a step.
        let whole = Affine3A::from_rotation_translation(
            Quat::from_euler(glam::EulerRot::XYZ, 0.3, 0.2, 0.9),
            Vec3::new(1.0, 2.0, 3.0),
        );
        let (mut pose, mut moved) = (Pose::default(), spheres.clone());
        rig.set(0.0, &mut pose);
        let bones: Vec<Affine3A> = pose.bones().iter().map(|b| whole * *b).collect();
        rig.anchors().pose(&bones, &mut moved);
        for (a, b) in moved.iter().zip(&spheres) {
            let expected = whole.transform_point3(b.center.into());
            near(a.center, expected.to_array());
        }
    }
}

#[test]
fn clips_take_joints_and_nodes_along() {
    let mut loaded = played(&good("animated.gltf"), "Wave");
    loaded.motion.pose(1.0, &mut loaded.scene);
    // The root's part of vertex 1 stays; the tip's turns by a quarter and is on a spline at (0, 1, 1).
    let flag = &loaded.scene.objects[0].mesh.positions;
    near(flag[0], [0.0, 0.0, 0.0]);
    near(flag[1], [1.0, 1.0, 0.5]);
    near(flag[2], [0.0, 1.0, 1.0]);
    // The stone stands on another node.
    near(loaded.scene.objects[1].mesh.positions[1], [6.0, 0.0, 0.0]);

    let mut loaded = played(&good("animated.gltf"), "Roll");
    loaded.motion.pose(1.5, &mut loaded.scene);
    let half = 2.0 * 0.5_f32.sqrt();
    near(loaded.scene.objects[0].mesh.positions[1], [1.0, 0.0, 0.0]);
    near(loaded.scene.objects[1].mesh.positions[0], [5.0, 0.0, 0.0]);
    near(
        loaded.scene.objects[1].mesh.positions[1],
        [5.0 + half, half, 0.0],
    );
    // A clip may be named by its number as well, and is the first by default.
    for (choice, name) in [
        (ClipChoice::Named("1"), "`Roll`"),
        (ClipChoice::First, "`Wave`"),
    ] {
        let loaded = load_scene_with(&good("animated.gltf"), choice, None, &|_| {}).unwrap();
        assert!(
            loaded.report.moves[0].contains(name),
            "{:?}",
            loaded.report.moves
        );
    }
}

#[test]
fn without_a_clip_everything_is_as_it_was() {
    let still = load_scene(&good("animated.gltf")).unwrap();
    let model = load_mesh(&good("animated.gltf")).unwrap();
    assert!(still.motion.is_still());
    for (object, part) in still.scene.objects.iter().zip(&model.parts) {
        assert_eq!(object.mesh.positions, part.mesh.positions);
    }
    // And a file that has no clip has no first one either.
    let none = load_scene_with(&good("skinned.gltf"), ClipChoice::First, None, &|_| {}).unwrap();
    assert!(none.motion.is_still());
}

#[test]
fn a_clip_that_is_not_there_is_refused_with_those_that_are() {
    let refused = |path: &Path, name: &str| {
        let loaded = load_scene_with(path, ClipChoice::Named(name), None, &|_| {});
        loaded.expect_err("no clip").to_string()
    };
    let sentence = refused(&good("animated.gltf"), "Walk");
    assert!(
        sentence.ends_with("there is no clip `Walk`; the file has `Wave`, `Roll`."),
        "{sentence}"
    );
    let sentence = refused(&good("triangle.glb"), "Walk");
    assert!(
        sentence.ends_with("there is no clip `Walk`: the file has none."),
        "{sentence}"
    );
    let sentence = refused(&good("smallest.toml"), "Walk");
    assert!(sentence.contains("under [[objects]]"), "{sentence}");
}

#[test]
fn a_scene_moves_by_keys_clips_and_a_sky_that_turns() {
    let folder = Folder::new("scene");
    let path = folder.0.join("scene.toml");
    let (animated, triangle) = (good("animated.gltf"), good("triangle.glb"));
    let text = format!(
        "[[objects]]\nmesh = {animated:?}\nclip = \"Wave\"\nscale = 2\n\
         keys = [{{ time = 0 }}, {{ time = 4, translate = [8, -3, 0], rotate = [0, 90, 0], scale = 4 }}]\n\
         [[objects]]\nmesh = {triangle:?}\nspheres = 1\n\
         [environment]\nmap = {:?}\nrotation = 45\nturn = 90\n",
        good("ramp.exr")
    );
    std::fs::write(&path, text).unwrap();
    let mut loaded = load_scene(&path).unwrap();
    assert_eq!(loaded.report.moves.len(), 3);
    assert_eq!(loaded.motion.period(), 4.0);
    let start = Affine3A::from_scale(Vec3::splat(2.0));
    assert_eq!(loaded.scene.objects[0].transform, start);
    assert_eq!(loaded.scene.objects[1].transform, start);
    // The lowest place is reached later.
    let ground = loaded.scene.ground.unwrap().height;
    assert!((-3.0..-2.8).contains(&ground), "{ground}");
    let still = loaded.scene.objects[2].transform;
    loaded.motion.pose(2.0, &mut loaded.scene);
    let expected = Affine3A::from_scale_rotation_translation(
        Vec3::splat(3.0),
        Quat::from_rotation_y(45.0_f32.to_radians()),
        Vec3::new(4.0, -1.5, 0.0),
    );
    for object in &loaded.scene.objects[..2] {
        assert!(
            object.transform.abs_diff_eq(expected, 1e-5),
            "{:?}",
            object.transform
        );
    }
    assert_eq!(loaded.scene.objects[2].transform, still);
    let map = sh_bake::load_environment(&good("ramp.exr")).unwrap();
    let turned = map.rotated(225.0_f32.to_radians());
    for (a, b) in loaded.scene.environment.pixels.iter().zip(&turned.pixels) {
        near(*a, *b);
    }
    // Without `repeat` the object stays where its keys end.
    loaded.motion.pose(60.0, &mut loaded.scene);
    assert_eq!(loaded.scene.objects[0].transform.translation.y, -3.0);
}
