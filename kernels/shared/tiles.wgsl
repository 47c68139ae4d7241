// How a grid is stored: tile by tile, each row by row. Twin of sh_scene::Tiles.

#import constants

// Where the cell of a column and row is stored, in a grid that many tiles across.
fn tile_index(column: u32, row: u32, tiles_across: u32) -> u32 {
    let tile = row / SIDE * tiles_across + column / SIDE;
    return tile * AREA + row % SIDE * SIDE + column % SIDE;
}

// The column and row of what is stored at an index. They may lie beyond the grid, at the right and at the bottom.
fn tile_cell(index: u32, tiles_across: u32) -> vec2u {
    let tile = index / AREA;
    let inside = vec2u(index % SIDE, index % AREA / SIDE);
    return vec2u(tile % tiles_across, tile / tiles_across) * SIDE + inside;
}

// Tiles across a grid of so many columns.
fn tiles_across(columns: u32) -> u32 {
    return (columns + SIDE - 1u) / SIDE;
}
