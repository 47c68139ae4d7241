//! Scenes at the scale of the papers: bodies are made by code; receivers, leaf spheres and clusters are as many as there.

pub mod figures;
mod sending;
mod shadows;

use super::body::Body;
use glam::Vec3;
use sh_scene::{Indirect, Receiver};

/// Which scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Name {
    /// Two characters between columns.
    Battle,
    /// A herd on a plain.
    Dino,
    /// A squirrel and balls that slide down a ramp.
    Squirrel,
    /// A robot.
    Robot,
    /// Two packages that deform.
    Packages,
    /// What moves in a plant.
    Assembly,
}

impl Name {
    /// All of them.
    #[cfg(test)]
    const ALL: [Self; 6] = [
        Self::Battle,
        Self::Dino,
        Self::Squirrel,
        Self::Robot,
        Self::Packages,
        Self::Assembly,
    ];

    /// The name that commands use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Battle => "battle",
            Self::Dino => "dino",
            Self::Squirrel => "squirrel",
            Self::Robot => "robot",
            Self::Packages => "packages",
            Self::Assembly => "assembly",
        }
    }
}

/// What stands and walks around, and what it is lit by.
pub struct Plan {
    /// All bodies: they cast shadows, and send light on where that is asked for.
    pub bodies: Vec<Body>,
    /// Ground and walls: these receive alone.
    pub faces: Vec<Face>,
    /// Lights that circle above, beside the sky.
    pub lamps: Vec<Lamp>,
    /// How bodies light each other and the ground.
    pub indirect: Option<Indirect>,
}

/// A rectangle of receivers.
#[derive(Clone, Copy, Debug)]
pub struct Face {
    /// Its middle, in metres.
    pub middle: Vec3,
    /// One side, in metres.
    pub across: Vec3,
    /// The other; its normal is `along` × `across`.
    pub along: Vec3,
    /// Receivers along both.
    pub counts: [usize; 2],
    /// Clusters of them.
    pub clusters: usize,
}

impl Face {
    /// A floor about the origin, `size` metres wide.
    fn floor(size: f32, side: usize, clusters: usize) -> Self {
        Self {
            middle: Vec3::ZERO,
            across: Vec3::X * size,
            along: Vec3::Z * size,
            counts: [side; 2],
            clusters,
        }
    }

    /// Its receivers.
    pub fn receivers(&self) -> Vec<Receiver> {
        let [side, rows] = self.counts;
        let normal = self.along.cross(self.across).normalize();
        let at = |i: usize, count: usize| (i as f32 + 0.5) / count as f32 - 0.5;
        (0..side * rows)
            .map(|i| Receiver {
                position: (self.middle
                    + self.across * at(i % side, side)
                    + self.along * at(i / side, rows))
                .into(),
                covered: 1,
                normal: normal.into(),
                object: 0,
            })
            .collect()
    }
}

/// A ball that shines.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Radiance of its surface.
    pub radiance: [f32; 3],
    /// Metres.
    pub radius: f32,
    /// The angle from straight down within which it glows; none: all over.
    pub spread: Option<f32>,
}

/// What a scene is made of.
pub fn plan(name: Name) -> Plan {
    match name {
        Name::Battle => shadows::battle(),
        Name::Dino => shadows::dino(),
        Name::Squirrel => sending::squirrel(),
        Name::Robot => sending::robot(),
        Name::Packages => sending::packages(),
        Name::Assembly => sending::assembly(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_of_the_papers_scale() {
        // Receivers, moving ones, spheres, clusters, lamps.
        let expected = [
            [65_200, 24_000, 244, 120, 2],
            [120_176, 60_000, 500, 256, 2],
            [21_000, 13_000, 14, 25, 0],
            [25_000, 15_000, 26, 68, 0],
            [10_000, 6_000, 16, 18, 0],
            [21_000, 13_000, 38, 40, 1],
        ];
        for (name, expected) in Name::ALL.into_iter().zip(expected) {
            let plan = plan(name);
            let bodies = &plan.bodies;
            let sum = |of: fn(&Body) -> usize| bodies.iter().map(of).sum::<usize>();
            let faces = plan.faces.iter().map(|face| face.clusters).sum::<usize>();
            let found = [
                sum(|b| b.receivers)
                    + plan
                        .faces
                        .iter()
                        .map(|f| f.counts[0] * f.counts[1])
                        .sum::<usize>(),
                sum(|b| if b.pace > 0.0 { b.receivers } else { 0 }),
                sum(|b| b.spheres),
                sum(|b| b.clusters) + faces,
                plan.lamps.len(),
            ];
            assert_eq!(found, expected, "{name:?}");
        }
    }

    #[test]
    fn receivers_of_a_floor_look_up() {
        let on = Face::floor(2.0, 4, 1).receivers();
        assert_eq!(on.len(), 16);
        assert!(on.iter().all(|r| r.normal == [0.0, 1.0, 0.0]));
        assert_eq!(on[0].position, [-0.75, 0.0, -0.75]);
        assert_eq!(on[1].position, [-0.25, 0.0, -0.75]);
    }
}
