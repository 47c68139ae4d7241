// The environment map's radiance from a direction. Twin of sh_scene::EnvironmentMap.

// Angle of (x, y) from the x axis, in -pi..pi, within 4e-7: WGSL's atan2 may be 4096 units in the last
// place off, and drivers use that. The polynomial is that of Cephes' atanf (Moshier 1995).
fn angle_of(y: f32, x: f32) -> f32 {
    let low = min(abs(x), abs(y));
    let high = max(abs(x), abs(y));
    // Above tan(pi/8), turn by pi/4.
    let steep = low > 0.41421356 * high;
    let t = select(low, low - high, steep) / max(select(high, low + high, steep), 1e-30);
    let s = t * t;
    let series = ((0.0805374449538 * s - 0.138776856032) * s + 0.199777106478) * s - 0.333329491539;
    var angle = select(0.0, 0.78539816, steep) + t + t * s * series;
    angle = select(angle, 1.57079633 - angle, abs(y) > abs(x));
    angle = select(angle, 3.14159265 - angle, x < 0.0);
    return select(angle, -angle, y < 0.0);
}

// Bilinear between the four nearest texel centres, around the seam and clamped at the poles.
fn environment_radiance(direction: vec3f) -> vec3f {
    let size = vec2i(textureDimensions(environment));
    let u = 0.5 + angle_of(direction.x, -direction.z) / 6.28318531;
    let v = angle_of(length(direction.xz), direction.y) / 3.14159265;
    let x = u * f32(size.x) - 0.5;
    let y = clamp(v * f32(size.y) - 0.5, 0.0, f32(size.y - 1));
    let left = (i32(floor(x)) + size.x) % size.x;
    let right = (left + 1) % size.x;
    let top = i32(floor(y));
    let bottom = min(top + 1, size.y - 1);
    let upper = between(texel(left, top), texel(right, top), x - floor(x));
    let lower = between(texel(left, bottom), texel(right, bottom), x - floor(x));
    return between(upper, lower, y - floor(y));
}

fn between(a: vec3f, b: vec3f, weight: f32) -> vec3f {
    return a + (b - a) * weight;
}

fn texel(column: i32, row: i32) -> vec3f {
    return textureLoad(environment, vec2i(column, row), 0).rgb;
}
