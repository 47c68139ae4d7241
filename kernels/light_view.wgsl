// Light view: how near what is seen from lights with sharp shadows is. Bodies are drawn into a picture of all views, side by side;
// of blocks of its texels the nearest is kept, of blocks of these, and of each view. Twin of sh_cpu's `light_view`.

#import shared/invocation
#import shared/body
#import shared/light_views
#import constants

@group(0) @binding(0) var<uniform> view: LightView;
@group(1) @binding(0) var<uniform> body: Body;

struct Seen {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
}

@vertex
fn view_vertex(@location(0) position: vec3f) -> Seen {
    let world = (body.world_from_object * vec4f(position, 1.0)).xyz;
    let seen = pictured(view, world);
    if (view.distant == 0.0) {
        return Seen(vec4f(seen.xy, view.near, seen.z), world);
    }
    return Seen(vec4f(seen.xy, (view.far - seen.z) / view.far, 1.0), world);
}

@fragment
fn view_fragment(seen: Seen) -> @location(0) f32 {
    return nearness_of(view, pictured(view, seen.position).z);
}

@group(0) @binding(0) var<uniform> source: PunctualScene;
@group(0) @binding(1) var nearest: texture_2d<f32>;
// Blocks of texels view by view, row by row; blocks of these; then one a view.
@group(0) @binding(2) var<storage, read_write> coarse: array<f32>;

@compute @workgroup_size(WORKGROUP)
fn coarsen(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    let across = source.side / VIEW_BLOCK;
    let blocks = across * across;
    if (index >= source.views * blocks) {
        return;
    }
    let number = index / blocks;
    let block = vec2u(index % across, index % blocks / across);
    let corner = vec2u(number % source.across, number / source.across) * source.side + block * VIEW_BLOCK;
    var most = NOWHERE;
    for (var y = 0u; y < VIEW_BLOCK; y += 1u) {
        for (var x = 0u; x < VIEW_BLOCK; x += 1u) {
            most = max(most, textureLoad(nearest, corner + vec2u(x, y), 0).r);
        }
    }
    coarse[index] = most;
}

@compute @workgroup_size(WORKGROUP)
fn coarsen_again(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    let below = source.side / VIEW_BLOCK;
    let across = below / VIEW_BLOCK;
    let blocks = across * across;
    if (index >= source.views * blocks) {
        return;
    }
    let block = vec2u(index % across, index % blocks / across);
    let first = (index / blocks * below + block.y * VIEW_BLOCK) * below + block.x * VIEW_BLOCK;
    coarse[source.views * below * below + index] = nearest_of(first, below, VIEW_BLOCK);
}

@compute @workgroup_size(WORKGROUP)
fn coarsen_last(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= source.views) {
        return;
    }
    let texels = source.side / VIEW_BLOCK;
    let below = texels / VIEW_BLOCK;
    let before = source.views * texels * texels;
    let last = before + source.views * below * below;
    coarse[last + index] = nearest_of(before + index * below * below, below, below);
}

// The nearest of a square of elements, of which the rows of `stride` begin at `first`.
fn nearest_of(first: u32, stride: u32, side: u32) -> f32 {
    var most = NOWHERE;
    for (var y = 0u; y < side; y += 1u) {
        for (var x = 0u; x < side; x += 1u) {
            most = max(most, coarse[first + y * stride + x]);
        }
    }
    return most;
}
