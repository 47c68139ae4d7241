//! A picture in horizontal bands, so that memory stays bounded whatever the picture's size.

use crate::Error;
use crate::records::Band;
use glam::{Mat4, Vec3, Vec4};
use sh_scene::{Ground, View};
use wgpu::{Buffer, BufferUsages, Device, Queue};

/// Bytes from one band's record to the next: the alignment that every device grants for dynamic offsets.
pub(crate) const STRIDE: u64 = 256;

/// A band's rows of samples must be a multiple of this, so that its pixels begin at a multiple of 256 bytes
/// in the picture: 16 rows of pixels, 16 bytes a pixel.
const ROW_STEP: u32 = 16 * View::OVERSAMPLE;

/// The near plane, for a camera that looks at something 1 away. Depth is a float that is largest there, so
/// that it costs no precision to put it this near.
const NEAR: f32 = 1e-4;

/// The bands of a picture of a given size, top to bottom, and their records on the GPU.
#[derive(Debug)]
pub struct Bands {
    width: u32,
    height: u32,
    /// Rows of samples of all bands but the last.
    rows: u32,
    buffer: Buffer,
}

impl Bands {
    /// The most samples a band holds unless said otherwise: 100 MiB of G-buffer, receivers and radiance.
    pub const MAX_SAMPLES: u32 = 1 << 20;

    /// Divides a picture of `width` by `height` pixels into bands of at most `max_samples` samples, though
    /// never fewer than 32 rows.
    pub fn new(device: &Device, width: u32, height: u32, max_samples: u32) -> Result<Self, Error> {
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
        let columns = across as u32;
        let most = (max_samples / columns).min(limits.max_texture_dimension_2d);
        let most = (most / ROW_STEP * ROW_STEP).max(ROW_STEP);
        let all = height * View::OVERSAMPLE;
        // Bands of one height, as far as the step allows.
        let rows = all.div_ceil(all.div_ceil(most)).next_multiple_of(ROW_STEP);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("gaunt bands"),
            size: u64::from(all.div_ceil(rows)) * STRIDE,
            usage: BufferUsages::UNIFORM | BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        Ok(Self {
            width,
            height,
            rows,
            buffer,
        })
    }

    /// How many bands there are.
    pub fn count(&self) -> u32 {
        (self.height * View::OVERSAMPLE).div_ceil(self.rows)
    }

    /// Samples across.
    pub fn columns(&self) -> u32 {
        self.width * View::OVERSAMPLE
    }

    /// Rows of samples of a band: the same for all but the last, which may have fewer. None for a band
    /// that is not there.
    pub fn rows(&self, band: u32) -> u32 {
        let below = (self.height * View::OVERSAMPLE).saturating_sub(band.saturating_mul(self.rows));
        below.min(self.rows)
    }

    /// Samples of a band.
    pub fn samples(&self, band: u32) -> u64 {
        u64::from(self.columns()) * u64::from(self.rows(band))
    }

    /// Where a band's pixels are in a picture of 16 bytes a pixel: offset and size in bytes.
    pub fn picture_range(&self, band: u32) -> (u64, u64) {
        let row = u64::from(self.width) * 16;
        let first = u64::from(band) * u64::from(self.rows / View::OVERSAMPLE);
        (
            first * row,
            u64::from(self.rows(band) / View::OVERSAMPLE) * row,
        )
    }

    /// Uploads camera and ground for what is submitted next. The view must have the size the bands were
    /// made for.
    pub fn prepare(&self, queue: &Queue, view: &View, ground: Option<Ground>) -> Result<(), Error> {
        let mut bytes = vec![0; self.buffer.size() as usize];
        for band in 0..self.count() {
            let record = self.camera(view, ground, band)?;
            let at = band as usize * STRIDE as usize;
            bytes[at..at + size_of::<Band>()].copy_from_slice(bytemuck::bytes_of(&record));
        }
        queue.write_buffer(&self.buffer, 0, &bytes);
        Ok(())
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
        if (width, height) != (self.width, self.height) {
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
        let near = reach * NEAR;
        let [right, up, forward] = view.axes();
        let tall = (view.camera.fov * 0.5).tan();
        let wide = tall * view.width as f32 / view.height as f32;
        let (first_row, rows) = (band * self.rows, self.rows(band));
        // Clip space of the band: y is stretched so that the band's rows alone fill -1..1.
        let all = (view.height * View::OVERSAMPLE) as f32;
        let stretch = all / rows as f32;
        let shift = (2 * first_row + rows) as f32 / rows as f32 - stretch;
        let fit = Mat4::from_cols(
            Vec4::X,
            Vec4::Y * stretch,
            Vec4::Z,
            Vec4::new(0.0, shift, 0.0, 1.0),
        );
        Ok(Band {
            clip_from_world: fit * view.clip_from_world(near),
            eye: view.camera.eye,
            near,
            right: right * wide,
            first_row,
            up: up * tall,
            rows,
            forward,
            ground: u32::from(ground.is_some()),
            grid: [self.columns(), view.height * View::OVERSAMPLE],
            ground_height: ground.map_or(0.0, |g| g.height),
            padding: 0,
            ground_albedo: ground.map_or(Vec3::ZERO, |g| g.albedo.into()),
            tail: 0,
        })
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
