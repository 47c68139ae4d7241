// In which order light meets spheres, and which of them hide which. Twin of sh_cpu's `light_order`, where the rule and
// its reasons stand.

#import shared/records
#import shared/scan
#import shared/cut
#import shared/blocker
#import shared/power
#import constants

// Of each sphere of a cut the node, its centre and radius, and its power against the middle of the cluster.
var<workgroup> names: array<u32, ROOM>;

var<workgroup> balls: array<vec4f, ROOM>;

var<workgroup> powers: array<f32, ROOM>;

// What the light of each is multiplied with.
var<workgroup> gains: array<vec3f, ROOM>;

// Where all do not fit, half of the memory holds some that send, the other half some that hide them.
const HALF: u32 = ROOM / 2u;

// A sphere that light meets on its way.
struct Met {
    center: vec3f,
    radius: f32,
    node: u32,
    power: f32,
}

// One of those in workgroup memory.
fn met(at: u32) -> Met {
    return Met(balls[at].xyz, balls[at].w, names[at], powers[at]);
}

fn comes_first(a: Met, b: Met) -> bool {
    return a.power < b.power || (a.power == b.power && a.node < b.node);
}

// Whether they are spheres of one body that intersect.
fn is_joint(a: Met, b: Met, apart: f32) -> bool {
    let body = members[a.node].x;
    return body == members[b.node].x && body != NO_BODY && apart < a.radius + b.radius;
}

// How much of what `hider` covers it hides of `hidden` from a place, 0 to 1.
fn share(hidden: Met, hider: Met, place: vec3f) -> f32 {
    let apart = distance(hidden.center, hider.center);
    let twice = 2.0 * apart;
    if (twice == 0.0) {
        return f32(comes_first(hider, hidden));
    }
    let lead = power(place, hidden.center, hidden.radius) - power(place, hider.center, hider.radius);
    let slope = 1.0 / max(2.0 * swap_width(hidden.radius, hider.radius, apart) * twice, SMALLEST_DIVISOR);
    return clamp(0.5 + lead * slope, 0.0, 1.0);
}

// Whether all that `near` covers is hidden of `far`, and nothing the other way, from all receivers of the cluster.
fn is_settled(near: Met, far: Met, bounds: vec4f) -> bool {
    let apart = distance(near.center, far.center);
    let reach = bounds.w + swap_width(near.radius, far.radius, apart);
    return far.power - near.power >= 2.0 * apart * reach;
}

// Lists the nodes of the cut, as many as there is room for, and tells how many there are.
fn list_cut(bounds: vec4f, lane: u32) -> u32 {
    var total = 0u;
    for (var chunk = 0u; chunk < lighting.nodes; chunk += WORKGROUP) {
        let taken = u32(in_cut(chunk + lane, bounds));
        let place = total + sum_up_to(lane, taken) - taken;
        if (taken != 0u && place < ROOM) {
            names[place] = chunk + lane;
        }
        total += workgroupUniformLoad(&sums[WORKGROUP - 1u]);
    }
    return total;
}

// A sphere's place in workgroup memory.
fn keep(at: u32, node: u32, ball: vec4f, middle: vec3f) {
    names[at] = node;
    balls[at] = ball;
    powers[at] = power(middle, ball.xyz, ball.w);
}

// Spheres of the cut that an invocation sorts.
const SORTED: u32 = ROOM / WORKGROUP;

// Sorts the spheres in workgroup memory by power.
fn sort_kept(count: u32, middle: vec3f, lane: u32) {
    var own: array<u32, SORTED>;
    var ball: array<vec4f, SORTED>;
    var rank: array<u32, SORTED>;
    for (var i = 0u; i < SORTED; i += 1u) {
        let k = lane + i * WORKGROUP;
        if (k < count) {
            own[i] = names[k];
            ball[i] = balls[k];
            for (var other = 0u; other < count; other += 1u) {
                rank[i] += u32(comes_first(met(other), met(k)));
            }
        }
    }
    workgroupBarrier();
    for (var i = 0u; i < SORTED; i += 1u) {
        if (lane + i * WORKGROUP < count) {
            keep(rank[i], own[i], ball[i], middle);
        }
    }
    workgroupBarrier();
}

// A sphere in workgroup memory as the receiver sees it.
fn seen_by(receiver: Receiver, at: u32) -> Blocker {
    let own = is_own(receiver, nodes[names[at]].object);
    return above(balls[at].xyz - receiver.position, receiver.normal, balls[at].w, own);
}
