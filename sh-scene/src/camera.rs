//! The camera, and the grid of samples it looks through.

use glam::{Mat4, Vec3, Vec4};
use sh_core::constants;

/// Where the picture is taken from. +Y is up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the eye, in metres.
    pub eye: Vec3,
    /// The point it looks at.
    pub target: Vec3,
    /// Vertical field of view, in radians.
    pub fov: f32,
}

impl Camera {
    /// The vertical field of view where nothing is said: 35°.
    pub const FOV: f32 = 35.0 * std::f32::consts::PI / 180.0;

    /// A camera that looks at the box from `min` to `max` from in front (+Z), a little from the right and
    /// from above, near enough that the box fills most of a picture of 4:3 or wider; `fov` is the vertical
    /// field of view in radians ([`Camera::FOV`] is usual). A box without extent is seen from a metre's
    /// distance; one so small and so far from the origin that `f32` could not tell the eye from the target,
    /// from farther away than would fill the picture.
    ///
    /// ```
    /// use glam::Vec3;
    /// let camera = sh_scene::Camera::framing(-Vec3::ONE, Vec3::ONE, sh_scene::Camera::FOV);
    /// assert_eq!(camera.target, Vec3::ZERO);
    /// assert!(camera.eye.z > 2.0);
    /// ```
    pub fn framing(min: Vec3, max: Vec3, fov: f32) -> Self {
        const ASPECT: f32 = 4.0 / 3.0;
        const MARGIN: f32 = 1.12;
        let (target, half) = ((min + max) * 0.5, (max - min) * 0.5);
        let away = Vec3::new(0.46, 0.42, 1.0).normalize();
        let [right, up, _] = View {
            camera: Self {
                eye: away,
                target: Vec3::ZERO,
                fov,
            },
            width: 1,
            height: 1,
        }
        .axes();
        let tall = (fov * 0.5).tan() / MARGIN;
        let mut distance = 0.0_f32;
        for corner in 0..8 {
            let sign = |bit: u32| if corner >> bit & 1 == 1 { 1.0 } else { -1.0 };
            let c = half * Vec3::new(sign(0), sign(1), sign(2));
            // Seen from `distance` along `away`, the corner lies `distance - c·away` deep.
            let aside = (c.dot(right) / ASPECT).abs().max(c.dot(up).abs());
            distance = distance.max(c.dot(away) + aside / tall);
        }
        if distance <= 1e-12 {
            distance = 1.0;
        }
        let distance = distance.max(Self::nearest(target));
        Self {
            eye: target + away * distance,
            target,
            fov,
        }
    }

    /// How near to `target` an eye may be, in metres, so that rounding leaves it somewhere else and the
    /// direction between them roughly right.
    pub fn nearest(target: Vec3) -> f32 {
        (1e-6 * target.abs().max_element()).max(1e-12)
    }
}

/// A camera together with the size of the picture: what the G-buffer pass samples.
///
/// A picture of `width` by `height` pixels is sampled on a grid [`View::OVERSAMPLE`] times as fine in
/// each direction; both backends look through the centres of the same grid cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

impl View {
    /// Samples per pixel in each direction.
    pub const OVERSAMPLE: u32 = constants::OVERSAMPLE;

    /// The camera's axes: right, up and forward, unit vectors. Looking straight up or down, +Z stands in
    /// for +Y.
    pub fn axes(&self) -> [Vec3; 3] {
        let forward = (self.camera.target - self.camera.eye).normalize();
        let up = if forward.y.abs() > 0.9999 {
            Vec3::Z
        } else {
            Vec3::Y
        };
        let right = forward.cross(up).normalize();
        [right, right.cross(forward), forward]
    }

    /// The grid of samples that pixels are made of: [`View::OVERSAMPLE`] a pixel in each direction.
    pub fn samples(&self) -> Grid {
        Grid {
            columns: self.width * Self::OVERSAMPLE,
            rows: self.height * Self::OVERSAMPLE,
            spacing: 1.0 / Self::OVERSAMPLE as f32,
        }
    }

    /// The grid at half the picture's resolution: a ray through the middle of every two by two pixels. The last
    /// column and row of a picture with odd sides reach half a cell beyond it.
    pub fn halves(&self) -> Grid {
        Grid {
            columns: self.width.div_ceil(2),
            rows: self.height.div_ceil(2),
            spacing: 2.0,
        }
    }

    /// Unit direction through column `x`, row `y` of a grid, from the top left.
    pub fn ray(&self, grid: Grid, x: u32, y: u32) -> Vec3 {
        let [right, up, forward] = self.axes();
        let tall = (self.camera.fov * 0.5).tan();
        let wide = tall * self.width as f32 / self.height as f32;
        let [u, v] = grid.place(self, x, y);
        (forward + right * (u * wide) + up * (v * tall)).normalize()
    }

