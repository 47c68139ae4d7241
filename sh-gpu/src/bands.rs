//! A grid of rays in horizontal bands, so that memory stays bounded whatever the picture's size.

use crate::Error;
use crate::records::Band;
use crate::upload::{Kept, Known};
use glam::{Mat4, Vec3, Vec4};
use sh_scene::{Grid, Ground, Tiles, View, upsample};
use std::ops::Range;
use wgpu::{Buffer, BufferUsages, Device, Queue};

/// Bytes from one band's record to the next: the alignment that every device grants for dynamic offsets.
pub(crate) const STRIDE: u64 = 256;

/// A band's rows must be a multiple of this: whole tiles, and of samples so many that a band's pixels begin at a
/// multiple of 256 bytes in the picture, 16 rows of pixels of 16 bytes each.
const ROW_STEP: u32 = 16 * View::OVERSAMPLE;

/// The near plane, for a camera that looks at something 1 away. Depth is a float that is largest there, so
/// that it costs no precision to put it this near.
const NEAR_PLANE: f32 = 1e-4;

/// The bands of a grid through a picture of a given size, top to bottom, and their records on the GPU.
///
/// What passes store of a band are whole tiles ([`Tiles`]), filled up with receivers that are not covered.
///
/// ```no_run
/// # fn bands(device: &wgpu::Device, view: &sh_scene::View) -> Result<(), sh_gpu::Error> {
/// let bands = sh_gpu::Bands::new(device, view, view.samples(), sh_gpu::Bands::MAX_SAMPLES)?;
/// for band in 0..bands.count() {
///     println!("{} rows, {} receivers", bands.rows(band), bands.receivers(band));
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Debug)]
pub struct Bands {
    /// Only the size matters.
    view: View,
    grid: Grid,
    /// Rows of all bands but the last.
    rows: u32,
    buffer: Buffer,
    kept: Kept<Vec<u8>>,
    known: Known,
}

impl Bands {
    /// The most cells a band holds unless said otherwise: 160 MiB of G-buffer, receivers and radiance.
    pub const MAX_SAMPLES: u32 = 1 << 20;

    /// Divides a grid of `view` ([`View::samples`] or [`View::halves`]) into bands of at most `max_samples` cells,
    /// though never fewer than 32 rows. The view's camera may be another one later.
    pub fn new(device: &Device, view: &View, grid: Grid, max_samples: u32) -> Result<Self, Error> {
        let View { width, height, .. } = *view;
        if width == 0 || height == 0 {
            let problem = "is empty; both must be positive";
            return Err(Error::View {
                width,
                height,
                problem,
            });
        }
        let limits = device.limits();
        let across = u64::from(width) * u64::from(View::OVERSAMPLE);
        let side = u64::from(limits.max_texture_dimension_2d);
        Error::within(
            "the number of samples across",
            across,
            "max_texture_dimension_2d",
            side,
        )?;
        let picture = u64::from(width) * u64::from(height) * 16;
        Error::within(
            "the picture",
            picture,
            "max_buffer_size",
            limits.max_buffer_size,
        )?;
        let most = (max_samples / grid.columns).min(limits.max_texture_dimension_2d);
        let most = (most / ROW_STEP * ROW_STEP).max(ROW_STEP);
        // Bands of one height, as far as the step allows.
        let bands = grid.rows.div_ceil(most);
        let rows = grid.rows.div_ceil(bands).next_multiple_of(ROW_STEP);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("gaunt bands"),
            size: u64::from(grid.rows.div_ceil(rows)) * STRIDE,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Ok(Self {
            view: *view,
            grid,
            rows,
            buffer,
            kept: Kept::default(),
            known: Known::default(),
        })
    }

    /// Bytes of GPU memory: 256 a band.
    pub fn bytes(&self) -> u64 {
        self.buffer.size()
    }

    /// Bytes that have been uploaded since they were made.
    pub(crate) fn uploaded(&self) -> u64 {
        self.known.written()
    }

    /// How many bands there are.
    pub fn count(&self) -> u32 {
        self.grid.rows.div_ceil(self.rows)
    }

    /// Cells across.
    pub fn columns(&self) -> u32 {
        self.grid.columns
    }

    /// Rows of cells of a band: the same for all but the last, which may have fewer. None for a band
    /// that is not there.
    pub fn rows(&self, band: u32) -> u32 {
        let below = self.grid.rows.saturating_sub(self.first_row(band));
        below.min(self.rows)
    }

    /// The tiles of a band: what its receivers are stored in.
    pub fn tiles(&self, band: u32) -> Tiles {
        Tiles {
            rows: self.rows(band).div_ceil(Tiles::SIDE),
            ..self.grid.tiles()
        }
    }

    /// Receivers of a band, those included that fill up its tiles.
    pub fn receivers(&self, band: u32) -> u64 {
        self.tiles(band).len() as u64
    }

