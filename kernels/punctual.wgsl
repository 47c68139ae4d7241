// Punctual lights: spots, points and suns, added to what every receiver gets already, as far as nothing is in the way. Twin of sh_cpu's
// `punctual` and `light_views`, where the reasons stand.

#import shared/records
#import shared/invocation
#import shared/lit
#import shared/gloss
#import shared/light
#import shared/light_views
#import constants
#import library

// A spot, a point or a sun: sh_scene::PunctualRecord.
struct PunctualRecord {
    position: vec3f,
    radius: f32,
    axis: vec3f,
    outer: f32,
    radiance: vec3f,
    steep: f32,
    distant: f32,
    first: u32,
    views: u32,
    unused: u32,
}

@group(0) @binding(0) var<uniform> source: PunctualScene;
@group(0) @binding(1) var<storage, read> lights: array<PunctualRecord>;
@group(0) @binding(2) var<storage, read> views: array<LightView>;
// All views side by side.
@group(0) @binding(3) var nearest: texture_2d<f32>;
@group(0) @binding(4) var<storage, read> coarse: array<f32>;
// Where the picture is seen from.
@group(0) @binding(5) var<uniform> eye: vec4f;
@group(1) @binding(0) var<storage, read> receivers: array<Receiver>;
// Radiance reflected by albedo 1: red, green, blue, 0.
@group(1) @binding(1) var<storage, read_write> radiance: array<vec4f>;

// Whether anything may be in the way.
override VIEWS: bool = true;

@compute @workgroup_size(WORKGROUP)
fn punctual(
    @builtin(workgroup_id) workgroup: vec3u,
    @builtin(num_workgroups) workgroups: vec3u,
    @builtin(local_invocation_index) lane: u32,
) {
    let index = element_index(workgroup, workgroups, lane);
    if (index >= arrayLength(&receivers)) {
        return;
    }
    let receiver = receivers[index];
    if (!is_lit(receiver)) {
        return;
    }
    let gloss = gloss_of(receiver, eye.xyz);
    // A sample's own turn among the four of its pixel.
    let turn = index % SIDE % 2u + index / SIDE % 2u * 2u;
    var sum = vec3f(0.0);
    for (var i = 0u; i < source.lights; i += 1u) {
        let light = lights[i];
        let seen = seen_light(light, receiver.position);
        let cosine = dot(seen.direction, receiver.normal);
        var share = seen.share * mean_cosine(cosine, seen.sine);
        // What is no number is dark.
        if (!(share > 0.0)) {
            continue;
        }
        let along = dot(seen.direction, gloss.view);
        share = reflects(share, gloss, cosine, along, 0.25 * seen.sine * seen.sine);
        if (VIEWS) {
            share *= visible(light, receiver.position, receiver.normal, turn);
        }
        sum += share * light.radiance;
    }
    radiance[index] += vec4f(number(sum), 0.0);
}

// Where a place sees a light.
struct SeenLight {
    direction: vec3f,
    sine: f32,
    share: f32,
}

fn seen_light(light: PunctualRecord, place: vec3f) -> SeenLight {
    if (light.distant != 0.0) {
        let sine = light.radius / sqrt(1.0 + light.radius * light.radius);
        return SeenLight(light.position, sine, 1.0);
    }
    let towards = light.position - place;
    let far = max(max(length(towards), light.radius), CLOSEST);
    let direction = towards / far;
    // Of both unit vectors half the squared difference is 1 - the cosine.
    let aside = direction + light.axis;
    let within = clamp((light.outer - 0.5 * dot(aside, aside)) * light.steep, 0.0, 1.0);
    return SeenLight(direction, min(light.radius / far, 1.0), within * within / (far * far));
}

// The mean cosine of what of a ball is above the horizon.
fn mean_cosine(cosine: f32, sine: f32) -> f32 {
    if (cosine >= sine) {
        return max(cosine, 0.0);
    }
    let over = max(cosine + sine, 0.0);
    return over * over / max(4.0 * sine, TINY);
}