    /// World to clip space (depth 1 at `near`, towards 0 at infinity) for rasterising the same grid.
    pub fn clip_from_world(&self, near: f32) -> Mat4 {
        let [right, up, forward] = self.axes();
        let tall = 1.0 / (self.camera.fov * 0.5).tan();
        let wide = tall * self.height as f32 / self.width as f32;
        let row =
            |axis: Vec3, scale: f32| (axis * scale).extend(-axis.dot(self.camera.eye) * scale);
        Mat4::from_cols(
            row(right, wide),
            row(up, tall),
            Vec4::W * near,
            row(forward, 1.0),
        )
        .transpose()
    }
}

/// Rays through a view, one every `spacing` pixels in each direction, the first half a step from the top left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Rays across.
    pub columns: u32,
    /// Rays down.
    pub rows: u32,
    /// Pixels between two neighbours.
    pub spacing: f32,
}

impl Grid {
    /// Where the ray of a column and row goes through the picture: -1 left and bottom, 1 right and top.
    pub fn place(&self, view: &View, x: u32, y: u32) -> [f32; 2] {
        let at = |i: u32, side: u32| 2.0 * (i as f32 + 0.5) * self.spacing / side as f32 - 1.0;
        [at(x, view.width), -at(y, view.height)]
    }

    /// How the passes store what they compute for this grid: tile by tile.
    pub fn tiles(&self) -> Tiles {
        Tiles {
            columns: self.columns.div_ceil(Tiles::SIDE),
            rows: self.rows.div_ceil(Tiles::SIDE),
        }
    }
}

/// A grid cut into square tiles, stored one after another, row by row of tiles, and row by row within a tile.
/// Every tile is a cluster of receivers that share a cut of blockers; tiles at the right and bottom edge are filled
/// up with receivers that are not covered.
///
/// ```
/// let tiles = sh_scene::Tiles { columns: 3, rows: 2 };
/// assert_eq!(tiles.index(0, 0), 0);
/// assert_eq!(tiles.index(17, 1), 256 + 16 + 1);
/// assert_eq!(tiles.len(), 6 * 256);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tiles {
    /// Tiles across.
    pub columns: u32,
    /// Tiles down.
    pub rows: u32,
}

impl Tiles {
    /// Cells of a tile across and down.
    pub const SIDE: u32 = constants::SIDE;

    /// Cells of a tile.
    pub const AREA: usize = constants::AREA;

    /// Where the cell of column `x` and row `y` is stored.
    pub fn index(&self, x: u32, y: u32) -> usize {
        let tile = (y / Self::SIDE) as usize * self.columns as usize + (x / Self::SIDE) as usize;
        tile * Self::AREA + (y % Self::SIDE * Self::SIDE + x % Self::SIDE) as usize
    }

    /// How many cells are stored.
    pub fn len(&self) -> usize {
        self.columns as usize * self.rows as usize * Self::AREA
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The cells of each tile: clusters for the shadow pass.
    pub fn clusters(&self) -> Vec<std::ops::Range<usize>> {
        let first = (0..self.len()).step_by(Self::AREA);
        first.map(|first| first..first + Self::AREA).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn framing_looks_somewhere_however_small_and_far_the_box() {
        for size in [0.0, 1e-40, 1e-20, 1e-9, 1.0, 1e9, 1e18] {
            for place in [0.0, 1e-20, 1.0, 9e8, 1e18] {
                let min = Vec3::new(place, -place, place);
                let camera = Camera::framing(min, min + Vec3::splat(size), Camera::FOV);
                let view = View {
                    camera,
                    width: 4,
                    height: 3,
                };
                for axis in view.axes() {
                    assert!(
                        (axis.length() - 1.0).abs() < 1e-5,
                        "{size} at {place}: {camera:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn framing_shows_every_corner() {
        for (min, max) in [
            (Vec3::ZERO, Vec3::new(1.0, 3.0, 0.5)),
            (Vec3::new(-900.0, 0.0, -10.0), Vec3::new(900.0, 20.0, 10.0)),
            (Vec3::splat(0.001), Vec3::splat(0.002)),
        ] {
            let camera = Camera::framing(min, max, Camera::FOV);
            let view = View {
                camera,
                width: 640,
                height: 480,
            };
            let clip = view.clip_from_world(1e-3);
            let mut widest = 0.0_f32;
            for corner in 0..8 {
                let pick = |bit: u32, i: usize| {
                    if corner >> bit & 1 == 1 {
                        max[i]
                    } else {
                        min[i]
                    }
                };
                let p = clip * Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2)).extend(1.0);
                assert!(p.w > 0.0);
                widest = widest.max((p.x / p.w).abs()).max((p.y / p.w).abs());
            }
            assert!(widest > 0.75 && widest < 1.0, "{min} {max}: {widest}");
        }
        let point = Camera::framing(Vec3::ONE, Vec3::ONE, 0.5);
        assert!((point.eye.distance(Vec3::ONE) - 1.0).abs() < 1e-6);
    }
}
