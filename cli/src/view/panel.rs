//! The panel: what can be set, and what the picture took.

use super::Hints;
use super::look::{ACCENT, FAINT, WRONG, bold, note, title};
use super::state::{Facts, State};
use super::wish::{Overlay, Shown};
use crate::report::Stage;
use egui::{Align, ComboBox, Layout, Rect, RichText, Slider, Ui, vec2};
use sh_core::ORDERS;
use sh_scene::{Blocking, Indirect, Limits, Quality};

/// What the panel shows besides the state.
pub(super) struct Told<'a> {
    pub facts: &'a Facts,
    pub hints: &'a Hints,
    pub shown: Option<&'a Shown>,
    pub busy: Option<&'a (String, f32)>,
    pub error: Option<&'a str>,
    /// The size of a picture when nothing moves.
    pub full: [u32; 2],
}

/// Room for the names of controls, in points.
const NAMES: f32 = 94.0;

/// All of the panel.
pub(super) fn panel(ui: &mut Ui, state: &mut State, told: &Told) {
    head(ui, told);
    light(ui, state, told.hints);
    shadows(ui, state, told);
    indirect(ui, state);
    overlays(ui, state);
    times(ui, told);
}

fn head(ui: &mut Ui, told: &Told) {
    ui.label(bold(&told.facts.name, 17.0));
    let spheres = told.shown.map_or(told.facts.spheres, |shown| shown.spheres);
    let device = told.shown.map_or("…", |shown| &shown.device);
    // In one place, so that nothing below moves.
    note(
        ui,
        match told.busy {
            Some((what, part)) => format!("{what}, {:.0} %", 100.0 * part),
            None => format!("{spheres} spheres, on {device}"),
        },
    );
    for sentence in &told.facts.sentences {
        note(ui, sentence);
    }
    if let Some(error) = told.error {
        ui.label(RichText::new(error).small().color(WRONG));
    }
}

/// A control with its name before it. Pointing at the name tells what it is.
fn row(ui: &mut Ui, name: &str, hint: &str, control: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        let size = vec2(NAMES, ui.spacing().interact_size.y);
        let words = |ui: &mut Ui| {
            ui.set_min_width(NAMES);
            ui.label(RichText::new(name).color(FAINT))
        };
        let label = ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), words);
        if !hint.is_empty() {
            label.inner.on_hover_text(hint);
        }
        control(ui);
    });
}

/// Some words side by side, of which one is chosen.
fn choice<T: PartialEq + Copy>(
    ui: &mut Ui,
    chosen: Option<T>,
    all: impl IntoIterator<Item = (T, String, String)>,
) -> Option<T> {
    let mut now = None;
    ui.spacing_mut().item_spacing.x = 3.0;
    for (value, name, hint) in all {
        let mut button = ui.selectable_label(chosen == Some(value), name);
        if !hint.is_empty() {
            button = button.on_hover_text(hint);
        }
        if button.clicked() {
            now = Some(value);
        }
    }
    now
}

