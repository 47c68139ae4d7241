//! Records on their way to the GPU, in memory that is kept from frame to frame.

use crate::Error;
use bytemuck::NoUninit;
use std::fmt;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use wgpu::{Buffer, BufferUsages, Device, Queue};

/// Memory that grows to what the largest frame needs: a steady frame allocates nothing.
pub(crate) struct Kept<T>(Mutex<T>);

impl<T: Default> Default for Kept<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T> fmt::Debug for Kept<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Kept")
    }
}

impl<T> Kept<T> {
    /// Hands over what was kept, as the last frame left it.
    pub fn with<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        // Whoever panicked in here left records that the next frame clears.
        let mut kept = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        work(&mut kept)
    }
}

impl<T: NoUninit> Kept<Vec<T>> {
    /// Writes records to a buffer, from its beginning on.
    pub fn upload(&self, queue: &Queue, buffer: &Buffer, records: impl IntoIterator<Item = T>) {
        self.with(|kept| {
            kept.clear();
            kept.extend(records);
            write(queue, buffer, kept);
        });
    }
}

/// A buffer with contents. Where there is no memory for them, the device says so to whoever listens.
pub(crate) fn filled(
    device: &Device,
    label: &str,
    contents: &[u8],
    usage: BufferUsages,
) -> Result<Buffer, Error> {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: contents.len().next_multiple_of(4) as u64,
        usage,
        mapped_at_creation: !contents.is_empty(),
    });
    if !contents.is_empty() {
        let mapped = buffer.slice(..).get_mapped_range_mut();
        let mut mapped = mapped.map_err(|_| Error::lost())?;
        mapped.slice(..contents.len()).copy_from_slice(contents);
        drop(mapped);
        buffer.unmap();
    }
    Ok(buffer)
}

/// What a buffer holds, so that only what is different is uploaded.
#[derive(Default)]
pub(crate) struct Known {
    bytes: Mutex<Vec<u8>>,
    written: AtomicU64,
}

impl fmt::Debug for Known {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Known({})", self.written())
    }
}

impl Known {
    /// Bytes that are compared as one: an upload of less costs as much.
    const BLOCK: usize = 256;

    /// Writes records to a buffer, from its beginning on: those blocks of 256 bytes of them that it does not hold, runs of
    /// blocks at once. What the buffer holds beyond the records stays.
    pub fn write<T: NoUninit>(&self, queue: &Queue, buffer: &Buffer, records: &[T]) {
        let bytes: &[u8] = bytemuck::cast_slice(records);
        let mut known = self.bytes.lock().unwrap_or_else(PoisonError::into_inner);
        let held = known.len().min(bytes.len());
        let blocks = bytes.len().div_ceil(Self::BLOCK);
        let range =
            |block: usize| block * Self::BLOCK..((block + 1) * Self::BLOCK).min(bytes.len());
        let same = |block: usize| {
            let range = range(block);
            range.end <= held && known[range.clone()] == bytes[range]
        };
        let mut block = 0;
        let mut written = 0;
        while block < blocks {
            if same(block) {
                block += 1;
                continue;
            }
            let first = block;
            while block < blocks && !same(block) {
                block += 1;
            }
            let run = range(first).start..range(block - 1).end;
            queue.write_buffer(buffer, run.start as u64, &bytes[run.clone()]);
            written += run.len() as u64;
        }
        if known.len() < bytes.len() {
            known.resize(bytes.len(), 0);
        }
        if written > 0 {
            known[..bytes.len()].copy_from_slice(bytes);
            self.written.fetch_add(written, Ordering::Relaxed);
        }
    }

    /// Knows nothing any more, because somebody else has written to the buffer.
    pub fn forget(&self) {
        let mut known = self.bytes.lock().unwrap_or_else(PoisonError::into_inner);
        known.clear();
    }

    /// How many bytes have been written.
    pub fn written(&self) -> u64 {
        self.written.load(Ordering::Relaxed)
    }
}

/// Writes records to a buffer, from its beginning on.
pub(crate) fn write<T: NoUninit>(queue: &Queue, buffer: &Buffer, records: &[T]) {
    if !records.is_empty() {
        queue.write_buffer(buffer, 0, bytemuck::cast_slice(records));
    }
}
