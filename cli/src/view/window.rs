//! The window on a display, by eframe; the GPU that draws it renders the scene as well, if it is one.

use super::app::App;
use super::options::Options;
use crate::Error;
use crate::gpu::Gpu;
use eframe::egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};
use egui::viewport::ViewportCommand;
use egui::{ColorImage, Context, ViewportBuilder};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What is left of a window that was closed.
#[derive(Default)]
pub(super) struct Left {
    /// The picture of it that was asked for.
    pub picture: Option<Arc<ColorImage>>,
    /// Why there is none.
    pub error: Option<Error>,
}

/// Makes the app once there is a window and, perhaps, a GPU for the passes.
pub(super) type Make<'a> = &'a dyn Fn(&Context, Gpu) -> Result<App, Error>;

/// Opens the window and returns when it is closed.
///
/// # Errors
/// Where there is no display, or nothing to draw with; then `make` has not been called, or its error is in what is
/// left.
pub(super) fn open(options: &Options, name: &str, make: Make) -> Result<Left, eframe::Error> {
    let [width, height] = options.size.map(|side| side as f32);
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.device_descriptor = Arc::new(Gpu::wants);
    let native = eframe::NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title(format!("{name} - gaunt"))
            .with_inner_size([width, height])
            .with_min_inner_size([640.0, 400.0]),
        wgpu_options: WgpuConfiguration {
            wgpu_setup: WgpuSetup::CreateNew(setup),
            ..WgpuConfiguration::default()
        },
        dithering: false,
        ..Default::default()
    };
    let left = Arc::new(Mutex::new(Left::default()));
    let its = Arc::clone(&left);
    let scripted = options.screenshot.is_some();
    eframe::run_native(
        "gaunt",
        native,
        Box::new(move |creation| {
            let ctx = &creation.egui_ctx;
            App::dress(ctx);
            let state = creation
                .wgpu_render_state
                .as_ref()
                .ok_or("no GPU driver was found")?;
            let gpu = Gpu::of(&state.adapter, &state.device, &state.queue);
            let app = match make(ctx, gpu) {
                Ok(app) => Some(app),
                Err(error) => {
                    lock(&its).error = Some(error);
                    None
                }
            };
            Ok(Box::new(Window {
                app,
                left: its,
                scripted,
                asked: false,
            }))
        }),
    )?;
    Ok(std::mem::take(&mut *lock(&left)))
}

fn lock(left: &Mutex<Left>) -> MutexGuard<'_, Left> {
    left.lock().unwrap_or_else(PoisonError::into_inner)
}

struct Window {
    /// None where it could not be made: the window closes at once.
    app: Option<App>,
    left: Arc<Mutex<Left>>,
    /// Whether a picture of the window is wanted.
    scripted: bool,
    /// Whether it has been asked for.
    asked: bool,
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        let Some(app) = &mut self.app else {
            ctx.send_viewport_cmd(ViewportCommand::Close);
            return;
        };
        let last = app.finished();
        app.ui(ui);
        if !self.scripted {
            return;
        }
        if let Some(error) = app.error() {
            lock(&self.left).error = Some(Error::Gpu(error.into()));
            ctx.send_viewport_cmd(ViewportCommand::Close);
        } else if last && !self.asked {
            self.asked = true;
            let (left, window) = (Arc::clone(&self.left), ctx.clone());
            ctx.request_screenshot(move |image| {
                lock(&left).picture = Some(image);
                window.send_viewport_cmd(ViewportCommand::Close);
            });
        }
        // Nobody moves the pointer.
        ctx.request_repaint();
    }

    fn clear_color(&self, _: &egui::Visuals) -> [f32; 4] {
        super::look::BACK.to_normalized_gamma_f32()
    }
}
