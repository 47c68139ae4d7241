// One body: where it stands and how it reflects.

struct Body {
    world_from_object: mat4x4f,
    albedo: vec3f,
    object: u32,
    // 1 where it mirrors light.
    glossy: u32,
    roughness: f32,
    metallic: f32,
    tail: u32,
}
