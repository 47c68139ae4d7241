//! Motion made by code: a function of time alone, with what moves where it should be.

use glam::{Affine3A, EulerRot, Quat, Vec3};
use sh_scene::motion::{
    Anchor, Anchors, Bone, Clip, Influences, Interpolation, Joint, JointTracks, Keys, Motion,
    MotionError, Place, Rig, Skeleton, Skin, Track, Trs,
};
use sh_scene::{
    Camera, EnvironmentMap, Ground, Material, Mesh, Object, Scene, Settings, Sky, Sphere,
};
use std::sync::Arc;

const REST: Trs = Trs {
    translation: Vec3::ZERO,
    rotation: Quat::IDENTITY,
    scale: Vec3::ONE,
};

/// A strip along y from 0 to 4, carried by a bone below and one above y = 2, where it blends.
fn strip() -> (Mesh, Vec<Influences>) {
    let mut mesh = Mesh::default();
    let mut influences = Vec::new();
    for row in 0..=16_u32 {
        let y = row as f32 / 4.0;
        let above = (y - 1.5).clamp(0.0, 1.0);
        for x in [0.0, 1.0] {
            mesh.positions.push([x, y, 0.0]);
            mesh.normals.push([0.0, 0.0, 1.0]);
            influences.push(Influences {
                bones: [0, 1, 0, 0],
                weights: [1.0 - above, above, 0.0, 0.0],
            });
        }
        if row > 0 {
            let i = 2 * row;
            mesh.triangles
                .extend([[i - 2, i - 1, i], [i, i - 1, i + 1]]);
        }
    }
    (mesh, influences)
}

/// A joint in the origin and one at y = 2 that turns about z by a quarter in two seconds.
fn bend() -> (Skeleton, Vec<Bone>, Clip) {
    let up = Affine3A::from_translation(Vec3::Y * 2.0);
    let joints = vec![
        Joint {
            parent: None,
            local: Affine3A::IDENTITY,
        },
        Joint {
            parent: Some(0),
            local: up,
        },
    ];
    let bone = |joint, inverse_bind| Bone {
        joint: Some(joint),
        inverse_bind,
    };
    let bones = vec![bone(0, Affine3A::IDENTITY), bone(1, up.inverse())];
    let turns = [0.0, 1.0, 2.0].map(|t: f32| Quat::from_rotation_z(t * 45.0_f32.to_radians()));
    let rotation = Track::new(vec![0.0, 1.0, 2.0], turns.to_vec(), Interpolation::Linear);
    let tracks = JointTracks {
        joint: 1,
        rest: Trs {
            translation: Vec3::Y * 2.0,
            ..REST
        },
        translation: None,
        rotation: Some(rotation.unwrap()),
        scale: None,
    };
    let clip = Clip::new("bend".into(), vec![tracks]);
    (Skeleton::new(joints).unwrap(), bones, clip)
}

fn object(mesh: Mesh) -> Object {
    Object {
        name: "strip".into(),
        mesh,
        material: Material::diffuse([0.5; 3]),
        spheres: vec![
            Sphere {
                center: [0.5, 0.5, 0.0],
                radius: 1.0,
            },
            Sphere {
                center: [0.5, 3.0, 0.0],
                radius: 1.0,
            },
        ],
        ..Object::default()
    }
}

