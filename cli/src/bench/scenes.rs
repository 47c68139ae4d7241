//! The two scenes of Ren et al. 2006, section 9, at their scale: a battle of two characters, and dinosaurs. Bodies are
//! made by code; receivers, leaf spheres and clusters are as many as in the paper.

use super::body::{Body, Segment};
use glam::Vec3;

/// Which scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// Two characters between columns.
    Battle,
    /// A herd on a plain.
    Dino,
}

impl Name {
    /// The name that commands use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Battle => "battle",
            Self::Dino => "dino",
        }
    }
}

/// A floor and what stands and walks on it.
pub struct Plan {
    /// All bodies.
    pub bodies: Vec<Body>,
    /// Receivers of the floor along one side; they are its square.
    pub floor_side: usize,
    /// Metres along a side of the floor.
    pub floor_size: f32,
    /// Clusters of the floor.
    pub floor_clusters: usize,
}

/// A scene's bodies.
pub fn plan(name: Name) -> Plan {
    match name {
        Name::Battle => battle(),
        Name::Dino => dino(),
    }
}

fn battle() -> Plan {
    let mut bodies = vec![
        Body {
            segments: character(1.5, 0.26),
            receivers: 11_000,
            spheres: 100,
            clusters: 8,
            place: Vec3::new(-1.2, 0.0, 0.0),
            circle: 0.8,
            pace: 0.8,
        },
        Body {
            segments: character(1.0, 0.16),
            receivers: 10_000,
            spheres: 74,
            clusters: 8,
            place: Vec3::new(1.6, 0.0, 0.4),
            circle: 0.6,
            pace: 1.1,
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
            circle: 0.4,
            pace: 0.9,
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
            circle: 0.0,
            pace: 0.0,
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
        circle: 0.0,
        pace: 0.0,
    });
    // 24,000 + 8,800 + 180² = 65,200.
    Plan {
        bodies,
        floor_side: 180,
        floor_size: 14.0,
        floor_clusters: 95,
    }
}

fn dino() -> Plan {
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
        circle: 1.5,
        pace: 0.5 + 0.07 * i as f32,
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
            circle: 0.0,
            pace: 0.0,
        });
    }
    // 60,000 + 10,000 + 224² = 120,176.
    Plan {
        bodies,
        floor_side: 224,
        floor_size: 26.0,
        floor_clusters: 116,
    }
}

/// A figure of so many times a person's size, with limbs of a thickness in metres, walking towards +Z.
pub(super) fn character(size: f32, thick: f32) -> Vec<Segment> {
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
fn dinosaur() -> Vec<Segment> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_of_the_paper_s_scale() {
        let count = |name| {
            let plan = plan(name);
            let bodies = &plan.bodies;
            let moving = bodies
                .iter()
                .filter(|b| b.pace > 0.0)
                .map(|b| b.receivers)
                .sum::<usize>();
            let receivers =
                bodies.iter().map(|b| b.receivers).sum::<usize>() + plan.floor_side.pow(2);
            let spheres = bodies.iter().map(|b| b.spheres).sum::<usize>();
            let clusters = bodies.iter().map(|b| b.clusters).sum::<usize>() + plan.floor_clusters;
            (receivers, moving, spheres, clusters)
        };
        let (receivers, moving, spheres, clusters) = count(Name::Battle);
        assert_eq!(
            (receivers / 1000, moving, spheres, clusters),
            (65, 24_000, 244, 120)
        );
        let (receivers, _, spheres, clusters) = count(Name::Dino);
        assert_eq!((receivers / 1000, spheres, clusters), (120, 500, 256));
    }
}