    /// Where a band's pixels are in a picture of 16 bytes a pixel: offset and size in bytes.
    pub fn picture_range(&self, band: u32) -> (u64, u64) {
        let row = u64::from(self.view.width) * 16;
        let first = u64::from(band) * u64::from(self.rows / View::OVERSAMPLE);
        (
            first * row,
            u64::from(self.rows(band) / View::OVERSAMPLE) * row,
        )
    }

    /// The rows of tiles of [`View::halves`] that upsampling to a band of samples reads.
    pub fn half_tile_rows(&self, band: u32) -> Range<u32> {
        let halves = self.view.halves();
        let steps = halves.spacing / self.grid.spacing;
        // The row of `halves` above the middle of a row of cells.
        let above = |row: u32| ((row as f32 + 0.5) / steps - 0.5).floor().max(0.0) as u32;
        let first = self.first_row(band);
        let last = (first + self.rows(band)).saturating_sub(1);
        let below = (above(last) + 1).min(halves.rows.saturating_sub(1));
        above(first) / Tiles::SIDE..below / Tiles::SIDE + 1
    }

    fn first_row(&self, band: u32) -> u32 {
        band.saturating_mul(self.rows)
    }

    /// Uploads camera and ground for what is submitted next. The view must have the size the bands were
    /// made for.
    pub fn prepare(&self, queue: &Queue, view: &View, ground: Option<Ground>) -> Result<(), Error> {
        self.kept.with(|bytes| {
            bytes.clear();
            bytes.resize(self.buffer.size() as usize, 0);
            for band in 0..self.count() {
                let record = self.camera(view, ground, band)?;
                let at = band as usize * STRIDE as usize;
                bytes[at..at + size_of::<Band>()].copy_from_slice(bytemuck::bytes_of(&record));
            }
            self.known.write(queue, &self.buffer, bytes);
            Ok(())
        })
    }

    /// The camera of one band, for a host that draws into it itself
    /// ([`GbufferPass::record_with`](crate::GbufferPass::record_with)).
    pub fn camera(&self, view: &View, ground: Option<Ground>, band: u32) -> Result<Band, Error> {
        let (width, height) = (view.width, view.height);
        let fail = |problem| {
            Err(Error::View {
                width,
                height,
                problem,
            })
        };
        if (width, height) != (self.view.width, self.view.height) {
            return fail("has another size than the bands were made for");
        }
        if self.rows(band) == 0 {
            return fail("has fewer bands than asked for");
        }
        let reach = view.camera.target.distance(view.camera.eye);
        if !(reach > 0.0 && reach.is_finite()) {
            return fail("has no direction; eye and target must be finite and apart");
        }
        if !(view.camera.fov > 0.0 && view.camera.fov < std::f32::consts::PI) {
            return fail("has no angle; the field of view must lie between 0 and π");
        }
        let near = reach * NEAR_PLANE;
        let [right, up, forward] = view.axes();
        let tall = (view.camera.fov * 0.5).tan();
        let wide = tall * view.width as f32 / view.height as f32;
        let (first_row, rows) = (self.first_row(band), self.rows(band));
        let extent = [width, height].map(|pixels| pixels as f32 / self.grid.spacing);
        let halves = view.halves();
        Ok(Band {
            clip_from_world: self.fit(extent, first_row, rows) * view.clip_from_world(near),
            eye: view.camera.eye,
            near,
            right: right * wide,
            first_row,
            up: up * tall,
            rows,
            forward,
            ground: u32::from(ground.is_some()),
            extent,
            columns: self.columns(),
            ground_height: ground.map_or(0.0, |g| g.height),
            ground_albedo: ground.map_or(Vec3::ZERO, |g| g.albedo.into()),
            footprint: upsample::footprint(view),
            half_columns: halves.columns,
            half_rows: halves.rows,
            half_first_row: self.half_tile_rows(band).start * Tiles::SIDE,
            tail: 0,
        })
    }

    /// From the picture's clip space to that of a band, whose cells alone fill -1 to 1.
    fn fit(&self, extent: [f32; 2], first_row: u32, rows: u32) -> Mat4 {
        let [across, down] = [extent[0] / self.columns() as f32, extent[1] / rows as f32];
        let shift = (2 * first_row + rows) as f32 / rows as f32 - down;
        Mat4::from_cols(
            Vec4::X * across,
            Vec4::Y * down,
            Vec4::Z,
            Vec4::new(across - 1.0, shift, 0.0, 1.0),
        )
    }

    /// The record of one band, to be chosen by a dynamic offset of `band * STRIDE`.
    pub(crate) fn binding(&self) -> wgpu::BindingResource<'_> {
        wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: &self.buffer,
            offset: 0,
            size: wgpu::BufferSize::new(size_of::<Band>() as u64),
        })
    }

    /// The dynamic offset of a band's record.
    pub(crate) fn offset(&self, band: u32) -> u32 {
        band * STRIDE as u32
    }
}
