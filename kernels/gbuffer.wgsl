// G-buffer: position, normal and albedo where the camera's rays first meet a surface. Bodies are rasterised
// with one fragment a ray, the infinite ground plane is drawn by a triangle that covers the band, and
// `pack` turns both textures into the buffers that the other passes read. Twin of sh_cpu's `gbuffer`.

#import shared/records
#import shared/body
#import shared/invocation
#import shared/band
#import shared/tiles
#import shared/octahedral
#import constants

@group(0) @binding(0) var<uniform> band: Band;
@group(1) @binding(0) var<uniform> body: Body;
// White where a body has no texture.
@group(1) @binding(1) var base_color: texture_2d<f32>;
// The same for roughness (green) and metallic (blue).
@group(1) @binding(2) var finish: texture_2d<f32>;

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) color: vec3f,
}

// Two textures of 128 bits a sample, the most that WebGPU's default limits allow: position and object;
// octahedral normal, albedo in 16 bits a channel, and in the last 16 bits, which are not 0 where something is hit, the finish.
struct Targets {
    @location(0) place: vec4u,
    @location(1) surface: vec4u,
}

fn targets(position: vec3f, object: u32, normal: vec3f, albedo: vec3f, packed: u32) -> Targets {
    let surface = vec4u(
        bitcast<vec2u>(octahedral_from_unit(normal)),
        pack2x16unorm(albedo.rg),
        pack2x16unorm(vec2f(albedo.b, 0.0)) | packed << 16u,
    );
    return Targets(vec4u(bitcast<vec3u>(position), object), surface);
}

@vertex
fn body_vertex(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) uv: vec2f,
    @location(3) color: vec3f,
) -> Fragment {
    let world = body.world_from_object * vec4f(position, 1.0);
    let turned = (body.world_from_object * vec4f(normal, 0.0)).xyz;
    return Fragment(band.clip_from_world * world, world.xyz, turned, uv, color);
}

// A texture, bilinear between texel centres, repeated in both directions. By hand, because a
// sampler's weights have 8 bits only.
fn textured(map: texture_2d<f32>, uv: vec2f) -> vec3f {
    let size = vec2i(textureDimensions(map));
    let place = fract(uv) * vec2f(size) - 0.5;
    let corner = floor(place);
    let weight = place - corner;
    let low = (vec2i(corner) + size) % size;
    let high = (low + 1) % size;
    let above = mix(texel(map, low.x, low.y), texel(map, high.x, low.y), weight.x);
    let below = mix(texel(map, low.x, high.y), texel(map, high.x, high.y), weight.x);
    return mix(above, below, weight.y);
}

fn texel(map: texture_2d<f32>, column: i32, row: i32) -> vec3f {
    return textureLoad(map, vec2i(column, row), 0).rgb;
}

// What a sample keeps of its finish, as sh_scene::Finish has it.
fn packed_finish(roughness: f32, metallic: f32) -> u32 {
    if (body.glossy == 0u || !(roughness < 1.0 || metallic > 0.0)) {
        return MATT;
    }
    let byte = 1u + u32(clamp(roughness, 0.0, 1.0) * ROUGHNESS_STEPS + 0.5);
    return byte | u32(clamp(metallic, 0.0, 1.0) * 255.0 + 0.5) << 8u;
}

@fragment
fn body_fragment(fragment: Fragment) -> Targets {
    // An open mesh seen from behind: the normal turns to the viewer's side. Seen from the front it is left
    // alone, even where the smooth normal leans away.
    let plane = cross(dpdx(fragment.position), dpdy(fragment.position));
    let behind = dot(plane, fragment.normal) * dot(plane, fragment.position - band.eye) > 0.0;
    let normal = normalize(select(fragment.normal, -fragment.normal, behind));
    let albedo = body.albedo * textured(base_color, fragment.uv) * fragment.color;
    let told = textured(finish, fragment.uv);
    let packed = packed_finish(body.roughness * told.g, body.metallic * told.b);
    return targets(fragment.position, body.object, normal, albedo, packed);
}

// A triangle that covers the band.
@vertex
fn ground_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

struct GroundTargets {
    @builtin(frag_depth) depth: f32,
    @location(0) place: vec4u,
    @location(1) surface: vec4u,
}

@fragment
fn ground_fragment(@builtin(position) place: vec4f) -> GroundTargets {
    // The ray advances 1 along `forward`, so its parameter is the depth.
    let ray = sample_ray(band, u32(place.x), u32(place.y));
    let drop = band.eye.y - band.ground_height;
    if (band.ground == 0u || drop <= 0.0 || ray.y > -HORIZON) {
        discard;
    }
    let depth = drop / -ray.y;
    let position = band.eye + depth * ray;
    let written = targets(
        vec3f(position.x, band.ground_height, position.z),
        GROUND,
        vec3f(0.0, 1.0, 0.0),
        band.ground_albedo,
        MATT,
    );
    return GroundTargets(min(band.near / depth, 1.0), written.place, written.surface);
}

// How much a ray must sink, for 1 along `forward`, to meet the ground at all.
const HORIZON: f32 = 1e-7;

// The body of the ground: none.
const GROUND: u32 = 0u;

@group(0) @binding(1) var places: texture_2d<u32>;
@group(0) @binding(2) var surfaces: texture_2d<u32>;
// Tile by tile; what lies beyond the grid is not covered.
@group(1) @binding(0) var<storage, read_write> receivers: array<Receiver>;
@group(1) @binding(1) var<storage, read_write> albedo: array<vec4f>;

@compute @workgroup_size(WORKGROUP)
fn pack(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let cell = tile_cell(index, tiles_across(band.columns));
    var surface = vec4u(0u);
    if (cell.x < band.columns && cell.y < band.rows) {
        surface = textureLoad(surfaces, cell, 0);
    }
    if (surface.w == 0u) {
        receivers[index] = Receiver();
        albedo[index] = vec4f(0.0);
        return;
    }
    let place = textureLoad(places, cell, 0);
    let normal = unit_from_octahedral(bitcast<vec2f>(surface.xy));
    let packed = surface.w >> 16u;
    var covered = 1u;
    if ((packed & MATT) != MATT) {
        covered |= (packed & MATT) << ROUGHNESS_SHIFT;
    }
    receivers[index] = Receiver(bitcast<vec3f>(place.xyz), covered, normal, place.w);
    let metallic = f32(packed >> 8u) / 255.0;
    albedo[index] = vec4f(unpack2x16unorm(surface.z), unpack2x16unorm(surface.w).x, metallic);
}
