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
    let foot = center - height * normal;
    let foot_squared = dot(foot, foot);
    var counted = radius;
    var raised = height;
    if (height < radius) {
        let circle = sqrt(max((radius - height) * (radius + height), 0.0));
        let a = clamp((sqrt(foot_squared) - circle) / max(circle, TINY), 0.0, 1.0);
        counted = (1.0 - a) * max(height, 0.0) + a * (radius + height) * 0.5;
        raised = counted;
    }
    let distance = sqrt(foot_squared + raised * raised);
    let inverse = 1.0 / max(distance, TINY);
    // distance^2 - radius^2, without the cancellation where the sphere touches the plane.
    let tangent = sqrt(max(foot_squared + (raised - counted) * (raised + counted), 0.0));
    return Blocker(
        min(counted * inverse, 1.0),
        min(tangent * inverse, 1.0),
        (foot + raised * normal) * inverse,
    );
}
