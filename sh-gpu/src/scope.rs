//! What the device complains of, as an [`Error`] of the call that caused it.

use crate::Error;
use std::pin::pin;
use std::task::{Context, Poll, Waker};
use wgpu::{BufferUsages, Device, ErrorFilter};

/// Runs what makes objects on the device, and returns what the device complained of while it did.
///
/// On the web such complaints arrive later; there they go to the host's own error scopes, as if this were not here.
pub(crate) fn checked<T>(
    device: &Device,
    make: impl FnOnce() -> Result<T, Error>,
) -> Result<T, Error> {
    if cfg!(target_arch = "wasm32") {
        return make();
    }
    let scopes = [
        ErrorFilter::OutOfMemory,
        ErrorFilter::Validation,
        ErrorFilter::Internal,
    ]
    .map(|filter| device.push_error_scope(filter));
    let made = make();
    let mut found = None;
    // All of them have to be closed, the last first. What memory ran out for is refused later on as well.
    for scope in scopes.into_iter().rev() {
        found = ready(scope.pop()).flatten().or(found);
    }
    match found.map(Error::from) {
        Some(Error::OutOfMemory) => return Err(Error::OutOfMemory),
        // Nothing that a lost device says helps.
        Some(error) => return Err(probe(device).err().unwrap_or(error)),
        None => {}
    }
    let made = made?;
    probe(device)?;
    Ok(made)
}

/// What a future has to say at once.
fn ready<T>(future: impl Future<Output = T>) -> Option<T> {
    let mut future = pin!(future);
    match future
        .as_mut()
        .poll(&mut Context::from_waker(Waker::noop()))
    {
        Poll::Ready(value) => Some(value),
        Poll::Pending => None,
    }
}

/// A lost device makes whatever it is asked for and complains of nothing, but has no memory to show.
fn probe(device: &Device) -> Result<(), Error> {
    let scope = device.push_error_scope(ErrorFilter::OutOfMemory);
    let probe = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("gaunt probe"),
        size: 16,
        usage: BufferUsages::COPY_SRC,
        mapped_at_creation: true,
    });
    if ready(scope.pop()).flatten().is_some() {
        return Err(Error::OutOfMemory);
    }
    let mapped = probe.slice(..).get_mapped_range_mut();
    mapped.map_or(Err(Error::lost()), |_| Ok(()))
}
