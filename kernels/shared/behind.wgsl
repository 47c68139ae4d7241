// Blockers that are behind a lamp, and do not hide it. Twin of sh_cpu's `behind`, where the rule and its reasons stand.

#import shared/records
#import shared/invocation
#import shared/blocker
#import shared/cut
#import shared/emitted
#import shared/power
#import constants

// No lamp: blockers hide all that is in their direction.
const NO_LAMP: u32 = 0xffffffffu;

// Of each invocation: bit i says that lamp i may have a blocker behind it. Then of all together.
var<workgroup> found_before: array<u32, WORKGROUP>;
var<workgroup> lamps_before: u32;

// sh_scene::order::Pair.
struct LampPair {
    most: f32,
    slope: f32,
    settled: f32,
    twice: f32,
}

fn lamp_pair(lamp: u32, center: vec3f, radius: f32) -> LampPair {
    let own = emitters[lamp].radius;
    let apart = distance(emitters[lamp].center, center);
    let twice = 2.0 * apart;
    let ahead = 0.5 * (apart + (own * own - radius * radius) / max(apart, SMALLEST_DIVISOR));
    let width = max(swap_width(own, radius, apart), min(ahead, apart - ahead));
    let most = clamp((apart - radius + own) / (2.0 * own), 0.0, 1.0);
    return LampPair(most, 1.0 / max(2.0 * width * twice, SMALLEST_DIVISOR), twice * width, twice);
}

// By how much the power of a place against a lamp is greater than that against a blocker.
fn lamp_lead(lamp: u32, center: vec3f, radius: f32, place: vec3f) -> f32 {
    return power(place, emitters[lamp].center, emitters[lamp].radius) - power(place, center, radius);
}

// Whether a lamp lies wholly outside of a node.
fn is_clear(lamp: u32, node: u32) -> bool {
    let away = emitters[lamp].center - nodes[node].center;
    let reach = emitters[lamp].radius + nodes[node].radius;
    return dot(away, away) >= reach * reach;
}

// Whether a node hides all that it covers of a lamp from all receivers of the cluster, or is aside of it for all.
fn leaves_lamp(lamp: u32, at: u32, bounds: vec4f) -> bool {
    let node = nodes[at];
    let pair = lamp_pair(lamp, node.center, node.radius);
    let lead = lamp_lead(lamp, node.center, node.radius, bounds.xyz);
    if (node.radius <= 0.0 || (pair.most >= 1.0 && lead >= pair.settled + pair.twice * bounds.w)) {
        return true;
    }
    let to = emitters[lamp].center - bounds.xyz;
    let towards = node.center - bounds.xyz;
    let far = length(to);
    let near = length(towards);
    let reach = bounds.w * WIDENED;
    if (far <= reach || near <= reach + NEAR * node.radius) {
        return false;
    }
    let spread = asin(reach / far) + asin(reach / near) + asin(min(REACH * node.radius / (near - reach), 1.0));
    return acos(clamp(dot(to, towards) / (far * near), -1.0, 1.0)) - spread > ASIDE_EDGE;
}

// Lamps that a node of the cut may be behind.
fn lamps_behind(at: u32, bounds: vec4f) -> u32 {
    var mask = 0u;
    for (var lamp = 0u; lamp < min(lighting.emitters, MOST_LAMPS); lamp += 1u) {
        let whole = nodes[at].skip <= at + 1u || is_clear(lamp, at);
        if (emitters[lamp].local != 0.0 && !(whole && leaves_lamp(lamp, at, bounds))) {
            mask |= 1u << lamp;
        }
    }
    return mask;
}

// Puts together what all invocations have found.
fn gather_lamps(found: u32, lane: u32) -> u32 {
    found_before[lane] = found;
    workgroupBarrier();
    if (lane == 0u) {
        var all = 0u;
        for (var i = 0u; i < WORKGROUP; i += 1u) {
            all |= found_before[i];
        }
        lamps_before = all;
    }
    return workgroupUniformLoad(&lamps_before);
}

// Whether a node counts for a lamp: as in the cut, but of nodes that reach around it the leaves.
fn counts_for_lamp(lamp: u32, at: u32, bounds: vec4f) -> bool {
    if (at >= lighting.nodes) {
        return false;
    }
    let leaf = nodes[at].skip <= at + 1u;
    if (!leaf && !(is_small(nodes[at], bounds) && is_clear(lamp, at))) {
        return false;
    }
    // The node of the cut that it is, or is below.
    var top = at;
    while (nodes[top].parent != top && is_small(nodes[nodes[top].parent], bounds)) {
        top = nodes[top].parent;
    }
    return (top == at || !is_clear(lamp, top)) && (top == at || leaf) && !is_negligible(top, bounds);
}

// How much of a blocker's logarithm a lamp's sum has.
fn lamp_part(lamp: u32, center: vec3f, radius: f32, seen: Blocker, place: vec3f) -> f32 {
    let pair = lamp_pair(lamp, center, radius);
    let lead = lamp_lead(lamp, center, radius, place);
    let hidden = pair.most * clamp(0.5 + lead * pair.slope, 0.0, 1.0);
    let towards = emitters[lamp].center - place;
    let direction = towards / max(length(towards), NEAREST);
    let near = clamp((dot(direction, seen.direction) + seen.sine - ASIDE) * STEEP, 0.0, 1.0);
    return 1.0 + (hidden - 1.0) * near;
}

// How often blockers may have to be summed up again: once a lamp.
fn rounds() -> u32 {
    return select(0u, min(lighting.emitters, MOST_LAMPS), LAMPS);
}
