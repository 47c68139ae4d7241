// What patches and regions of a body send to a receiver, and what hides them. Twin of sh_cpu's `patches` and `patch_cut`, where
// the formulae and their reasons stand.

#import shared/records
#import shared/scan
#import shared/blocker
#import shared/light
#import constants
#import library

// The spheres of the cut: their node, and centre and radius.
var<workgroup> names: array<u32, ROOM>;

var<workgroup> balls: array<vec4f, ROOM>;

const PI: f32 = 3.14159265;

// Whether a node is small enough, seen from every receiver of the cluster, to stand for its leaves.
fn stands(node: Node, bounds: vec4f, limit: f32) -> bool {
    return node.radius < limit * (distance(node.center, bounds.xyz) - bounds.w);
}

fn is_cut(at: u32, bounds: vec4f, limit: f32) -> bool {
    if (at >= lighting.nodes) {
        return false;
    }
    let node = nodes[at];
    if (node.skip > at + 1u && !stands(node, bounds, limit)) {
        return false;
    }
    return node.parent == at || !stands(nodes[node.parent], bounds, limit);
}

// Puts the nodes of the cut into workgroup memory, of a coarser one where there would be more than it holds.
fn coarse_cut(bounds: vec4f, lane: u32) -> u32 {
    var limit = lighting.sin_max;
    var total = 0u;
    for (var i = 0u; i < COARSEST; i += 1u) {
        total = 0u;
        for (var chunk = 0u; chunk < lighting.nodes; chunk += WORKGROUP) {
            let taken = u32(is_cut(chunk + lane, bounds, limit));
            let place = total + sum_up_to(lane, taken) - taken;
            if (taken != 0u && place < ROOM) {
                names[place] = chunk + lane;
                let node = nodes[chunk + lane];
                balls[place] = vec4f(node.center, min(node.radius, sqrt(node.area)));
            }
            total += workgroupUniformLoad(&sums[WORKGROUP - 1u]);
        }
        if (total <= ROOM) {
            break;
        }
        limit = max(limit * COARSER, COARSER - 1.0);
    }
    workgroupBarrier();
    return min(total, ROOM);
}

// A sphere as the receiver sees it, in the space of the body that it hides.
struct Hidden {
    direction: vec3f,
    sine: f32,
    cosine: f32,
    // How far its middle is.
    far: f32,
    // One over twice its radius.
    inverse: f32,
}

// Spheres that are kept while patches are gone through; what is beyond is looked at anew for each.
const HELD: u32 = 16u;

// A receiver in the space of a body, and what may hide that.
struct Local {
    position: vec3f,
    normal: vec3f,
}

fn local_of(receiver: Receiver, body: u32) -> Local {
    let matrix = bodies[body].object_from_world;
    let position = (matrix * vec4f(receiver.position, 1.0)).xyz;
    let normal = (matrix * vec4f(receiver.normal, 0.0)).xyz * bodies[body].scale;
    return Local(position, normal);
}

fn see_hidden(receiver: Receiver, body: u32, at: u32) -> Hidden {
    let ball = balls[at];
    let away = ball.xyz - receiver.position;
    let own = is_own(receiver, nodes[names[at]].object);
    let seen = above(away, receiver.normal, ball.w, own);
    let scale = bodies[body].scale;
    let direction = (bodies[body].object_from_world * vec4f(seen.direction, 0.0)).xyz * scale;
    let cosine = sqrt(max(1.0 - seen.sine * seen.sine, 0.0));
    return Hidden(direction, seen.sine, cosine, length(away) / scale, 0.5 / max(ball.w / scale, NEAREST));
}

// Whether a sphere may hide a part of a body from some receiver of the cluster.
fn may_hide(at: u32, body: u32, bounds: vec4f) -> bool {
    if (nodes[names[at]].object == bodies[body].object) {
        return false;
    }
    let far = distance(bodies[body].center, bounds.xyz) + bodies[body].radius;
    return distance(balls[at].xyz, bounds.xyz) - balls[at].w <= far + 2.0 * bounds.w;
}

// What a sphere leaves of a disc in a direction, so far away, of so large an angular radius.
fn left_by(other: Hidden, direction: vec3f, far: f32, sine: f32) -> f32 {
    let cosine = sqrt(max(1.0 - sine * sine, 0.0));
    let across = other.sine * sine;
    // From cos (a + b), where the discs touch, to cos (a - b), where one lies in the other.
    let over = dot(direction, other.direction) - (other.cosine * cosine - across);
    if (over <= 0.0) {
        return 1.0;
    }
    let x = clamp(over / max(2.0 * across, NEAREST), 0.0, 1.0);
    let size = min(other.sine * other.sine / max(sine * sine, NEAREST), 1.0);
    let before = clamp(0.5 + (far - other.far) * other.inverse, 0.0, 1.0);
    return 1.0 - x * x * (3.0 - 2.0 * x) * size * before;
}

