// Shadow: environment light through the visibility of all blocker spheres, for every receiver
// (Ren et al. 2006, section 8). The log visibilities of the blockers are summed, in the order of accumulation,
// and exponentiated once; what the order of the light holds of that is multiplied with the cosine lobe and
// dotted with the light. Twin of sh_cpu's `shadow`.
//
// One invocation a receiver; the blockers pass through workgroup memory, a tile at a time.

#import shared/records
#import shared/invocation
#import shared/blocker
#import shared/light
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> blockers: array<Sphere>;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(1) var<storage, read_write> radiance: array<vec4f>;

var<workgroup> tile: array<Sphere, WORKGROUP>;

@compute @workgroup_size(64)
fn shadow(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    let inside = index < arrayLength(&receivers);
    var receiver = Receiver();
    if (inside) {
        receiver = receivers[index];
    }
    let covered = receiver.covered != 0u;
    var f = array<f32, $B>();
    for (var first = 0u; first < lighting.blockers; first += WORKGROUP) {
        workgroupBarrier();
        if (first + lane < lighting.blockers) {
            tile[lane] = blockers[first + lane];
        }
        workgroupBarrier();
        let filled = select(0u, min(WORKGROUP, lighting.blockers - first), covered);
        for (var i = 0u; i < filled; i += 1u) {
            let blocker = replace(tile[i].center - receiver.position, receiver.normal, tile[i].radius);
            if (blocker.sine > 0.0) {
                f = sh$A_add_cap_log_saturating(f, blocker.sine, blocker.cosine, blocker.direction);
            }
        }
    }
    if (!inside) {
        return;
    }
    var result = vec3f(0.0);
    if (covered) {
        let accumulated = sh$A_exp_saturating(f);
        var visibility = array<f32, $C>();
        for (var i = 0u; i < $Cu; i += 1u) {
            visibility[i] = accumulated[i];
        }
        let shadowed = reflected(sh$N_product_cosine(visibility, receiver.normal));
        result = bounded(shadowed, reflected(sh$N_cosine(receiver.normal)));
    }
    radiance[index] = vec4f(result, 0.0);
}