// What a receiver looks up.
struct Look {
    view: LightView,
    index: u32,
    radius: f32,
    place: vec3f,
    normal: vec3f,
    // Its picture, in texels from the upper left corner.
    at: vec2f,
    nearness: f32,
    // What is nearer to the light than it by less than that is not told apart from it, in metres.
    footprint: f32,
    // How near the receiver's own plane is at a texel: a constant, and what is added for each texel to the right and down.
    plane: vec3f,
}

// The share of a light that a place sees.
fn visible(light: PunctualRecord, place: vec3f, normal: vec3f, turn: u32) -> f32 {
    if (source.ground != 0u) {
        let level = select(0.0, source.ground_height, light.distant == 0.0);
        if ((place.y < source.ground_height) != (light.position.y < level)) {
            return 0.0;
        }
    }
    var index = light.first;
    var deepest = depth_of(index, place);
    for (var other = light.first + 1u; other < light.first + light.views; other += 1u) {
        let depth = depth_of(other, place);
        if (depth > deepest) {
            index = other;
            deepest = depth;
        }
    }
    let view = views[index];
    let seen = pictured(view, place);
    if (!(seen.z > view.near)) {
        return 1.0;
    }
    let nearness = nearness_of(view, seen.z);
    let picture = seen.xy * select(1.0, nearness, view.distant == 0.0);
    if (!(abs(picture.x) <= 1.0 && abs(picture.y) <= 1.0)) {
        return 1.0;
    }
    let side = f32(source.side);
    let texel = 2.0 / (side * view.inverse);
    let footprint = select(texel, texel / nearness, view.distant == 0.0);
    let at = vec2f(0.5 + 0.5 * picture.x, 0.5 - 0.5 * picture.y) * side;
    let plane = plane_of(view, place, normal, 2.0 / side);
    let look = Look(view, index, light.radius, place, normal, at, nearness, footprint, plane);
    return looked(look, turn);
}

fn depth_of(index: u32, place: vec3f) -> f32 {
    return dot(place - views[index].origin, views[index].forward);
}

fn looked(look: Look, turn: u32) -> f32 {
    let blocks = source.side / VIEW_BLOCK;
    let above = blocks / VIEW_BLOCK;
    var near = coarse[source.views * (blocks * blocks + above * above) + look.index];
    var reach = LEAST_BLUR;
    for (var i = 0; i < 2; i += 1) {
        if (near <= look.nearness) {
            return 1.0;
        }
        reach = blurred(look, near);
        near = nearest_within(look, reach);
    }
    if (near <= look.nearness) {
        return 1.0;
    }
    reach = min(reach, blurred(look, near));
    var found = spread(look, reach, select(SEARCH_TAPS, SHARP_TAPS, reach < SHARP), turn);
    // Something near by may have spread points so far that what hides the light lies between them.
    for (var i = 0; i < 2 && found.x == 0.0 && found.w > look.nearness; i += 1) {
        reach = blurred(look, found.w);
        found = spread(look, reach, select(SEARCH_TAPS, SHARP_TAPS, reach < SHARP), turn);
    }
    if (found.x == 0.0) {
        return 1.0;
    }
    let width = blurred(look, found.z / found.x);
    if (reach < SHARP && width == reach) {
        // These are the texels that were just looked at.
        return found.y / (found.x + found.y);
    }
    let left = spread(look, width, select(SHADOW_TAPS, SHARP_TAPS, width < SHARP), turn);
    return left.y / max(left.x + left.y, 1.0);
}

// By how many texels the shadow of something so near is blurred: by so much at least that texels have no corners.
fn blurred(look: Look, nearness: f32) -> f32 {
    return clamp(shifted(look, nearness), LEAST_BLUR, WIDE * 0.5 * f32(source.side));
}

// By how many texels the light's edge shifts something so near over the receiver's picture.
fn shifted(look: Look, nearness: f32) -> f32 {
    return look.radius * (nearness - look.nearness) * look.view.inverse * 0.5 * f32(source.side);
}

