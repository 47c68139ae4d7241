//! Receivers in clusters, for the kernels that work cluster by cluster.

use crate::pipeline::Kernel;
use crate::scope::checked;
use crate::slot::Slot;
use crate::upload::filled;
use crate::{Bound, Error};
use sh_scene::{Receiver, Tiles};
use wgpu::{Buffer, BufferBinding, BufferUsages, Device};

/// Receivers that share a cut of blockers, as the GPU reads them.
///
/// ```no_run
/// # fn bind(device: &wgpu::Device, shadow: &sh_gpu::ShadowPass, runs: &wgpu::Buffer, receivers: &wgpu::Buffer,
/// #     radiance: &wgpu::Buffer) -> Result<sh_gpu::Bound, sh_gpu::Error> {
/// // `runs` holds [0, 300], [300, 120], …: no cluster has more than 300 receivers.
/// let clusters = sh_gpu::ClusterBinding { clusters: runs.as_entire_buffer_binding(), largest: 300 };
/// let (receivers, radiance) = (receivers.as_entire_buffer_binding(), radiance.as_entire_buffer_binding());
/// shadow.bind_clusters(device, receivers, clusters, radiance)
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct ClusterBinding<'a> {
    /// A `vec2u` each, 8 bytes: index of the first receiver, and how many. They may change from frame to frame, and
    /// be written by a pass; those of no receivers cost next to nothing.
    pub clusters: BufferBinding<'a>,
    /// Receivers of the largest cluster; what a cluster has beyond is not lit.
    pub largest: u32,
}

/// Receivers and what is written of them, with a cluster for every [`Tiles::AREA`] receivers one after another. What is
/// too large for one binding of the device is bound in parts.
pub(crate) fn bind_tiles(
    kernel: &Kernel,
    device: &Device,
    receivers: BufferBinding<'_>,
    written: Slot<'_>,
) -> Result<Bound, Error> {
    let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
    kernel.bind_parts(&[receivers, written], |slots, count| {
        let [receivers, written] = slots else {
            unreachable!("as many slots come back as went in");
        };
        let runs = checked(device, || runs(device, count as u32))?;
        let clusters = ClusterBinding {
            clusters: runs.as_entire_buffer_binding(),
            largest: Tiles::AREA as u32,
        };
        let (receivers, written) = (receivers.binding.clone(), written.clone());
        let bound = bind_clusters(kernel, device, receivers, clusters, written)?;
        Ok(bound.with_bytes(runs.size()))
    })
}

/// Receivers, clusters of the host's and what is written of the receivers.
pub(crate) fn bind_clusters(
    kernel: &Kernel,
    device: &Device,
    receivers: BufferBinding<'_>,
    clusters: ClusterBinding<'_>,
    written: Slot<'_>,
) -> Result<Bound, Error> {
    let ClusterBinding { clusters, largest } = clusters;
    let clusters = Slot::with("clusters", 8, 0, clusters);
    let count = kernel.elements(&clusters)?;
    let receivers = Slot::counting("receivers", size_of::<Receiver>() as u64, receivers);
    let slots = [receivers, clusters, written];
    checked(device, || {
        kernel.bind_groups(device, &slots, count, largest.into())
    })
}

/// Clusters of [`Tiles::AREA`] receivers one after another.
fn runs(device: &Device, count: u32) -> Result<Buffer, Error> {
    let runs: Vec<[u32; 2]> = (0..count)
        .step_by(Tiles::AREA)
        .map(|first| [first, (count - first).min(Tiles::AREA as u32)])
        .collect();
    let bytes = bytemuck::cast_slice(&runs);
    filled(device, "gaunt clusters", bytes, BufferUsages::STORAGE)
}
