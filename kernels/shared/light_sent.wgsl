// What nodes send on.

#import shared/records
#import shared/blocker
#import shared/light
#import constants
#import library

// Elements of `emission` a node: its coefficients, with those of how much of it can be seen, and the brightest that it
// is anywhere.
const SENT: u32 = $Cu + 1u;

// Whether a node sends anything.
fn shines(node: u32) -> bool {
    return any(emission[node * SENT + $Cu].rgb > vec3f(0.0));
}

const SMALLEST_SQUARE: f32 = 1.2e-38;

// The reflection ratio of a node whose disc has this radius (Guerrero et al. 2008, equation 25): what the spheres below
// it give to a place, as much of each as its body leaves to be seen from there, over what the node gives in their stead. 1 for a
// sphere.
fn gain(at: u32, radius: f32, place: vec3f) -> vec3f {
    let end = min(nodes[at].skip, lighting.nodes);
    if (end <= at + 1u || !shines(at)) {
        return vec3f(1.0);
    }
    var sum = vec3f(0.0);
    for (var below = at + 1u; below < end; below += 1u) {
        if (nodes[below].skip <= below + 1u) {
            sum += seen_of(below, place) * given(below, nodes[below].radius, place);
        }
    }
    let own = given(at, radius, place);
    let ratio = min(sum / own, vec3f(MOST_GAIN));
    return select(vec3f(1.0), ratio, (own > vec3f(0.0)) & (sum > vec3f(0.0)));
}

// How much of a sphere its body's other spheres leave to be seen from a place.
fn seen_of(node: u32, place: vec3f) -> f32 {
    let towards = place - nodes[node].center;
    let basis = sh$N_basis(towards / max(length(towards), SMALLEST_SQUARE));
    var share = 0.0;
    for (var i = 0u; i < $Cu; i += 1u) {
        share += basis[i] * emission[node * SENT + i].a;
    }
    return clamp(share, 0.0, 1.0);
}

// What a node gives to a place, by the square of its disc's sine.
fn given(node: u32, radius: f32, place: vec3f) -> vec3f {
    let to = nodes[node].center - place;
    let square = max(dot(to, to), SMALLEST_SQUARE);
    let sine = sqrt(min(radius * radius / square, 1.0));
    let cosine = sqrt(max(1.0 - sine * sine, 0.0));
    return sine * sine * mean_sent(node, Blocker(sine, cosine, to / sqrt(square)));
}

// The mean radiance of what is seen of a node (Guerrero et al. 2008, equation 18).
fn mean_sent(node: u32, seen: Blocker) -> vec3f {
    let weights = sh$N_ball_average(seen.sine, seen.cosine, -seen.direction);
    var mean = vec3f(0.0);
    for (var i = 0u; i < $Cu; i += 1u) {
        mean += weights[i] * emission[node * SENT + i].rgb;
    }
    return bounded(mean, emission[node * SENT + $Cu].rgb);
}
