//! The G-buffer pass: what every ray of a grid through a view sees.

use crate::device::check::check_view;
use crate::device::geometry::Geometry;
use crate::device::rays::Rays;
use crate::error::Error;
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::{Finish, Grid, Receiver, Tiles, View};
use std::ops::Range;

/// Receivers and albedo of some rows of tiles, in the order of [`Tiles`].
#[derive(Clone, Debug, Default)]
pub struct Gbuffer {
    /// Position, normal and object; `covered` is 0 where the view looks into the sky, and beyond the grid.
    pub receivers: Vec<Receiver>,
    /// Base colour, linear Rec.709, black where nothing is hit; and how metallic the surface is.
    pub albedo: Vec<[f32; 4]>,
}

/// Fills `out` with the rows of tiles `rows` of `grid`, reusing its memory. Tiles are cast in parallel; every ray
/// is its own, so that the result does not depend on the number of threads.
pub fn gbuffer(
    geometry: &Geometry,
    view: &View,
    grid: Grid,
    rows: Range<u32>,
    out: &mut Gbuffer,
) -> Result<(), Error> {
    check_view(view)?;
    let rays = Rays::new(view, grid);
    let across = grid.tiles().columns as usize;
    let count = across * rows.len() * Tiles::AREA;
    out.receivers.clear();
    out.receivers.resize(count, NOTHING);
    out.albedo.clear();
    out.albedo.resize(count, [0.0; 4]);
    let eye = Vec3A::from(view.camera.eye);
    out.receivers
        .par_chunks_mut(Tiles::AREA)
        .zip(out.albedo.par_chunks_mut(Tiles::AREA))
        .enumerate()
        .for_each(|(tile, (receivers, albedo))| {
            let side = Tiles::SIDE;
            let left = (tile % across) as u32 * side;
            let top = (rows.start + (tile / across) as u32) * side;
            for (i, (receiver, albedo)) in receivers.iter_mut().zip(albedo).enumerate() {
                let (x, y) = (left + i as u32 % side, top + i as u32 / side);
                if x >= grid.columns || y >= grid.rows {
                    continue;
                }
                if let Some((seen, color)) = look(geometry, eye, rays.through(x, y)) {
                    *receiver = seen;
                    *albedo = color;
                }
            }
        });
    Ok(())
}

/// A sample that sees the sky.
const NOTHING: Receiver = Receiver {
    position: [0.0; 3],
    covered: 0,
    normal: [0.0, 1.0, 0.0],
    object: 0,
};

/// What a ray from the eye hits: a mesh, or the ground from above.
fn look(geometry: &Geometry, eye: Vec3A, direction: Vec3A) -> Option<(Receiver, [f32; 4])> {
    let hit = geometry.cast(eye, direction);
    let ground = geometry.scene.ground.and_then(|ground| {
        let distance = (ground.height - eye.y) / direction.y;
        let seen = direction.y < 0.0 && distance > 0.0 && distance.is_finite();
        (seen && hit.is_none_or(|hit| distance < hit.distance)).then_some((ground, distance))
    });
    if let Some((ground, distance)) = ground {
        let mut position = eye + direction * distance;
        position.y = ground.height;
        let receiver = Receiver {
            position: position.into(),
            covered: 1,
            normal: [0.0, 1.0, 0.0],
            object: 0,
        };
        let [red, green, blue] = ground.albedo;
        return Some((receiver, [red, green, blue, 0.0]));
    }
    let hit = hit?;
    let material = &geometry.scene.objects[hit.object as usize].material;
    let albedo = Vec3A::from(material.albedo);
    let albedo = match (&material.texture, hit.uv) {
        (Some(texture), Some(uv)) => albedo * texture.color(uv),
        _ => albedo,
    };
    let albedo = hit.color.map_or(albedo, |color| albedo * color);
    let finish = match geometry.scene.settings.gloss {
        true => material.finish_at(hit.uv).packed(),
        false => Finish::DIFFUSE.packed(),
    };
    let receiver = Receiver {
        position: hit.position.into(),
        covered: Finish::covered(finish),
        normal: hit.normal.into(),
        object: geometry.scene.body(hit.object as usize),
    };
    let [red, green, blue] = albedo.to_array();
    Some((receiver, [red, green, blue, Finish::metallic(finish)]))
}
