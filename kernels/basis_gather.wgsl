// Basis gather: light that patches of bodies send on, added to what every receiver gets already (Iwasaki et al. 2007, equation
// 4). Twin of sh_cpu's `basis_gather`; what a patch and a region give stands in its `patches`.
//
// Receivers of a cluster share a cut, as in the shadow pass: workgroup (x, y, z) has the receivers from 64 x on of cluster
// z * rows + y.

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/lit
#import shared/gloss
#import shared/bounds
#import shared/clusters
#import shared/blocker
#import shared/light
#import shared/patches
#import constants
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
// Each before those below it.
@group(0) @binding(1) var<storage, read> nodes: array<Node>;
@group(0) @binding(2) var<storage, read> bodies: array<Basis>;
@group(0) @binding(3) var<storage, read> patches: array<Patch>;
// Body by body: as many as patches over REGION_PATCHES.
@group(0) @binding(4) var<storage, read> regions: array<Region>;
// Of each body: what each patch sends on and what its body sends it, then coefficients of regions, then the brightest.
@group(0) @binding(5) var<storage, read> light: array<vec4f>;
// Where the picture is seen from.
@group(0) @binding(6) var<uniform> eye: vec4f;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// First receiver and how many.
@group(1) @binding(1) var<storage, read> clusters: array<vec2u>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(2) var<storage, read_write> radiance: array<vec4f>;

// Whether receivers get what their own body gives itself: points of patches have it in their weights.
override OWN_LIGHT: bool = true;

@compute @workgroup_size(WORKGROUP)
fn gather(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let range = cluster_range(workgroup.z * workgroups.y + workgroup.y);
    let at = workgroup.x * WORKGROUP + lane;
    let receiver = receiver_at(range, at);
    sum_up_to(lane, u32(is_lit(receiver)));
    if (workgroupUniformLoad(&sums[WORKGROUP - 1u]) == 0u) {
        return;
    }
    let bounds = cluster_bounds(range.x, range.y, lane);
    let count = coarse_cut(bounds, lane);
    if (!is_lit(receiver)) {
        return;
    }
    let gloss = gloss_of(receiver, eye.xyz);
    var sent = vec3f(0.0);
    var brightest = vec3f(0.0);
    for (var body = 0u; body < arrayLength(&bodies); body += 1u) {
        let end = bodies[body].light + 2u * bodies[body].patches;
        brightest = max(brightest, light[end + bodies[body].patches / REGION_PATCHES * $Cu].rgb);
        if (bodies[body].scale <= 0.0) {
            continue;
        }
        if (bodies[body].object == receiver.object) {
            if (OWN_LIGHT && bodies[body].own != 0u) {
                sent += itself(receiver, body);
            }
        } else {
            sent += sent_by(receiver, gloss, body, count, bounds);
        }
    }
    radiance[range.x + at] += vec4f(bounded(sent, brightest), 0.0);
}
