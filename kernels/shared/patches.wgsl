// What patches and regions of a body send to a receiver, and what hides them. Twin of sh_cpu's `patches` and `patch_cut`, where
// the formulae and their reasons stand.

#import shared/records
#import shared/scan
#import shared/gloss
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
    // One over the sine.
    steep: f32,
    // How far its middle is.
    far: f32,
    // One over twice its radius.
    inverse: f32,
}

// The disc in the sky that something is taken for.
struct Cone {
    direction: vec3f,
    far: f32,
    sine: f32,
    cosine: f32,
    steep: f32,
}

// That of a disc in this unit direction, so far away, of this area over PI.
fn cone_of(direction: vec3f, square: f32, far: f32, area: f32) -> Cone {
    let whole = square + area;
    let inverse = sqrt(1.0 / whole);
    let root = sqrt(area);
    return Cone(direction, far, inverse * root, inverse * far, whole * inverse / root);
}

// Spheres that are kept while patches are gone through; what is beyond is looked at anew for each.
const HELD: u32 = 16u;

// A receiver in the space of a body, and what may hide that.
struct Local {
    position: vec3f,
    normal: vec3f,
    // The direction to the eye.
    view: vec3f,
}

// What it reflects of something of which it would reflect `open` diffusely.
fn mirrored(open: f32, gloss: Gloss, cone: Cone, local: Local) -> f32 {
    let along = dot(cone.direction, local.view);
    return reflects(open, gloss, dot(cone.direction, local.normal), along, cone.sine * cone.sine);
}

fn local_of(receiver: Receiver, gloss: Gloss, body: u32) -> Local {
    let matrix = bodies[body].object_from_world;
    let position = (matrix * vec4f(receiver.position, 1.0)).xyz;
    let normal = (matrix * vec4f(receiver.normal, 0.0)).xyz * bodies[body].scale;
    let view = (matrix * vec4f(gloss.view, 0.0)).xyz * bodies[body].scale;
    return Local(position, normal, view);
}

fn see_hidden(receiver: Receiver, body: u32, at: u32) -> Hidden {
    let ball = balls[at];
    let away = ball.xyz - receiver.position;
    let own = is_own(receiver, nodes[names[at]].object);
    let seen = above(away, receiver.normal, ball.w, own);
    let scale = bodies[body].scale;
    let direction = (bodies[body].object_from_world * vec4f(seen.direction, 0.0)).xyz * scale;
    let cosine = sqrt(max(1.0 - seen.sine * seen.sine, 0.0));
    let steep = 1.0 / max(seen.sine, NEAREST);
    return Hidden(direction, seen.sine, cosine, steep, length(away) / scale, 0.5 / max(ball.w / scale, NEAREST));
}

// Whether a sphere may hide a part of a body from some receiver of the cluster.
fn may_hide(at: u32, body: u32, bounds: vec4f) -> bool {
    if (nodes[names[at]].object == bodies[body].object) {
        return false;
    }
    let far = distance(bodies[body].center, bounds.xyz) + bodies[body].radius;
    return distance(balls[at].xyz, bounds.xyz) - balls[at].w <= far + 2.0 * bounds.w;
}

// What a sphere leaves of a disc in the sky.
fn left_by(other: Hidden, cone: Cone) -> f32 {
    // From cos (a + b), where the discs touch, to cos (a - b), where one lies in the other.
    let across = other.sine * cone.sine;
    let over = dot(cone.direction, other.direction) - (other.cosine * cone.cosine - across);
    if (over <= 0.0) {
        return 1.0;
    }
    let x = clamp(over * other.steep * cone.steep * 0.5, 0.0, 1.0);
    let size = min(other.sine * cone.steep, 1.0);
    let before = clamp(0.5 + (cone.far - other.far) * other.inverse, 0.0, 1.0);
    return 1.0 - x * x * (3.0 - 2.0 * x) * size * size * before;
}

