// The records that Rust and WGSL share; a test compares both layouts.

// A point that is lit; sh_scene::Receiver.
struct Receiver {
    position: vec3f,
    covered: u32,
    normal: vec3f,
    object: u32,
}

// A sphere that blocks light; sh_scene::Sphere.
struct Sphere {
    center: vec3f,
    radius: f32,
}

// What is the same for all receivers: how many blockers there are, and the environment's radiance as SH
// coefficients (red, green, blue). Sized for the highest order, so that one record serves all.
struct Lighting {
    blockers: u32,
    coefficients: array<vec4f, 36>,
}
