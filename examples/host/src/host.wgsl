// The renderer's own passes: bodies into a G-buffer, and the G-buffer times radiance into the picture.

struct Frame {
    clip_from_world: mat4x4f,
    // Centre and radius; the first is the ground, a square.
    bodies: array<vec4f, 6>,
    albedos: array<vec4f, 6>,
}

@group(0) @binding(0) var<uniform> frame: Frame;

struct Vertex {
    @builtin(position) clip: vec4f,
    @location(0) normal: vec3f,
    @location(1) @interpolate(flat) albedo: vec4f,
}

// Two triangles for each of 96 by 48 cells of a sphere, with which this draws all bodies but the first.
@vertex fn body_vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) body: u32) -> Vertex {
    let corner = (vec2u(0x32u, 0x2cu) >> vec2u(index % 6u)) & vec2u(1u);
    let angle = vec2f(vec2u(index / 6u % 96u, index / 576u) + corner) * (3.14159265 / 48.0);
    var normal = vec3f(sin(angle.y) * cos(angle.x), cos(angle.y), sin(angle.y) * sin(angle.x));
    var offset = normal;
    if (body == 0u) {
        normal = vec3f(0.0, 1.0, 0.0);
        offset = vec3f(2.0 * vec2f(corner) - 1.0, 0.0).xzy;
    }
    let place = frame.bodies[body].xyz + frame.bodies[body].w * offset;
    return Vertex(frame.clip_from_world * vec4f(place, 1.0), normal, frame.albedos[body]);
}

struct Surface {
    @location(0) normal: vec4f,
    @location(1) albedo: vec4f,
}

@fragment fn body_fragment(vertex: Vertex) -> Surface {
    return Surface(vec4f(normalize(vertex.normal), 0.0), vertex.albedo);
}

@group(0) @binding(0) var albedos: texture_2d<f32>;
@group(0) @binding(1) var depths: texture_depth_2d;
@group(0) @binding(2) var radiance: texture_2d<f32>;

@vertex fn picture_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

// Two by two samples a pixel.
@fragment fn picture_fragment(@builtin(position) place: vec4f) -> @location(0) vec4f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < 4u; i += 1u) {
        let at = vec2u(place.xy) * 2u + vec2u(i & 1u, i >> 1u);
        let lit = textureLoad(albedos, at, 0).rgb * textureLoad(radiance, at, 0).rgb;
        sum += select(lit, vec3f(0.35, 0.5, 0.75), textureLoad(depths, at, 0) == 0.0) * 0.25;
    }
    return vec4f(sum, 1.0);
}
