//! Which of two spheres hides the other, for all receivers of a cluster.

use crate::device::emission::Emission;
use crate::device::light_cut::{ALWAYS, Met, NEVER};
use glam::Vec3;
use sh_scene::Forest;
use sh_scene::order::{Ball, SHARPEST, swap_slope, swap_width};

/// Whether two are spheres of one body that intersect.
pub(super) fn joint(pair: [&Met; 2], lights: &Emission) -> bool {
    let [a, b] = pair.map(|met| lights.body(met.node));
    let [p, q] = pair.map(|met| met.blocker);
    let reach = p.radius + q.radius;
    a == b && a.is_some() && Vec3::from(p.center).distance_squared(q.center.into()) < reach * reach
}

/// What the nearer of a pair hides of the other, and the other of it, for receivers within `radius`.
pub(super) fn by_spheres([near, far]: [&Met; 2], radius: f32) -> [f32; 2] {
    let centers = [near, far].map(|met| Vec3::from(met.blocker.center));
    let [a, b] = [near.blocker.radius, far.blocker.radius];
    // Twice the distance of the cluster's centre from the plane of equal power, times that of the centres.
    let difference = far.power - near.power;
    let smaller = a.min(b);
    let square = centers[0].distance_squared(centers[1]);
    // Most pairs are far apart, and need no root.
    let reach = 2.0 * (radius + SHARPEST * smaller);
    if square >= (a + b) * (a + b) && difference * difference >= square * reach * reach {
        return [ALWAYS, NEVER];
    }
    let distance = square.sqrt();
    let width = swap_width(a, b, distance);
    if difference >= 2.0 * distance * (radius + width) {
        return [ALWAYS, NEVER];
    }
    [swap_slope(width, distance); 2]
}

/// The same by the power of whole bodies: the nearer body hides all of the other.
pub(super) fn by_bodies(
    [near, far]: [&Met; 2],
    center: Vec3,
    forest: &Forest,
    lights: &Emission,
) -> [f32; 2] {
    let [a, b] = [near, far].map(|met| lights.body(met.node));
    let (Some(a), Some(b)) = (a, b) else {
        return [ALWAYS, NEVER];
    };
    if a == b {
        let joint = joint([near, far], lights);
        return if joint { [NEVER; 2] } else { [ALWAYS, NEVER] };
    }
    let whole = |body: u32| {
        let node = &forest.nodes()[lights.root(body) as usize];
        (Ball::new(node.center, node.radius).power(center), body)
    };
    let (first, second) = (whole(a), whole(b));
    let in_order = first.0 < second.0 || first.0 == second.0 && first.1 < second.1;
    if in_order {
        [ALWAYS, NEVER]
    } else {
        [NEVER, ALWAYS]
    }
}
