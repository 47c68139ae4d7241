//! What the passes of a frame hand each other.

use crate::device::cut::Cuts;
use crate::device::geometry::Geometry;
use crate::device::light_cuts::LightCuts;
use crate::device::light_views::Views;
use crate::device::patch_cut::PatchCuts;
use crate::device::patch_lights::PatchLights;
use crate::device::spherical_lights::{Points, SphericalLights};
use crate::lanes::path::Path;
use crate::passes::gbuffer::Gbuffer;
use crate::passes::upsample::{Failed, Halves};
use sh_scene::resource::Given;
use sh_scene::{Domain, Forest, Light, Receiver, Resource, Scene, Settings, Tiles, View};
use std::ops::Range;

/// Every resource of a plan, or what it is made from.
pub(crate) struct Store<'a, 's> {
    pub scene: &'a Scene,
    pub spheres: Spheres<'s>,
    pub sets: Sets<'a>,
    /// What rays are cast against; none where no pass casts any.
    pub geometry: Option<Geometry<'a>>,
    /// Lights with sharp shadows, and what they see.
    pub views: &'s mut Views,
    /// What a camera sees; none where receivers are the caller's.
    pub camera: Option<Camera>,
}

/// A camera and its picture.
pub(crate) struct Camera {
    pub view: View,
    pub pixels: Vec<[f32; 3]>,
    /// What is given of every pixel besides.
    pub given: Given,
}

/// Receivers of every domain, with their light. Memory serves all bands.
#[derive(Default)]
pub(crate) struct Sets<'a> {
    pub halves: Halves,
    pub half_clusters: Vec<Range<usize>>,
    pub samples: Gbuffer,
    pub sample_clusters: Vec<Range<usize>>,
    pub radiance: Vec<[f32; 3]>,
    /// The samples, of which only those that mirror light are covered, where any may; and from where that is seen.
    pub gloss: Vec<Receiver>,
    pub gloss_radiance: Vec<[f32; 3]>,
    pub eye: [f32; 3],
    pub rest: Failed,
    pub rest_radiance: Vec<[f32; 3]>,
    pub brought: &'a [Receiver],
    pub brought_clusters: &'a [Range<usize>],
    pub brought_sent: Vec<[f32; 3]>,
    pub points: Points,
    pub patches: Points,
}

/// One set of receivers.
pub(crate) struct Set<'s> {
    pub receivers: &'s [Receiver],
    pub clusters: &'s [Range<usize>],
    pub radiance: &'s mut Vec<[f32; 3]>,
    /// Light that spheres send, where it is kept apart.
    pub sent: Option<&'s mut Vec<[f32; 3]>>,
    /// Where they are looked at from, if they mirror light.
    pub eye: Option<[f32; 3]>,
}

impl Sets<'_> {
    /// The receivers of a domain.
    pub fn of(&mut self, domain: Domain) -> Set<'_> {
        match domain {
            Domain::Points => self.points.set(),
            Domain::Patches => self.patches.set(),
            Domain::Halves => Set {
                receivers: &self.halves.receivers,
                clusters: &self.half_clusters,
                radiance: &mut self.halves.shares,
                sent: Some(&mut self.halves.sent),
                eye: None,
            },
            Domain::Rest => Set {
                receivers: &self.rest.receivers,
                clusters: &self.rest.clusters,
                radiance: &mut self.rest_radiance,
                sent: None,
                eye: None,
            },
            Domain::Gloss => Set {
                receivers: &self.gloss,
                clusters: &self.sample_clusters,
                radiance: &mut self.gloss_radiance,
                sent: None,
                eye: Some(self.eye),
            },
            Domain::Receivers => Set {
                receivers: self.brought,
                clusters: self.brought_clusters,
                radiance: &mut self.radiance,
                sent: Some(&mut self.brought_sent),
                eye: None,
            },
            // Pixels are made of samples; the others have no receivers, and no pass over them asks for any.
            Domain::Samples | Domain::Pixels | Domain::Spheres | Domain::Views | Domain::Scene => {
                Set {
                    receivers: &self.samples.receivers,
                    clusters: &self.sample_clusters,
                    radiance: &mut self.radiance,
                    sent: None,
                    eye: None,
                }
            }
        }
    }
}

