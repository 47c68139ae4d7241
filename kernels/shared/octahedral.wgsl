// A unit vector as a point of the unfolded octahedron, both coordinates in -1..1 (Meyer et al. 2010).

fn octahedral_from_unit(unit: vec3f) -> vec2f {
    let flat = unit.xy / (abs(unit.x) + abs(unit.y) + abs(unit.z));
    return select((1.0 - abs(flat.yx)) * outward(flat), flat, unit.z >= 0.0);
}

fn unit_from_octahedral(flat: vec2f) -> vec3f {
    let z = 1.0 - abs(flat.x) - abs(flat.y);
    return normalize(vec3f(flat - outward(flat) * max(-z, 0.0), z));
}

// 1 or -1 for each coordinate, never 0.
fn outward(flat: vec2f) -> vec2f {
    return select(vec2f(-1.0), vec2f(1.0), flat >= vec2f(0.0));
}
