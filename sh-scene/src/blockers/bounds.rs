//! Where a cluster of receivers is, and which way it faces.

use crate::Receiver;
use glam::Vec3;

/// A ball around the covered receivers of a cluster, and a cone around their normals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Centre of the box around the receivers: p* and p_R of Ren et al. 2006, section 6.3.
    pub center: Vec3,
    /// The largest distance of a receiver from there.
    pub radius: f32,
    /// The cone's axis, a unit vector.
    pub axis: Vec3,
    /// The largest distance of a receiver from the plane through the centre across the axis.
    pub rise: f32,
    /// Cosine and sine of the largest angle between the axis and a normal; (-1, 0) where normals point everywhere.
    pub cone: [f32; 2],
}

/// How far a blocker reaches over the tangent planes of a cluster's receivers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Wholly in front of all of them: it counts as it is.
    Front,
    /// Wholly behind all of them: it does not count.
    Behind,
    /// In front of some, behind some, or across: each receiver has to look for itself.
    Across,
}

impl Bounds {
    /// Those of the covered receivers, or none where nothing is covered.
    ///
    /// ```
    /// use sh_scene::{Bounds, Receiver};
    /// let at = |x: f32| Receiver { position: [x, 0.0, 0.0], covered: 1, normal: [0.0, 1.0, 0.0], object: 0 };
    /// let bounds = Bounds::of(&[at(1.0), at(3.0)]).unwrap();
    /// assert_eq!((bounds.center.x, bounds.radius), (2.0, 1.0));
    /// assert_eq!(bounds.cone, [1.0, 0.0]);
    /// ```
    pub fn of(receivers: &[Receiver]) -> Option<Self> {
        let mut low = Vec3::INFINITY;
        let mut high = Vec3::NEG_INFINITY;
        let mut sum = Vec3::ZERO;
        let covered = || receivers.iter().filter(|receiver| receiver.covered != 0);
        for receiver in covered() {
            let p = Vec3::from(receiver.position);
            low = low.min(p);
            high = high.max(p);
            sum += Vec3::from(receiver.normal);
        }
        if low.x > high.x {
            return None;
        }
        let center = low + (high - low) * 0.5;
        let axis = sum.normalize_or(Vec3::Y);
        let (mut radius, mut rise, mut cosine) = (0.0_f32, 0.0_f32, 1.0_f32);
        for receiver in covered() {
            let from = Vec3::from(receiver.position) - center;
            radius = radius.max(from.length_squared());
            rise = rise.max(from.dot(axis).abs());
            cosine = cosine.min(Vec3::from(receiver.normal).dot(axis));
        }
        // A normal that is the axis but for rounding must not open the cone.
        let cone = if cosine > 1.0 - 1e-6 {
            [1.0, 0.0]
        } else if cosine > -1.0 + 1e-6 {
            [cosine, (1.0 - cosine * cosine).sqrt()]
        } else {
            [-1.0, 0.0]
        };
        Some(Self {
            center,
            radius: radius.sqrt(),
            axis,
            rise,
            cone,
        })
    }

    /// Where a sphere lies over the tangent planes of all receivers that these bounds hold; [`Side::Across`] where
    /// it cannot be told.
    pub fn side(&self, center: Vec3, radius: f32) -> Side {
        let towards = center - self.center;
        let along = towards.dot(self.axis);
        let across = (towards.length_squared() - along * along).max(0.0).sqrt();
        let [cos, sin] = self.cone;
        // The lowest and the highest height over a plane whose normal is in the cone: cos(γ ± α) times the
        // distance, and the distance itself where the cone holds the direction.
        let distance = towards.length();
        let low = if along <= -cos * distance {
            -distance
        } else {
            along * cos - across * sin
        };
        let high = if along >= cos * distance {
            distance
        } else {
            along * cos + across * sin
        };
        // How far a receiver's plane may lie from one through the centre, and what rounding may have moved it by.
        let apart = if cos > 0.0 {
            self.radius.min(self.rise + self.radius * sin)
        } else {
            self.radius
        };
        let slack = apart + 1e-5 * (distance + radius);
        if low - slack >= radius {
            Side::Front
        } else if high + slack <= -radius {
            Side::Behind
        } else {
            Side::Across
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn receivers(spread: f32) -> Vec<Receiver> {
        (0..200)
            .map(|i| {
                let t = i as f32;
                let lean = Vec3::new((1.7 * t).sin(), 0.0, (2.3 * t).cos()) * spread;
                Receiver {
                    position: [(0.9 * t).sin(), 0.3 * (0.4 * t).cos(), (1.3 * t).sin()],
                    covered: u32::from(i % 7 != 3),
                    normal: (Vec3::Y + lean).normalize().to_array(),
                    object: 0,
                }
            })
            .collect()
    }

    #[test]
    fn a_side_holds_for_every_receiver() {
        let mut seen = [0; 3];
        for spread in [0.0, 0.2, 1.0, 5.0] {
            let receivers = receivers(spread);
            let bounds = Bounds::of(&receivers).unwrap();
            for i in 0..4000 {
                let t = i as f32;
                let center = Vec3::new((0.37 * t).sin(), (0.71 * t).cos(), (1.1 * t).sin())
                    * (0.01 * t % 9.0);
                let radius = 0.02 + (0.013 * t) % 1.5;
                let heights = receivers
                    .iter()
                    .filter(|r| r.covered != 0)
                    .map(|r| (center - Vec3::from(r.position)).dot(Vec3::from(r.normal)));
                let side = bounds.side(center, radius);
                seen[side as usize] += 1;
                for height in heights {
                    match side {
                        Side::Front => assert!(height >= radius),
                        Side::Behind => assert!(height <= -radius),
                        Side::Across => {}
                    }
                }
            }
        }
        assert!(seen.iter().all(|&n| n > 500), "{seen:?}");
    }

    #[test]
    fn over_a_plane_only_spheres_that_cut_it_or_nearly_do_are_across() {
        let bounds = Bounds::of(&receivers(0.0)).unwrap();
        // Receivers lie within 0.3 m of the plane, and within 1.4 m of the centre.
        assert_eq!(bounds.side(Vec3::Y * 1.9, 1.5), Side::Front);
        assert_eq!(bounds.side(Vec3::new(40.0, 1.9, 0.0), 1.5), Side::Front);
        assert_eq!(bounds.side(Vec3::Y * -1.9, 1.5), Side::Behind);
        assert_eq!(bounds.side(Vec3::Y, 1.5), Side::Across);
    }

    #[test]
    fn nothing_covered_has_no_bounds() {
        let mut all = receivers(0.1);
        all.iter_mut().for_each(|r| r.covered = 0);
        assert_eq!(Bounds::of(&all), None);
        assert_eq!(Bounds::of(&[]), None);
    }
}
