// Light update: what every node of the tree of blockers sends on of the light that falls on the bodies' surfaces
// (Guerrero et al. 2008, section 5). Points of a surface become receivers (`place`), which the shadow pass lights;
// their radiance, weighted by the basis' integral over their directions' Voronoi cells, is what a sphere emits
// (`project`, equation 10); a node above the leaves emits their mean by cross-section (`raise`). Twin of sh_cpu's
// `light_update`.
//
// `place` and `project` have a workgroup a sphere, `raise` one a node.

#import shared/records
#import shared/invocation
#import shared/light
#import constants
#import library

// Only how many nodes there are.
@group(0) @binding(0) var<uniform> lighting: Lighting;
@group(0) @binding(1) var<storage, read> senders: array<Sender>;
// Sphere by sphere.
@group(0) @binding(2) var<storage, read> points: array<SurfacePoint>;
// The integral of every basis function of the highest order over each direction's cell.
@group(0) @binding(3) var<storage, read> cells: array<f32>;
// For each direction of each sphere which of its points stands for it, four to a word from the lowest byte on.
@group(0) @binding(5) var<storage, read> stands: array<u32>;
// How much of each sphere its body's other spheres leave to be seen: coefficients of order 6, in the frame of its
// directions.
@group(0) @binding(6) var<storage, read> exposed: array<f32>;
// What each node sends on: its coefficients, with those of how much of it can be seen, and the brightest that it is
// anywhere.
@group(0) @binding(4) var<storage, read_write> emission: array<vec4f>;

// Elements of `emission` a node.
const SENT: u32 = $Cu + 1u;

@group(1) @binding(0) var<storage, read_write> receivers: array<Receiver>;

@compute @workgroup_size(WORKGROUP)
fn place(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let sphere = workgroup.z * workgroups.y + workgroup.y;
    if (sphere >= arrayLength(&senders)) {
        return;
    }
    let first = senders[sphere].first;
    let end = min(first + senders[sphere].count, arrayLength(&points));
    for (var i = first + lane; i < end; i += WORKGROUP) {
        let position = senders[sphere].world_from_object * vec4f(points[i].position, 1.0);
        let normal = turned(points[i].normal, senders[sphere].turn);
        receivers[i] = Receiver(position.xyz, 1u, normal, senders[sphere].object);
    }
}

// A vector turned by a unit quaternion.
fn turned(v: vec3f, q: vec4f) -> vec3f {
    let across = 2.0 * cross(q.xyz, v);
    return v + q.w * across + cross(q.xyz, across);
}

// Light that reaches each point by itself, and what bodies have sent it in the bounce before: red, green, blue, 0.
@group(1) @binding(0) var<storage, read> radiance: array<vec4f>;
@group(1) @binding(1) var<storage, read> gathered: array<vec4f>;

// And what can be seen.
const CHANNELS: u32 = 4u;

// Coefficients, channel by channel.
var<workgroup> vector: array<array<f32, $C>, CHANNELS>;

// What a point sends on. Its albedo is already what its cell reflects.
fn sent(point: u32) -> vec3f {
    let all = points[point].albedo * (radiance[point].rgb + gathered[point].rgb);
    return bounded(all, all);
}

// Which of a sphere's points stands for a direction, or NO_POINT.
fn standing(sphere: u32, direction: u32) -> u32 {
    let word = stands[(sphere * DIRECTIONS + direction) / 4u];
    return (word >> (direction % 4u * 8u)) & 255u;
}

@compute @workgroup_size(WORKGROUP)
fn project(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let sphere = workgroup.z * workgroups.y + workgroup.y;
    if (sphere >= arrayLength(&senders) || senders[sphere].node >= lighting.nodes) {
        return;
    }
    let first = senders[sphere].first;
    let end = min(first + senders[sphere].count, arrayLength(&points));
    let target_at = senders[sphere].node * SENT;
    if (lane < $Cu) {
        var sum = vec3f(0.0);
        for (var j = 0u; j < DIRECTIONS; j += 1u) {
            let point = standing(sphere, j);
            if (point != NO_POINT && first + point < end) {
                sum += sent(first + point) * cells[j * MOST_COEFFICIENTS + lane];
            }
        }
        vector[0][lane] = sum.r;
        vector[1][lane] = sum.g;
        vector[2][lane] = sum.b;
        vector[3][lane] = exposed[sphere * MOST_COEFFICIENTS + lane];
    } else if (lane == $Cu) {
        var brightest = vec3f(0.0);
        for (var i = first; i < end; i += 1u) {
            brightest = max(brightest, sent(i));
        }
        emission[target_at + lane] = vec4f(brightest, 0.0);
    }
    workgroupBarrier();
    // From the frame of the directions to the world.
    if (lane < CHANNELS) {
        vector[lane] = sh$N_rotate(vector[lane], senders[sphere].frame);
    }
    workgroupBarrier();
    if (lane < $Cu) {
        emission[target_at + lane] = vec4f(vector[0][lane], vector[1][lane], vector[2][lane], vector[3][lane]);
    }
}

// Each before those below it.
@group(1) @binding(0) var<storage, read> nodes: array<Node>;

@compute @workgroup_size(WORKGROUP)
fn raise(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let own = workgroup.z * workgroups.y + workgroup.y;
    if (own >= lighting.nodes || lane >= SENT) {
        return;
    }
    let whole = nodes[own];
    if (whole.skip <= own + 1u) {
        return;
    }
    var sum = vec4f(0.0);
    var brightest = vec4f(0.0);
    for (var at = own + 1u; at < min(whole.skip, lighting.nodes); at += 1u) {
        if (nodes[at].skip <= at + 1u) {
            let leaf = emission[at * SENT + lane];
            if (whole.area > 0.0) {
                sum += nodes[at].area / whole.area * emission[at * SENT].a / ROOT_FOUR_PI * leaf;
            }
            brightest = max(brightest, leaf);
        }
    }
    emission[own * SENT + lane] = select(sum, brightest, lane == $Cu);
}
