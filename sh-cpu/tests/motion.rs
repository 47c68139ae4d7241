//! Shadows of bodies that move: they change from frame to frame by no more than the bodies do.

mod common;

use common::{object, scene, sphere_mesh};
use glam::{Affine3A, Quat, Vec3, vec3};
use sh_scene::motion::{Anchor, Anchors, Bone, Clip, Interpolation, Joint, JointTracks};
use sh_scene::motion::{Influences, Motion, Rig, Skeleton, Skin, Track, Trs};
use sh_scene::{Camera, Ground, Limits, Plan, Scene, Sky, Sphere};
use std::sync::Arc;

/// Joints of an arm over the ground, a metre apart; each turns up to half a radian about its own axis.
const JOINTS: u32 = 5;

/// An arm of 60 spheres on joints that swing to and fro in two seconds, and a camera that sees nothing but the
/// ground under it.
fn swinging() -> (Scene, Motion) {
    let joint = |j: u32| Joint {
        parent: j.checked_sub(1),
        local: Affine3A::from_translation(match j {
            0 => vec3(-2.0, 1.6, 0.0),
            _ => Vec3::X,
        }),
    };
    let joints: Vec<Joint> = (0..JOINTS).map(joint).collect();
    let tracks = |j: u32| {
        let axis = if j.is_multiple_of(2) {
            Vec3::Y
        } else {
            Vec3::Z
        };
        let turns = [0.0, 0.5, 0.0, -0.3, 0.0].map(|angle| Quat::from_axis_angle(axis, angle));
        let times = vec![0.0, 0.5, 1.0, 1.5, 2.0];
        JointTracks {
            joint: j,
            rest: Trs {
                translation: joints[j as usize].local.translation.into(),
                rotation: Quat::IDENTITY,
                scale: Vec3::ONE,
            },
            translation: None,
            rotation: Some(Track::new(times, turns.to_vec(), Interpolation::Linear).unwrap()),
            scale: None,
        }
    };
    let clip = Clip::new("swing".into(), (0..JOINTS).map(tracks).collect());
    let bone = |j| Bone {
        joint: Some(j),
        inverse_bind: Affine3A::IDENTITY,
    };
    let bones: Vec<Bone> = (0..JOINTS).map(bone).collect();
    let mesh = sphere_mesh(0.01, 2);
    let all = vec![Influences::one(0); mesh.positions.len()];
    let skin = Skin::new(&mesh.positions, &mesh.normals, all).unwrap();
    let held = |i: u32| {
        vec![Anchor {
            bone: i % JOINTS,
            weight: 1.0,
            point: vec3((i / JOINTS) as f32 / 12.0, 0.0, 0.0),
        }]
    };
    let anchors = Anchors::new((0..60).map(held));
    let skeleton = Skeleton::new(joints.clone()).unwrap();
    let rig = Rig::new(skeleton, bones, clip, vec![skin], anchors).unwrap();
    let mut motion = Motion::default();
    motion.add_rig(0, Arc::new(rig));

    let mut body = object(mesh, Affine3A::IDENTITY);
    let sphere = |i: u32| Sphere {
        center: [0.0; 3],
        radius: 0.1 + 0.01 * (i % 7) as f32,
    };
    body.spheres = (0..60).map(sphere).collect();
    let mut scene = scene(vec![body]);
    scene.environment = Sky::default().map(64, 32);
    scene.ground = Some(Ground {
        height: 0.0,
        albedo: [1.0; 3],
    });
    scene.camera = Camera {
        eye: vec3(0.0, 0.9, 0.1),
        target: Vec3::ZERO,
        fov: 1.6,
    };
    (scene, motion)
}

/// The largest change of a pixel's green from a frame to the next, over half a second with so many frames,
/// relative to the brightest pixel; and the farthest that a sphere moves.
fn changes(scene: &mut Scene, motion: &mut Motion, frames: u32) -> (f32, f32) {
    let plan = Plan::new(scene);
    let mut last: Option<(Vec<f32>, Vec<Sphere>)> = None;
    let (mut change, mut way) = (0.0_f32, 0.0_f32);
    for frame in 0..=frames {
        motion.pose(0.8 + 0.5 * f64::from(frame) / f64::from(frames), scene);
        let picture = sh_cpu::render(scene, &plan, (48, 32), &|_| {}).unwrap();
        let green: Vec<f32> = picture.pixels.iter().map(|p| p[1]).collect();
        let spheres = scene.world_spheres();
        if let Some((before, moved)) = &last {
            let brightest = green.iter().fold(0.0, |a: f32, b| a.max(*b));
            let pixels = green.iter().zip(before);
            change = pixels.fold(change, |m, (a, b)| m.max((a - b).abs() / brightest));
            let pairs = spheres.iter().zip(moved);
            way = pairs.fold(way, |m, (a, b)| {
                m.max(Vec3::from(a.center).distance(b.center.into()))
            });
        }
        last = Some((green, spheres));
    }
    (change, way)
}

/// Of the brightest pixel, for each metre that a sphere moves. The arm is 1.6 metres above the ground.
const MOST_A_METRE: f32 = 0.2;
/// What a cut may add that takes another node than in the frame before, whatever the rate of frames.
const MOST_OF_A_CUT: f32 = 0.015;

#[test]
fn a_shadow_changes_by_no_more_than_its_body_moves() {
    let (mut scene, mut motion) = swinging();
    for half_resolution in [false, true] {
        for (limits, jump) in [(Limits::LEAVES, 0.0), (Limits::default(), MOST_OF_A_CUT)] {
            scene.settings.half_resolution = half_resolution;
            scene.settings.limits = limits;
            for frames in [15, 120] {
                let (change, way) = changes(&mut scene, &mut motion, frames);
                let most = MOST_A_METRE * way + jump;
                assert!(
                    change < most && change > 0.1 * MOST_A_METRE * way,
                    "half {half_resolution}, {limits:?}, {frames} frames: {change} of {most}, {way} m"
                );
            }
        }
    }
}
