#import shared/records

// The part of a blocker sphere that a receiver with a tangent plane sees: centre relative to the receiver,
// and radius, which is 0 where nothing is left. The self-shadow rule of Ren et al. 2006, section 6.2, made
// continuous: a sphere wholly in front of the tangent plane counts as it is, one wholly behind it not at
// all, and one that straddles it shrinks towards the sphere that touches the plane from in front, the more
// the nearer the receiver is to the circle the plane cuts out of it.
fn visible_part(receiver: Receiver, sphere: Sphere) -> vec4f {
    let towards = sphere.center - receiver.position;
    let height = dot(towards, receiver.normal);
    let radius = sphere.radius;
    if (height >= radius) {
        return vec4f(towards, radius);
    }
    if (height <= -radius) {
        return vec4f(0.0);
    }
    let foot = towards - height * receiver.normal;
    // The circle's radius reaches 0 where the sphere touches the plane; either weight is right there.
    let circle = max(sqrt(max((radius - height) * (radius + height), 0.0)), 1e-18);
    let away = clamp((length(foot) - circle) / circle, 0.0, 1.0);
    let kept = (1.0 - away) * max(height, 0.0) + away * 0.5 * (radius + height);
    return vec4f(foot + kept * receiver.normal, kept);
}
