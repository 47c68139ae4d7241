//! Base-colour textures in f64: bilinear between linear texels, repeated in both directions.

use sh_scene::Texture;

/// Linear value of an 8-bit sRGB code (IEC 61966-2-1).
fn linear(code: u8) -> f64 {
    let encoded = f64::from(code) / 255.0;
    if encoded <= 0.04045 {
        encoded / 12.92
    } else {
        ((encoded + 0.055) / 1.055).powf(2.4)
    }
}

/// A texture, decoded.
pub(super) struct Texels {
    width: usize,
    height: usize,
    colors: Vec<[f64; 3]>,
}

impl Texels {
    /// # Panics
    /// If there are not `width · height` texels, or none.
    pub fn new(texture: &Texture) -> Self {
        let (width, height) = (texture.width as usize, texture.height as usize);
        let (texels, rest) = texture.rgba.as_chunks::<4>();
        assert!(
            rest.is_empty() && texels.len() == width * height && !texels.is_empty(),
            "a texture of {width} by {height} texels, not {} bytes",
            texture.rgba.len()
        );
        Self {
            width,
            height,
            colors: texels
                .iter()
                .map(|[r, g, b, _]| [*r, *g, *b].map(linear))
                .collect(),
        }
    }

    /// The colour at texture coordinates, of which (0, 0) is the first texel's outer corner and (1, 1) the last's;
    /// those that are not finite count as 0.
    pub fn color(&self, uv: [f64; 2]) -> [f64; 3] {
        let [u, v] = uv.map(|c| {
            if c.is_finite() {
                c.rem_euclid(1.0)
            } else {
                0.0
            }
        });
        let [columns, rows] = [(u, self.width), (v, self.height)].map(|(c, size)| beside(c, size));
        let mut sum = [0.0; 3];
        for (row, down) in rows {
            for (column, across) in columns {
                let color = self.colors[row * self.width + column];
                for (sum, c) in sum.iter_mut().zip(color) {
                    *sum += down * across * c;
                }
            }
        }
        sum
    }
}

/// The two texels whose centres are beside a coordinate, each with its weight.
fn beside(coordinate: f64, size: usize) -> [(usize, f64); 2] {
    let shifted = coordinate * size as f64 - 0.5;
    let part = shifted - shifted.floor();
    let wrap = |i: f64| i.rem_euclid(size as f64) as usize % size;
    [
        (wrap(shifted.floor()), 1.0 - part),
        (wrap(shifted.floor() + 1.0), part),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::assert_close;

    #[test]
    fn texels_are_mixed_in_linear_light_and_repeat() {
        // White, black; black, middle grey.
        let rgba = [255, 0, 0, 188].iter().flat_map(|&v| [v, v, v, 255]);
        let texels = Texels::new(&Texture {
            width: 2,
            height: 2,
            rgba: rgba.collect(),
        });
        let gray = 0.502_886_458_033;
        for (uv, expected) in [
            ([0.25, 0.25], 1.0),
            ([0.75, 0.25], 0.0),
            ([0.75, 0.75], gray),
            ([0.5, 0.25], 0.5),
            ([0.0, 0.25], 0.5),
            ([0.5, 0.5], 0.25 * (1.0 + gray)),
            ([-2.25, 3.75], gray),
            ([f64::NAN, f64::INFINITY], 0.25 * (1.0 + gray)),
        ] {
            assert_close(&texels.color(uv), &[expected; 3], 1e-9);
        }
    }
}
