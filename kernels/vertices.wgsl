// Vertices: a host's own vertex buffer as receivers.

#import shared/records
#import shared/invocation
#import constants

// Where the vertices stand, and where their position and normal lie: three floats each, counted in words.
struct VertexSource {
    world_from_object: mat4x4f,
    first: u32,
    stride: u32,
    normal: u32,
    object: u32,
}

@group(0) @binding(0) var<uniform> source: VertexSource;
@group(1) @binding(0) var<storage, read_write> receivers: array<Receiver>;
@group(1) @binding(1) var<storage, read> vertices: array<f32>;

@compute @workgroup_size(WORKGROUP)
fn from_vertices(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let at = source.first + index * source.stride;
    let place = source.world_from_object * vec4f(three(at), 1.0);
    let turn = source.world_from_object;
    let normal = three(at + source.normal);
    // Normals go with areas: by the matrix of cofactors. A mirrored body turns it inside out, which its sign undoes.
    let across = cross(turn[1].xyz, turn[2].xyz);
    let mirrored = select(1.0, -1.0, dot(turn[0].xyz, across) < 0.0);
    let turned = normal.x * across + normal.y * cross(turn[2].xyz, turn[0].xyz)
        + normal.z * cross(turn[0].xyz, turn[1].xyz);
    let size = length(turned);
    // A normal without length faces nowhere and is lit from nowhere.
    let unit = mirrored * turned / max(size, 1e-30);
    receivers[index] = Receiver(place.xyz, u32(size > 0.0), unit, source.object);
}

fn three(at: u32) -> vec3f {
    return vec3f(vertices[at], vertices[at + 1u], vertices[at + 2u]);
}
