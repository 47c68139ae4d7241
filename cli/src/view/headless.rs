//! The window without a display: drawn in memory, frame by frame.

use super::app::App;
use super::raster::Raster;
use crate::Error;
use egui::{Color32, ColorImage, Context, Pos2, RawInput, Rect, vec2};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Where the worker rings, for whoever waits.
#[derive(Clone, Default)]
pub(super) struct Bell(Arc<(Mutex<bool>, Condvar)>);

impl Bell {
    /// Something is new.
    pub fn ring(&self) {
        let (rung, bell) = &*self.0;
        *rung.lock().unwrap_or_else(PoisonError::into_inner) = true;
        bell.notify_all();
    }

    /// Waits until something is new, or for a second.
    fn wait(&self) {
        let (rung, bell) = &*self.0;
        let rung = rung.lock().unwrap_or_else(PoisonError::into_inner);
        let patience = Duration::from_secs(1);
        let waited = bell.wait_timeout_while(rung, patience, |rung| !*rung);
        *waited.unwrap_or_else(PoisonError::into_inner).0 = false;
    }
}

/// Shows frames until the app's script is finished, and returns the last one.
pub(super) fn picture(mut app: App, bell: &Bell, size: [u32; 2]) -> Result<ColorImage, Error> {
    let ctx = Context::default();
    App::dress(&ctx);
    let mut raster = Raster::default();
    let start = Instant::now();
    let [width, height] = size;
    let screen = Rect::from_min_size(Pos2::ZERO, vec2(width as f32, height as f32));
    loop {
        let last = app.finished();
        let input = RawInput {
            screen_rect: Some(screen),
            time: Some(start.elapsed().as_secs_f64()),
            ..RawInput::default()
        };
        let mut output = ctx.run_ui(input, |ui| app.ui(ui));
        if let Some(error) = app.error() {
            output.drop_without_applying_deltas();
            return Err(Error::Gpu(error.into()));
        }
        raster.update(&output.textures_delta);
        if last {
            let shapes = std::mem::take(&mut output.shapes);
            let primitives = ctx.tessellate(shapes, output.pixels_per_point);
            let mut picture = ColorImage::filled([width as usize, height as usize], Color32::BLACK);
            raster.draw(&primitives, output.pixels_per_point, &mut picture);
            output.drop_without_applying_deltas();
            return Ok(picture);
        }
        raster.free(&output.textures_delta);
        output.drop_without_applying_deltas();
        if !app.finished() {
            bell.wait();
        }
    }
}
