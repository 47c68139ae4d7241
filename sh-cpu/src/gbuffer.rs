//! The G-buffer pass: what every ray of a grid through a view sees.

use crate::Error;
use crate::geometry::Geometry;
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::{Grid, Receiver, Tiles, View};
use std::ops::Range;

/// Receivers and albedo of some rows of tiles, in the order of [`Tiles`].
#[derive(Clone, Debug, Default)]
pub struct Gbuffer {
    /// Position, normal and object; `covered` is 0 where the view looks into the sky, and beyond the grid.
    pub receivers: Vec<Receiver>,
    /// Linear Rec.709 reflectance, black where nothing is hit.
    pub albedo: Vec<[f32; 3]>,
}

/// The rays of a grid: [`View::ray`] with what is common to all rays computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    axes: [glam::Vec3; 3],
    wide: f32,
    tall: f32,
    view: View,
    grid: Grid,
}

impl Rays {
    pub(crate) fn new(view: &View, grid: Grid) -> Self {
        let tall = (view.camera.fov * 0.5).tan();
        Self {
            axes: view.axes(),
            wide: tall * view.width as f32 / view.height as f32,
            tall,
            view: *view,
            grid,
        }
    }

    /// Unit direction through a cell, the bits of [`View::ray`].
    #[inline(always)]
    pub(crate) fn through(&self, x: u32, y: u32) -> Vec3A {
        let [right, up, forward] = self.axes;
        let [u, v] = self.grid.place(&self.view, x, y);
        (forward + right * (u * self.wide) + up * (v * self.tall))
            .normalize()
            .into()
    }
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
    out.albedo.resize(count, [0.0; 3]);
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
                    *albedo = color.into();
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
fn look(geometry: &Geometry, eye: Vec3A, direction: Vec3A) -> Option<(Receiver, Vec3A)> {
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
        return Some((receiver, ground.albedo.into()));
    }
    let hit = hit?;
    let material = &geometry.scene.objects[hit.object as usize].material;
    let albedo = Vec3A::from(material.albedo);
    let albedo = match (&material.texture, hit.uv) {
        (Some(texture), Some(uv)) => albedo * texture.color(uv),
        _ => albedo,
    };
    let albedo = hit.color.map_or(albedo, |color| albedo * color);
    let receiver = Receiver {
        position: hit.position.into(),
        covered: 1,
        normal: hit.normal.into(),
        object: geometry.scene.body(hit.object as usize),
    };
    Some((receiver, albedo))
}

/// Whether rays through the view are directions.
pub(crate) fn check_view(view: &View) -> Result<(), Error> {
    let side = 1..=crate::MAX_SIDE;
    if !side.contains(&view.width) || !side.contains(&view.height) {
        return Err(Error::Size {
            width: view.width,
            height: view.height,
        });
    }
    let camera = &view.camera;
    let problem = if !camera.eye.is_finite() || !camera.target.is_finite() {
        "eye and target must be finite".into()
    } else if (camera.target - camera.eye).try_normalize().is_none() {
        format!("eye and target are the same point {}", camera.eye)
    } else if !(camera.fov > 0.0 && camera.fov < std::f32::consts::PI) {
        format!(
            "its field of view is {} radians, it must lie between 0 and π",
            camera.fov
        )
    } else {
        return Ok(());
    };
    Err(Error::Camera { problem })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;
    use sh_scene::Camera;

    #[test]
    fn rays_are_those_of_the_view() {
        let camera = Camera {
            eye: vec3(1.0, 2.0, 3.0),
            target: vec3(-0.3, 0.1, 0.2),
            fov: 0.8,
        };
        let view = View {
            camera,
            width: 37,
            height: 23,
        };
        for grid in [view.samples(), view.halves()] {
            let rays = Rays::new(&view, grid);
            for y in 0..grid.rows {
                for x in 0..grid.columns {
                    assert_eq!(rays.through(x, y), Vec3A::from(view.ray(grid, x, y)));
                }
            }
        }
    }
}
