//! The `points` pass: points of surfaces as receivers where their bodies are now, those of each sphere, or some of a
//! body's patches that lie together, a cluster.

use crate::device::spherical_lights::Points;
use glam::Vec3;
use sh_scene::basis::{PATCH_SAMPLES, REGION_PATCHES};
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

/// The same of patches' points: of all bodies those first that take light that bodies have sent.
pub(crate) fn place_patches<'a>(
    bodies: impl Iterator<Item = BasisBody<'a>> + Clone,
    points: &mut Points,
) {
    points.receivers.clear();
    points.clusters.clear();
    points.few = None;
    for rest in [false, true] {
        for body in bodies.clone() {
            let (turn, _) = body.placed();
            let few = body.basis.few();
            let own = match rest {
                false => 0..few,
                true => few..body.basis.patches(),
            };
            let first = points.receivers.len();
            let samples = body.basis.samples();
            let place = |patch: &usize| {
                let point = samples[patch * PATCH_SAMPLES];
                let position = body.transform.transform_point3(point.position.into());
                Receiver {
                    position: position.into(),
                    covered: 1,
                    normal: (turn * Vec3::from(point.normal)).into(),
                    object: body.object,
                }
            };
            let own = body.basis.order()[own].iter().map(place);
            points.receivers.extend(own);
            let end = points.receivers.len();
            let runs = (first..end).step_by(REGION_PATCHES);
            points
                .clusters
                .extend(runs.map(|first| first..end.min(first + REGION_PATCHES)));
        }
        points
            .few
            .get_or_insert([points.receivers.len(), points.clusters.len()]);
    }
    let few = points.few.map_or(0, |[receivers, _]| receivers);
    points.sent.clear();
    points.sent.resize(few, [0.0; 3]);
}
