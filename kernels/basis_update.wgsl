// Basis update: what bodies send on of the light that falls on them, told in few functions (Iwasaki et al. 2007, sections 5.2
// and 5.3). A point of each patch becomes a receiver (`place`), which the shadow pass lights; what falls on all of a body's
// gives the weights of its functions (`weigh`), these what each patch sends on, and what its body sends it itself (`shine`);
// of a region that is an SH vector by direction (`raise`). Twin of sh_cpu's `basis_update`.
//
// x counts 64 elements of a body, y and z count bodies.

#import shared/records
#import shared/invocation
#import constants
#import library

@group(0) @binding(0) var<storage, read> bodies: array<Basis>;

// Which body a workgroup works on.
fn body_of(workgroup: vec3u, workgroups: vec3u) -> u32 {
    return workgroup.z * workgroups.y + workgroup.y;
}

// Where a point of a body is among those of all: those come first that take light that bodies have sent.
fn place_of(body: u32, point: u32) -> u32 {
    let own = bodies[body];
    if (point < own.few) {
        return own.first_few + point;
    }
    let last = bodies[arrayLength(&bodies) - 1u];
    return last.first_few + last.few + own.first - own.first_few + point - own.few;
}

// The patch of a point: of every few the first, then all others.
fn patch_of(body: u32, point: u32) -> u32 {
    let few = bodies[body].few;
    if (few == bodies[body].patches) {
        return point;
    }
    if (point < few) {
        return point * FEWER;
    }
    let rest = point - few;
    return rest / (FEWER - 1u) * FEWER + 1u + rest % (FEWER - 1u);
}

// Of each point, in the order in which they are lit: position and normal, object space.
@group(1) @binding(0) var<storage, read> points: array<vec4f>;
@group(1) @binding(1) var<storage, read_write> receivers: array<Receiver>;

@compute @workgroup_size(WORKGROUP)
fn place(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let body = body_of(workgroup, workgroups);
    let own = workgroup.x * WORKGROUP + lane;
    if (body >= arrayLength(&bodies) || own >= bodies[body].patches) {
        return;
    }
    let at = bodies[body].first + own;
    let matrix = bodies[body].world_from_object;
    let position = matrix * vec4f(points[2u * at].xyz, 1.0);
    let normal = (matrix * vec4f(points[2u * at + 1u].xyz, 0.0)).xyz;
    let scale = bodies[body].scale;
    receivers[place_of(body, own)] = Receiver(position.xyz, 1u, normal / max(scale, NEAREST), bodies[body].object);
}

// Of each function at all patches, and then at the few, body by body.
@group(1) @binding(0) var<storage, read> duals: array<f32>;
@group(1) @binding(1) var<storage, read> radiance: array<vec4f>;
@group(1) @binding(2) var<storage, read> gathered: array<vec4f>;
// What `light` holds of the turn before.
@group(1) @binding(3) var<storage, read> before: array<vec4f>;
// Of each body's functions.
@group(1) @binding(4) var<storage, read_write> weights: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn weigh(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let body = body_of(workgroup, workgroups);
    if (body >= arrayLength(&bodies) || lane >= bodies[body].functions) {
        return;
    }
    let own = bodies[body];
    var sum = vec3f(0.0);
    for (var k = 0u; k < own.patches; k += 1u) {
        let at = patch_of(body, k);
        let itself = before[own.light + 2u * at + 1u].rgb;
        sum += duals[own.duals + lane * own.patches + at] * (radiance[place_of(body, k)].rgb + itself);
    }
    let others = own.duals + own.functions * own.patches;
    for (var k = 0u; k < own.few; k += 1u) {
        sum += duals[others + lane * own.few + k] * gathered[own.first_few + k].rgb;
    }
    weights[own.weights + lane] = vec4f(sum, 0.0);
}

// Of each patch: what it sends on of each function, and what its body sends it (red, green, blue, 0), patch by patch.
@group(1) @binding(0) var<storage, read> sends: array<vec4f>;
@group(1) @binding(1) var<storage, read> owns: array<vec4f>;
@group(1) @binding(2) var<storage, read> weighed: array<vec4f>;
// Of each body: what each patch sends on and what its body sends it, then coefficients of regions, then the brightest.
@group(1) @binding(3) var<storage, read_write> light: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn shine(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let body = body_of(workgroup, workgroups);
    let at = workgroup.x * WORKGROUP + lane;
    if (body >= arrayLength(&bodies) || at >= bodies[body].patches) {
        return;
    }
    let own = bodies[body];
    var sent = vec3f(0.0);
    var itself = vec3f(0.0);
    for (var i = 0u; i < own.functions; i += 1u) {
        let weight = weighed[own.weights + i].rgb;
        sent += sends[own.sends + at * own.functions + i].rgb * weight;
        if (own.own != 0u) {
            itself += owns[own.sends + at * own.functions + i].rgb * weight;
        }
    }
    light[own.light + 2u * at] = vec4f(max(sent, vec3f(0.0)), 0.0);
    light[own.light + 2u * at + 1u] = vec4f(max(itself, vec3f(0.0)), 0.0);
}

// Of each patch: coefficients of order 6.
@group(1) @binding(0) var<storage, read> lobes: array<f32>;

@compute @workgroup_size(WORKGROUP)
fn raise(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let body = body_of(workgroup, workgroups);
    let at = workgroup.x * WORKGROUP + lane;
    if (body >= arrayLength(&bodies)) {
        return;
    }
    let own = bodies[body];
    let regions = own.patches / REGION_PATCHES;
    let target_at = own.light + 2u * own.patches + at;
    if (at < regions * $Cu) {
        var sum = vec3f(0.0);
        for (var k = 0u; k < REGION_PATCHES; k += 1u) {
            let patch_at = at / $Cu * REGION_PATCHES + k;
            let lobe = lobes[(own.first + patch_at) * MOST_COEFFICIENTS + at % $Cu];
            sum += lobe * light[own.light + 2u * patch_at].rgb;
        }
        light[target_at] = vec4f(sum, 0.0);
    } else if (at == regions * $Cu) {
        var brightest = vec3f(0.0);
        for (var k = 0u; k < own.patches; k += 1u) {
            brightest = max(brightest, light[own.light + 2u * k].rgb);
        }
        light[target_at] = vec4f(brightest, 0.0);
    }
}