/// With a capital letter.
fn capital(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

fn light(ui: &mut Ui, state: &mut State, hints: &Hints) {
    title(ui, "Light");
    let settings = &mut state.settings;
    row(ui, "Quality", hints.of("quality"), |ui| {
        let is = |quality: &Quality| settings.with_quality(*quality) == *settings;
        let chosen = Quality::ALL.into_iter().find(is);
        let all = Quality::ALL.map(|quality| {
            let name = quality.name();
            (quality, capital(name), hints.of(name).to_string())
        });
        if let Some(quality) = choice(ui, chosen, all) {
            *settings = settings.with_quality(quality);
        }
    });
    row(ui, "SH order", hints.of("order"), |ui| {
        let mut order = settings.order;
        if ui.add(Slider::new(&mut order, ORDERS)).changed() {
            *settings = settings.with_order(order);
        }
    });
    row(
        ui,
        "Rotation",
        "Turns the environment and the discs in the sky about the vertical.",
        |ui| {
            let slider = Slider::new(&mut state.turn, -180.0..=180.0).suffix("°");
            ui.add(slider.fixed_decimals(0));
        },
    );
    row(ui, "Exposure", "Brighter by so many stops.", |ui| {
        let slider = Slider::new(&mut state.stops, -4.0..=4.0).suffix(" EV");
        ui.add(slider.fixed_decimals(1));
    });
}

fn shadows(ui: &mut Ui, state: &mut State, told: &Told) {
    title(ui, "Shadows");
    let settings = &mut state.settings;
    row(ui, "Shadows", told.hints.of("shadows"), |ui| {
        ui.checkbox(&mut settings.shadows, "");
    });
    row(
        ui,
        "Half resolution",
        told.hints.of("half_resolution"),
        |ui| {
            ui.add_enabled_ui(settings.shadows, |ui| {
                ui.checkbox(&mut settings.half_resolution, "");
            });
        },
    );
    row(ui, "Accumulation", told.hints.of("accumulation"), |ui| {
        let lowest = settings.order;
        let slider = Slider::new(&mut settings.accumulation, lowest..=6);
        // With one value there is nothing to slide.
        ui.add_enabled(settings.shadows && lowest < 6, slider);
    });
    let group = "Groups of spheres below this angular radius count as one.";
    row(ui, "Group below", group, |ui| {
        let mut angle = settings.limits.sin_max.asin().to_degrees();
        let slider = Slider::new(&mut angle, 0.0..=30.0)
            .suffix("°")
            .fixed_decimals(0);
        if ui.add_enabled(settings.shadows, slider).changed() {
            settings.limits = Limits {
                sin_max: angle.to_radians().sin(),
                ..settings.limits
            };
        }
    });
    let budget =
        "How many spheres stand for all meshes. They are fitted anew when the slider is let go.";
    row(ui, "Spheres", budget, |ui| {
        let all = told.facts.spheres.max(1) as f64;
        let slider = Slider::new(&mut state.spheres_wanted, 0.125..=4.0)
            .logarithmic(true)
            .custom_formatter(move |factor, _| format!("{:.0}", factor * all))
            .custom_parser(move |text| Some(text.trim().parse::<f64>().ok()? / all));
        let slider = ui.add(slider);
        if !slider.dragged() && !slider.has_focus() {
            state.spheres = state.spheres_wanted;
        }
    });
}

fn indirect(ui: &mut Ui, state: &mut State) {
    title(ui, "Bounced light");
    let settings = &mut state.settings;
    let mut on = settings.indirect.is_some();
    row(
        ui,
        "Bodies shine",
        "Bodies send on what light falls on them.",
        |ui| {
            if ui.checkbox(&mut on, "").changed() {
                settings.indirect = on.then_some(state.indirect);
            }
        },
    );
    let mut now = state.indirect;
    row(
        ui,
        "Bounces",
        "How often light is sent on before it reaches the eye.",
        |ui| {
            let slider = Slider::new(&mut now.bounces, 1..=Indirect::MOST_BOUNCES.min(6));
            ui.add_enabled(on, slider);
        },
    );
    row(
        ui,
        "Blocked by",
        "What hides one body's light from another.",
        |ui| {
            ui.add_enabled_ui(on, |ui| {
                let chosen = capital(now.blocking.name());
                ComboBox::from_id_salt("blocking")
                    .selected_text(chosen)
                    .show_ui(ui, |ui| {
                        for blocking in Blocking::ALL {
                            ui.selectable_value(
                                &mut now.blocking,
                                blocking,
                                capital(blocking.name()),
                            );
                        }
                    });
            });
        },
    );
    state.indirect = now;
    settings.indirect = settings.indirect.map(|_| now);
}

fn overlays(ui: &mut Ui, state: &mut State) {
    title(ui, "Overlay");
    // One row of them is wider than the panel, which would grow into the picture.
    ui.horizontal_wrapped(|ui| {
        let all = Overlay::ALL.map(|o| (o, o.name().to_string(), String::new()));
        if let Some(overlay) = choice(ui, Some(state.overlay), all) {
            state.overlay = overlay;
        }
    });
}

/// What the picture took, pass by pass, and why each pass is there.
fn times(ui: &mut Ui, told: &Told) {
    title(ui, "Plan and time");
    let Some(shown) = told.shown else {
        note(ui, "…");
        return;
    };
    let [width, height] = shown.wish.size;
    let size = match shown.wish.size == told.full {
        true => format!("{width} × {height} pixels"),
        false => {
            let [wide, high] = told.full;
            format!("{width} × {height} of {wide} × {high} pixels")
        }
    };
    let most = shown.stages.iter().map(|s| s.seconds).fold(0.0, f64::max);
    for Stage { stage, seconds } in &shown.stages {
        let part = if most > 0.0 { seconds / most } else { 0.0 };
        time(ui, stage, Some(*seconds), part as f32);
        for pass in shown.plan.iter().filter(|pass| pass.pass == *stage) {
            note(ui, &pass.reason);
        }
    }
    let untimed = |name: &str| shown.stages.iter().all(|stage| stage.stage != name);
    for pass in shown.plan.iter().filter(|pass| untimed(pass.pass)) {
        time(ui, pass.pass, None, 0.0);
        note(ui, &pass.reason);
    }
    ui.add_space(2.0);
    time(ui, "the picture", Some(shown.seconds), 0.0);
    note(ui, size);
}

/// A name, a bar, and milliseconds.
fn time(ui: &mut Ui, name: &str, seconds: Option<f64>, part: f32) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        let (rect, _) =
            ui.allocate_exact_size(vec2(ui.available_width(), 15.0), egui::Sense::hover());
        let font = egui::FontId::proportional(12.5);
        let color = ui.visuals().text_color();
        let (left, right) = (rect.left_center(), rect.right_center());
        let painter = ui.painter();
        painter.text(left, egui::Align2::LEFT_CENTER, name, font.clone(), color);
        let words = match seconds {
            Some(seconds) => milliseconds(seconds),
            None => "not timed".into(),
        };
        painter.text(right, egui::Align2::RIGHT_CENTER, words, font, color);
        let room = Rect::from_min_max(
            rect.left_top() + vec2(NAMES, 5.0),
            rect.right_bottom() - vec2(66.0, 5.0),
        );
        let bar = room.with_max_x(room.left() + room.width() * part);
        painter.rect_filled(bar, 2.0, ACCENT);
    });
}

/// Milliseconds with as many digits as are of use.
fn milliseconds(seconds: f64) -> String {
    let ms = seconds * 1e3;
    match ms {
        _ if ms < 9.95 => format!("{ms:.2} ms"),
        _ if ms < 99.5 => format!("{ms:.1} ms"),
        _ => format!("{ms:.0} ms"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_three_digits() {
        let texts = [0.000_123, 0.0123, 0.1234, 12.345].map(milliseconds);
        assert_eq!(texts, ["0.12 ms", "12.3 ms", "123 ms", "12345 ms"]);
    }
}
