//! A pass that is a kernel over buffers of the frame and nothing else: bound by its declaration alone.

use crate::pipeline::Kernel;
use crate::setup::Setup;
use crate::slot::Slot;
use crate::{Bands, Bound, Error};
use sh_kernels::{EntryPoint, MIN_ORDER, Pass};
use sh_scene::Planned;
use sh_scene::plan::{Access, Entry, Facts, Orders};
use std::sync::Arc;
use wgpu::{BindGroup, CommandEncoder, ComputePassTimestampWrites};

/// Its kernel, bound band by band. Group 0 is the band; what is in group 1 are slots, by the names that these give it. There
/// is an invocation for each element of what the pass makes.
#[derive(Debug)]
pub(crate) struct Plain {
    kernel: Arc<Kernel>,
    group: BindGroup,
    pub bound: Vec<Bound>,
}

impl Plain {
    /// From the declaration of a pass of a plan.
    pub fn new(setup: &Setup, planned: &Planned) -> Result<Self, Error> {
        let none = Error::NoPass {
            pass: planned.name(),
        };
        let facts = Facts::of(setup.scene, false);
        let entries = (planned.pass.entries)(&facts);
        let [entry] = &entries[..] else {
            return Err(none);
        };
        let mut all = Pass::ALL.into_iter();
        let pass = all.find(|pass| pass.name() == entry.kernel);
        let pass = pass.ok_or(none.clone())?;
        let mut points = pass.entries().iter();
        let point = points.find(|point| point.name == entry.name).ok_or(none)?;
        let kernel = kernel(setup, pass, entry)?;
        let bands = setup.bands_of(planned.at)?;
        let bound = (0..bands.count()).map(|band| {
            let slots = slots(setup, planned, point, band)?;
            kernel.bind(setup.device, &slots)
        });
        Ok(Self {
            bound: bound.collect::<Result<_, _>>()?,
            group: kernel.own(setup.device, &[("band", bands.binding())]),
            kernel,
        })
    }

    /// Records a band.
    pub fn record(
        &self,
        encoder: &mut CommandEncoder,
        bands: &Bands,
        band: u32,
        timestamps: Option<ComputePassTimestampWrites<'_>>,
    ) {
        let own = (&self.group, &[bands.offset(band)][..]);
        let bound = &self.bound[band as usize];
        self.kernel.record(encoder, own, bound, timestamps);
    }
}

fn kernel(setup: &Setup, pass: Pass, entry: &Entry) -> Result<Arc<Kernel>, Error> {
    let settings = setup.scene.settings;
    let of = match entry.orders {
        Orders::None => (pass, MIN_ORDER, MIN_ORDER),
        Orders::Light => (pass, settings.order, settings.order),
        Orders::Both => (pass, settings.order, settings.accumulation),
    };
    let constants = &entry.constants;
    setup.pipelines.specialised(of, entry.name, constants)
}

/// A band's part of what each binding of group 1 is.
fn slots<'a>(
    setup: &'a Setup,
    planned: &Planned,
    point: &EntryPoint,
    band: u32,
) -> Result<Vec<Slot<'a>>, Error> {
    let declared = planned.slots();
    let bound = point.bindings.iter().filter(|binding| binding.group == 1);
    let slot = |name: &'static str| {
        let mut all = declared.iter();
        let slot = all.find(|slot| slot.bindings.contains(&name));
        let slot = slot.ok_or(Error::NoResource { resource: name })?;
        let (resource, at) = slot.bound(planned.at);
        let part = setup.part(resource, at, band)?;
        Ok(match slot.access {
            Access::Write => Slot::counting(name, resource.bytes, part),
            _ => Slot::with(name, resource.bytes, 0, part),
        })
    };
    bound.map(|binding| slot(binding.name)).collect()
}