// The nearest of all that is in blocks which come within so many texels.
fn nearest_within(look: Look, reach: f32) -> f32 {
    let block = f32(VIEW_BLOCK);
    let blocks = source.side / VIEW_BLOCK;
    var size = block;
    var across = blocks;
    var first = 0u;
    if (2.0 * reach > 3.0 * block) {
        size = block * block;
        across = blocks / VIEW_BLOCK;
        first = source.views * blocks * blocks;
    }
    first += look.index * across * across;
    let last = f32(across) - 1.0;
    let low = vec2u(clamp(floor((look.at - reach) / size), vec2f(0.0), vec2f(last)));
    let high = vec2u(clamp(floor((look.at + reach) / size), vec2f(0.0), vec2f(last)));
    var near = NOWHERE;
    for (var row = low.y; row <= high.y; row += 1u) {
        for (var column = low.x; column <= high.x; column += 1u) {
            near = max(near, coarse[first + row * across + column]);
        }
    }
    return near;
}

// Looks at texels on a spiral that fills a disc evenly: how many are in the way, how many are not, and how near the former are in
// sum. What hides nothing only because the light is too small for it is neither; how near the nearest of that is comes last.
fn spread(look: Look, reach: f32, taps: u32, turn: u32) -> vec4f {
    let side = f32(source.side);
    let corner = vec2u(look.index % source.across, look.index / source.across) * source.side;
    var direction = vec2f(1.0, 0.0);
    if (turn == 1u) {
        direction = vec2f(0.0, 1.0);
    } else if (turn == 2u) {
        direction = vec2f(-1.0, 0.0);
    } else if (turn == 3u) {
        direction = vec2f(0.0, -1.0);
    }
    var found = vec4f(0.0, 0.0, 0.0, NOWHERE);
    for (var tap = 0u; tap < taps; tap += 1u) {
        let far = reach * sqrt((f32(tap) + 0.5) / f32(taps));
        let cell = clamp(floor(look.at + far * direction), vec2f(0.0), vec2f(side - 1.0));
        let near = textureLoad(nearest, corner + vec2u(cell), 0).r;
        let plane = look.plane.x + look.plane.y * (cell.x + 0.5) + look.plane.z * (cell.y + 0.5);
        if (near <= plane || !is_in_the_way(look, cell + 0.5, near)) {
            found.y += 1.0;
        } else if (far <= shifted(look, near) + 1.0) {
            found += vec4f(1.0, 0.0, near, 0.0);
        } else {
            found.w = max(found.w, near);
        }
        direction = vec2f(
            direction.x * GOLDEN_COSINE - direction.y * GOLDEN_SINE,
            direction.x * GOLDEN_SINE + direction.y * GOLDEN_COSINE,
        );
    }
    return found;
}

// How near a plane is in a view, whose texels are `scale` of the picture wide.
fn plane_of(view: LightView, place: vec3f, normal: vec3f, scale: f32) -> vec3f {
    let right = dot(normal, view.right);
    let up = dot(normal, view.up);
    let ahead = dot(normal, view.forward);
    let behind = dot(normal, place - view.origin);
    let whole = select(ahead * view.far - behind, ahead, view.distant == 0.0);
    let by = select(ahead, behind, view.distant == 0.0);
    if (!(by < 0.0)) {
        return vec3f(NOWHERE, 0.0, 0.0);
    }
    return vec3f((whole - right + up) / by, right * scale / by, -up * scale / by);
}

fn is_in_the_way(look: Look, cell: vec2f, near: f32) -> bool {
    if (near <= look.nearness) {
        return false;
    }
    let scale = 2.0 / f32(source.side);
    let other = unpictured(look.view, cell.x * scale - 1.0, 1.0 - cell.y * scale, near);
    let towards = other - look.place;
    let before = select(
        near - look.nearness,
        1.0 / look.nearness - 1.0 / near,
        look.view.distant == 0.0,
    );
    let rises = RISE * length(towards) + 0.5 * look.footprint;
    return before > look.footprint && dot(towards, look.normal) > rises;
}