/// A strip that bends, a strip that moves as a whole, and one that stands still, under a sky that turns.
fn scene() -> (Scene, Motion) {
    let (mesh, influences) = strip();
    let skin = Skin::new(&mesh.positions, &mesh.normals, influences).unwrap();
    let (skeleton, bones, clip) = bend();
    let anchor = |bone, point| Anchor {
        bone,
        weight: 1.0,
        point,
    };
    let anchors = Anchors::new([
        vec![anchor(0, Vec3::new(0.5, 0.5, 0.0))],
        vec![anchor(1, Vec3::new(0.5, 3.0, 0.0))],
    ]);
    let rig = Rig::new(skeleton, bones, clip, vec![skin], anchors).unwrap();
    let place = |x: f32, turn: f32| Place {
        translation: Vec3::new(x, 0.0, 0.0),
        rotation: Quat::from_euler(EulerRot::YXZ, turn, 0.2, 0.1),
        scale: 1.0 + x,
    };
    let keys = vec![
        (0.5, place(0.0, 0.0)),
        (1.5, place(2.0, 1.0)),
        (3.0, place(0.0, 2.0)),
    ];
    let environment = Sky::default().map(32, 16);
    let mut motion = Motion::default();
    motion.add_rig(0, Arc::new(rig));
    motion.add_keys(1..2, Keys::new(keys, true).unwrap());
    motion.turn_environment(environment.clone(), 0.3, 0.5);
    let scene = Scene {
        punctual: Vec::new(),
        objects: vec![object(mesh.clone()), object(mesh.clone()), object(mesh)],
        environment,
        lights: Vec::new(),
        ground: Some(Ground {
            height: 0.0,
            albedo: [0.5; 3],
        }),
        camera: Camera::framing(Vec3::ZERO, Vec3::ONE, Camera::FOV),
        settings: Settings::default(),
    };
    (scene, motion)
}

/// All that may move, bit by bit.
fn bits(scene: &Scene) -> Vec<u32> {
    let mut bits = Vec::new();
    let mut put = |floats: &[f32]| bits.extend(floats.iter().map(|f| f.to_bits()));
    for object in &scene.objects {
        put(object.mesh.positions.as_flattened());
        put(object.mesh.normals.as_flattened());
        put(&object.transform.to_cols_array());
        for sphere in &object.spheres {
            put(&sphere.center);
            put(&[sphere.radius]);
        }
    }
    put(scene.environment.pixels.as_flattened());
    bits
}

#[test]
fn a_frame_is_the_same_whatever_came_before_it() {
    let (mut long, mut motion) = scene();
    for frame in [3, 40, 7, 1000, 0, 40] {
        motion.pose(f64::from(frame) / 30.0, &mut long);
    }
    let (mut alone, mut other) = scene();
    other.pose(40.0 / 30.0, &mut alone);
    assert_eq!(bits(&long), bits(&alone));
    motion.pose(41.0 / 30.0, &mut long);
    assert_ne!(bits(&long), bits(&alone));
}

#[test]
fn a_steady_frame_allocates_nothing() {
    let (mut scene, mut motion) = scene();
    motion.pose(0.0, &mut scene);
    let room = |scene: &Scene| {
        let object = &scene.objects[0];
        (
            object.mesh.positions.as_ptr(),
            object.mesh.normals.as_ptr(),
            object.spheres.as_ptr(),
            scene.environment.pixels.as_ptr(),
            scene.environment.pixels.capacity(),
        )
    };
    let before = room(&scene);
    for frame in 1..50 {
        motion.pose(f64::from(frame) * 0.1, &mut scene);
        assert_eq!(room(&scene), before, "frame {frame}");
    }
}

#[test]
fn what_does_not_move_is_not_touched() {
    let (mut scene, mut motion) = scene();
    let still = scene.objects[2].clone();
    motion.pose(1.2, &mut scene);
    assert_eq!(scene.objects[2].mesh.positions, still.mesh.positions);
    assert_eq!(scene.objects[2].transform, still.transform);
    let before = bits(&scene);
    let mut none = Motion::default();
    assert!(none.is_still() && !none.bends() && !none.turns() && none.period() == 0.0);
    none.pose(5.0, &mut scene);
    assert_eq!(bits(&scene), before);
}

