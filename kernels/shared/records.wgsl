// The records that Rust and WGSL share; a test compares both layouts.

// A point that is lit; sh_scene::Receiver.
struct Receiver {
    position: vec3f,
    covered: u32,
    normal: vec3f,
    object: u32,
}

// A node of the tree of blockers, a leaf if `skip` is the next node; sh_scene::Node.
struct Node {
    center: vec3f,
    radius: f32,
    // Sum of the squared radii of all leaves below.
    area: f32,
    // The node above; the root has its own index.
    parent: u32,
    // The first node that is not below this one.
    skip: u32,
    sphere: u32,
}

// A disc in the sky or a glowing ball; sh_scene::Emitter. A receiver at p sees its middle at center - local p, and
// its angular radius has the sine `radius` over the length of that.
struct Emitter {
    center: vec3f,
    radius: f32,
    radiance: vec3f,
    local: f32,
    // What each band is multiplied with.
    gains: array<vec4f, 2>,
}

// What is the same for all receivers: how many nodes and emitters there are, how coarse cuts may be
// (sh_scene::Limits), and the environment's radiance as SH coefficients (red, green, blue). Sized for the highest
// order, so that one record serves all.
struct Lighting {
    nodes: u32,
    emitters: u32,
    sin_max: f32,
    sin_min: f32,
    coefficients: array<vec4f, 36>,
}

// Where light at half resolution will do for a sample; the constants of sh_scene::upsample.
struct UpsampleRule {
    min_weight: f32,
    max_spread: f32,
    normal_from: f32,
    corner: f32,
}