// What those of the spheres leave of it that may hide a part of the body.
fn left_of(
    receiver: Receiver,
    body: u32,
    hiding: ptr<function, array<u32, ROOM>>,
    kept: ptr<function, array<Hidden, HELD>>,
    count: u32,
    cone: Cone,
) -> f32 {
    var left = 1.0;
    for (var i = 0u; i < count; i += 1u) {
        if (i < HELD) {
            left *= left_by((*kept)[i], cone);
        } else {
            left *= left_by(see_hidden(receiver, body, (*hiding)[i]), cone);
        }
    }
    return left;
}

// What a body sends to a receiver of another.
fn sent_by(receiver: Receiver, gloss: Gloss, body: u32, count: u32, bounds: vec4f) -> vec3f {
    let own = bodies[body];
    let height = dot(own.center - receiver.position, receiver.normal);
    if (height <= -own.radius) {
        return vec3f(0.0);
    }
    let local = local_of(receiver, gloss, body);
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
        let center = regions[first + r].center;
        let radius = max(regions[first + r].radius, NEAREST);
        let flat = regions[first + r].whole.disc.area > 0.0;
        // How much of it a receiver that faces it gets of what it sends that way, as a disc or by its intensity.
        var whole: f32;
        var open: f32;
        var cone: Cone;
        if (flat) {
            let disc = regions[first + r].whole.disc;
            let seen = seen_disc(disc, local);
            whole = seen.whole;
            open = seen.open * whole;
            cone = cone_of(seen.away / seen.far, seen.square, seen.far, disc.area / PI);
        } else {
            let away = center - local.position;
            let square = max(dot(away, away), NEAREST);
            let far = sqrt(square);
            whole = clamp((far / radius - REFINED) / (ENTIRE - REFINED), 0.0, 1.0);
            open = max(dot(away / far, local.normal), 0.0) * whole / (square * PI);
            cone = cone_of(away / far, square, far, radius * radius);
        }
        if (open > 0.0) {
            let left = left_of(receiver, body, &hiding, &kept, hiders, cone);
            var sent = vec3f(0.0);
            if (flat) {
                for (var m = r * REGION_PATCHES; m < (r + 1u) * REGION_PATCHES; m += 1u) {
                    sent += light[own.light + 2u * m].rgb / f32(REGION_PATCHES);
                }
                sent *= escape(regions[first + r].whole.escape, -cone.direction);
            } else {
                let basis = sh$N_basis(-cone.direction);
                let start = own.light + 2u * own.patches + r * $Cu;
                for (var k = 0u; k < $Cu; k += 1u) {
                    sent += basis[k] * light[start + k].rgb;
                }
            }
            sum += mirrored(open, gloss, cone, local) * left * max(sent, vec3f(0.0));
        }
        if (whole >= 1.0) {
            continue;
        }
        for (var quarter = 0u; quarter < QUARTERS; quarter += 1u) {
            let start = r * REGION_PATCHES + quarter * QUARTER;
            var near = 1.0 - whole;
            // One after another: the quarter as a whole, and each of its patches.
            for (var k = 0u; k <= QUARTER; k += 1u) {
                let at = own.first + start + k - 1u;
                var facet = regions[first + r].quarters[quarter];
                if (k > 0u) {
                    facet = patches[at].whole;
                }
                if (facet.disc.area <= 0.0) {
                    continue;
                }
                let seen = seen_disc(facet.disc, local);
                var open = seen.open * seen.whole;
                var cone: Cone;
                var radiance = vec3f(0.0);
                if (k == 0u) {
                    open *= near;
                    near *= 1.0 - seen.whole;
                    cone = cone_of(seen.away / seen.far, seen.square, seen.far, facet.disc.area / PI);
                    for (var m = start; m < start + QUARTER; m += 1u) {
                        radiance += light[own.light + 2u * m].rgb / f32(QUARTER);
                    }
                } else {
                    if (seen.whole < 1.0) {
                        var parts = 0.0;
                        for (var p = 0u; p < PATCH_SAMPLES; p += 1u) {
                            if (patches[at].discs[p].area > 0.0) {
                                parts += given(patches[at].discs[p], local);
                            }
                        }
                        open += (1.0 - seen.whole) * parts;
                    }
                    open *= near;
                    let away = lifted(facet.disc, local);
                    let square = dot(away, away);
                    let far = sqrt(square);
                    cone = cone_of(away / far, square, far, facet.disc.area / PI);
                    radiance = light[own.light + 2u * (start + k - 1u)].rgb;
                }
                if (open > 0.0) {
                    let left = left_of(receiver, body, &hiding, &kept, hiders, cone);
                    let shown = escape(facet.escape, -cone.direction) * left;
                    sum += mirrored(open, gloss, cone, local) * shown * radiance;
                }
                if (near <= 0.0) {
                    break;
                }
            }
        }
    }
    return sum;
}

