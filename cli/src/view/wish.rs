//! What is asked of the worker, and what comes back.

use crate::render::Backend;
use crate::report::{Planned, Stage};
use egui::ColorImage;
use sh_scene::passes::INVALID_SAMPLES;
use sh_scene::{Camera, Resource, Settings, Sphere};
use std::sync::Arc;

/// What is laid over the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Overlay {
    /// Nothing
    #[default]
    None,
    /// The spheres that stand for the bodies
    Spheres,
    /// The clusters of receivers that share a cut of the spheres' tree
    Clusters,
    /// How many spheres each cluster looks at
    Cut,
    /// Where samples are no number, infinite or negative: there should be none
    Invalid,
    /// The difference to the path tracer, which goes on while nothing moves
    Error,
}

impl Overlay {
    pub(super) const ALL: [Self; 6] = [
        Self::None,
        Self::Spheres,
        Self::Clusters,
        Self::Cut,
        Self::Invalid,
        Self::Error,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::Spheres => "Spheres",
            Self::Clusters => "Clusters",
            Self::Cut => "Cut size",
            Self::Invalid => "Invalid",
            Self::Error => "Error",
        }
    }

    /// What of every pixel has to be given besides the picture.
    pub(super) fn asks(self) -> &'static [Resource] {
        match self {
            Self::Invalid => &[INVALID_SAMPLES],
            _ => &[],
        }
    }
}

/// A picture that is wanted. Two that are equal have the same picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wish {
    pub settings: Settings,
    pub backend: Backend,
    pub camera: Camera,
    /// In pixels.
    pub size: [u32; 2],
    /// Of the scene's motion.
    pub seconds: f64,
    /// How far the light is turned from where the scene has it, in radians, counter-clockwise seen from above.
    pub turn: f32,
    /// What every mesh's number of spheres is multiplied with.
    pub spheres: f32,
    /// Brighter by powers of two.
    pub stops: f32,
    pub overlay: Overlay,
    /// Whether nothing moves, so that the truth may be traced.
    pub rests: bool,
}

/// A picture to lay over another, and what it means.
#[derive(Clone, Debug)]
pub(super) struct Layer {
    /// Of any size; it is stretched over the picture.
    pub image: Arc<ColorImage>,
    pub legend: Legend,
}

/// What the colours of a layer mean.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Legend {
    pub title: String,
    /// The values of the darkest and the brightest colour of the heat map, as text; none where colours have no order.
    pub ends: Option<[String; 2]>,
    /// Sentences and figures below.
    pub notes: Vec<String>,
}

/// A sphere and the number of its object.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub sphere: Sphere,
    pub object: usize,
}

/// A picture that was wanted.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    pub wish: Wish,
    pub image: Arc<ColorImage>,
    pub plan: Vec<Planned>,
    pub stages: Vec<Stage>,
    /// From taking up the wish to the picture, without loading.
    pub seconds: f64,
    /// What computed: "the CPU, 2 threads".
    pub device: String,
    /// All spheres of the scene, where they are laid over the picture.
    pub balls: Vec<Ball>,
    /// How many spheres the scene has.
    pub spheres: usize,
    pub layer: Option<Layer>,
}
