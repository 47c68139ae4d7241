// Shadowed light: what the shadow pass multiplies with the cosine lobe, as it is: light through the visibility of all
// blocker spheres, an SH vector for every receiver, for BRDFs and normal maps of the host's. Product of visibility with
// the environment and all analytic lights, channel by channel (Ren et al. 2006, section 8, without the lobe).
//
// Clusters and workgroups are those of `shadow`.

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/bounds
#import shared/visibility
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
// The coefficients of a receiver one after another: red, green, blue, 0.
@group(1) @binding(2) var<storage, read_write> light: array<vec4f>;

@compute @workgroup_size(64)
fn shadowed_light(
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
            for (var i = 0u; i < $Cu; i += 1u) {
                light[index * $Cu + i] = vec4f(0.0);
            }
        }
        return;
    }
    let bounds = cluster_bounds(first, count, lane);
    let sum = log_visibility(receiver, bounds, lane);
    if (!inside) {
        return;
    }
    var all = array<vec3f, $C>();
    if (covered) {
        all = arriving(receiver.position);
    }
    let visibility = visibility_of(sum);
    // Channel by channel, so that the product is compiled once.
    var product = array<vec3f, $C>();
    for (var c = 0u; c < 3u; c += 1u) {
        var channel = array<f32, $C>();
        for (var i = 0u; i < $Cu; i += 1u) {
            channel[i] = all[i][c];
        }
        let one = sh$N_product(visibility, channel);
        for (var i = 0u; i < $Cu; i += 1u) {
            product[i][c] = one[i];
        }
    }
    for (var i = 0u; i < $Cu; i += 1u) {
        light[index * $Cu + i] = vec4f(number(product[i]), 0.0);
    }
}

// The light of the environment and of all analytic lights together, without blockers.
fn arriving(position: vec3f) -> array<vec3f, $C> {
    var sum = array<vec3f, $C>();
    for (var i = 0u; i < $Cu; i += 1u) {
        sum[i] = lighting.coefficients[i].rgb;
    }
    for (var at = 0u; LAMPS && at < lighting.emitters; at += 1u) {
        let own = emitter_light(at, position);
        for (var i = 0u; i < $Cu; i += 1u) {
            sum[i] += own[i] * emitters[at].radiance;
        }
    }
    return sum;
}
