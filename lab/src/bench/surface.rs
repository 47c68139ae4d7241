//! Samples of the surface around a body's spheres, for bodies of capsules: by the rules that meshes are sampled by
//! (Guerrero et al. 2008, section 4.2), in closed form.

use super::body::{Body, Parts, placed_sphere};
use super::capsule::Capsule;
use glam::{Affine3A, Quat, Vec3};
use sh_scene::Sphere;
use sh_scene::surface::{SurfacePoint, SurfaceSamples, directions};

/// How far inside another capsule a point of the surface may lie, in metres.
const DEPTH: f32 = 1e-4;

/// A body's surface, sampled once, and where it is now.
#[derive(Clone, Debug)]
pub struct Surface {
    /// In world space, in the frame that [`Surface::pose`] was called for.
    pub now: SurfaceSamples,
    /// How many segments the body has.
    pub segments: usize,
    /// In the segments' spaces: the segment of each sphere, and its points.
    rest: Vec<(usize, Vec<SurfacePoint>)>,
}

impl Surface {
    /// Samples a body whose segments are at `poses`; `parts` are its own.
    pub fn new(body: &Body, parts: &Parts, poses: &[Affine3A]) -> Self {
        let capsules = body.capsules(poses);
        let on = |(segment, sphere): &(usize, Sphere)| placed_sphere(sphere, &poses[*segment]);
        let spheres: Vec<Sphere> = parts.spheres.iter().map(on).collect();
        let mut now = SurfaceSamples::default();
        let mut rest = Vec::new();
        for (sphere, (segment, _)) in parts.spheres.iter().enumerate() {
            let pose = poses[*segment];
            let back = pose.inverse();
            let mut points = Vec::new();
            for (index, direction) in directions().iter().enumerate() {
                let towards = pose.transform_vector3(Vec3::from(*direction)).normalize();
                if let Some((point, normal)) = seen(&capsules, &spheres, sphere, towards) {
                    points.push(SurfacePoint {
                        position: back.transform_point3(point).into(),
                        direction: index as u32,
                        normal: back.transform_vector3(normal).normalize().into(),
                        albedo: body.albedo,
                        ..SurfacePoint::default()
                    });
                }
            }
            now.push(points.iter().copied());
            rest.push((*segment, points));
        }
        now.expose(&spheres);
        let mut surface = Self {
            now,
            segments: body.segments.len(),
            rest,
        };
        surface.pose(poses);
        surface
    }

    /// Moves it to where the segments are.
    pub fn pose(&mut self, poses: &[Affine3A]) {
        let mut now = self.now.points.iter_mut();
        for ((segment, points), rotation) in self.rest.iter().zip(&mut self.now.rotations) {
            let pose = &poses[*segment];
            *rotation = Quat::from_mat3a(&pose.matrix3).normalize().to_array();
            for (rest, now) in points.iter().zip(&mut now) {
                now.position = pose.transform_point3(rest.position.into()).into();
                now.normal = pose.transform_vector3(rest.normal.into()).into();
            }
        }
    }
}

/// The farthest place ahead of a sphere's centre where the line leaves the body and that belongs to the sphere, and the
/// normal there. Bodies are filled capsules around their spheres' centres, so there is none to be found behind.
fn seen(
    capsules: &[Capsule],
    spheres: &[Sphere],
    sphere: usize,
    towards: Vec3,
) -> Option<(Vec3, Vec3)> {
    let center = Vec3::from(spheres[sphere].center);
    let relative = |p: Vec3, s: &Sphere| p.distance(s.center.into()) / s.radius;
    let mut farthest: Option<(f32, Vec3, Vec3)> = None;
    for (i, capsule) in capsules.iter().enumerate() {
        let Some(t) = capsule.leaves(center, towards).filter(|t| *t > 0.0) else {
            continue;
        };
        let point = center + towards * t;
        let mut others = capsules.iter().enumerate();
        let inside = others.any(|(k, other)| k != i && other.distance(point) < -DEPTH);
        let own = relative(point, &spheres[sphere]);
        let theirs = spheres.iter().any(|s| relative(point, s) < own);
        if !inside && !theirs && farthest.is_none_or(|(most, ..)| most < t) {
            let normal = (point - capsule.nearest(point)) / capsule.radius;
            farthest = Some((t, point, normal));
        }
    }
    farthest.map(|(_, point, normal)| (point, normal))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::scenes::{Name, plan};
    use sh_scene::surface::DIRECTIONS;

    fn sampled(body: &Body, seconds: f32) -> (Surface, Vec<Affine3A>) {
        let mut poses = Vec::new();
        body.pose(0.0, &mut poses);
        let mut surface = Surface::new(body, &body.parts(1), &poses);
        poses.clear();
        body.pose(seconds, &mut poses);
        surface.pose(&poses);
        (surface, poses)
    }

    #[test]
    fn a_ball_is_seen_from_everywhere() {
        let ball = &plan(Name::Squirrel).bodies[2];
        let (surface, poses) = sampled(ball, 0.4);
        assert_eq!(surface.now.points.len(), DIRECTIONS);
        let center = poses[0].transform_point3(ball.segments[0].from);
        for point in &surface.now.points {
            let away = Vec3::from(point.position) - center;
            assert!((away.length() - ball.segments[0].radius).abs() < 1e-5);
            assert!(away.normalize().dot(point.normal.into()) > 0.9999);
        }
    }

    #[test]
    fn points_lie_on_the_body() {
        for name in [Name::Squirrel, Name::Robot, Name::Packages, Name::Assembly] {
            for body in &plan(name).bodies {
                let (surface, poses) = sampled(body, 0.0);
                assert_eq!(surface.now.spheres(), body.spheres);
                let capsules = body.capsules(&poses);
                let on = |p: Vec3| capsules.iter().any(|c| c.distance(p).abs() < 1e-4);
                let points = &surface.now.points;
                assert!(points.len() > 10 * body.spheres, "{name:?}");
                assert!(points.iter().all(|p| on(p.position.into())));
            }
        }
    }
}
