#import shared/records
#import constants
#import library

// A blocker as the receiver sees it: sine and cosine of its angular radius (0 to 90 degrees), and the
// direction of its centre. A sine of 0 means that it does not count.
struct Blocker {
    sine: f32,
    cosine: f32,
    direction: vec3f,
}

// What of a ball is above the horizon of a receiver; `center` is seen from there, `own` says that the ball is of the
// receiver's own body. Twin of sh_core::seen, where the rule and its reasons stand.
fn above(center: vec3f, normal: vec3f, radius: f32, own: bool) -> Blocker {
    let height = dot(center, normal);
    let square = dot(center, center);
    // At the very centre it does not count.
    if (height <= -radius || square <= TINY * TINY) {
        return Blocker(0.0, 1.0, normal);
    }
    let sine_squared = radius * radius / square;
    // From inside a ball counts that reaches to the receiver: its height is over more than its radius.
    let over = height / max(radius, TINY) * max(sine_squared, 1.0);
    let cuts = height < radius;
    let grown = select(1.0, min((1.0 - min(sine_squared, 1.0)) / OWN, 1.0), own);
    if (!cuts) {
        let whole = seen(center, radius);
        return Blocker(whole.sine * grown, whole.cosine, whole.direction);
    }
    if (over <= -1.0) {
        return Blocker(0.0, 1.0, normal);
    }
    let counted = radius * sh$N_horizon_radius(over, min(sine_squared, 1.0));
    // The ball touches the plane at the foot.
    let foot = center - height * normal;
    let along = dot(foot, foot);
    // Under the foot, where nothing counts, rounding must not make a small ball a near one.
    let inverse = 1.0 / max(sqrt(max(along + counted * counted, FOOT * square)), TINY);
    let cosine = min(sqrt(along) * inverse, 1.0);
    return Blocker(min(counted * inverse, 1.0) * grown, cosine, (foot + counted * normal) * inverse);
}

// Whether a blocker of the body `object` is of the receiver's own.
fn is_own(receiver: Receiver, object: u32) -> bool {
    return object != 0u && object == receiver.object;
}

// A ball as it is; `center` is seen from the receiver.
fn seen(center: vec3f, radius: f32) -> Blocker {
    let square = dot(center, center);
    let inverse = 1.0 / max(sqrt(square), TINY);
    let cosine = min(sqrt(max(square - radius * radius, 0.0)) * inverse, 1.0);
    return Blocker(min(radius * inverse, 1.0), cosine, center * inverse);
}
