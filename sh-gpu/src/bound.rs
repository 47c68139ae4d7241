//! What a pass dispatches over: bind groups of the host's buffers.

use wgpu::BindGroup;

/// The host's buffers, looked over and bound to one pass. Made once, used every frame while the buffers
/// stay the same; valid only for the pass that made it. Buffers that are too large for one binding of the device are
/// bound in several parts, each with a dispatch.
///
/// What was bound part by part comes together again by `collect`:
///
/// ```no_run
/// # fn bind(device: &wgpu::Device, shadow: &sh_gpu::ShadowPass, screen: &sh_gpu::ScreenPass)
/// #     -> Result<sh_gpu::Bound, sh_gpu::Error> {
/// screen.parts().map(|part| shadow.bind(device, part.receivers, part.radiance)).collect()
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Bound {
    pub(crate) parts: Vec<Part>,
    bytes: u64,
}

/// What one dispatch binds.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub group: BindGroup,
    pub workgroups: [u32; 3],
}

impl Bound {
    pub(crate) fn new(group: BindGroup, workgroups: [u32; 3]) -> Self {
        Self {
            parts: vec![Part { group, workgroups }],
            bytes: 0,
        }
    }

    /// With a buffer that was made for it.
    pub(crate) fn with_bytes(self, bytes: u64) -> Self {
        Self {
            bytes: self.bytes + bytes,
            ..self
        }
    }

    /// How many dispatches a pass records for this.
    pub fn dispatches(&self) -> usize {
        self.parts.len()
    }

    /// Bytes of GPU memory that binding took: a list of clusters where the host brought none, 8 for 256 receivers.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

impl FromIterator<Bound> for Bound {
    fn from_iter<I: IntoIterator<Item = Bound>>(parts: I) -> Self {
        let mut all = Self {
            parts: Vec::new(),
            bytes: 0,
        };
        for bound in parts {
            all.parts.extend(bound.parts);
            all.bytes += bound.bytes;
        }
        all
    }
}
