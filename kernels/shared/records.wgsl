// The records that Rust and WGSL share; a test compares both layouts.

#import constants

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
    // What a leaf's log visibility is multiplied with; of others the mean of those below.
    weight: f32,
    // The body of all leaves below, as receivers carry it; 0: several.
    object: u32,
}

// A disc in the sky or a glowing ball; sh_scene::Emitter. A receiver at p sees its middle at center - local p, and
// its angular radius has the sine `radius` over the length of that.
struct Emitter {
    center: vec3f,
    radius: f32,
    radiance: vec3f,
    local: f32,
    // What each band is multiplied with.
    gains: array<f32, MAX_ORDER>,
    // That of its distribution; 0: it is equally bright all over.
    order: u32,
    // How bright it is where, in parts of the radiance: SH coefficients (red, green, blue).
    distribution: array<vec4f, MOST_COEFFICIENTS>,
}

// What is the same for all receivers: how many nodes and emitters there are, how coarse cuts may be
// (sh_scene::Limits), and the environment's radiance as SH coefficients (red, green, blue). Sized for the highest
// order, so that one record serves all.
struct Lighting {
    nodes: u32,
    emitters: u32,
    sin_max: f32,
    sin_min: f32,
    coefficients: array<vec4f, MOST_COEFFICIENTS>,
}

// Where light at half resolution will do for a sample; the constants of sh_scene::upsample.
struct UpsampleRule {
    min_weight: f32,
    max_spread: f32,
    normal_from: f32,
    corner: f32,
}

// A point of a body's surface; sh_scene::SurfacePoint.
struct SurfacePoint {
    // In object space.
    position: vec3f,
    // Which of its sphere's directions it stands for.
    direction: u32,
    normal: vec3f,
    // In how much of the direction's cell the sphere has surface of its own.
    share: f32,
    albedo: vec3f,
}

// A sphere that sends light on: where its body stands, the body's rotation and that from the frame of the sphere's
// directions to the world as quaternions, the sphere's points, the index of its body and the node that it is.
struct Sender {
    world_from_object: mat4x4f,
    turn: vec4f,
    frame: vec4f,
    first: u32,
    count: u32,
    object: u32,
    node: u32,
}

// A rigid body whose light is told in few functions, and where it is; sh_gpu::records::Basis.
struct Basis {
    world_from_object: mat4x4f,
    object_from_world: mat4x4f,
    // The ball around it in the world.
    center: vec3f,
    radius: f32,
    // Metres of the world a metre of its own; 0: it is nowhere to be seen.
    scale: f32,
    // The body, as receivers carry it.
    object: u32,
    // Its first patch, and how many it has.
    first: u32,
    patches: u32,
    // How many functions; where their weights begin, and what tells them.
    functions: u32,
    weights: u32,
    duals: u32,
    sends: u32,
    // Where what its patches send on begins; and its regions.
    light: u32,
    // Whether it sends itself light.
    own: u32,
    // How many of its points take light that bodies have sent, and where they begin: those of all bodies come first.
    few: u32,
    first_few: u32,
}

// A flat part of a surface; sh_scene::basis::Disc.
struct Disc {
    center: vec3f,
    // As it is seen from its normal.
    area: f32,
    normal: vec3f,
    unused: f32,
}

// A disc and what of it is seen by direction: b; xx, yy, zz; xy, yz, zx; sh_scene::basis::Facet.
struct Facet {
    disc: Disc,
    escape: array<vec4f, 3>,
}

// A part of a body's surface, in the body's own space: as a whole, and, for who is near, as several; sh_scene::basis::Patch.
struct Patch {
    whole: Facet,
    discs: array<Disc, PATCH_SAMPLES>,
}

// Patches that lie together; sh_scene::basis::Region.
struct Region {
    center: vec3f,
    radius: f32,
    // These have no area where they are not flat.
    whole: Facet,
    quarters: array<Facet, QUARTERS>,
}
