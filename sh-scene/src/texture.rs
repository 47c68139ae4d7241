//! Textures of surfaces.

use glam::Vec3A;
use std::sync::LazyLock;

/// A texture: RGBA, 8 bits each, sRGB-encoded where it holds colours, rows from the top, repeated in both directions.
#[derive(Clone, Debug)]
pub struct Texture {
    /// Texels across.
    pub width: u32,
    /// Texels down.
    pub height: u32,
    /// `width * height * 4` bytes.
    pub rgba: Vec<u8>,
}

/// Linear value of every 8-bit sRGB code (IEC 61966-2-1).
static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| {
    core::array::from_fn(|code| {
        let encoded = code as f64 / 255.0;
        if encoded <= 0.04045 {
            (encoded / 12.92) as f32
        } else {
            ((encoded + 0.055) / 1.055).powf(2.4) as f32
        }
    })
});

/// The number that every byte stands for that is no colour.
static NUMBERS: LazyLock<[f32; 256]> =
    LazyLock::new(|| core::array::from_fn(|code| code as f32 / 255.0));

/// The two texels beside `coordinate` (in texels, texel i reaching from i to i + 1 with its centre in the
/// middle) and the weight of the second. Neighbours are not yet wrapped.
#[inline(always)]
fn beside(coordinate: f32) -> (f32, f32, f32) {
    let shifted = coordinate - 0.5;
    let first = shifted.floor();
    (first, first + 1.0, shifted - first)
}

/// Bilinear mixture of four corner values.
#[inline(always)]
fn mix(corners: [[Vec3A; 2]; 2], across: f32, down: f32) -> Vec3A {
    let top = corners[0][0].lerp(corners[0][1], across);
    let bottom = corners[1][0].lerp(corners[1][1], across);
    top.lerp(bottom, down)
}

impl Texture {
    /// The linear colour at texture coordinates: bilinear between linear texels, repeated in both directions.
    /// Coordinates that are not finite count as 0.
    ///
    /// ```
    /// let texture = sh_scene::Texture { width: 2, height: 1, rgba: vec![0, 0, 0, 255, 255, 255, 255, 255] };
    /// assert_eq!(texture.color([0.75, 0.5]).to_array(), [1.0; 3]);
    /// assert_eq!(texture.color([0.5, 0.5]).to_array(), [0.5; 3]);
    /// ```
    ///
    /// # Panics
    /// If there are fewer bytes than texels need, or no texel.
    #[inline]
    pub fn color(&self, uv: [f32; 2]) -> Vec3A {
        self.mean(uv, &LINEAR)
    }

    /// Red, green and blue as numbers from 0 to 1, where they are no colours; else as [`color`](Self::color).
    ///
    /// ```
    /// let texture = sh_scene::Texture { width: 1, height: 1, rgba: vec![0, 51, 255, 255] };
    /// assert_eq!(texture.numbers([0.5, 0.5]).to_array(), [0.0, 0.2, 1.0]);
    /// ```
    ///
    /// # Panics
    /// If there are fewer bytes than texels need, or no texel.
    #[inline]
    pub fn numbers(&self, uv: [f32; 2]) -> Vec3A {
        self.mean(uv, &NUMBERS)
    }

    /// The bilinear mean at texture coordinates of what each byte stands for.
    #[inline]
    fn mean(&self, uv: [f32; 2], code: &[f32; 256]) -> Vec3A {
        // Into 0..1 first, so that far repetitions lose no more than the coordinate itself has lost.
        let wrapped = uv.map(|c| if c.is_finite() { c - c.floor() } else { 0.0 });
        let (x0, x1, across) = beside(wrapped[0] * self.width as f32);
        let (y0, y1, down) = beside(wrapped[1] * self.height as f32);
        let wrap = |c: f32, size: u32| (c as i64).rem_euclid(i64::from(size)) as usize;
        let columns = [wrap(x0, self.width), wrap(x1, self.width)];
        let rows = [wrap(y0, self.height), wrap(y1, self.height)];
        let corners = rows.map(|y| {
            columns.map(|x| {
                let at = 4 * (y * self.width as usize + x);
                Vec3A::from_array(core::array::from_fn(|c| {
                    code[usize::from(self.rgba[at + c])]
                }))
            })
        });
        mix(corners, across, down)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checker() -> Texture {
        // White, black; black, white.
        let rgba = [255, 0, 0, 255]
            .iter()
            .flat_map(|&v| [v, v, v, 255])
            .collect();
        Texture {
            width: 2,
            height: 2,
            rgba,
        }
    }

    #[test]
    fn texel_centres_give_texels_and_middles_linear_means() {
        let texture = checker();
        assert_eq!(texture.color([0.25, 0.25]), Vec3A::ONE);
        assert_eq!(texture.color([0.75, 0.25]), Vec3A::ZERO);
        assert_eq!(texture.color([0.5, 0.25]), Vec3A::splat(0.5));
        assert_eq!(texture.color([0.5, 0.5]), Vec3A::splat(0.5));
    }

    #[test]
    fn textures_repeat() {
        let texture = checker();
        for (u, v) in [(0.1, 0.3), (0.9, 0.05), (0.0, 0.0)] {
            let here = texture.color([u, v]);
            for (du, dv) in [(1.0, 0.0), (0.0, -1.0), (-3.0, 2.0)] {
                assert!(here.abs_diff_eq(texture.color([u + du, v + dv]), 2e-6));
            }
        }
        assert!(texture.color([f32::NAN, f32::INFINITY]).is_finite());
    }

    #[test]
    fn middle_grey_decodes() {
        let texture = Texture {
            width: 1,
            height: 1,
            rgba: vec![188, 188, 188, 255],
        };
        assert!((texture.color([0.3, 0.7]).x - 0.5028865).abs() < 1e-6);
    }
}
