//! Four scenes at the scale of Guerrero et al. 2008, section 8.5: bodies of few spheres that send light on, above ground
//! and walls that receive alone. Everything else is in motion.

use super::figures::{character, squirrel as animal};
use super::{Face, Lamp, Plan};
use crate::bench::body::{Body, Segment, Way};
use glam::Vec3;
use sh_scene::Indirect;

/// The slope of the squirrel's ramp, in radians.
const SLOPE: f32 = 0.35;

/// A squirrel and four balls slide down a ramp: 21,000 receivers, 14 spheres, 25 clusters.
pub fn squirrel() -> Plan {
    let (sin, cos) = SLOPE.sin_cos();
    let (down, up) = (Vec3::new(cos, -sin, 0.0), Vec3::new(sin, cos, 0.0));
    let top = down * -4.0 + Vec3::Y * 1.6;
    let slide = |start| Way::Line {
        along: down * 7.0,
        start,
    };
    let mut bodies = vec![Body {
        segments: animal(),
        receivers: 9_000,
        spheres: 10,
        clusters: 6,
        place: top + up * 0.05,
        way: slide(0.3),
        pace: 1.0,
        albedo: [0.6, 0.3, 0.12],
    }];
    let colors = [
        [0.8, 0.1, 0.1],
        [0.1, 0.6, 0.2],
        [0.15, 0.25, 0.8],
        [0.8, 0.7, 0.1],
    ];
    for ((i, albedo), z) in colors.into_iter().enumerate().zip([-1.1, 0.9, -0.7, 1.2]) {
        let radius = 0.25 + 0.05 * i as f32;
        bodies.push(Body {
            segments: vec![Segment::ball(Vec3::ZERO, Vec3::ZERO, radius)],
            receivers: 1_000,
            spheres: 1,
            clusters: 1,
            place: top + up * (radius + 0.02) + Vec3::Z * z,
            way: slide(0.25 * i as f32),
            pace: 1.2 + 0.15 * i as f32,
            albedo,
        });
    }
    let ramp = Face {
        middle: Vec3::Y * 1.6,
        across: down * 8.0,
        along: Vec3::Z * 4.0,
        counts: [80, 50],
        clusters: 8,
    };
    let ground = Face {
        middle: Vec3::new(0.0, -0.3, 0.0),
        across: Vec3::X * 12.0,
        along: Vec3::Z * 8.0,
        counts: [80, 50],
        clusters: 7,
    };
    Plan {
        bodies,
        faces: vec![ramp, ground],
        lamps: Vec::new(),
        indirect: Some(Indirect::default()),
    }
}

/// A robot walks in a circle: 25,000 receivers, 26 spheres, 68 clusters.
pub fn robot() -> Plan {
    let robot = Body {
        segments: character(1.0, 0.15),
        receivers: 15_000,
        spheres: 26,
        clusters: 40,
        place: Vec3::ZERO,
        way: Way::Circle(0.8),
        pace: 0.9,
        albedo: [0.7, 0.45, 0.2],
    };
    Plan {
        bodies: vec![robot],
        faces: vec![Face::floor(6.0, 100, 28)],
        lamps: Vec::new(),
        indirect: Some(Indirect::default()),
    }
}

/// Eight balls about a middle, each on a joint there: what they make together changes its shape.
fn package(size: f32) -> Vec<Segment> {
    let corners = (0..8).map(|i| Vec3::from([0, 1, 2].map(|k| ((i >> k & 1) * 2 - 1) as f32)));
    let ball = |(i, corner): (usize, Vec3)| Segment {
        axis: corner.any_orthogonal_vector(),
        swing: 0.25,
        phase: 0.13 * i as f32,
        ..Segment::ball(Vec3::ZERO, corner * 0.4 * size, 0.55 * size)
    };
    corners.enumerate().map(ball).collect()
}

/// Two packages of jelly beans that deform beside each other: 10,000 receivers, 16 spheres, 18 clusters.
pub fn packages() -> Plan {
    let package = |x, albedo| Body {
        segments: package(0.6),
        receivers: 3_000,
        spheres: 8,
        clusters: 4,
        place: Vec3::new(x, 0.75, 0.0),
        way: Way::Circle(0.15),
        pace: 1.0,
        albedo,
    };
    let ground = Face {
        middle: Vec3::ZERO,
        across: Vec3::X * 6.0,
        along: Vec3::Z * 4.0,
        counts: [80, 50],
        clusters: 10,
    };
    Plan {
        bodies: vec![
            package(-0.8, [0.8, 0.15, 0.1]),
            package(0.8, [0.1, 0.3, 0.8]),
        ],
        faces: vec![ground],
        lamps: Vec::new(),
        indirect: Some(Indirect::default()),
    }
}

