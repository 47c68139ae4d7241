//! The `points` pass: points of surfaces as receivers where their bodies are now, those of each sphere, or of each region of
//! a body, a cluster.

use crate::device::spherical_lights::Points;
use glam::Vec3;
use sh_scene::basis::REGION_PATCHES;
use sh_scene::{BasisBody, Body, Receiver};

/// Puts all points where they are now; nothing has been sent to them yet.
pub(crate) fn place<'a>(bodies: impl IntoIterator<Item = Body<'a>>, points: &mut Points) {
    points.receivers.clear();
    points.clusters.clear();
    for (object, body) in (1..).zip(bodies) {
        let turn = body.turn();
        for sphere in 0..body.spheres {
            let first = points.receivers.len();
            let own = body.surface.of(sphere).iter().map(|point| Receiver {
                position: body
                    .transform
                    .transform_point3(point.position.into())
                    .into(),
                covered: 1,
                normal: (turn * Vec3::from(point.normal)).into(),
                object,
            });
            points.receivers.extend(own);
            points.clusters.push(first..points.receivers.len());
        }
    }
    points.sent.clear();
    points.sent.resize(points.receivers.len(), [0.0; 3]);
}

/// The same of patches' points.
pub(crate) fn place_patches<'a>(bodies: impl Iterator<Item = BasisBody<'a>>, points: &mut Points) {
    points.receivers.clear();
    points.clusters.clear();
    for body in bodies {
        let (turn, _) = body.placed();
        let own = body.basis.points().map(|point| Receiver {
            position: body
                .transform
                .transform_point3(point.position.into())
                .into(),
            covered: 1,
            normal: (turn * Vec3::from(point.normal)).into(),
            object: body.object,
        });
        points.receivers.extend(own);
    }
    let regions = (0..points.receivers.len()).step_by(REGION_PATCHES);
    points
        .clusters
        .extend(regions.map(|first| first..first + REGION_PATCHES));
    points.sent.clear();
    points.sent.resize(points.receivers.len(), [0.0; 3]);
}