// What a body sends to a receiver of another.
fn sent_by(receiver: Receiver, body: u32, count: u32, bounds: vec4f) -> vec3f {
    let own = bodies[body];
    let height = dot(own.center - receiver.position, receiver.normal);
    if (height <= -own.radius) {
        return vec3f(0.0);
    }
    let local = local_of(receiver, body);
    var hiding: array<u32, ROOM>;
    var kept: array<Hidden, HELD>;
    var hiders = 0u;
    for (var i = 0u; i < count; i += 1u) {
        if (may_hide(i, body, bounds)) {
            hiding[hiders] = i;
            if (hiders < HELD) {
                kept[hiders] = see_hidden(receiver, body, i);
            }
            hiders += 1u;
        }
    }
    var sum = vec3f(0.0);
    let first = own.first / REGION_PATCHES;
    for (var r = 0u; r < own.patches / REGION_PATCHES; r += 1u) {
        let region = regions[first + r];
        let away = region.xyz - local.position;
        let square = max(dot(away, away), NEAREST);
        let far = sqrt(square);
        let whole = clamp((far / max(region.w, NEAREST) - REFINED) / (ENTIRE - REFINED), 0.0, 1.0);
        let direction = away / far;
        let facing = max(dot(direction, local.normal), 0.0) * whole;
        if (facing > 0.0) {
            let sine = min(region.w / far, 1.0);
            var left = 1.0;
            for (var i = 0u; i < hiders; i += 1u) {
                if (i < HELD) {
                    left *= left_by(kept[i], direction, far, sine);
                } else {
                    left *= left_by(see_hidden(receiver, body, hiding[i]), direction, far, sine);
                }
            }
            let basis = sh$N_basis(-direction);
            var intensity = vec3f(0.0);
            let start = own.light + 2u * own.patches + r * $Cu;
            for (var k = 0u; k < $Cu; k += 1u) {
                intensity += basis[k] * light[start + k].rgb;
            }
            sum += facing * left / (square * PI) * max(intensity, vec3f(0.0));
        }
        if (whole >= 1.0) {
            continue;
        }
        for (var m = r * REGION_PATCHES; m < (r + 1u) * REGION_PATCHES; m += 1u) {
            let at = own.first + m;
            let disc = patches[at].whole;
            if (disc.area <= 0.0) {
                continue;
            }
            let away = lifted(disc, local);
            let square = dot(away, away);
            let far = sqrt(square);
            // Whether it counts as a whole.
            let joined = clamp((far / sqrt(disc.area) - SPLIT) / (JOINED - SPLIT), 0.0, 1.0);
            var open = given(disc, local) * joined;
            if (joined < 1.0) {
                var parts = 0.0;
                for (var k = 0u; k < PATCH_SAMPLES; k += 1u) {
                    if (patches[at].discs[k].area > 0.0) {
                        parts += given(patches[at].discs[k], local);
                    }
                }
                open += (1.0 - joined) * parts;
            }
            open *= 1.0 - whole;
            if (open <= 0.0) {
                continue;
            }
            let direction = away / far;
            let area = disc.area / PI;
            let sine = sqrt(area / (area + square));
            var left = escape(at, -direction);
            for (var i = 0u; i < hiders; i += 1u) {
                if (i < HELD) {
                    left *= left_by(kept[i], direction, far, sine);
                } else {
                    left *= left_by(see_hidden(receiver, body, hiding[i]), direction, far, sine);
                }
            }
            sum += open * left * light[own.light + 2u * m].rgb;
        }
    }
    return sum;
}

// How far a receiver lies in front of a disc's plane.
fn height_over(disc: Disc, local: Local) -> f32 {
    return dot(local.position - disc.center, disc.normal);
}

fn lifted_height(height: f32, disc: Disc) -> f32 {
    let least = sqrt(disc.area) * LIFTED;
    return sqrt(height * height + least * least);
}

// The way to a disc from where the receiver is lifted to.
fn lifted(disc: Disc, local: Local) -> vec3f {
    let height = height_over(disc, local);
    return disc.center - local.position - (lifted_height(height, disc) - height) * disc.normal;
}

// What a disc gives of its radiance.
fn given(disc: Disc, local: Local) -> f32 {
    let height = height_over(disc, local);
    let away = lifted(disc, local);
    let above = max(dot(away, local.normal), 0.0);
    let front = clamp(height / (sqrt(disc.area) * LIFTED * BEHIND) + 1.0, 0.0, 1.0);
    let inverse = 1.0 / dot(away, away);
    return disc.area / PI * inverse * inverse * lifted_height(height, disc) * above * front;
}

// How much of a patch its own body leaves to be seen from a direction.
fn escape(at: u32, u: vec3f) -> f32 {
    let even = dot(patches[at].escape[1].xyz, u * u);
    let mixed = dot(patches[at].escape[2].xyz, u * u.yzx);
    return clamp(dot(patches[at].escape[0].xyz, u) + even + 2.0 * mixed, 0.0, 1.0);
}

// What a body gives a receiver on it: what it gives its patches, by nearness.
fn itself(receiver: Receiver, body: u32) -> vec3f {
    let own = bodies[body];
    let local = local_of(receiver, body);
    var sum = vec3f(0.0);
    var all = NEAREST;
    for (var m = 0u; m < own.patches; m += 1u) {
        let disc = patches[own.first + m].whole;
        let away = disc.center - local.position;
        let area = disc.area * 0.5;
        let near = max(dot(disc.normal, local.normal), 0.0) * area / (dot(away, away) + area);
        all += near * near;
        sum += near * near * light[own.light + 2u * m + 1u].rgb;
    }
    return sum / all;
}
