//! How the window looks: one font, a few greys, one accent.

use crate::words::FONTS;
use egui::{
    Color32, Context, CornerRadius, FontData, FontDefinitions, FontFamily, FontId, RichText,
};
use egui::{Stroke, TextStyle, Theme, Ui, Visuals};
use std::sync::Arc;

/// Behind everything.
pub(super) const BACK: Color32 = Color32::from_rgb(24, 25, 28);
/// The panel.
pub(super) const PANEL: Color32 = Color32::from_rgb(31, 32, 36);
/// What can be moved.
const FIELD: Color32 = Color32::from_rgb(50, 52, 58);
const HOVERED: Color32 = Color32::from_rgb(64, 67, 75);
/// Text.
const TEXT: Color32 = Color32::from_rgb(214, 216, 220);
/// What explains.
pub(super) const FAINT: Color32 = Color32::from_rgb(140, 144, 152);
/// What is chosen.
pub(super) const ACCENT: Color32 = Color32::from_rgb(88, 140, 224);
/// What went wrong.
pub(super) const WRONG: Color32 = Color32::from_rgb(238, 128, 110);

/// The width of the panel, in points.
pub(super) const WIDTH: f32 = 320.0;

/// Puts the look into a context. The program's own font is the only one.
pub(super) fn apply(ctx: &Context) {
    let mut fonts = FontDefinitions::empty();
    for (name, bytes) in ["regular", "bold"].into_iter().zip(FONTS) {
        let data = FontData::from_static(bytes);
        fonts.font_data.insert(name.into(), Arc::new(data));
        let family = FontFamily::Name(name.into());
        fonts.families.insert(family, vec![name.into()]);
    }
    for family in [FontFamily::Proportional, FontFamily::Monospace] {
        fonts.families.insert(family, vec!["regular".into()]);
    }
    ctx.set_fonts(fonts);
    ctx.set_theme(Theme::Dark);
    ctx.set_visuals_of(Theme::Dark, visuals());
    ctx.all_styles_mut(|style| {
        let sizes = [
            (TextStyle::Small, 11.5),
            (TextStyle::Body, 13.5),
            (TextStyle::Button, 13.5),
            (TextStyle::Monospace, 12.5),
            (TextStyle::Heading, 17.0),
        ];
        style.text_styles = sizes
            .into_iter()
            .map(|(name, size)| (name, FontId::proportional(size)))
            .collect();
        style.spacing.item_spacing = egui::vec2(8.0, 6.0);
        style.spacing.button_padding = egui::vec2(6.0, 3.0);
        style.spacing.slider_width = 108.0;
        // Numbers beside sliders are all of one width.
        style.spacing.interact_size = egui::vec2(58.0, 20.0);
        style.interaction.selectable_labels = false;
        // Nothing fades: a picture taken at once is the same as one taken later.
        style.animation_time = 0.0;
    });
}

fn visuals() -> Visuals {
    let mut visuals = Visuals::dark();
    visuals.panel_fill = PANEL;
    visuals.window_fill = PANEL;
    visuals.extreme_bg_color = FIELD;
    visuals.override_text_color = None;
    visuals.selection.bg_fill = ACCENT.gamma_multiply(0.75);
    visuals.selection.stroke = Stroke::new(1.0, Color32::WHITE);
    visuals.slider_trailing_fill = true;
    let widgets = &mut visuals.widgets;
    for (look, fill) in [
        (&mut widgets.inactive, FIELD),
        (&mut widgets.hovered, HOVERED),
        (&mut widgets.active, HOVERED),
        (&mut widgets.open, FIELD),
    ] {
        look.bg_fill = fill;
        look.weak_bg_fill = fill;
        look.bg_stroke = Stroke::NONE;
        look.fg_stroke = Stroke::new(1.0, TEXT);
        look.corner_radius = CornerRadius::same(4);
        look.expansion = 0.0;
    }
    widgets.noninteractive.fg_stroke = Stroke::new(1.0, TEXT);
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, FIELD);
    visuals
}

/// Text in bold.
pub(super) fn bold(text: impl Into<String>, size: f32) -> RichText {
    RichText::new(text).font(FontId::new(size, FontFamily::Name("bold".into())))
}

/// The title of a group, with room above it.
pub(super) fn title(ui: &mut Ui, text: &str) {
    ui.add_space(10.0);
    ui.label(bold(text, 13.5));
    ui.add_space(1.0);
}

/// Small, faint text that explains.
pub(super) fn note(ui: &mut Ui, text: impl Into<String>) {
    ui.label(RichText::new(text).small().color(FAINT));
}
