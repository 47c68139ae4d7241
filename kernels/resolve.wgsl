// Resolve: samples to pixels. A sample shows its albedo times its radiance, or the environment where
// nothing is hit; a pixel is the mean of its OVERSAMPLE x OVERSAMPLE samples. Twin of sh_cpu's `resolve`.

#import shared/records
#import shared/invocation
#import shared/band
#import shared/tiles
#import shared/environment
#import shared/gloss
#import constants
#import library

@group(0) @binding(0) var<uniform> band: Band;
@group(0) @binding(1) var environment: texture_2d<f32>;
// This band's samples, tile by tile.
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
@group(1) @binding(1) var<storage, read> albedo: array<vec4f>;
@group(1) @binding(2) var<storage, read> radiance: array<vec4f>;
// The mean of what those samples that mirror light see in their lobe.
@group(1) @binding(4) var<storage, read> mirrored: array<vec4f>;
// This band's pixels, row by row: linear red, green, blue, and the share of samples that hit something.
@group(1) @binding(3) var<storage, read_write> picture: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn resolve(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&picture)) {
        return;
    }
    let width = band.columns / OVERSAMPLE;
    let pixel = vec2u(index % width, index / width);
    var sum = vec4f(0.0);
    for (var y = 0u; y < OVERSAMPLE; y += 1u) {
        for (var x = 0u; x < OVERSAMPLE; x += 1u) {
            let place = pixel * OVERSAMPLE + vec2u(x, y);
            let receiver = tile_index(place.x, place.y, tiles_across(band.columns));
            if (receivers[receiver].covered != 0u) {
                sum += vec4f(shown(receiver), 1.0);
            } else {
                sum += vec4f(environment_radiance(sample_ray(band, place.x, place.y)), 0.0);
            }
        }
    }
    picture[index] = sum / f32(OVERSAMPLE * OVERSAMPLE);
}

// What a covered sample sends to the eye.
fn shown(sample: u32) -> vec3f {
    let base = albedo[sample];
    let receiver = receivers[sample];
    if (!GLOSS || !is_lit(receiver)) {
        return base.rgb * radiance[sample].rgb;
    }
    let away = band.eye - receiver.position;
    let view = away * (1.0 / max(length(away), NEAREST));
    let facing = facing_of(dot(view, receiver.normal));
    let energy = sh$N_gloss_energy(roughness_of(receiver), facing);
    let front = (base.rgb - DIELECTRIC) * base.a + DIELECTRIC;
    let matte = (1.0 - base.a) * (1.0 - reflectance(vec3f(DIELECTRIC), energy).x);
    return base.rgb * matte * radiance[sample].rgb + reflectance(front, energy) * mirrored[sample].rgb;
}

// What is mirrored of an even sky, by the reflectance from the front: sh_core::gloss.
fn reflectance(front: vec3f, energy: vec2f) -> vec3f {
    let once = front * (energy.x - energy.y) + energy.y;
    return min(once * (front * (1.0 / energy.x - 1.0) + 1.0), vec3f(1.0));
}
