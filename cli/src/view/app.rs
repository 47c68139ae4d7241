//! The window's contents, whoever draws them: eframe in a window, or `headless` in memory.

use super::look::{BACK, PANEL, WIDTH};
use super::pace::{Pace, even};
use super::panel::{Told, panel};
use super::stage;
use super::state::{Facts, State};
use super::wish::{Layer, Overlay, Shown, Wish};
use super::worker::Worker;
use super::{Hints, look};
use egui::{CentralPanel, Color32, Context, Frame, Margin, Panel, Rect, ScrollArea, Sense};
use egui::{TextureHandle, TextureOptions, Ui, pos2, vec2};
use std::collections::VecDeque;
use std::time::Duration;

/// Seconds of motion between two frames of a script.
pub(super) const FRAME: f64 = 1.0 / 30.0;

/// Seconds without a change after which nothing moves.
const REST: f64 = 0.2;

/// What becomes of a picture of the window that was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Script {
    /// Frames of motion to show, the last of which is pictured.
    pub frames: u32,
    done: u32,
}

impl Script {
    /// A picture after so many frames.
    pub fn new(frames: u32) -> Self {
        Self { frames, done: 0 }
    }
}

/// The contents of the window.
pub(super) struct App {
    facts: Facts,
    hints: Hints,
    state: State,
    worker: Worker,
    asked: Option<Wish>,
    shown: Option<Shown>,
    layer: Option<(Wish, Layer)>,
    busy: Option<(String, f32)>,
    error: Option<String>,
    picture: Option<TextureHandle>,
    veil: Option<TextureHandle>,
    pace: Pace,
    full: [u32; 2],
    /// What was wished for at rest, without its size, and since when.
    last: Option<(Wish, f64)>,
    /// When the latest pictures came.
    arrivals: VecDeque<f64>,
    script: Option<Script>,
}

impl App {
    pub fn new(
        facts: Facts,
        hints: Hints,
        state: State,
        worker: Worker,
        script: Option<Script>,
    ) -> Self {
        Self {
            facts,
            hints,
            state,
            worker,
            asked: None,
            shown: None,
            layer: None,
            busy: None,
            error: None,
            picture: None,
            veil: None,
            pace: Pace::default(),
            full: [0; 2],
            last: None,
            arrivals: VecDeque::new(),
            script,
        }
    }

    /// Puts the look into a context, before the first frame.
    pub fn dress(ctx: &Context) {
        look::apply(ctx);
    }

    /// Why there is no picture, if there is none.
    pub fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// Whether all frames that a script asks for have been shown.
    pub fn finished(&self) -> bool {
        self.script
            .is_some_and(|script| script.done >= script.frames)
    }

