//! The two scenes of Ren et al. 2006, section 9, at their scale: a battle of two characters, and dinosaurs.

use super::figures::{character, dinosaur};
use super::{Face, Lamp, Plan};
use crate::bench::body::{Body, Segment, Way};
use glam::Vec3;

/// Nothing is sent on here.
const GRAY: [f32; 3] = [0.5; 3];

fn lamps() -> Vec<Lamp> {
    let lamp = |radiance, radius| Lamp {
        radiance,
        radius,
        spread: None,
    };
    vec![lamp([60.0, 42.0, 24.0], 0.3), lamp([20.0, 30.0, 60.0], 0.4)]
}

/// Two characters between columns.
pub fn battle() -> Plan {
    let mut bodies = vec![
        Body {
            segments: character(1.5, 0.26),
            receivers: 11_000,
            spheres: 100,
            clusters: 8,
            place: Vec3::new(-1.2, 0.0, 0.0),
            way: Way::Circle(0.8),
            pace: 0.8,
            albedo: GRAY,
        },
        Body {
            segments: character(1.0, 0.16),
            receivers: 10_000,
            spheres: 74,
            clusters: 8,
            place: Vec3::new(1.6, 0.0, 0.4),
            way: Way::Circle(0.6),
            pace: 1.1,
            albedo: GRAY,
        },
        // A club that is swung by nobody.
        Body {
            segments: vec![Segment {
                swing: 1.1,
                ..Segment::still(Vec3::Y * 2.6, Vec3::Y * -0.2, Vec3::Y * -1.6, 0.2)
            }],
            receivers: 3_000,
            spheres: 10,
            clusters: 4,
            place: Vec3::new(0.3, 0.0, 1.2),
            way: Way::Circle(0.4),
            pace: 0.9,
            albedo: GRAY,
        },
    ];
    for (x, z) in [(-4.0, -4.0), (4.0, -4.0), (-4.0, 4.0), (4.0, 4.0)] {
        bodies.push(Body {
            segments: vec![Segment::still(
                Vec3::ZERO,
                Vec3::Y * 0.3,
                Vec3::Y * 4.0,
                0.35,
            )],
            receivers: 1_800,
            spheres: 10,
            clusters: 1,
            place: Vec3::new(x, 0.0, z),
            way: Way::Stands,
            pace: 0.0,
            albedo: GRAY,
        });
    }
    bodies.push(Body {
        segments: vec![
            Segment::still(
                Vec3::ZERO,
                Vec3::new(-0.5, 0.3, 0.0),
                Vec3::new(0.5, 0.5, 0.2),
                0.5,
            ),
            Segment::still(
                Vec3::ZERO,
                Vec3::new(0.0, 0.2, -0.4),
                Vec3::new(0.3, 0.3, 0.6),
                0.4,
            ),
        ],
        receivers: 1_600,
        spheres: 20,
        clusters: 1,
        place: Vec3::new(3.0, 0.0, 0.0),
        way: Way::Stands,
        pace: 0.0,
        albedo: GRAY,
    });
    // 24,000 + 8,800 + 180² = 65,200.
    Plan {
        bodies,
        faces: vec![Face::floor(14.0, 180, 95)],
        lamps: lamps(),
        indirect: None,
    }
}

/// A herd on a plain.
pub fn dino() -> Plan {
    let mut bodies: Vec<Body> = [
        (-5.0, -3.0),
        (4.0, -5.0),
        (0.0, 3.0),
        (6.0, 4.0),
        (-6.0, 5.0),
    ]
    .into_iter()
    .enumerate()
    .map(|(i, (x, z))| Body {
        segments: dinosaur(),
        receivers: 12_000,
        spheres: 90,
        clusters: 25,
        place: Vec3::new(x, 0.0, z),
        way: Way::Circle(1.5),
        pace: 0.5 + 0.07 * i as f32,
        albedo: GRAY,
    })
    .collect();
    for (x, z) in [
        (-9.0, 0.0),
        (9.0, 0.0),
        (0.0, -9.0),
        (2.0, 9.0),
        (-9.0, -9.0),
    ] {
        bodies.push(Body {
            segments: vec![
                Segment::still(Vec3::ZERO, Vec3::Y * 0.2, Vec3::Y * 3.0, 0.25),
                Segment::still(Vec3::ZERO, Vec3::Y * 3.4, Vec3::Y * 4.2, 1.0),
            ],
            receivers: 2_000,
            spheres: 10,
            clusters: 3,
            place: Vec3::new(x, 0.0, z),
            way: Way::Stands,
            pace: 0.0,
            albedo: GRAY,
        });
    }
    // 60,000 + 10,000 + 224² = 120,176.
    Plan {
        bodies,
        faces: vec![Face::floor(26.0, 224, 116)],
        lamps: lamps(),
        indirect: None,
    }
}
