//! Figures of segments that walk.

use crate::bench::body::Segment;
use glam::Vec3;

/// A figure of so many times a person's size, with limbs of a thickness in metres, walking towards +Z.
pub fn character(size: f32, thick: f32) -> Vec<Segment> {
    let at = |x: f32, y: f32, z: f32| Vec3::new(x, y, z) * size;
    let body = Segment::still(
        at(0.0, 0.95, 0.0),
        Vec3::ZERO,
        at(0.0, 0.5, 0.0),
        thick * 1.5,
    );
    let mut all = vec![
        Segment {
            axis: Vec3::Y,
            swing: 0.15,
            ..body
        },
        Segment {
            parent: Some(0),
            axis: Vec3::X,
            swing: 0.1,
            ..Segment::still(
                at(0.0, 0.62, 0.0),
                at(0.0, 0.05, 0.0),
                at(0.0, 0.2, 0.02),
                thick * 1.1,
            )
        },
    ];
    for side in [-1.0, 1.0] {
        let phase = if side > 0.0 { 0.0 } else { 0.5 };
        // Upper arm, forearm.
        let shoulder = Segment::still(
            at(0.24 * side, 0.5, 0.0),
            Vec3::ZERO,
            at(0.1 * side, -0.3, 0.0),
            thick * 0.7,
        );
        all.push(Segment {
            parent: Some(0),
            swing: 0.7,
            phase,
            ..shoulder
        });
        let elbow = Segment::still(
            at(0.1 * side, -0.32, 0.0),
            Vec3::ZERO,
            at(0.02 * side, -0.24, 0.14),
            thick * 0.6,
        );
        all.push(Segment {
            parent: Some(all.len() - 1),
            swing: 0.4,
            phase,
            ..elbow
        });
        // Thigh, shin, foot.
        let hip = Segment::still(
            at(0.12 * side, -0.02, 0.0),
            Vec3::ZERO,
            at(0.02 * side, -0.42, 0.0),
            thick * 0.8,
        );
        all.push(Segment {
            parent: Some(0),
            swing: 0.6,
            phase: phase + 0.5,
            ..hip
        });
        let knee = Segment::still(
            at(0.02 * side, -0.44, 0.0),
            Vec3::ZERO,
            at(0.0, -0.38, -0.02),
            thick * 0.65,
        );
        all.push(Segment {
            parent: Some(all.len() - 1),
            swing: 0.4,
            phase: phase + 0.6,
            ..knee
        });
        let ankle = Segment::still(
            at(0.0, -0.42, 0.0),
            Vec3::ZERO,
            at(0.0, -0.02, 0.16),
            thick * 0.5,
        );
        all.push(Segment {
            parent: Some(all.len() - 1),
            swing: 0.2,
            phase,
            ..ankle
        });
    }
    all
}

/// A dinosaur with a long neck and tail, four metres from head to tail, walking towards +Z.
pub fn dinosaur() -> Vec<Segment> {
    let at = Vec3::new;
    let mut all = vec![Segment {
        axis: Vec3::Z,
        swing: 0.06,
        ..Segment::still(
            at(0.0, 1.3, 0.0),
            at(0.0, 0.0, -0.6),
            at(0.0, 0.05, 0.6),
            0.5,
        )
    }];
    // Neck and tail: chains that thin out.
    for (start, step, first) in [
        (at(0.0, 0.15, 0.8), at(0.0, 0.38, 0.28), 0.28),
        (at(0.0, -0.05, -0.9), at(0.0, -0.06, -0.5), 0.3),
    ] {
        let mut parent = 0;
        let mut joint = start;
        for link in 0..4 {
            let radius = first * 0.8_f32.powi(link);
            all.push(Segment {
                parent: Some(parent),
                axis: Vec3::Y,
                swing: 0.2,
                phase: 0.12 * link as f32,
                ..Segment::still(joint, Vec3::ZERO, step, radius)
            });
            parent = all.len() - 1;
            joint = step;
        }
    }
    for (x, z, phase) in [
        (-0.35, 0.5, 0.0),
        (0.35, 0.5, 0.5),
        (-0.35, -0.5, 0.5),
        (0.35, -0.5, 0.0),
    ] {
        all.push(Segment {
            parent: Some(0),
            swing: 0.4,
            phase,
            ..Segment::still(at(x, -0.3, z), Vec3::ZERO, at(0.0, -0.45, 0.0), 0.22)
        });
        all.push(Segment {
            parent: Some(all.len() - 1),
            swing: 0.3,
            phase: phase + 0.1,
            ..Segment::still(at(0.0, -0.5, 0.0), Vec3::ZERO, at(0.0, -0.38, 0.02), 0.17)
        });
    }
    all
}

/// A squirrel that sits on its feet at the origin, a metre from nose to tail, looking towards +X.
pub fn squirrel() -> Vec<Segment> {
    let at = Vec3::new;
    let mut all = vec![
        Segment {
            axis: Vec3::Z,
            swing: 0.08,
            ..Segment::still(
                at(0.0, 0.45, 0.0),
                at(-0.12, -0.05, 0.0),
                at(0.12, 0.15, 0.0),
                0.24,
            )
        },
        Segment {
            parent: Some(0),
            axis: Vec3::Y,
            swing: 0.4,
            ..Segment::ball(at(0.25, 0.3, 0.0), at(0.05, 0.08, 0.0), 0.18)
        },
    ];
    // A tail that stands up.
    for (i, (joint, step)) in [
        (at(-0.25, -0.1, 0.0), at(-0.2, 0.15, 0.0)),
        (at(-0.24, 0.2, 0.0), at(-0.02, 0.25, 0.0)),
        (at(-0.02, 0.32, 0.0), at(0.1, 0.14, 0.0)),
    ]
    .into_iter()
    .enumerate()
    {
        all.push(Segment {
            parent: Some(if i == 0 { 0 } else { all.len() - 1 }),
            axis: Vec3::X,
            swing: 0.25,
            phase: 0.15 * i as f32,
            ..Segment::still(joint, Vec3::ZERO, step, 0.13 + 0.02 * i as f32)
        });
    }
    for (x, z, phase) in [
        (-0.15, -0.16, 0.0),
        (-0.15, 0.16, 0.5),
        (0.22, -0.13, 0.5),
        (0.22, 0.13, 0.0),
    ] {
        all.push(Segment {
            parent: Some(0),
            axis: Vec3::Z,
            swing: 0.35,
            phase,
            ..Segment::still(at(x, -0.12, z), Vec3::ZERO, at(0.05, -0.2, 0.0), 0.08)
        });
    }
    all
}
