//! The window's triangles drawn in software: for pictures of it where there is neither a display nor a GPU.
//!
//! egui hands over triangles whose corners have a place, a place in a texture and a colour. Colours are sRGB values
//! with premultiplied alpha, and are multiplied, interpolated and blended as such.

use egui::epaint::textures::TexturesDelta;
use egui::epaint::{ClippedPrimitive, ImageData, ImageDelta, Mesh, Primitive, Vertex};
use egui::{Color32, ColorImage, TextureFilter, TextureId};
use std::collections::HashMap;

/// Red, green, blue and alpha, 0 to 255.
type Rgba = [f32; 4];

/// A texture and whether it is interpolated.
struct Texture {
    image: ColorImage,
    linear: bool,
}

/// The textures that egui has handed over.
#[derive(Default)]
pub(super) struct Raster {
    textures: HashMap<TextureId, Texture>,
}

impl Raster {
    /// Takes new and changed textures.
    pub fn update(&mut self, delta: &TexturesDelta) {
        for (id, deltas) in &delta.set {
            for delta in deltas {
                self.set(*id, delta);
            }
        }
    }

    /// Forgets textures, after a frame that still needed them.
    pub fn free(&mut self, delta: &TexturesDelta) {
        for id in &delta.free {
            self.textures.remove(id);
        }
    }

    fn set(&mut self, id: TextureId, delta: &ImageDelta) {
        let ImageData::Color(image) = &delta.image;
        match (delta.pos, self.textures.get_mut(&id)) {
            (Some([x, y]), Some(texture)) => {
                let [width, height] = image.size;
                let across = texture.image.size[0];
                for row in 0..height {
                    let from = &image.pixels[row * width..][..width];
                    texture.image.pixels[(y + row) * across + x..][..width].copy_from_slice(from);
                }
            }
            _ => {
                let linear = delta.options.magnification == TextureFilter::Linear;
                let image = ColorImage::clone(image);
                self.textures.insert(id, Texture { image, linear });
            }
        }
    }

    /// Draws triangles over a picture, `scale` pixels a point.
    pub fn draw(&self, primitives: &[ClippedPrimitive], scale: f32, picture: &mut ColorImage) {
        for ClippedPrimitive {
            clip_rect,
            primitive,
        } in primitives
        {
            let Primitive::Mesh(mesh) = primitive else {
                continue;
            };
            let Some(texture) = self.textures.get(&mesh.texture_id) else {
                continue;
            };
            let side =
                |points: f32, end: usize| (points * scale).round().clamp(0.0, end as f32) as usize;
            let [width, height] = picture.size;
            let clip = [
                [side(clip_rect.min.x, width), side(clip_rect.max.x, width)],
                [side(clip_rect.min.y, height), side(clip_rect.max.y, height)],
            ];
            triangles(mesh, texture, scale, clip, picture);
        }
    }
}

fn triangles(
    mesh: &Mesh,
    texture: &Texture,
    scale: f32,
    clip: [[usize; 2]; 2],
    picture: &mut ColorImage,
) {
    for corners in mesh.indices.as_chunks::<3>().0 {
        let corners = corners.map(|i| mesh.vertices[i as usize]);
        triangle(corners, texture, scale, clip, picture);
    }
}

/// Twice the area of the triangle a, b, p: above 0 where p lies on one side of the edge, below on the other.
fn edge(a: [f32; 2], b: [f32; 2], p: [f32; 2]) -> f32 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

fn triangle(
    mut corners: [Vertex; 3],
    texture: &Texture,
    scale: f32,
    clip: [[usize; 2]; 2],
    picture: &mut ColorImage,
) {
    let place = |v: &Vertex| [v.pos.x * scale, v.pos.y * scale];
    let area = edge(place(&corners[0]), place(&corners[1]), place(&corners[2]));
    if area < 0.0 {
        corners.swap(1, 2);
    }
    let places = corners.each_ref().map(place);
    let area = area.abs();
    if !(area > 0.0 && area.is_finite()) {
        return;
    }
    let bounds = [0, 1].map(|axis| {
        let along = places.map(|p| p[axis]);
        let low = along.iter().copied().fold(f32::INFINITY, f32::min);
        let high = along.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        let [from, to] = clip[axis];
        // Pixels whose middle may lie within.
        let from = (low - 0.5).ceil().max(from as f32) as usize;
        let to = ((high - 0.5).floor() + 1.0).clamp(0.0, to as f32) as usize;
        from..to
    });
    let colors = corners
        .each_ref()
        .map(|v| v.color.to_array().map(f32::from));
    // An edge between two triangles belongs to one of them: the one that has it above or to its left.
    let owns = [0, 1, 2].map(|i| {
        let (a, b) = (places[(i + 1) % 3], places[(i + 2) % 3]);
        a[1] == b[1] && b[0] > a[0] || b[1] < a[1]
    });
    let even = corners[0].color == corners[1].color && corners[1].color == corners[2].color;
    let flat = even && corners.iter().all(|v| v.uv == corners[0].uv);
    let single = flat.then(|| modulate(colors[0], texture.at(corners[0].uv.x, corners[0].uv.y)));
    let across = picture.size[0];
    for y in bounds[1].clone() {
        for x in bounds[0].clone() {
            let p = [x as f32 + 0.5, y as f32 + 0.5];
            let weights = [0, 1, 2].map(|i| edge(places[(i + 1) % 3], places[(i + 2) % 3], p));
            if (0..3).any(|i| weights[i] < 0.0 || weights[i] == 0.0 && !owns[i]) {
                continue;
            }
            let color = single.unwrap_or_else(|| {
                let weights = weights.map(|w| w / area);
                let mix =
                    |of: [f32; 3]| of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2];
                let color = [0, 1, 2, 3].map(|c| mix(colors.map(|color| color[c])));
                let [u, v] = [mix(corners.map(|v| v.uv.x)), mix(corners.map(|v| v.uv.y))];
                modulate(color, texture.at(u, v))
            });
            let below = &mut picture.pixels[y * across + x];
            *below = over(color, *below);
        }
    }
}

