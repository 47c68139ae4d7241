// Shadow: light through the visibility of all blocker spheres, for every receiver (Ren et al. 2006, section 8). The
// log visibilities of the blockers are summed, in the order of accumulation, exponentiated and multiplied with the cosine
// lobe once; the bands that the light has of that are dotted with it. Twin of sh_cpu's `cut` and `shadow`.
//
// Receivers of a cluster share the cut of blockers that a workgroup finds in its memory, a chunk of the tree at a
// time: workgroup (x, y, z) has the receivers from 64 x on of cluster z * rows + y.

#import shared/records
#import shared/invocation
#import shared/lit
#import shared/gloss
#import shared/scan
#import shared/bounds
#import shared/visibility
#import shared/behind
#import shared/log_shading
#import shared/light
#import shared/emitted
#import constants
#import library

@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> emitters: array<Emitter>;
// Each before those below it.
@group(0) @binding(2) var<storage, read> nodes: array<Node>;
// Where the picture is seen from.
@group(0) @binding(3) var<uniform> eye: vec4f;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// First receiver and how many.
@group(1) @binding(1) var<storage, read> clusters: array<vec2u>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(2) var<storage, read_write> radiance: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
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
    let covered = is_lit(receiver);
    sum_up_to(lane, u32(covered));
    if (workgroupUniformLoad(&sums[WORKGROUP - 1u]) == 0u) {
        if (inside) {
            radiance[index] = vec4f(0.0);
        }
        return;
    }
    let bounds = cluster_bounds(first, count, lane);
    let gloss = gloss_of(receiver, eye.xyz);
    // First all light, and then one by one the lamps that may have blockers behind them.
    var result = vec3f(0.0);
    var lamps = 0u;
    for (var turn = 0u; turn <= rounds(); turn += 1u) {
        let lamp = turn - 1u;
        if (lamp != NO_LAMP && (lamps >> lamp & 1u) == 0u) {
            continue;
        }
        let found = log_visibility(receiver, bounds, lane, lamp);
        if (lamp == NO_LAMP) {
            lamps = found.lamps;
        }
        if (!covered) {
            continue;
        }
        if (GLOSS && lamp == NO_LAMP) {
            let mirrored = mirrored_of(found.sum, gloss);
            result = bounded(reflected(mirrored), reflected(lobe_of(receiver, gloss)));
            if (!LAMPS) {
                continue;
            }
        }
        // Lamps are hidden as those who reflect diffusely have it: of a lobe little may be left where a lamp is.
        let transfer = transfer_of(found.sum, receiver.normal);
        let lobe = sh$N_cosine(receiver.normal);
        if (lamp != NO_LAMP) {
            result += emitted(transfer, lobe, receiver, gloss, lamp, lamp + 1u, 0u);
            continue;
        }
        if (!GLOSS) {
            result = bounded(reflected(transfer), reflected(lobe));
        }
        result += emitted(transfer, lobe, receiver, gloss, 0u, lighting.emitters, lamps);
    }
    if (inside) {
        radiance[index] = vec4f(result, 0.0);
    }
}

// What leads from light of the light's order to radiance, of the order of accumulation the lower bands.
fn transfer_of(sum: array<f32, $B>, normal: vec3f) -> array<f32, $C> {
    return lower(sh$A_transfer(sh$A_accumulated_log(sum), normal));
}

// The same for what is mirrored.
fn mirrored_of(sum: array<f32, $B>, gloss: Gloss) -> array<f32, $C> {
    let bands = sh$A_gloss_lobe(gloss.told, gloss.facing);
    return lower(sh$A_transfer_lobe(sh$A_accumulated_log(sum), gloss.axis, bands));
}

// The bands that the light has.
fn lower(all: array<f32, $B>) -> array<f32, $C> {
    var transfer = array<f32, $C>();
    for (var i = 0u; i < $Cu; i += 1u) {
        transfer[i] = all[i];
    }
    return transfer;
}
