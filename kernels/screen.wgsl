// Screen: a host's own G-buffer as receivers, tile by tile, and radiance back into a texture of the host's.

#import shared/records
#import shared/invocation
#import shared/tiles
#import constants

// The G-buffer's size, the part of it at hand, how normals are stored (texel * scale + bias), and, where depth stands
// for position, what leads from clip space to the world and the depth of what is not covered.
struct ScreenSource {
    world_from_clip: mat4x4f,
    size: vec2u,
    first_row: u32,
    empty: f32,
    scale: f32,
    bias: f32,
}

@group(0) @binding(0) var<uniform> source: ScreenSource;
@group(1) @binding(0) var<storage, read_write> receivers: array<Receiver>;
@group(1) @binding(1) var normals: texture_2d<f32>;
// World position, and 0 in alpha where nothing is covered.
@group(1) @binding(2) var positions: texture_2d<f32>;
@group(1) @binding(2) var depths: texture_depth_2d;

// The pixel of a receiver, and whether there is one.
struct Pixel {
    at: vec2u,
    inside: bool,
}

fn pixel_of(index: u32) -> Pixel {
    let cell = tile_cell(index, tiles_across(source.size.x));
    let at = vec2u(cell.x, cell.y + source.first_row);
    return Pixel(at, all(at < source.size));
}

fn receiver_at(position: vec3f, normal: vec3f, covered: bool) -> Receiver {
    let facing = normal * source.scale + source.bias;
    let size = length(facing);
    // A normal without length faces nowhere and is lit from nowhere.
    return Receiver(position, u32(covered && size > 0.0), facing / max(size, 1e-30), 0u);
}

@compute @workgroup_size(WORKGROUP)
fn from_positions(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let pixel = pixel_of(index);
    var receiver = Receiver();
    if (pixel.inside) {
        let position = textureLoad(positions, pixel.at, 0);
        let normal = textureLoad(normals, pixel.at, 0).xyz;
        receiver = receiver_at(position.xyz, normal, position.w != 0.0);
    }
    receivers[index] = receiver;
}

@compute @workgroup_size(WORKGROUP)
fn from_depth(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let pixel = pixel_of(index);
    var receiver = Receiver();
    if (pixel.inside) {
        let depth = textureLoad(depths, pixel.at, 0);
        let across = (vec2f(pixel.at) + 0.5) / vec2f(source.size);
        let clip = vec4f(2.0 * across.x - 1.0, 1.0 - 2.0 * across.y, depth, 1.0);
        let place = source.world_from_clip * clip;
        let normal = textureLoad(normals, pixel.at, 0).xyz;
        receiver = receiver_at(place.xyz / place.w, normal, depth != source.empty);
    }
    receivers[index] = receiver;
}

@group(1) @binding(0) var<storage, read> radiance: array<vec4f>;
@group(1) @binding(1) var target_texture: texture_storage_2d<rgba16float, write>;

@compute @workgroup_size(WORKGROUP)
fn to_texture(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&radiance)) {
        return;
    }
    let pixel = pixel_of(index);
    if (pixel.inside) {
        textureStore(target_texture, pixel.at, radiance[index]);
    }
}
