//! Surface samples go along with their spheres on skins that bend.

use glam::{Affine3A, Quat, Vec3};
use sh_scene::motion::{
    Anchor, Anchors, Bone, Clip, Influences, Interpolation, Joint, JointTracks, Motion, Rig,
    Skeleton, Skin, Track, Trs,
};
use sh_scene::surface::directions;
use sh_scene::{
    Camera, EnvironmentMap, Material, Mesh, Object, Scene, Settings, Sphere, SurfacePoint,
    SurfaceSamples,
};
use std::f32::consts::TAU;
use std::sync::Arc;

const RADIUS: f32 = 0.3;
const LENGTH: f32 = 4.0;
const SPHERES: usize = 8;
/// Where the tube bends.
const KNEE: Vec3 = Vec3::new(0.0, 2.0, 0.0);

/// How much of the upper bone a height has: all beyond half a metre above the knee.
fn share(y: f32, hard: bool) -> f32 {
    match hard {
        true => 1.0,
        false => (y - KNEE.y + 0.5).clamp(0.0, 1.0),
    }
}

/// A tube up the y axis.
fn tube() -> Mesh {
    const AROUND: u32 = 24;
    const ROWS: u32 = 80;
    let mut mesh = Mesh::default();
    for row in 0..=ROWS {
        for k in 0..AROUND {
            let (sin, cos) = (TAU * k as f32 / AROUND as f32).sin_cos();
            let y = LENGTH * row as f32 / ROWS as f32;
            mesh.positions.push([RADIUS * cos, y, RADIUS * sin]);
            mesh.normals.push([cos, 0.0, sin]);
            if row > 0 {
                let (a, b) = (
                    AROUND * (row - 1) + k,
                    AROUND * (row - 1) + (k + 1) % AROUND,
                );
                let (c, d) = (a + AROUND, b + AROUND);
                mesh.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
    }
    mesh
}

/// Spheres along the tube, and where rays from their centres meet it in each one's own part.
fn samples() -> (Vec<Sphere>, SurfaceSamples) {
    let half = LENGTH / SPHERES as f32 / 2.0;
    let (mut spheres, mut samples) = (Vec::new(), SurfaceSamples::default());
    for i in 0..SPHERES {
        let y = half * (2 * i + 1) as f32;
        let center = [0.0, y, 0.0];
        let radius = RADIUS.hypot(half);
        spheres.push(Sphere { center, radius });
        let met = |(j, d): (usize, &[f32; 3])| {
            let across = d[0].hypot(d[2]);
            let rise = RADIUS * d[1] / across.max(1e-6);
            (rise.abs() <= half).then(|| SurfacePoint {
                position: [RADIUS * d[0] / across, y + rise, RADIUS * d[2] / across],
                direction: j as u32,
                normal: [d[0] / across, 0.0, d[2] / across],
                albedo: [0.5; 3],
                ..Default::default()
            })
        };
        samples.push(directions().iter().enumerate().filter_map(met));
    }
    (spheres, samples)
}

/// The tube on a bone in the origin and one at the knee that turns by so much about an axis in two seconds; all on the
/// upper one where it is `hard`.
fn scene(turn: Quat, hard: bool) -> (Scene, Motion) {
    let knee = Affine3A::from_translation(KNEE);
    let joint = |parent, local| Joint { parent, local };
    let skeleton = Skeleton::new(vec![joint(None, Affine3A::IDENTITY), joint(Some(0), knee)]);
    let bone = |joint, inverse_bind| Bone {
        joint: Some(joint),
        inverse_bind,
    };
    let bones = vec![bone(0, Affine3A::IDENTITY), bone(1, knee.inverse())];
    let turns = vec![Quat::IDENTITY, turn];
    let rest = Trs {
        translation: KNEE,
        rotation: Quat::IDENTITY,
        scale: Vec3::ONE,
    };
    let tracks = JointTracks {
        joint: 1,
        rest,
        translation: None,
        rotation: Some(Track::new(vec![0.0, 2.0], turns, Interpolation::Linear).unwrap()),
        scale: None,
    };
    let mesh = tube();
    let influences = mesh.positions.iter().map(|p| {
        let above = share(p[1], hard);
        Influences {
            bones: [0, 1, 0, 0],
            weights: [1.0 - above, above, 0.0, 0.0],
        }
    });
    let skin = Skin::new(&mesh.positions, &mesh.normals, influences.collect()).unwrap();
    let (spheres, surface) = samples();
    let anchors = spheres.iter().map(|s| {
        let above = share(s.center[1], hard);
        let anchor = |bone, weight| Anchor {
            bone,
            weight,
            point: Vec3::from(s.center) * weight,
        };
        vec![anchor(0, 1.0 - above), anchor(1, above)]
    });
    let clip = Clip::new("bend".into(), vec![tracks]);
    let anchors = Anchors::new(anchors);
    let rig = Rig::new(skeleton.unwrap(), bones, clip, vec![skin], anchors).unwrap();
    let mut motion = Motion::default();
    motion.add_rig(0, Arc::new(rig));
    let object = Object {
        name: "tube".into(),
        mesh,
        material: Material::diffuse([0.5; 3]),
        transform: Affine3A::from_translation(Vec3::X),
        spheres,
        surface,
        ..Object::default()
    };
    motion.add_surfaces(std::slice::from_ref(&object));
    let scene = Scene {
        punctual: Vec::new(),
        objects: vec![object],
        environment: EnvironmentMap::constant([1.0; 3]),
        lights: Vec::new(),
        ground: None,
        camera: Camera::framing(Vec3::ZERO, Vec3::ONE, Camera::FOV),
        settings: Settings::default(),
    };
    (scene, motion)
}

#[test]
fn the_only_bone_takes_points_along_rigidly() {
    for angle in [0.3_f32, 1.5, 3.0] {
        let axis = Vec3::new(0.6, 0.0, 0.8);
        let turn = Quat::from_axis_angle(axis, angle);
        let (mut scene, mut motion) = scene(turn, true);
        let (_, rest) = samples();
        // The clip begins anew at its end.
        motion.pose(2.0 - 1e-6, &mut scene);
        let surface = &scene.objects[0].surface;
        assert_eq!(surface.starts, rest.starts);
        for (p, q) in rest.points.iter().zip(&surface.points) {
            let moved = KNEE + turn * (Vec3::from(p.position) - KNEE);
            assert!(
                moved.distance(Vec3::from(q.position)) < 1e-4,
                "{moved} {q:?}"
            );
            let normal = turn * Vec3::from(p.normal);
            assert!(normal.distance(Vec3::from(q.normal)) < 1e-4);
            assert_eq!((p.direction, p.albedo), (q.direction, q.albedo));
        }
        for rotation in &surface.rotations {
            assert!(Quat::from_array(*rotation).dot(turn).abs() > 1.0 - 1e-6);
        }
    }
}

#[test]
fn the_frame_of_directions_turns_with_the_points() {
    let (mut scene, mut motion) = scene(Quat::from_rotation_z(1.2), false);
    motion.pose(1.9, &mut scene);
    let object = &scene.objects[0];
    for (i, sphere) in object.spheres.iter().enumerate() {
        let turn = Quat::from_array(object.surface.rotations[i]);
        for p in object.surface.of(i) {
            let way = Vec3::from(p.position) - Vec3::from(sphere.center);
            let direction = turn * Vec3::from(directions()[p.direction as usize]);
            assert!(way.normalize().distance(direction) < 1e-4, "{i}");
        }
    }
}

/// How far points are from the nearest vertex of the mesh, in the radii of their spheres: the farthest, and the mean.
fn stray(object: &Object) -> (f32, f32) {
    let (mut most, mut sum, mut count) = (0.0_f32, 0.0, 0);
    for (i, sphere) in object.spheres.iter().enumerate() {
        for p in object.surface.of(i) {
            let away = |q: &[f32; 3]| Vec3::from(*q).distance_squared(p.position.into());
            let least = object
                .mesh
                .positions
                .iter()
                .map(away)
                .fold(f32::INFINITY, f32::min);
            let away = least.sqrt() / sphere.radius;
            (most, sum, count) = (most.max(away), sum + away, count + 1);
        }
    }
    (most, sum / count as f32)
}

#[test]
fn points_of_a_tube_that_bends_stay_near_it() {
    // Vertices are up to 0.05 apart, a seventh of a sphere's radius.
    let still = stray(&scene(Quat::IDENTITY, false).0.objects[0]);
    assert!(still.0 < 0.12 && still.1 < 0.07, "{still:?}");
    for (degrees, most, mean) in [(45.0_f32, 0.2, 0.07), (90.0, 0.27, 0.08), (135.0, 0.5, 0.1)] {
        let (mut scene, mut motion) = scene(Quat::from_rotation_z(degrees.to_radians()), false);
        motion.pose(2.0 - 1e-6, &mut scene);
        let found = stray(&scene.objects[0]);
        println!("{degrees} degrees: {found:?}");
        assert!(
            found.0 < most && found.1 < mean,
            "{degrees} degrees: {found:?}"
        );
    }
}

#[test]
fn a_frame_is_the_same_whatever_came_before_it_and_allocates_nothing() {
    let turn = Quat::from_rotation_z(1.5);
    let (mut long, mut motion) = scene(turn, false);
    let room = |scene: &Scene| {
        let surface = &scene.objects[0].surface;
        (surface.points.as_ptr(), surface.rotations.as_ptr())
    };
    let before = room(&long);
    for seconds in [0.3, 1.9, 17.0, 0.0, 1.1] {
        motion.pose(seconds, &mut long);
        assert_eq!(room(&long), before);
    }
    let (mut alone, mut other) = scene(turn, false);
    other.pose(1.1, &mut alone);
    assert_eq!(long.objects[0].surface, alone.objects[0].surface);
    assert_ne!(long.objects[0].surface, samples().1);
}

#[test]
fn samples_that_are_gone_are_passed_over() {
    let (mut scene, mut motion) = scene(Quat::from_rotation_z(1.0), false);
    let surface = &mut scene.objects[0].surface;
    surface.points.truncate(7);
    surface.rotations.clear();
    motion.pose(1.0, &mut scene);
    assert_eq!(scene.objects[0].surface.points.len(), 7);
    scene.objects[0].surface = SurfaceSamples::default();
    motion.pose(1.0, &mut scene);
    motion.add_surfaces(&scene.objects);
    scene.objects.clear();
    motion.pose(1.0, &mut scene);
    motion.add_surfaces(&[]);
}

#[test]
fn bones_without_volume_leave_finite_points() {
    let (mut scene, _) = scene(Quat::IDENTITY, false);
    for scale in [Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0), Vec3::NEG_ONE] {
        let joint = Joint {
            parent: None,
            local: Affine3A::from_scale(scale),
        };
        let bone = Bone {
            joint: Some(0),
            inverse_bind: Affine3A::IDENTITY,
        };
        let skeleton = Skeleton::new(vec![joint]).unwrap();
        let anchor = Anchor {
            bone: 0,
            weight: 1.0,
            point: Vec3::Y,
        };
        let anchors = Anchors::new(vec![vec![anchor]; SPHERES]);
        let rig = Rig::new(skeleton, vec![bone], Clip::default(), Vec::new(), anchors).unwrap();
        let mut motion = Motion::default();
        motion.add_rig(0, Arc::new(rig));
        motion.add_surfaces(&scene.objects);
        motion.pose(1.0, &mut scene);
        for p in &scene.objects[0].surface.points {
            let length = Vec3::from(p.normal).length();
            assert!(Vec3::from(p.position).is_finite() && (length - 1.0).abs() < 1e-5);
        }
    }
}
