//! The G-buffer pass: what every sample of a view sees.

use crate::Error;
use crate::geometry::Geometry;
use crate::texture::texture_color;
use glam::Vec3A;
use rayon::prelude::*;
use sh_scene::{Receiver, View};
use std::ops::Range;

/// Receivers and albedo of a band of sample rows, row by row from the top.
#[derive(Clone, Debug, Default)]
pub struct Gbuffer {
    /// Position, normal and object; `covered` is 0 where the view looks into the sky.
    pub receivers: Vec<Receiver>,
    /// Linear Rec.709 reflectance, black where nothing is hit.
    pub albedo: Vec<[f32; 3]>,
}

/// The rays of a view's sample grid: [`View::ray`] with what is common to all rays computed once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rays {
    axes: [glam::Vec3; 3],
    wide: f32,
    tall: f32,
    columns: f32,
    rows: f32,
}

impl Rays {
    pub(crate) fn new(view: &View) -> Self {
        let tall = (view.camera.fov * 0.5).tan();
        Self {
            axes: view.axes(),
            wide: tall * view.width as f32 / view.height as f32,
            tall,
            columns: (view.width * View::OVERSAMPLE) as f32,
            rows: (view.height * View::OVERSAMPLE) as f32,
        }
    }

    /// Unit direction through a sample, the bits of [`View::ray`].
    #[inline(always)]
    pub(crate) fn through(&self, x: u32, y: u32) -> Vec3A {
        let [right, up, forward] = self.axes;
        let u = 2.0 * (x as f32 + 0.5) / self.columns - 1.0;
        let v = 1.0 - 2.0 * (y as f32 + 0.5) / self.rows;
        (forward + right * (u * self.wide) + up * (v * self.tall))
            .normalize()
            .into()
    }
}

/// Fills `out` with the sample rows `rows` of `view` (out of `view.height * View::OVERSAMPLE`), reusing its
/// memory. Rows are cast in parallel; every sample is its own ray, so that the result does not depend on
/// the number of threads.
pub fn gbuffer(
    geometry: &Geometry,
    view: &View,
    rows: Range<u32>,
    out: &mut Gbuffer,
) -> Result<(), Error> {
    check_view(view)?;
    let rays = Rays::new(view);
    let columns = (view.width * View::OVERSAMPLE) as usize;
    let count = columns * rows.len();
    out.receivers.clear();
    out.receivers.resize(count, NOTHING);
    out.albedo.clear();
    out.albedo.resize(count, [0.0; 3]);
    let eye = Vec3A::from(view.camera.eye);
    out.receivers
        .par_chunks_mut(columns)
        .zip(out.albedo.par_chunks_mut(columns))
        .zip(rows)
        .for_each(|((receivers, albedo), y)| {
            for (x, (receiver, albedo)) in receivers.iter_mut().zip(albedo).enumerate() {
                if let Some((seen, color)) = look(geometry, eye, rays.through(x as u32, y)) {
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
    object: u32::MAX,
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
            object: u32::MAX,
        };
        return Some((receiver, ground.albedo.into()));
    }
    let hit = hit?;
    let material = &geometry.scene.objects[hit.object as usize].material;
    let albedo = Vec3A::from(material.albedo);
    let albedo = match (&material.texture, hit.uv) {
        (Some(texture), Some(uv)) => albedo * texture_color(texture, uv),
        _ => albedo,
    };
    let receiver = Receiver {
        position: hit.position.into(),
        covered: 1,
        normal: hit.normal.into(),
        object: hit.object,
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
        let rays = Rays::new(&view);
        for y in 0..46 {
            for x in 0..74 {
                assert_eq!(rays.through(x, y), Vec3A::from(view.ray(x, y)));
            }
        }
    }
}
