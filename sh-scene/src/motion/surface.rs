//! Surface points that follow a skin by their spheres (Guerrero et al. 2008, section 7.1).
//!
//! A point moves with the average of what moves its sphere's surroundings: a rotation about the sphere's centre, and the
//! centre's own way. The bones' average at the sphere is the matrix M = Σ_b λ_b B_b with the weights λ_b of its anchors;
//! relative to where the points were sampled that is M M₀⁻¹, and the rotation is the nearest to it. So a frame costs one
//! small eigenvector a sphere and one rotation a point, and what a sphere emits keeps its shape: the frame of its
//! directions turns along ([`crate::SurfaceSamples::rotations`]).

use super::turn::rotation;
use super::{Anchor, Anchors};
use crate::{Object, Sphere, SurfaceSamples};
use glam::{Affine3A, DMat3, Vec3A};

/// The surface of a skinned body where it was sampled.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    /// Each point's way from its sphere's centre, and its normal.
    points: Vec<(Vec3A, Vec3A)>,
    spheres: Vec<Held>,
}

/// What holds a sphere's points.
#[derive(Clone, Copy, Debug)]
struct Held {
    /// Where its points end.
    end: usize,
    /// The inverse of its bones' average; none where that is flat or there are no bones, and nothing turns.
    back: Option<DMat3>,
}

impl Surface {
    /// The surface of an object, sampled with the bones as they are here.
    pub(super) fn new(object: &Object, anchors: &Anchors, bones: &[Affine3A]) -> Self {
        let mut all = Self {
            points: Vec::new(),
            spheres: Vec::new(),
        };
        for ((i, sphere), anchors) in object.spheres.iter().enumerate().zip(anchors.each()) {
            let center = Vec3A::from(sphere.center);
            let points = object.surface.of(i).iter();
            let points = points.map(|p| (Vec3A::from(p.position) - center, p.normal.into()));
            all.points.extend(points);
            let average = average(anchors, bones);
            let longest = [average.x_axis, average.y_axis, average.z_axis]
                .into_iter()
                .fold(0.0, |most: f64, axis| most.max(axis.length()));
            let back = average.inverse();
            let upright = average.determinant().abs() > 1e-6 * longest.powi(3) && back.is_finite();
            all.spheres.push(Held {
                end: all.points.len(),
                back: upright.then_some(back),
            });
        }
        all
    }

    /// Moves the points along with spheres that the bones have moved. Points and spheres that are not there are passed
    /// over.
    pub(super) fn pose(
        &self,
        anchors: &Anchors,
        bones: &[Affine3A],
        spheres: &[Sphere],
        surface: &mut SurfaceSamples,
    ) {
        let mut rest = self.points.iter();
        let mut points = surface.points.iter_mut();
        let (mut start, mut turns) = (0, surface.rotations.iter_mut());
        for ((held, anchors), sphere) in self.spheres.iter().zip(anchors.each()).zip(spheres) {
            let turn = held
                .back
                .map(|back| rotation(average(anchors, bones) * back));
            let turn = turn.unwrap_or_default().as_quat();
            let center = Vec3A::from(sphere.center);
            let count = held.end - start;
            start = held.end;
            for ((way, normal), point) in rest.by_ref().take(count).zip(&mut points) {
                point.position = (center + turn * *way).to_array();
                point.normal = (turn * *normal).normalize_or(*normal).to_array();
            }
            if let Some(rotation) = turns.next() {
                *rotation = turn.to_array();
            }
        }
    }
}

/// The weighted sum of the bones that hold a sphere.
fn average(anchors: &[Anchor], bones: &[Affine3A]) -> DMat3 {
    let mut sum = DMat3::ZERO;
    for anchor in anchors {
        let bone = bones[anchor.bone as usize].matrix3.as_dmat3();
        sum += bone * f64::from(anchor.weight);
    }
    sum
}
