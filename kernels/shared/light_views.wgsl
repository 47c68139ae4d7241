// What lights with sharp shadows see: sh_scene::LightView, and the lights themselves.

struct LightView {
    origin: vec3f,
    // 1 for a sun, else 0.
    distant: f32,
    // From the middle to the right edge of the picture; `up` is as long.
    right: vec3f,
    far: f32,
    up: vec3f,
    near: f32,
    forward: vec3f,
    // One over the length of `right`.
    inverse: f32,
}

// How many lights and views there are, and where their pictures lie.
struct PunctualScene {
    lights: u32,
    views: u32,
    // Texels along the side of a view.
    side: u32,
    // Views along the side of the picture that holds them all.
    across: u32,
    // 1 where there is a ground.
    ground: u32,
    ground_height: f32,
    tail: vec2u,
}

// A place's picture, from -1 to 1 across and up, and its depth along the view's axis.
fn pictured(view: LightView, place: vec3f) -> vec3f {
    let relative = place - view.origin;
    let depth = dot(relative, view.forward);
    let scale = view.inverse * view.inverse;
    return vec3f(dot(relative, view.right) * scale, dot(relative, view.up) * scale, depth);
}

// How near something is that lies so deep: it falls with distance.
fn nearness_of(view: LightView, depth: f32) -> f32 {
    return select(view.far - depth, 1.0 / depth, view.distant == 0.0);
}

// The place of which something is the picture.
fn unpictured(view: LightView, across: f32, up: f32, nearness: f32) -> vec3f {
    let aside = view.right * across + view.up * up;
    if (view.distant == 0.0) {
        return view.origin + (view.forward + aside) / nearness;
    }
    return view.origin + aside + view.forward * (view.far - nearness);
}
