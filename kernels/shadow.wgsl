// Shadow: light through the visibility of all blocker spheres, for every receiver (Ren et al. 2006, section 8). The
// log visibilities of the blockers are summed, in the order of accumulation, and exponentiated once; what the order
// of the light holds of that is multiplied with the cosine lobe and dotted with the light. Twin of sh_cpu's `cut` and
// `shadow`.
//
// Receivers of a cluster share the cut of blockers that a workgroup finds in its memory, a chunk of the tree at a
// time: workgroup (x, y, z) has the receivers from 64 x on of cluster z * rows + y.

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/bounds
#import shared/cut
#import shared/blocker
#import shared/light
#import shared/emitted
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> emitters: array<Emitter>;
// Each before those below it.
@group(0) @binding(2) var<storage, read> nodes: array<Node>;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// First receiver and how many.
@group(1) @binding(1) var<storage, read> clusters: array<vec2u>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(2) var<storage, read_write> radiance: array<vec4f>;

// Nodes that an invocation looks at between two barriers.
const EACH: u32 = 4u;

const CHUNK: u32 = 256u;

// Those of a chunk of nodes that are in the cut.
var<workgroup> cut: array<Weighted, CHUNK>;

@compute @workgroup_size(64)
fn shadow(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let cluster = workgroup.z * workgroups.y + workgroup.y;
    if (cluster >= arrayLength(&clusters)) {
        return;
    }
    let first = min(clusters[cluster].x, arrayLength(&receivers));
    let count = min(clusters[cluster].y, arrayLength(&receivers) - first);
    let start = workgroup.x * WORKGROUP;
    if (start >= count) {
        return;
    }
    let inside = start + lane < count;
    let index = first + start + lane;
    var receiver = Receiver();
    if (inside) {
        receiver = receivers[index];
    }
    let covered = receiver.covered != 0u;
    sum_up_to(lane, u32(covered));
    if (workgroupUniformLoad(&sums[WORKGROUP - 1u]) == 0u) {
        if (inside) {
            radiance[index] = vec4f(0.0);
        }
        return;
    }
    // Where only leaves count, nobody asks where the receivers are.
    var bounds = vec4f(0.0);
    if (lighting.sin_max > 0.0) {
        bounds = cluster_bounds(first, count, lane);
    }
    var sum = array<f32, $B>();
    for (var chunk = 0u; chunk < lighting.nodes; chunk += CHUNK) {
        let own = chunk + lane * EACH;
        var taken = 0u;
        for (var i = 0u; i < EACH; i += 1u) {
            taken |= u32(in_cut(own + i, bounds)) << i;
        }
        var place = sum_up_to(lane, countOneBits(taken)) - countOneBits(taken);
        let found = workgroupUniformLoad(&sums[WORKGROUP - 1u]);
        for (var i = 0u; i < EACH; i += 1u) {
            if ((taken >> i & 1u) != 0u) {
                cut[place] = weighted(own + i, bounds);
                place += 1u;
            }
        }
        workgroupBarrier();
        for (var i = 0u; i < found; i += 1u) {
            let blocker = replace(cut[i].center - receiver.position, receiver.normal, cut[i].radius);
            if (covered && blocker.sine > 0.0) {
                sum = sh$A_accumulate_blocker(
                    sum, blocker.sine, blocker.cosine, blocker.direction, cut[i].weights);
            }
        }
        workgroupBarrier();
    }
    if (!inside) {
        return;
    }
    var result = vec3f(0.0);
    if (covered) {
        let accumulated = sh$A_exp_saturating(sh$A_accumulated_log(sum));
        var visibility = array<f32, $C>();
        for (var i = 0u; i < $Cu; i += 1u) {
            visibility[i] = accumulated[i];
        }
        let transfer = sh$N_product_cosine(visibility, receiver.normal);
        let lobe = sh$N_cosine(receiver.normal);
        result = bounded(reflected(transfer), reflected(lobe)) + emitted(transfer, lobe, receiver.position);
    }
    radiance[index] = vec4f(result, 0.0);
}
