//! What the passes of a frame hand each other.

use crate::scope::checked;
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
    halves: Option<Half>,
    pub picture: Buffer,
}

/// What is kept at half resolution.
#[derive(Debug)]
struct Half {
    receivers: Buffer,
    radiance: Buffer,
    /// Radiance that spheres send, where they do.
    sent: Option<Buffer>,
}

impl Buffers {
    /// `sent`: whether spheres send light on.
    pub fn new(
        device: &Device,
        bands: &Bands,
        halves: Option<&Bands>,
        sent: bool,
    ) -> Result<Self, Error> {
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
        checked(device, || {
            let halves = match halves {
                Some(bands) => {
                    let count = all(bands, &|band| bands.receivers(band));
                    let name = "light that is sent, at half resolution";
                    let sent = sent.then(|| buffer(name, count * COLOR, BufferUsages::COPY_DST));
                    Some(Half {
                        receivers: buffer("receivers at half resolution", count * RECEIVER, none)?,
                        radiance: buffer("radiance at half resolution", count * COLOR, none)?,
                        sent: sent.transpose()?,
                    })
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
        })
    }

    /// Every buffer's name, and its bytes of GPU memory.
    pub fn bytes(&self) -> Vec<(&'static str, u64)> {
        let halves = self.halves.as_ref();
        let all = [
            ("receivers", Some(&self.receivers)),
            ("albedo", Some(&self.albedo)),
            ("radiance", Some(&self.radiance)),
            ("half_receivers", halves.map(|half| &half.receivers)),
            ("half_radiance", halves.map(|half| &half.radiance)),
            ("half_sent", halves.and_then(|half| half.sent.as_ref())),
            ("picture", Some(&self.picture)),
        ];
        let sizes = all.map(|(name, buffer)| buffer.map(|buffer| (name, buffer.size())));
        sizes.into_iter().flatten().collect()
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
        let albedo = part(&self.albedo, 0, halves.receivers(band) * COLOR);
        let half = self.half(halves, band)?;
        Some([half.receivers, albedo, half.shares])
    }

    /// All there is of a band at half resolution.
    pub fn half(&self, halves: &Bands, band: u32) -> Option<HalfBinding<'_>> {
        let before = (0..band).map(|band| halves.receivers(band)).sum();
        self.half_part(before, halves.receivers(band))
    }

    /// What spheres send at half resolution.
    pub fn half_sent(&self) -> Option<&Buffer> {
        self.halves.as_ref()?.sent.as_ref()
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
        let half = self.halves.as_ref()?;
        let color = |buffer| part(buffer, first * COLOR, count * COLOR);
        Some(HalfBinding {
            receivers: part(&half.receivers, first * RECEIVER, count * RECEIVER),
            shares: color(&half.radiance),
            sent: half.sent.as_ref().map(color),
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
