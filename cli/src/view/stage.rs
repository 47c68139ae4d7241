//! The picture: input to the camera, overlays, legend, and the bar with the time.

use super::layer::{distinct, heat};
use super::look::{ACCENT, FAINT, PANEL, bold};
use super::orbit::Orbit;
use super::state::{Facts, State};
use super::wish::{Ball, Layer, Shown};
use egui::{Align2, Color32, FontId, Key, Painter, PointerButton, Pos2, Rect, Response, Sense};
use egui::{Shape, Slider, Stroke, Ui, pos2, vec2};
use glam::Vec3;
use sh_scene::{Camera, View};

/// Radians of a point that the pointer is dragged.
const DRAG: f32 = 0.007;

/// Radians of a press of an arrow key.
const STEP: f32 = 0.06;

/// Moves the camera as pointer, wheel and keys say.
pub(super) fn steer(ui: &Ui, picture: &Response, state: &mut State) {
    let orbit: &mut Orbit = &mut state.orbit;
    let by = picture.drag_delta();
    let shift = ui.input(|input| input.modifiers.shift);
    if picture.dragged_by(PointerButton::Primary) && !shift {
        orbit.turn(-DRAG * by.x, DRAG * by.y);
    } else if picture.dragged() {
        let height = picture.rect.height().max(1.0);
        orbit.shift(-by.x / height, by.y / height);
    }
    if picture.hovered() {
        let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        orbit.zoom((-0.002 * wheel).exp() / pinch);
    }
    // Keys belong to whatever control is being used.
    if ui.ctx().memory(|memory| memory.focused().is_some()) {
        return;
    }
    ui.input(|input| {
        let pressed = |key| f32::from(u8::from(input.key_pressed(key)));
        let right = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
        let up = pressed(Key::ArrowUp) - pressed(Key::ArrowDown);
        orbit.turn(STEP * right, STEP * up);
        let near = pressed(Key::Plus) + pressed(Key::Equals) + pressed(Key::PageUp);
        let far = pressed(Key::Minus) + pressed(Key::PageDown);
        orbit.zoom(0.9_f32.powf(near - far));
        if input.key_pressed(Key::Home) {
            orbit.reset();
        }
        if input.key_pressed(Key::Space) {
            state.playing = !state.playing;
        }
    });
}

/// Play, pause, and any time by hand.
pub(super) fn bar(ui: &mut Ui, facts: &Facts, state: &mut State) {
    let Some(length) = facts.length else {
        return;
    };
    ui.horizontal_centered(|ui| {
        let (rect, button) = ui.allocate_exact_size(vec2(26.0, 22.0), Sense::click());
        let look = ui.style().interact(&button);
        ui.painter()
            .rect_filled(rect, look.corner_radius, look.bg_fill);
        sign(
            ui.painter(),
            rect.center(),
            state.playing,
            look.fg_stroke.color,
        );
        if button.on_hover_text("Play or pause (space)").clicked() {
            state.playing = !state.playing;
        }
        let words = format!("{:.2} of {length:.2} s", state.seconds);
        ui.spacing_mut().slider_width = (ui.available_width() - 106.0).max(40.0);
        let slider = Slider::new(&mut state.seconds, 0.0..=length).show_value(false);
        if ui.add(slider).dragged() {
            state.playing = false;
        }
        ui.label(words);
    });
}

/// Two bars while it plays, a triangle otherwise: the font has neither.
fn sign(painter: &Painter, at: Pos2, playing: bool, color: Color32) {
    if playing {
        for side in [-3.0, 3.0] {
            let bar = Rect::from_center_size(at + vec2(side, 0.0), vec2(3.0, 10.0));
            painter.rect_filled(bar, 0.5, color);
        }
    } else {
        let corners = [vec2(-4.0, -5.5), vec2(5.0, 0.0), vec2(-4.0, 5.5)];
        let corners = corners.map(|corner| at + corner).to_vec();
        painter.add(Shape::convex_polygon(corners, color, Stroke::NONE));
    }
}