/// An arm on a foot that reaches out, as machines have it.
fn arm() -> Vec<Segment> {
    let up = |length: f32| Vec3::Y * length;
    let mut all = vec![Segment {
        axis: Vec3::Y,
        swing: 0.6,
        ..Segment::still(Vec3::ZERO, up(0.25), up(0.9), 0.22)
    }];
    for (i, (length, radius)) in [(0.7, 0.16), (0.6, 0.13), (0.2, 0.16)]
        .into_iter()
        .enumerate()
    {
        all.push(Segment {
            parent: Some(i),
            axis: Vec3::Z,
            swing: 0.7,
            phase: 0.2 * i as f32,
            ..Segment::still(
                up([1.1, 0.85, 0.75][i]),
                Vec3::ZERO,
                Vec3::new(0.25, length, 0.0),
                radius,
            )
        });
    }
    all
}

/// Arms, packages and beans of a plant, and a hopper that shakes: 21,000 receivers, 38 spheres and a lamp, 40 clusters.
pub fn assembly() -> Plan {
    let mut bodies = Vec::new();
    for (x, albedo) in [(-1.6, [0.8, 0.5, 0.1]), (1.6, [0.3, 0.35, 0.4])] {
        bodies.push(Body {
            segments: arm(),
            receivers: 2_500,
            spheres: 6,
            clusters: 5,
            place: Vec3::new(x, 0.0, -1.0),
            way: Way::Stands,
            pace: 0.6,
            albedo,
        });
    }
    let belt = |start| Way::Line {
        along: Vec3::X * 6.0,
        start,
    };
    for i in 0..3 {
        let mut four = package(0.4);
        four.truncate(4);
        bodies.push(Body {
            segments: four,
            receivers: 1_500,
            spheres: 4,
            clusters: 2,
            place: Vec3::new(-3.0, 0.6, 0.2),
            way: belt(0.33 * i as f32),
            pace: 0.8,
            albedo: [0.75, 0.2, 0.3],
        });
    }
    let colors = [
        [0.8, 0.1, 0.1],
        [0.1, 0.6, 0.2],
        [0.15, 0.25, 0.8],
        [0.8, 0.7, 0.1],
        [0.6, 0.2, 0.6],
    ];
    for (i, albedo) in colors.into_iter().enumerate() {
        let bean = Segment::still(Vec3::ZERO, Vec3::X * -0.1, Vec3::X * 0.1, 0.12);
        bodies.push(Body {
            segments: vec![Segment {
                axis: Vec3::Z,
                swing: 1.0,
                ..bean
            }],
            receivers: 500,
            spheres: 2,
            clusters: 1,
            place: Vec3::new(-3.0, 0.3, 1.2),
            way: belt(0.2 * i as f32),
            pace: 1.1,
            albedo,
        });
    }
    let corners = [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)];
    let hopper = corners.map(|(x, z)| Segment {
        axis: Vec3::new(x, 0.0, z),
        swing: 0.3,
        ..Segment::ball(Vec3::ZERO, Vec3::new(x, 0.0, z) * 0.4, 0.4)
    });
    bodies.push(Body {
        segments: hopper.to_vec(),
        receivers: 1_000,
        spheres: 4,
        clusters: 2,
        place: Vec3::new(0.0, 2.2, 0.0),
        way: Way::Stands,
        pace: 2.0,
        albedo: [0.5; 3],
    });
    let ground = Face {
        middle: Vec3::ZERO,
        across: Vec3::X * 8.0,
        along: Vec3::Z * 6.0,
        counts: [80, 60],
        clusters: 10,
    };
    let wall = Face {
        middle: Vec3::new(0.0, 2.0, -2.5),
        across: Vec3::X * 8.0,
        along: Vec3::NEG_Y * 4.0,
        counts: [80, 40],
        clusters: 7,
    };
    Plan {
        bodies,
        faces: vec![ground, wall],
        lamps: vec![Lamp {
            radiance: [60.0, 50.0, 38.0],
            radius: 0.3,
            spread: Some(1.8),
        }],
        indirect: Some(Indirect::default()),
    }
}
