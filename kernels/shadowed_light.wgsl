// Shadowed light: what the shadow pass multiplies with the cosine lobe, as it is: light through the visibility of all
// blocker spheres, an SH vector for every receiver, for BRDFs and normal maps of the host's. Product of visibility with
// the environment and all analytic lights, channel by channel (Ren et al. 2006, section 8, without the lobe).
//
// Clusters and workgroups are those of `shadow`.

#import shared/records
#import shared/invocation
#import shared/lit
#import shared/scan
#import shared/bounds
#import shared/visibility
#import shared/behind
#import shared/log_saturating
#import shared/light
#import shared/emitted
#import constants
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

@compute @workgroup_size(WORKGROUP)
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
    let covered = is_lit(receiver);
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
    // First all light, and then one by one the lamps that may have blockers behind them.
    var product = array<vec3f, $C>();
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
        var all = array<vec3f, $C>();
        if (lamp == NO_LAMP) {
            for (var i = 0u; i < $Cu; i += 1u) {
                all[i] = lighting.coefficients[i].rgb;
            }
            all = with_lamps(all, receiver.position, 0u, lighting.emitters, lamps);
        } else {
            all = with_lamps(all, receiver.position, lamp, lamp + 1u, 0u);
        }
        let visibility = visibility_of(found.sum);
        // Channel by channel, so that the product is compiled once.
        for (var c = 0u; c < 3u; c += 1u) {
            var channel = array<f32, $C>();
            for (var i = 0u; i < $Cu; i += 1u) {
                channel[i] = all[i][c];
            }
            let one = sh$N_product(visibility, channel);
            for (var i = 0u; i < $Cu; i += 1u) {
                product[i][c] += one[i];
            }
        }
    }
    if (inside) {
        for (var i = 0u; i < $Cu; i += 1u) {
            light[index * $Cu + i] = vec4f(number(product[i]), 0.0);
        }
    }
}

// Light, and that of analytic lights without blockers: those from `first` to before `end`, without those whose bit is set.
fn with_lamps(all: array<vec3f, $C>, position: vec3f, first: u32, end: u32, without: u32) -> array<vec3f, $C> {
    var sum = all;
    for (var at = first; LAMPS && at < end; at += 1u) {
        if (at < MOST_LAMPS && (without >> at & 1u) != 0u) {
            continue;
        }
        let seen = shown(at, position);
        let own = emitter_light(at, seen);
        let radiance = emitter_radiance(at, seen);
        for (var i = 0u; i < $Cu; i += 1u) {
            sum[i] += own[i] * radiance;
        }
    }
    return sum;
}

// Visibility behind all blockers, of which the light's order has the lower bands.
fn visibility_of(sum: array<f32, $B>) -> array<f32, $C> {
    let accumulated = sh$A_exp_saturating(sh$A_accumulated_log(sum));
    var visibility = array<f32, $C>();
    for (var i = 0u; i < $Cu; i += 1u) {
        visibility[i] = accumulated[i];
    }
    return visibility;
}
