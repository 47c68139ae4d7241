//! Whether what spheres send on is on the device as it is now.
//!
//! What is recorded need not run: an encoder can be dropped. So there are three numbers of the state that light is in: what
//! was uploaded last, what was recorded last, and what the host says it has submitted. Only the last of them is on the
//! device.

use std::sync::atomic::{AtomicU64, Ordering};

/// The states.
#[derive(Debug)]
pub(super) struct Sent {
    uploaded: AtomicU64,
    recorded: AtomicU64,
    submitted: AtomicU64,
}

impl Default for Sent {
    /// Nothing is on the device.
    fn default() -> Self {
        Self {
            uploaded: AtomicU64::new(1),
            recorded: AtomicU64::new(0),
            submitted: AtomicU64::new(0),
        }
    }
}

impl Sent {
    /// Something was uploaded that sent light depends on.
    pub fn change(&self) {
        self.uploaded.fetch_add(1, Ordering::Relaxed);
    }

    /// Whether the device has it.
    pub fn is_current(&self) -> bool {
        self.submitted.load(Ordering::Relaxed) == self.uploaded.load(Ordering::Relaxed)
    }

    /// Whether it has to be recorded; it is taken to be, then.
    pub fn record(&self) -> bool {
        let needed = !self.is_current();
        if needed {
            let state = self.uploaded.load(Ordering::Relaxed);
            self.recorded.store(state, Ordering::Relaxed);
        }
        needed
    }

    /// What was recorded last has been submitted.
    pub fn submit(&self) {
        let state = self.recorded.load(Ordering::Relaxed);
        self.submitted.store(state, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_dropped_or_changed_is_recorded_again() {
        let sent = Sent::default();
        assert!(sent.record(), "at first");
        assert!(sent.record(), "dropped");
        sent.submit();
        assert!(!sent.record(), "as it was");
        sent.change();
        assert!(sent.record(), "changed");
        sent.change();
        sent.submit();
        assert!(sent.record(), "changed after it was recorded");
        sent.submit();
        assert!(!sent.record());
    }
}