    /// One frame of the window.
    pub fn ui(&mut self, ui: &mut Ui) {
        let now = ui.input(|input| input.time);
        self.hear(ui.ctx(), now);
        self.advance(ui);
        let told = Told {
            facts: &self.facts,
            hints: &self.hints,
            shown: self.shown.as_ref(),
            busy: self.busy.as_ref(),
            error: self.error.as_deref(),
            full: self.full,
        };
        let side = Frame::new()
            .fill(PANEL)
            .inner_margin(Margin::symmetric(14, 12));
        Panel::right("panel")
            .exact_size(WIDTH)
            .resizable(false)
            .show_separator_line(false)
            .frame(side)
            .show(ui, |ui| {
                ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                    // The bar for scrolling lies over what is at the edge.
                    ui.set_max_width(WIDTH - 38.0);
                    panel(ui, &mut self.state, &told);
                });
            });
        if self.facts.length.is_some() {
            let below = Frame::new()
                .fill(PANEL)
                .inner_margin(Margin::symmetric(12, 0));
            Panel::bottom("time")
                .exact_size(38.0)
                .resizable(false)
                .show_separator_line(false)
                .frame(below)
                .show(ui, |ui| stage::bar(ui, &self.facts, &mut self.state));
        }
        let frame = Frame::new().fill(BACK);
        CentralPanel::no_frame()
            .frame(frame)
            .show(ui, |ui| self.stage(ui));
        self.wish(ui.ctx(), now);
    }

    /// Takes what the worker has made.
    fn hear(&mut self, ctx: &Context, now: f64) {
        let news = self.worker.news();
        self.busy = news.busy;
        if let Some(shown) = news.shown {
            let image = std::sync::Arc::clone(&shown.image);
            upload(
                ctx,
                &mut self.picture,
                "picture",
                image,
                TextureOptions::LINEAR,
            );
            self.pace.note(shown.wish.size, shown.seconds);
            self.layer = shown.layer.clone().map(|layer| (shown.wish, layer));
            self.lay(ctx);
            self.arrivals.push_back(now);
            self.shown = Some(shown);
            self.error = None;
        }
        if let Some(layer) = news.layer {
            self.layer = Some(layer);
            self.lay(ctx);
        }
        if let Some(error) = news.error {
            self.error = Some(error);
        }
        while self.arrivals.len() > 16 || self.arrivals.front().is_some_and(|t| now - t > 2.0) {
            self.arrivals.pop_front();
        }
    }

    fn lay(&mut self, ctx: &Context) {
        if let Some((wish, layer)) = &self.layer {
            let options = match wish.overlay {
                Overlay::Error => TextureOptions::LINEAR,
                _ => TextureOptions::NEAREST,
            };
            let image = std::sync::Arc::clone(&layer.image);
            upload(ctx, &mut self.veil, "layer", image, options);
        }
    }

    /// Moves time on: with the clock, or frame by frame where a picture of the window is wanted.
    fn advance(&mut self, ui: &Ui) {
        let settled = self.settled();
        let Some(length) = self.facts.length else {
            if let Some(script) = self.script.as_mut().filter(|_| settled) {
                script.done += 1;
            }
            return;
        };
        if let Some(script) = &mut self.script {
            if settled && script.done < script.frames {
                script.done += 1;
                if script.done < script.frames {
                    self.state.seconds = f64::from(script.done) * FRAME;
                }
            }
        } else if self.state.playing {
            let passed = f64::from(ui.input(|input| input.unstable_dt)).min(0.25);
            self.state.seconds = (self.state.seconds + passed).rem_euclid(length);
        }
    }

    /// Whether the picture that was wished for last is there, with all that is laid over it.
    fn settled(&self) -> bool {
        let shown = self.shown.as_ref().map(|shown| shown.wish);
        let laid = self.layer.as_ref().map(|(wish, _)| *wish);
        let tracing = self.state.overlay == Overlay::Error;
        self.error.is_some()
            || shown.is_some() && shown == self.asked && (!tracing || laid == shown)
    }

    /// The picture and what is laid over it.
    fn stage(&mut self, ui: &mut Ui) {
        let scale = ui.ctx().pixels_per_point();
        let room = ui.available_rect_before_wrap();
        // As many pixels as there are, but an even number.
        let side = |points: f32| ((points * scale) as u32 & !1).max(2);
        self.full = [side(room.width()), side(room.height())];
        let size = vec2(self.full[0] as f32, self.full[1] as f32) / scale;
        let rect = Rect::from_min_size(room.min, size);
        let response = ui.allocate_rect(rect, Sense::click_and_drag());
        stage::steer(ui, &response, &mut self.state);
        let painter = ui.painter_at(rect);
        let all = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        let (Some(shown), Some(picture)) = (&self.shown, &self.picture) else {
            return;
        };
        painter.image(picture.id(), rect, all, Color32::WHITE);
        let chosen = self.state.overlay;
        if let (Some((wish, layer)), Some(veil)) = (&self.layer, &self.veil)
            && wish.overlay == chosen
        {
            painter.image(veil.id(), rect, all, Color32::WHITE);
            stage::legend(&painter, rect, layer);
        }
        if chosen == Overlay::Spheres {
            stage::spheres(&painter, rect, shown.wish.camera, &shown.balls);
        }
        stage::caption(&painter, rect, shown, self.full, self.rate());
    }

    /// Pictures a second, while it plays.
    fn rate(&self) -> Option<f64> {
        let (first, last) = (self.arrivals.front()?, self.arrivals.back()?);
        let moving = self.state.playing && self.facts.length.is_some() && self.script.is_none();
        (moving && last > first).then(|| (self.arrivals.len() - 1) as f64 / (last - first))
    }

    /// Asks for the picture of the state as it is now: a smaller one while it changes, if that is needed to keep up.
    fn wish(&mut self, ctx: &Context, now: f64) {
        let rest = self.state.wish([0; 2], true);
        let since = match self.last {
            Some((last, since)) if last == rest => since,
            // The first picture is not the end of a movement.
            None => now - REST,
            Some(_) => now,
        };
        self.last = Some((rest, since));
        let moving = self.script.is_none() && now - since < REST;
        let size = match moving {
            true => self.pace.moving(self.full),
            false => self.full.map(even),
        };
        if moving {
            ctx.request_repaint_after(Duration::from_secs_f64(REST));
        }
        let wish = self.state.wish(size, !moving);
        if self.asked != Some(wish) {
            self.worker.wish(wish);
            self.asked = Some(wish);
        }
        if self.state.playing && self.script.is_none() && self.facts.length.is_some() {
            // The next frame comes with the next picture; this is for pictures that are faster than the screen.
            ctx.request_repaint_after(Duration::from_millis(16));
        }
    }
}

fn upload(
    ctx: &Context,
    handle: &mut Option<TextureHandle>,
    name: &str,
    image: std::sync::Arc<egui::ColorImage>,
    options: TextureOptions,
) {
    match handle {
        Some(handle) => handle.set(image, options),
        none => *none = Some(ctx.load_texture(name, image, options)),
    }
}
