//! Lamps below the horizon of a whole cluster.
//!
//! What of a lamp is above a receiver's horizon is known in closed form (`emitters`), and nothing is where it lies wholly
//! below: the shadow pass gives exactly 0, whatever blocks it, and it needs no computing.

use glam::Vec3;
use sh_scene::{Bounds, Emitter, Side};

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