impl Sets<'_> {
    /// Finds the samples that mirror light.
    pub fn polish(&mut self, eye: [f32; 3]) {
        self.eye = eye;
        let all = self.samples.receivers.iter().map(|receiver| Receiver {
            covered: match receiver.roughness() {
                Some(_) => receiver.covered,
                None => 0,
            },
            ..*receiver
        });
        self.gloss.clear();
        self.gloss.extend(all);
    }

    /// Those receivers of a domain that take light that bodies have sent.
    pub fn gathering(&mut self, domain: Domain) -> Set<'_> {
        let few = match domain {
            Domain::Patches => self.patches.few,
            _ => None,
        };
        let mut set = self.of(domain);
        if let Some([receivers, clusters]) = few {
            set.receivers = &set.receivers[..receivers];
            set.clusters = &set.clusters[..clusters];
        }
        set
    }
}

impl Points {
    /// As receivers.
    pub fn set(&mut self) -> Set<'_> {
        Set {
            receivers: &self.receivers,
            clusters: &self.clusters,
            radiance: &mut self.radiance,
            sent: Some(&mut self.sent),
            eye: None,
        }
    }
}

impl Set<'_> {
    /// Radiance of every receiver, to be written.
    pub fn room(&mut self) -> &mut [[f32; 3]] {
        self.radiance.resize(self.receivers.len(), [0.0; 3]);
        self.radiance
    }
}

/// The spheres, the light on them and what they send on; with what is counted.
pub(crate) struct Spheres<'a> {
    pub path: Path,
    pub forest: &'a Forest,
    pub light: &'a Light,
    pub settings: Settings,
    pub cuts: &'a mut Cuts,
    pub lights: &'a mut SphericalLights,
    pub light_cuts: &'a mut LightCuts,
    pub patch_lights: &'a mut PatchLights,
    pub patch_cuts: &'a mut PatchCuts,
    /// Those of points of patches: the same in all turns, once they are found.
    pub point_cuts: &'a mut PatchCuts,
    pub counts: Counts,
}

/// What is counted in the passes that look at spheres.
#[derive(Clone, Copy, Default)]
pub(crate) struct Counts {
    pub pairs: usize,
    pub shadowed: usize,
    pub too_small: usize,
    pub lamps_below: usize,
}

/// Rows of tiles a band: 16 rows of pixels. With 1280 columns a band's samples are 6 MB, so that a pass finds in the
/// cache what the one before it wrote.
const BAND: u32 = 2;

impl Camera {
    /// How many bands the samples have.
    pub fn bands(&self) -> u32 {
        self.view.samples().tiles().rows.div_ceil(BAND)
    }

    /// The rows of tiles of a band of samples.
    pub fn rows(&self, band: u32) -> Range<u32> {
        let first = band * BAND;
        first..(first + BAND).min(self.view.samples().tiles().rows)
    }

    /// The tiles of a band of samples.
    pub fn tiles(&self, band: u32) -> Tiles {
        Tiles {
            rows: self.rows(band).len() as u32,
            ..self.view.samples().tiles()
        }
    }

    /// The pixels of a band.
    pub fn pixels(&mut self, band: u32) -> &mut [[f32; 3]] {
        let range = self.range(band);
        &mut self.pixels[range]
    }

    /// The same of something else that is given of every pixel; none where nobody asked for it.
    pub fn given(&mut self, resource: Resource, band: u32) -> &mut [[u32; 4]] {
        let range = self.range(band);
        let given = self.given.get_mut(&resource);
        given.map_or(&mut [], |all| &mut all[range])
    }

    fn range(&self, band: u32) -> Range<usize> {
        let rows = BAND * Tiles::SIDE / View::OVERSAMPLE;
        let size = (rows * self.view.width) as usize;
        let first = band as usize * size;
        first..(first + size).min(self.pixels.len())
    }
}
