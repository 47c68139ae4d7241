//! What the passes of a frame hand each other: a buffer for every resource that a pass of the plan makes.

use crate::scope::checked;
use crate::{Bands, Error};
use sh_scene::resource::ALBEDO;
use sh_scene::{Domain, Plan, Resource, Tiles};
use std::borrow::Cow;
use wgpu::{Buffer, BufferBinding, BufferSize, BufferUsages, Device};

/// Surface points, one band's samples, the whole picture at half resolution where there is one, and what there is of all pixels. The list
/// that upsampling leaves is the upsample pass's own.
#[derive(Debug)]
pub(crate) struct Buffers(Vec<Held>);

/// The memory of one or more resources of a domain.
#[derive(Debug)]
struct Held {
    memory: &'static str,
    at: Domain,
    /// Bytes of an element.
    stride: u64,
    /// Index of the first pass of the plan that makes something in it.
    maker: usize,
    buffer: Buffer,
}

impl Buffers {
    /// Those of a plan, with so many points around spheres and so many of patches.
    pub fn new(
        device: &Device,
        plan: &Plan,
        bands: &Bands,
        halves: Option<&Bands>,
        points: [u64; 2],
    ) -> Result<Self, Error> {
        let most = device.limits().max_buffer_size;
        let mut all: Vec<Held> = Vec::new();
        let made = plan.passes.iter().enumerate().flat_map(|(maker, planned)| {
            let slots = planned.slots().into_iter();
            let written = slots.filter(|slot| slot.access.makes());
            written.map(move |slot| (maker, slot.bound(planned.at)))
        });
        for (maker, (resource, at)) in made {
            let held = all.iter().any(|held| held.is(resource, at));
            let count = elements(resource, at, (bands, halves, points));
            let Some(count) = count.filter(|_| !held) else {
                continue;
            };
            let size = count * resource.bytes;
            let name = name(resource.memory, at);
            Error::within(resource.memory, size, "max_buffer_size", most)?;
            let buffer = checked(device, || {
                Ok(device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(&format!("gaunt {name}")),
                    size,
                    usage: usage(at),
                    mapped_at_creation: false,
                }))
            })?;
            all.push(Held {
                memory: resource.memory,
                at,
                stride: resource.bytes,
                maker,
                buffer,
            });
        }
        Ok(Self(all))
    }

    /// Each buffer's name, the pass of the plan that first writes it, and its bytes of GPU memory.
    pub fn told(&self) -> impl Iterator<Item = (Cow<'static, str>, usize, u64)> {
        let all = self.0.iter();
        all.map(|held| (name(held.memory, held.at), held.maker, held.buffer.size()))
    }

    /// The buffer of a resource of a domain.
    pub fn get(&self, resource: Resource, at: Domain) -> Option<&Buffer> {
        Some(&self.held(resource, at)?.buffer)
    }

    /// A band's part of a resource. `bands` are those of the domain.
    ///
    /// # Errors
    /// Where no pass of the plan makes it.
    pub fn band(
        &self,
        resource: Resource,
        at: Domain,
        bands: &Bands,
        band: u32,
    ) -> Result<BufferBinding<'_>, Error> {
        let held = self.held(resource, at).ok_or(missing(resource))?;
        let (first, count) = match at {
            Domain::Halves => {
                let before = (0..band).map(|band| bands.receivers(band)).sum();
                (before, bands.receivers(band))
            }
            Domain::Pixels => {
                let (offset, size) = bands.picture_range(band);
                (offset / PIXEL, size / PIXEL)
            }
            Domain::Points | Domain::Patches => (0, held.buffer.size() / held.stride),
            // There is one band at a time.
            _ => (0, bands.receivers(band)),
        };
        Ok(held.part(first, count))
    }

    /// What of a resource at half resolution lies under a band of samples.
    ///
    /// # Errors
    /// Where no pass of the plan makes it.
    pub fn under(
        &self,
        resource: Resource,
        [bands, halves]: [&Bands; 2],
        band: u32,
    ) -> Result<BufferBinding<'_>, Error> {
        let held = self.held(resource, Domain::Halves);
        let held = held.ok_or(missing(resource))?;
        let rows = bands.half_tile_rows(band);
        let row = u64::from(halves.tiles(0).columns) * Tiles::AREA as u64;
        let (first, count) = (u64::from(rows.start), u64::from(rows.end - rows.start));
        Ok(held.part(first * row, count * row))
    }

    fn held(&self, resource: Resource, at: Domain) -> Option<&Held> {
        self.0.iter().find(|held| held.is(resource, at))
    }
}

impl Held {
    fn is(&self, resource: Resource, at: Domain) -> bool {
        (self.memory, self.at) == (resource.memory, at)
    }

    fn part(&self, first: u64, count: u64) -> BufferBinding<'_> {
        BufferBinding {
            buffer: &self.buffer,
            offset: first * self.stride,
            size: BufferSize::new(count * self.stride),
        }
    }
}

/// Bytes of a pixel of the picture, which its range counts in.
const PIXEL: u64 = 16;

/// How many elements a buffer of a resource has; none where it is none of these.
fn elements(
    resource: Resource,
    at: Domain,
    (bands, halves, points): (&Bands, Option<&Bands>, [u64; 2]),
) -> Option<u64> {
    let all = |bands: &Bands, of: &dyn Fn(u32) -> u64| (0..bands.count()).map(of).sum::<u64>();
    let count = match at {
        Domain::Points => points[0].max(1),
        Domain::Patches => points[1].max(1),
        Domain::Samples => {
            let one = bands.receivers(0);
            match halves {
                // Nobody reads the albedo at half resolution, but it is written, a band at a time.
                Some(halves) if resource == ALBEDO => one.max(halves.receivers(0)),
                _ => one,
            }
        }
        Domain::Gloss => bands.receivers(0),
        Domain::Halves => all(halves?, &|band| halves.map_or(0, |h| h.receivers(band))),
        Domain::Pixels => all(bands, &|band| bands.picture_range(band).1 / PIXEL),
        _ => return None,
    };
    (resource.bytes > 0).then_some(count)
}

/// Some are read back, some are cleared, and a usage costs nothing.
fn usage(at: Domain) -> BufferUsages {
    match at {
        Domain::Pixels => BufferUsages::STORAGE | BufferUsages::COPY_SRC,
        _ => BufferUsages::STORAGE | BufferUsages::COPY_DST,
    }
}

/// How tables call memory of a domain.
fn name(memory: &'static str, at: Domain) -> Cow<'static, str> {
    match at {
        Domain::Halves => format!("half_{memory}").into(),
        Domain::Points => format!("point_{memory}").into(),
        Domain::Patches => format!("patch_{memory}").into(),
        _ => memory.into(),
    }
}

fn missing(resource: Resource) -> Error {
    Error::NoResource {
        resource: resource.name,
    }
}
