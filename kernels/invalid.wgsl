// Invalid: how many of a pixel's samples have radiance that is no number, infinite or below 0 in a channel. Bits are
// looked at, since a compiler may take it that no value is one of the first two. Twin of sh_cpu's `invalid`.

#import shared/records
#import shared/invocation
#import shared/band
#import shared/tiles
#import constants

@group(0) @binding(0) var<uniform> band: Band;
// This band's samples, tile by tile.
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
@group(1) @binding(1) var<storage, read> radiance: array<vec4f>;
// This band's pixels, row by row: samples that are no number, infinite, negative, and all that met a surface.
@group(1) @binding(2) var<storage, read_write> invalid_samples: array<vec4u>;

@compute @workgroup_size(WORKGROUP)
fn invalid(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&invalid_samples)) {
        return;
    }
    let width = band.columns / OVERSAMPLE;
    let pixel = vec2u(index % width, index / width);
    var counts = vec4u(0u);
    for (var y = 0u; y < OVERSAMPLE; y += 1u) {
        for (var x = 0u; x < OVERSAMPLE; x += 1u) {
            let place = pixel * OVERSAMPLE + vec2u(x, y);
            let sample = tile_index(place.x, place.y, tiles_across(band.columns));
            if (receivers[sample].covered != 0u) {
                counts += what(bitcast<vec3u>(radiance[sample].rgb));
            }
        }
    }
    invalid_samples[index] = counts;
}

// Which count a sample of these bits goes to, and 1 for itself.
fn what(bits: vec3u) -> vec4u {
    let size = bits & vec3u(0x7fffffffu);
    let infinity = vec3u(0x7f800000u);
    if (any(size > infinity)) {
        return vec4u(1u, 0u, 0u, 1u);
    }
    if (any(size == infinity)) {
        return vec4u(0u, 1u, 0u, 1u);
    }
    // -0 is 0.
    if (any((bits != size) & (size != vec3u(0u)))) {
        return vec4u(0u, 0u, 1u, 1u);
    }
    return vec4u(0u, 0u, 0u, 1u);
}
