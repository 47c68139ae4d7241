// A horizontal band of the picture's grid of samples, and the camera that looks through it. The grid is
// OVERSAMPLE times as fine as the picture, in each direction; rays go through the cells' centres.

const OVERSAMPLE: u32 = 2u;

struct Band {
    // World to the clip space of this band alone; depth 1 at `near`, towards 0 at infinity.
    clip_from_world: mat4x4f,
    eye: vec3f,
    near: f32,
    // The camera's axes; right and up as long as half the picture's extent at distance 1.
    right: vec3f,
    // The first row of samples, counted from the picture's top.
    first_row: u32,
    up: vec3f,
    // How many rows of samples.
    rows: u32,
    forward: vec3f,
    // 1 where there is a ground plane.
    ground: u32,
    // Samples of the whole picture, across and down.
    grid: vec2u,
    ground_height: f32,
    ground_albedo: vec3f,
}

// Direction, not normalised (1 along `forward`), through a sample of the band.
fn sample_ray(band: Band, column: u32, row: u32) -> vec3f {
    let cell = vec2f(f32(column) + 0.5, f32(band.first_row + row) + 0.5) / vec2f(band.grid);
    return band.forward + band.right * (2.0 * cell.x - 1.0) + band.up * (1.0 - 2.0 * cell.y);
}
