//! What the passes of a frame hand each other.

use crate::{Bands, Error, HalfBinding};
use sh_scene::{Receiver, Tiles};
use wgpu::{Buffer, BufferBinding, BufferSize, BufferUsages, Device};

/// Bytes of a receiver, and of an albedo, a radiance or a pixel.
const RECEIVER: u64 = size_of::<Receiver>() as u64;
const COLOR: u64 = 16;

/// One band's samples, the whole picture at half resolution where there is one, and the picture.
#[derive(Debug)]
pub(crate) struct Buffers {
    receivers: Buffer,
    albedo: Buffer,
    radiance: Buffer,
    /// Receivers and radiance.
    halves: Option<[Buffer; 2]>,
    pub picture: Buffer,
}

impl Buffers {
    pub fn new(device: &Device, bands: &Bands, halves: Option<&Bands>) -> Result<Self, Error> {
        let most = device.limits().max_buffer_size;
        let buffer = |name: &'static str, size: u64, usage: BufferUsages| {
            Error::within(name, size, "max_buffer_size", most)?;
            Ok::<_, Error>(device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(&format!("gaunt {name}")),
                size,
                usage: usage | BufferUsages::STORAGE,
                mapped_at_creation: false,
            }))
        };
        let none = BufferUsages::empty();
        let samples = bands.receivers(0);
        // Nobody reads the albedo at half resolution, but it is written.
        let widest = samples.max(halves.map_or(0, |halves| halves.receivers(0)));
        let all = |bands: &Bands, of: &dyn Fn(u32) -> u64| (0..bands.count()).map(of).sum::<u64>();
        let halves = match halves {
            Some(bands) => {
                let count = all(bands, &|band| bands.receivers(band));
                Some([
                    buffer("receivers at half resolution", count * RECEIVER, none)?,
                    buffer("radiance at half resolution", count * COLOR, none)?,
                ])
            }
            None => None,
        };
        let pixels = all(bands, &|band| bands.picture_range(band).1);
        Ok(Self {
            receivers: buffer("receivers", samples * RECEIVER, none)?,
            albedo: buffer("albedo", widest * COLOR, none)?,
            radiance: buffer("radiance", samples * COLOR, none)?,
            halves,
            picture: buffer("picture", pixels, BufferUsages::COPY_SRC)?,
        })
    }

    /// Receivers, albedo and radiance of a band of samples.
    pub fn samples(&self, bands: &Bands, band: u32) -> [BufferBinding<'_>; 3] {
        let count = bands.receivers(band);
        [
            part(&self.receivers, 0, count * RECEIVER),
            part(&self.albedo, 0, count * COLOR),
            part(&self.radiance, 0, count * COLOR),
        ]
    }

    /// Receivers, albedo and radiance of a band at half resolution, or none where there is no such thing.
    pub fn half_band(&self, halves: &Bands, band: u32) -> Option<[BufferBinding<'_>; 3]> {
        let count = halves.receivers(band);
        let before = (0..band).map(|band| halves.receivers(band)).sum();
        let HalfBinding { receivers, shares } = self.half_part(before, count)?;
        Some([receivers, part(&self.albedo, 0, count * COLOR), shares])
    }

    /// What lies at half resolution under a band of samples.
    pub fn under(&self, bands: &Bands, halves: &Bands, band: u32) -> Option<HalfBinding<'_>> {
        let rows = bands.half_tile_rows(band);
        let row = u64::from(halves.tiles(0).columns) * Tiles::AREA as u64;
        self.half_part(
            u64::from(rows.start) * row,
            u64::from(rows.end - rows.start) * row,
        )
    }

    fn half_part(&self, first: u64, count: u64) -> Option<HalfBinding<'_>> {
        let [receivers, shares] = self.halves.as_ref()?;
        Some(HalfBinding {
            receivers: part(receivers, first * RECEIVER, count * RECEIVER),
            shares: part(shares, first * COLOR, count * COLOR),
        })
    }

    /// A band's part of the picture.
    pub fn picture_of(&self, bands: &Bands, band: u32) -> BufferBinding<'_> {
        let (offset, size) = bands.picture_range(band);
        part(&self.picture, offset, size)
    }
}

fn part(buffer: &Buffer, offset: u64, size: u64) -> BufferBinding<'_> {
    BufferBinding {
        buffer,
        offset,
        size: BufferSize::new(size),
    }
}