// Patches of a quarter of a region.
const QUARTER: u32 = REGION_PATCHES / QUARTERS;

// A disc as a receiver sees it.
struct SeenDisc {
    away: vec3f,
    square: f32,
    far: f32,
    // What it gives of its radiance to whoever is not next to it.
    open: f32,
    // Whether it counts as a whole: 0 nearby, 1 from afar.
    whole: f32,
}

fn seen_disc(disc: Disc, local: Local) -> SeenDisc {
    let away = disc.center - local.position;
    let front = max(-dot(away, disc.normal), 0.0);
    let above = dot(away, local.normal);
    let square = max(dot(away, away), NEAREST);
    let area = disc.area / PI;
    let wide = square + area;
    let inverse = 1.0 / (square * wide);
    let size = area * wide * inverse;
    let steep = front * front * wide * inverse;
    let bent = size * (2.0 - 3.0 * steep);
    let aside = size * front * dot(disc.normal, local.normal);
    let open = max(above * bent + above - aside, 0.0) * front * inverse * area;
    let far = sqrt(square);
    let whole = clamp((far / sqrt(disc.area) - SPLIT) / (JOINED - SPLIT), 0.0, 1.0);
    return SeenDisc(away, square, far, open, whole);
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

// What a disc gives of its radiance to a receiver that is lifted.
fn given(disc: Disc, local: Local) -> f32 {
    let height = height_over(disc, local);
    let away = lifted(disc, local);
    let above = max(dot(away, local.normal), 0.0);
    let front = clamp(height / (sqrt(disc.area) * LIFTED * BEHIND) + 1.0, 0.0, 1.0);
    let inverse = 1.0 / dot(away, away);
    return disc.area / PI * inverse * inverse * lifted_height(height, disc) * above * front;
}

// How much of a part of it a body leaves to be seen from a direction.
fn escape(told: array<vec4f, 3>, u: vec3f) -> f32 {
    let even = dot(told[1].xyz, u * u);
    let mixed = dot(told[2].xyz, u * u.yzx);
    return clamp(dot(told[0].xyz, u) + even + 2.0 * mixed, 0.0, 1.0);
}

// What a body gives a receiver on it: what it gives its patches, by nearness.
fn itself(receiver: Receiver, body: u32) -> vec3f {
    let own = bodies[body];
    let local = local_of(receiver, Gloss(), body);
    var sum = vec3f(0.0);
    var all = NEAREST;
    for (var m = 0u; m < own.patches; m += 1u) {
        let disc = patches[own.first + m].whole.disc;
        let away = disc.center - local.position;
        let square = dot(away, away);
        let within = max(1.0 - square / max(WITHIN * WITHIN * disc.area, NEAREST), 0.0);
        if (within <= 0.0) {
            continue;
        }
        let area = disc.area * 0.5;
        let facing = max(dot(disc.normal, local.normal), 0.0) + ASKEW;
        let near = facing * area / (square + area) * within;
        all += near * near;
        sum += near * near * light[own.light + 2u * m + 1u].rgb;
    }
    return sum / all;
}