/// The outlines of spheres as a camera sees them, in its picture's rectangle; farther ones first.
pub(super) fn spheres(painter: &Painter, rect: Rect, camera: Camera, balls: &[Ball]) {
    let view = View {
        camera,
        width: 1,
        height: 1,
    };
    let axes = view.axes();
    // Points per unit of height at distance 1.
    let focal = 0.5 * rect.height() / (0.5 * camera.fov).tan();
    let mut seen: Vec<(f32, Vec3, &Ball)> = balls
        .iter()
        .map(|ball| {
            let away = Vec3::from(ball.sphere.center) - camera.eye;
            (
                away.length(),
                Vec3::from(axes.map(|axis| axis.dot(away))),
                ball,
            )
        })
        .collect();
    seen.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (distance, away, ball) in seen {
        let radius = ball.sphere.radius;
        if distance <= radius {
            continue;
        }
        // The eye sees a sphere up to the circle where its rays touch it.
        let towards = away / distance;
        let sine = radius / distance;
        let center = away * (1.0 - sine * sine);
        let radius = radius * (1.0 - sine * sine).sqrt();
        let (across, up) = towards.any_orthonormal_pair();
        let count = ((focal * sine).sqrt() * 5.0).clamp(10.0, 64.0) as usize;
        let outline: Option<Vec<Pos2>> = (0..count)
            .map(|i| {
                let (sin, cos) = (std::f32::consts::TAU * i as f32 / count as f32).sin_cos();
                let p = center + (across * cos + up * sin) * radius;
                // Nothing is drawn of what reaches behind the eye.
                (p.z > 1e-3 * distance).then(|| rect.center() + vec2(p.x, -p.y) * (focal / p.z))
            })
            .collect();
        if let Some(mut outline) = outline {
            // egui takes polygons clockwise as a screen has them.
            let [a, b, c] = [outline[0], outline[1], outline[2]];
            if (b - a).rot90().dot(c - b) < 0.0 {
                outline.reverse();
            }
            let color = distinct(ball.object);
            let fill = color.gamma_multiply(0.10);
            let line = Stroke::new(1.0, color.gamma_multiply(0.85));
            painter.add(Shape::convex_polygon(outline, fill, line));
        }
    }
}

/// What the colours of a layer mean, at the lower left of the picture.
pub(super) fn legend(painter: &Painter, picture: Rect, layer: &Layer) {
    const WIDE: f32 = 236.0;
    let legend = &layer.legend;
    let ramp = if legend.ends.is_some() { 34.0 } else { 0.0 };
    let height = 34.0 + ramp + 16.0 * legend.notes.len() as f32;
    let corner = picture.left_bottom() + vec2(14.0, -14.0 - height);
    let rect = Rect::from_min_size(corner, vec2(WIDE, height));
    painter.rect_filled(rect, 6.0, PANEL.gamma_multiply(0.92));
    let mut at = rect.min + vec2(12.0, 10.0);
    let text = |at: Pos2, align: Align2, words: &str, size: f32, color: Color32| {
        painter.text(at, align, words, FontId::proportional(size), color);
    };
    let heading = bold(&legend.title, 13.5);
    let galley = painter.layout_no_wrap(
        heading.text().to_string(),
        FontId::new(13.5, egui::FontFamily::Name("bold".into())),
        Color32::from_gray(222),
    );
    painter.galley(at, galley, Color32::WHITE);
    at.y += 20.0;
    if let Some([low, high]) = &legend.ends {
        let width = WIDE - 24.0;
        const STEPS: usize = 53;
        for i in 0..STEPS {
            let from = at + vec2(width * i as f32 / STEPS as f32, 2.0);
            let size = vec2(width / STEPS as f32 + 0.5, 9.0);
            let color = heat(i as f32 / (STEPS - 1) as f32);
            painter.rect_filled(Rect::from_min_size(from, size), 0.0, color);
        }
        let below = at.y + 13.0;
        text(pos2(at.x, below), Align2::LEFT_TOP, low, 11.5, FAINT);
        text(
            pos2(at.x + width, below),
            Align2::RIGHT_TOP,
            high,
            11.5,
            FAINT,
        );
        at.y += ramp;
    }
    for note in &legend.notes {
        text(at, Align2::LEFT_TOP, note, 11.5, FAINT);
        at.y += 16.0;
    }
}

/// How coarse the picture is just now, if it is, at the upper left.
pub(super) fn caption(
    painter: &Painter,
    picture: Rect,
    shown: &Shown,
    full: [u32; 2],
    rate: Option<f64>,
) {
    let [width, height] = shown.wish.size;
    let mut words = match rate {
        Some(rate) => format!("{rate:.0} pictures a second"),
        None => String::new(),
    };
    if shown.wish.size != full {
        let comma = if words.is_empty() { "" } else { ", " };
        words += &format!("{comma}{width} × {height}");
    }
    if words.is_empty() {
        return;
    }
    let font = FontId::proportional(12.5);
    let galley = painter.layout_no_wrap(words, font, Color32::from_gray(222));
    let size = galley.size() + vec2(16.0, 8.0);
    let rect = Rect::from_min_size(picture.min + vec2(14.0, 14.0), size);
    painter.rect_filled(rect, 5.0, PANEL.gamma_multiply(0.85));
    painter.galley(rect.min + vec2(8.0, 4.0), galley, ACCENT);
}
