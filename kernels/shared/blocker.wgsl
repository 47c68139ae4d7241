#import shared/records

// A blocker as the receiver sees it: sine and cosine of its angular radius (0 to 90 degrees), and the
// direction of its centre. A sine of 0 means that it does not count.
struct Blocker {
    sine: f32,
    cosine: f32,
    direction: vec3f,
}

const TINY: f32 = 1e-30;

// The self-shadow rule of Ren et al. 2006, section 6.2, in a form without jumps. `center` is the sphere's
// centre seen from the receiver, `height` = c its height above the tangent plane. In front (c >= r) the
// sphere counts as it is, behind (c <= -r) not at all. Between, a sphere counts that touches the plane from
// the front at the foot of the centre: its radius goes from max(c, 0), for a receiver inside the circle that
// the plane cuts from the sphere, to (r + c) / 2 at twice that circle's radius.
fn replace(center: vec3f, normal: vec3f, radius: f32) -> Blocker {
    let height = dot(center, normal);
    if (height <= -radius) {
        return Blocker(0.0, 1.0, normal);
    }
    if (height >= radius) {
        return seen(center, radius);
    }
    let foot = center - height * normal;
    let foot_squared = dot(foot, foot);
    // (|foot| - d) / d by one root, d the circle's radius.
    let circle_squared = max((radius - height) * (radius + height), TINY);
    let a = clamp(sqrt(foot_squared / circle_squared) - 1.0, 0.0, 1.0);
    let inner = max(height, 0.0);
    let counted = max(inner + a * ((radius + height) * 0.5 - inner), 0.0);
    let towards = foot + counted * normal;
    let inverse = 1.0 / max(length(towards), TINY);
    // cos^2 = 1 - sin^2, without the cancellation, as the sphere touches the plane: it is the foot's share.
    let cosine = sqrt(min(foot_squared * inverse * inverse, 1.0));
    return Blocker(min(counted * inverse, 1.0), cosine, towards * inverse);
}

// A ball as it is; `center` is seen from the receiver.
fn seen(center: vec3f, radius: f32) -> Blocker {
    let inverse = 1.0 / max(length(center), TINY);
    let sine = min(radius * inverse, 1.0);
    return Blocker(sine, sqrt(max(1.0 - sine * sine, 0.0)), center * inverse);
}
