// A horizontal band of a grid of rays, and the camera that they leave. Rays go through the cells' centres.

struct Band {
    // World to the clip space of this band alone; depth 1 at `near`, towards 0 at infinity.
    clip_from_world: mat4x4f,
    eye: vec3f,
    near: f32,
    // The camera's axes; right and up as long as half the picture's extent at distance 1.
    right: vec3f,
    // The first row of cells, counted from the picture's top.
    first_row: u32,
    up: vec3f,
    // How many rows of cells.
    rows: u32,
    forward: vec3f,
    // 1 where there is a ground plane.
    ground: u32,
    // The picture's extent in cells, across and down. Cells at the right and at the bottom may reach beyond it.
    extent: vec2f,
    columns: u32,
    ground_height: f32,
    ground_albedo: vec3f,
    // What two pixels cover at distance 1.
    footprint: f32,
    // The grid at half resolution: columns, rows, and the first row of those that lie under this band.
    half_columns: u32,
    half_rows: u32,
    half_first_row: u32,
}

// Direction, not normalised (1 along `forward`), through a cell of the band.
fn sample_ray(band: Band, column: u32, row: u32) -> vec3f {
    let cell = vec2f(f32(column) + 0.5, f32(band.first_row + row) + 0.5) / band.extent;
    return band.forward + band.right * (2.0 * cell.x - 1.0) + band.up * (1.0 - 2.0 * cell.y);
}