fn modulate(a: Rgba, b: Rgba) -> Rgba {
    [0, 1, 2, 3].map(|c| a[c] * b[c] / 255.0)
}

fn over(color: Rgba, below: Color32) -> Color32 {
    let left = 1.0 - color[3] / 255.0;
    let below = below.to_array().map(f32::from);
    let [r, g, b, a] = [0, 1, 2, 3].map(|c| (color[c] + below[c] * left + 0.5) as u8);
    Color32::from_rgba_premultiplied(r, g, b, a)
}

impl Texture {
    /// The colour at (u, v), (0, 0) being the upper left corner.
    fn at(&self, u: f32, v: f32) -> Rgba {
        let [width, height] = self.image.size;
        let texel = |x: usize, y: usize| self.image.pixels[y * width + x].to_array().map(f32::from);
        let place = |at: f32, side: usize| at.clamp(0.0, side as f32 - 1.0);
        if !self.linear {
            let x = place((u * width as f32).floor(), width);
            return texel(
                x as usize,
                place((v * height as f32).floor(), height) as usize,
            );
        }
        let (x, y) = (
            place(u * width as f32 - 0.5, width),
            place(v * height as f32 - 0.5, height),
        );
        let (left, top) = (x as usize, y as usize);
        let (right, low) = ((left + 1).min(width - 1), (top + 1).min(height - 1));
        let (fx, fy) = (x - left as f32, y - top as f32);
        let mix = |a: Rgba, b: Rgba, part: f32| [0, 1, 2, 3].map(|c| a[c] + (b[c] - a[c]) * part);
        let upper = mix(texel(left, top), texel(right, top), fx);
        mix(upper, mix(texel(left, low), texel(right, low), fx), fy)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Context, Pos2, RawInput, Rect, TextureOptions, vec2};

    /// What a context draws, on black.
    fn draw(side: f32, scale: f32, mut paint: impl FnMut(&egui::Ui)) -> ColorImage {
        let ctx = Context::default();
        let mut raster = Raster::default();
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, vec2(side, side))),
            ..RawInput::default()
        };
        let viewport = input.viewports.entry(input.viewport_id).or_default();
        viewport.native_pixels_per_point = Some(scale);
        let output = ctx.run_ui(input, |ui| paint(ui));
        raster.update(&output.textures_delta);
        let pixels = (side * scale) as usize;
        let mut picture = ColorImage::filled([pixels; 2], Color32::BLACK);
        let primitives = ctx.tessellate(output.shapes.clone(), output.pixels_per_point);
        raster.draw(&primitives, output.pixels_per_point, &mut picture);
        output.drop_without_applying_deltas();
        picture
    }

    #[test]
    fn a_rectangle_fills_its_pixels_once() {
        let half = Color32::from_rgba_premultiplied(100, 0, 0, 128);
        for scale in [1.0, 2.0] {
            let picture = draw(8.0, scale, |ui| {
                let rect = Rect::from_min_max(Pos2::new(2.0, 3.0), Pos2::new(6.0, 7.0));
                ui.painter().rect_filled(rect, 0.0, half);
            });
            let inside = |x: f32, y: f32| {
                picture.pixels[(y * scale) as usize * picture.size[0] + (x * scale) as usize]
            };
            // Along the diagonal two triangles meet: nothing is drawn twice or left out.
            for i in 0..2 {
                assert_eq!(
                    inside(3.0 + i as f32, 4.0 + i as f32).r(),
                    100,
                    "{scale} {i}"
                );
            }
            assert_eq!(inside(0.5, 0.5), Color32::BLACK);
            assert_eq!(inside(7.0, 7.5), Color32::BLACK);
        }
    }

    #[test]
    fn a_picture_comes_out_as_it_went_in() {
        let colors: Vec<_> = (0..16)
            .map(|i| Color32::from_rgb(i * 15, 255 - i * 9, i * i))
            .collect();
        let image = ColorImage::new([4, 4], colors);
        let mut texture = None;
        let picture = draw(4.0, 1.0, |ui| {
            let handle = texture.get_or_insert_with(|| {
                ui.ctx()
                    .load_texture("test", image.clone(), TextureOptions::LINEAR)
            });
            let all = Rect::from_min_max(Pos2::ZERO, Pos2::new(1.0, 1.0));
            let whole = Rect::from_min_size(Pos2::ZERO, vec2(4.0, 4.0));
            ui.painter().image(handle.id(), whole, all, Color32::WHITE);
        });
        assert_eq!(picture.pixels, image.pixels);
    }
}
