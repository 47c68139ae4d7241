#import shared/records

// A blocker as the receiver sees it: sine and cosine of its angular radius (0 to 90 degrees), and the
// direction of its centre. A sine of 0 means that it does not count.
struct Blocker {
    sine: f32,
    cosine: f32,
    direction: vec3f,
}

const TINY: f32 = 1e-30;
const FOOT: f32 = 1e-6;

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
    // The share of the distance between once and twice the circle's radius, in squares.
    let square = dot(center, center);
    let foot_squared = max(square - height * height, 0.0);
    let circle_squared = max((radius - height) * (radius + height), TINY);
    let a = clamp((foot_squared / circle_squared - 1.0) / 3.0, 0.0, 1.0);
    let inner = max(height, 0.0);
    let counted = max(inner + a * ((radius + height) * 0.5 - inner), 0.0);
    // Under the foot, where nothing counts, a distance that cancels to 0 would make the direction endless.
    let distance = sqrt(max(foot_squared + counted * counted, FOOT * square));
    let inverse = 1.0 / max(distance, TINY);
    // The sphere touches the plane at the foot.
    let cosine = min(sqrt(foot_squared) * inverse, 1.0);
    let direction = (center + (counted - height) * normal) * inverse;
    return Blocker(min(counted * inverse, 1.0), cosine, direction);
}

// A ball as it is; `center` is seen from the receiver.
fn seen(center: vec3f, radius: f32) -> Blocker {
    let square = dot(center, center);
    let inverse = 1.0 / max(sqrt(square), TINY);
    let cosine = min(sqrt(max(square - radius * radius, 0.0)) * inverse, 1.0);
    return Blocker(min(radius * inverse, 1.0), cosine, center * inverse);
}
