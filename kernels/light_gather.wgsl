// Light gather: light that spheres send on, added to what every receiver gets already (Guerrero et al. 2008, section
// 6). Each sphere gives its mean radiance times what is visible of it, the cosine included: of its disc, what nearer
// discs leave (`gather_discs`), or a difference of exponentials (`gather_sums`). Twin of sh_cpu's `light_order` and
// `light_gather`.
//
// Receivers of a cluster share a cut, as in the shadow pass, and which of its spheres hide which: workgroup (x, y, z)
// has the receivers from 64 x on of cluster z * rows + y. A cut that workgroup memory does not hold is looked at pair by
// pair.

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/lit
#import shared/gloss
#import shared/bounds
#import shared/clusters
#import shared/cut
#import shared/log_saturating
#import shared/blocker
#import shared/light
#import shared/light_order
#import shared/light_sent
#import shared/light_discs
#import shared/light_sums
#import constants
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
// Each before those below it.
@group(0) @binding(1) var<storage, read> nodes: array<Node>;
// The body of each node, and the node that stands for all of that body.
@group(0) @binding(2) var<storage, read> members: array<vec2u>;
// What each node sends on: its coefficients, and the brightest that it is anywhere.
@group(0) @binding(3) var<storage, read> emission: array<vec4f>;
// Where the picture is seen from.
@group(0) @binding(4) var<uniform> eye: vec4f;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// First receiver and how many.
@group(1) @binding(1) var<storage, read> clusters: array<vec2u>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(2) var<storage, read_write> radiance: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn gather_discs(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let range = cluster_range(workgroup.z * workgroups.y + workgroup.y);
    let at = workgroup.x * WORKGROUP + lane;
    let receiver = receiver_at(range, at);
    sum_up_to(lane, u32(is_lit(receiver)));
    if (workgroupUniformLoad(&sums[WORKGROUP - 1u]) == 0u || lighting.nodes == 0u) {
        return;
    }
    let bounds = cluster_bounds(range.x, range.y, lane);
    let count = list_cut(bounds, lane);
    let gloss = gloss_of(receiver, eye.xyz);
    var sent = vec3f(0.0);
    if (count <= ROOM) {
        find_hiders(count, bounds, lane);
        if (is_lit(receiver)) {
            sent = discs_in_memory(receiver, gloss, count);
        }
    } else {
        sent = discs_of_all(receiver, gloss, bounds, lane);
    }
    add(range.x + at, receiver, sent);
}

@compute @workgroup_size(WORKGROUP)
fn gather_sums(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let range = cluster_range(workgroup.z * workgroups.y + workgroup.y);
    let at = workgroup.x * WORKGROUP + lane;
    let receiver = receiver_at(range, at);
    sum_up_to(lane, u32(is_lit(receiver)));
    if (workgroupUniformLoad(&sums[WORKGROUP - 1u]) == 0u || lighting.nodes == 0u) {
        return;
    }
    let bounds = cluster_bounds(range.x, range.y, lane);
    let count = list_cut(bounds, lane);
    let gloss = gloss_of(receiver, eye.xyz);
    var sent = vec3f(0.0);
    if (count <= ROOM) {
        order_cut(count, bounds, lane);
        if (is_lit(receiver)) {
            sent = sums_in_memory(receiver, gloss, count, bounds.xyz);
        }
    } else {
        sent = sums_of_all(receiver, gloss, bounds, lane);
    }
    add(range.x + at, receiver, sent);
}

// No part of any surface sends on more than the brightest of all.
fn add(index: u32, receiver: Receiver, sent: vec3f) {
    if (is_lit(receiver)) {
        radiance[index] += vec4f(bounded(sent, emission[SENT - 1u].rgb), 0.0);
    }
}
