//! Storage buffers that a kernel wants, and whether they hold enough.

use crate::Error;
use wgpu::BufferBinding;

/// A storage buffer that a kernel wants.
#[derive(Clone)]
pub(crate) struct Slot<'a> {
    /// As the kernel names it.
    pub name: &'static str,
    /// Bytes an element.
    pub stride: u64,
    /// Elements an invocation needs.
    pub each: u64,
    /// Whether there is an invocation for every element.
    pub counts: bool,
    pub binding: BufferBinding<'a>,
}

impl<'a> Slot<'a> {
    /// What it holds for `count` invocations from `first` on.
    pub fn part(&self, first: u64, count: u64) -> Self {
        let each = self.stride * self.each;
        Self {
            binding: BufferBinding {
                buffer: self.binding.buffer,
                offset: self.binding.offset + first * each,
                size: wgpu::BufferSize::new(count * each),
            },
            ..self.clone()
        }
    }

    /// One element an invocation, and as many invocations as elements.
    pub fn counting(name: &'static str, stride: u64, binding: BufferBinding<'a>) -> Self {
        Self {
            name,
            stride,
            each: 1,
            counts: true,
            binding,
        }
    }

    /// At least `each` elements an invocation.
    pub fn with(name: &'static str, stride: u64, each: u64, binding: BufferBinding<'a>) -> Self {
        Self {
            name,
            stride,
            each,
            counts: false,
            binding,
        }
    }
}

/// How many elements the counting slot has, if all others hold enough for them.
pub(crate) fn enough(slots: &[Slot<'_>], sizes: &[u64]) -> Result<u64, Error> {
    let counting = slots.iter().position(|slot| slot.counts).unwrap_or(0);
    let count = sizes[counting];
    for (slot, &size) in slots.iter().zip(sizes) {
        let needed = count * slot.each;
        if size < needed {
            let problem = format!(
                "holds {size} elements of {} bytes; {needed} are needed, because `{}` holds {count}",
                slot.stride, slots[counting].name
            );
            return Err(Error::Binding {
                binding: slot.name,
                problem,
            });
        }
    }
    Ok(count)
}
