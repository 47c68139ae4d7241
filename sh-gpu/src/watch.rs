//! What a device reports when no call is there to return it.

use crate::Error;
use std::sync::{Arc, Mutex, PoisonError};
use wgpu::{Device, DeviceLostReason};

/// The first thing that went wrong on a device since the last time somebody asked: a lost device, memory that ran out
/// while a frame was submitted, a command that was refused. `new` and `bind` of the passes return what they cause
/// themselves; this is for the rest of a frame, which only uploads and records.
///
/// [`new`](Self::new) takes the device's two callbacks. A host that wants them for itself makes a `Watch` by `default`
/// and hands on what its own callbacks see ([`report`](Self::report), [`lost`](Self::lost)). Clones share what they saw.
///
/// ```no_run
/// # use sh_gpu::{Error, Watch};
/// # fn frame(device: &wgpu::Device, queue: &wgpu::Queue, encoder: wgpu::CommandEncoder) -> Result<(), Error> {
/// let watch = Watch::new(device); // once
/// queue.submit([encoder.finish()]); // every frame
/// watch.check()?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default)]
pub struct Watch(Arc<Mutex<Option<Error>>>);

impl Watch {
    /// Watches a device, in the place of whatever its callbacks did before.
    pub fn new(device: &Device) -> Self {
        let watch = Self::default();
        let (refused, lost) = (watch.clone(), watch.clone());
        device.on_uncaptured_error(Arc::new(move |error| refused.report(error)));
        device.set_device_lost_callback(move |reason, message| lost.lost(reason, &message));
        watch
    }

    /// Notes an error, unless an earlier one waits.
    ///
    /// ```
    /// # use sh_gpu::{Error, Watch};
    /// let watch = Watch::default();
    /// let description = "the buffer was destroyed".to_string();
    /// watch.report(wgpu::Error::Validation { source: description.clone().into(), description });
    /// assert!(matches!(watch.check(), Err(Error::Validation(text)) if text.contains("destroyed")));
    /// assert_eq!(watch.check(), Ok(()));
    /// ```
    pub fn report(&self, error: wgpu::Error) {
        self.note(error.into());
    }

    /// Notes that the device is lost, whatever else there was.
    ///
    /// ```
    /// # use sh_gpu::{Error, Watch};
    /// let watch = Watch::default();
    /// watch.lost(wgpu::DeviceLostReason::Unknown, "the driver was reset");
    /// assert_eq!(watch.check().unwrap_err().to_string(), "the device is lost: the driver was reset");
    /// assert!(watch.check().is_err(), "it does not come back");
    /// ```
    pub fn lost(&self, reason: DeviceLostReason, message: &str) {
        let message = match (reason, message) {
            (DeviceLostReason::Destroyed, "") => "it was destroyed",
            (_, "") => "the driver gave no reason",
            (_, message) => message,
        };
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) =
            Some(Error::DeviceLost(message.into()));
    }

    /// What went wrong since the last time. A lost device stays lost.
    pub fn check(&self) -> Result<(), Error> {
        let mut seen = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        match &*seen {
            Some(Error::DeviceLost(message)) => Err(Error::DeviceLost(message.clone())),
            _ => seen.take().map_or(Ok(()), Err),
        }
    }

    fn note(&self, error: Error) {
        let mut seen = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        seen.get_or_insert(error);
    }
}