#[test]
fn a_skin_bends_where_its_joints_are() {
    let (mut scene, mut motion) = scene();
    // Half a second before the clip's end, and as long after it has begun anew.
    for seconds in [1.5, 3.5, 21.5] {
        motion.pose(seconds, &mut scene);
        let mesh = &scene.objects[0].mesh;
        let turn = Quat::from_rotation_z((1.5 * 45.0_f32).to_radians());
        let (rest, _) = strip();
        for (i, (p, q)) in rest.positions.iter().zip(&mesh.positions).enumerate() {
            let (p, q) = (Vec3::from(*p), Vec3::from(*q));
            let turned = Vec3::Y * 2.0 + turn * (p - Vec3::Y * 2.0);
            let above = (p.y - 1.5).clamp(0.0, 1.0);
            let expected = p.lerp(turned, above);
            assert!(q.distance(expected) < 1e-5, "vertex {i}: {q}, {expected}");
        }
        // A turn in its plane leaves the strip's normal alone.
        for n in &mesh.normals {
            assert!(Vec3::from(*n).distance(Vec3::Z) < 1e-5, "{n:?}");
        }
        let [below, above] = [0, 1].map(|k| Vec3::from(scene.objects[0].spheres[k].center));
        assert!(below.distance(Vec3::new(0.5, 0.5, 0.0)) < 1e-5);
        let expected = Vec3::Y * 2.0 + turn * Vec3::new(0.5, 1.0, 0.0);
        assert!(above.distance(expected) < 1e-5, "{above}");
    }
}

#[test]
fn normals_stay_upright_on_bones_that_stretch_and_mirror() {
    let (mesh, influences) = strip();
    let leaning = vec![Vec3::new(0.6, 0.0, 0.8).to_array(); mesh.positions.len()];
    let skin = Skin::new(&mesh.positions, &leaning, influences).unwrap();
    let mut posed = mesh.clone();
    for scale in [Vec3::new(3.0, 1.0, 1.0), Vec3::new(-3.0, 1.0, 1.0)] {
        let bones = [Affine3A::from_scale(scale); 2];
        skin.pose(&bones, &mut posed);
        // Tangents (0, 1, 0) and (0.8, 0, -0.6) become (0, 1, 0) and (±2.4, 0, -0.6).
        let expected = Vec3::new(0.6 * scale.x.signum(), 0.0, 2.4).normalize();
        for n in &posed.normals {
            assert!(Vec3::from(*n).distance(expected) < 1e-5, "{n:?}");
        }
    }
}

#[test]
fn bones_without_volume_leave_unit_normals() {
    let (mesh, influences) = strip();
    let skin = Skin::new(&mesh.positions, &mesh.normals, influences).unwrap();
    let mut posed = mesh;
    for scale in [Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0), Vec3::splat(1e-30)] {
        // One bone alone, and one against its own mirror image, which cancel in the middle.
        for other in [scale, -scale, Vec3::ONE] {
            let bones = [Affine3A::from_scale(scale), Affine3A::from_scale(other)];
            skin.pose(&bones, &mut posed);
            for (p, n) in posed.positions.iter().zip(&posed.normals) {
                assert!(Vec3::from(*p).is_finite());
                let length = Vec3::from(*n).length();
                assert!((length - 1.0).abs() < 1e-5, "{scale} {other}: {n:?}");
            }
        }
    }
}

#[test]
fn a_mesh_can_be_posed_in_pieces() {
    let (mesh, influences) = strip();
    let skin = Skin::new(&mesh.positions, &mesh.normals, influences).unwrap();
    let bones = [Affine3A::IDENTITY, Affine3A::from_rotation_x(0.4)];
    let (mut whole, mut pieces) = (mesh.clone(), mesh);
    skin.pose(&bones, &mut whole);
    let (positions, normals) = (&mut pieces.positions, &mut pieces.normals);
    for (k, (p, n)) in positions
        .chunks_mut(5)
        .zip(normals.chunks_mut(5))
        .enumerate()
    {
        skin.pose_from(5 * k, &bones, p, n);
    }
    assert_eq!(whole.positions, pieces.positions);
    assert_eq!(whole.normals, pieces.normals);
}

