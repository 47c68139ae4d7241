//! What is so for all receivers of a cluster, and need not be asked of each.
//!
//! What of a lamp is above a receiver's horizon is known in closed form (`emitters`), and nothing is where it lies wholly
//! below: the shadow pass gives exactly 0, whatever blocks it, and it needs no computing.

use glam::Vec3;
use sh_scene::{Bounds, Emitter, Node, Side};

/// Whether a lamp gives nothing to any receiver within these bounds.
pub(crate) fn is_below(emitter: &Emitter, bounds: &Bounds) -> bool {
    let center = Vec3::from(emitter.center);
    if emitter.local != 0.0 {
        return bounds.side(center, emitter.radius) == Side::Behind;
    }
    // A disc at infinity, whose centre is a direction: the same from everywhere.
    let facing = center.dot(bounds.axis).clamp(-1.0, 1.0).acos();
    let [cosine, sine] = bounds.cone;
    let highest = (facing - sine.atan2(cosine)).max(0.0).cos();
    highest < -emitter.radius - 1e-5
}

/// Whether a node is so far from all receivers of a cluster that it counts as a whole even for those of its own body.
pub(crate) fn is_far(node: &Node, bounds: &Bounds) -> bool {
    let distance = Vec3::from(node.center).distance(bounds.center) - bounds.radius;
    // sin² is at most 1 − OWN from there on, whatever rounding does.
    distance * (0.99 * (1.0 - sh_core::seen::OWN as f32)).sqrt() >= node.radius
}