#[test]
fn keys_move_an_object_as_a_whole() {
    let (mut scene, mut motion) = scene();
    motion.pose(1.0, &mut scene);
    let object = &scene.objects[1];
    assert!((object.transform.translation.x - 1.0).abs() < 1e-6);
    let scale = object.transform.matrix3.x_axis.length();
    assert!((scale - 2.0).abs() < 1e-5, "{scale}");
    assert_eq!(object.mesh.positions, strip().0.positions);
    // They begin anew after three seconds.
    let (mut later, mut other) = self::scene();
    other.pose(4.0, &mut later);
    assert_eq!(later.objects[1].transform, object.transform);
}

#[test]
fn the_environment_turns_from_its_rest() {
    let (mut scene, mut motion) = scene();
    let rest = Sky::default().map(32, 16);
    for seconds in [0.0, 2.0, 100.0, 1e6] {
        motion.pose(seconds, &mut scene);
        let angle = motion.environment_angle(seconds).unwrap();
        assert!((angle - (0.3 + 0.5 * seconds).rem_euclid(std::f64::consts::TAU)).abs() < 1e-6);
        assert_eq!(scene.environment, rest.rotated(angle as f32), "{seconds}");
    }
    let d = EnvironmentMap::direction(0.4, 0.3);
    motion.pose(1.0, &mut scene);
    let turned = scene.environment.sample(Quat::from_rotation_y(0.8) * d);
    // Both interpolate, the turned map twice.
    let before = rest.sample(d);
    for c in 0..3 {
        assert!(
            (turned[c] - before[c]).abs() < 0.05 * before[c].max(0.1),
            "{turned:?} {before:?}"
        );
    }
}

#[test]
fn times_that_are_none_count_as_zero() {
    let (mut scene, mut motion) = scene();
    motion.pose(0.0, &mut scene);
    let zero = bits(&scene);
    for seconds in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        motion.pose(1.0, &mut scene);
        motion.pose(seconds, &mut scene);
        assert_eq!(bits(&scene), zero);
    }
    motion.pose(-1e12, &mut scene);
    assert!(bits(&scene).iter().all(|b| f32::from_bits(*b).is_finite()));
}

#[test]
fn objects_that_are_gone_are_passed_over() {
    let (mut scene, mut motion) = scene();
    while !scene.objects.is_empty() {
        scene.objects.pop();
        motion.pose(1.0, &mut scene);
    }
}

#[test]
fn rigs_that_name_what_is_not_there_are_refused() {
    let (mesh, influences) = strip();
    let (skeleton, bones, clip) = bend();
    let skin = Skin::new(&mesh.positions, &mesh.normals, influences).unwrap();
    let rig = |bones: &[Bone], anchors: Anchors| {
        let (skeleton, clip) = (skeleton.clone(), clip.clone());
        let rig = Rig::new(skeleton, bones.to_vec(), clip, vec![skin.clone()], anchors);
        rig.map(|_| ()).map_err(|e| e.to_string())
    };
    assert_eq!(rig(&bones, Anchors::default()), Ok(()));
    let sentence = rig(&bones[..1], Anchors::default()).unwrap_err();
    assert_eq!(sentence, "bone 1 is named, but there are 1");
    let far = Anchor {
        bone: 7,
        weight: 1.0,
        point: Vec3::ZERO,
    };
    let sentence = rig(&bones, Anchors::new([vec![far]])).unwrap_err();
    assert_eq!(sentence, "bone 7 is named, but there are 2");
    let wild = Bone {
        joint: Some(5),
        ..bones[0]
    };
    let sentence = rig(&[wild, bones[1]], Anchors::default()).unwrap_err();
    assert_eq!(sentence, "joint 5 is named, but there are 2");
    let child = Joint {
        parent: Some(1),
        local: Affine3A::IDENTITY,
    };
    let error = Skeleton::new(vec![child]).unwrap_err();
    assert_eq!(
        error,
        MotionError::Parent {
            joint: 0,
            parent: 1
        }
    );
    let short = Skin::new(&mesh.positions, &mesh.normals[1..], Vec::new()).unwrap_err();
    assert!(matches!(
        short,
        MotionError::Length {
            what: "normals",
            ..
        }
    ));
}
