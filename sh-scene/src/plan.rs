//! The plan of a frame: the passes a scene calls for, why, and what they read and write.
//!
//! A pass that is not in the plan costs nothing: no dispatch, no memory, no shader. A backend looks
//! through the list and does what it names, in order. New passes enter as one more [`PassKind`] and, where
//! they make something new (a light view, an array of depths, a picture at half resolution), one more
//! [`Resource`] with its [`Resolution`]; what is here stays as it is.

use crate::{Blocking, Object, Scene};
use std::fmt;

/// The passes there are. Each is one file of this name in `kernels`, `sh-cpu` and `sh-gpu`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PassKind {
    /// Position, normal and albedo per sample.
    Gbuffer,
    /// Light without blockers.
    Irradiance,
    /// Light through the visibility of all blocker spheres.
    Shadow,
    /// What the spheres of bodies send on of the light that falls on the surface around them, bounce by bounce.
    LightUpdate,
    /// The light that spheres have sent on, added to radiance.
    LightGather,
    /// Radiance at half resolution to samples, by a joint bilateral filter; what that cannot give is shaded anew.
    Upsample,
    /// Samples to pixels: radiance times albedo, the environment where nothing is hit.
    Resolve,
}

impl PassKind {
    /// The name that files, tables and messages use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gbuffer => "gbuffer",
            Self::Irradiance => "irradiance",
            Self::Shadow => "shadow",
            Self::LightUpdate => "light_update",
            Self::LightGather => "light_gather",
            Self::Upsample => "upsample",
            Self::Resolve => "resolve",
        }
    }
}

/// What passes hand each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Resource {
    /// Meshes, their transforms and textures, and the ground.
    Surfaces,
    /// Positions and normals to light: [`crate::Receiver`] records.
    Receivers,
    /// Linear Rec.709 reflectance of each receiver.
    Albedo,
    /// Radiance that albedo 1 would reflect at each receiver.
    Radiance,
    /// As `Receivers`, at half the picture's resolution.
    HalfReceivers,
    /// As `Radiance`, at half the picture's resolution.
    HalfRadiance,
    /// The spheres that block light, in world space: [`crate::Forest`].
    Blockers,
    /// Points on bodies' surfaces: [`crate::SurfaceSamples`].
    SurfacePoints,
    /// What each sphere sends on, as an SH vector.
    Emission,
    /// The environment as SH vectors, and analytic lights: [`crate::Light`].
    Light,
    /// The environment as a map: [`crate::EnvironmentMap`].
    Environment,
    /// The picture: linear Rec.709, 32-bit floats.
    Picture,
}

impl Resource {
    /// How many elements it has.
    pub fn resolution(self) -> Resolution {
        match self {
            Self::Surfaces | Self::Blockers | Self::Light | Self::Environment => Resolution::Fixed,
            Self::SurfacePoints => Resolution::Fixed,
            Self::Emission => Resolution::Spheres,
            Self::Receivers | Self::Albedo | Self::Radiance => Resolution::Samples,
            Self::HalfReceivers | Self::HalfRadiance => Resolution::Halves,
            Self::Picture => Resolution::Pixels,
        }
    }
}

/// What the size of a resource follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Resolution {
    /// One element a sample of the [`crate::View`]: [`crate::View::samples`].
    Samples,
    /// One element every two by two pixels: [`crate::View::halves`].
    Halves,
    /// One element a pixel of the picture.
    Pixels,
    /// One element a sphere.
    Spheres,
    /// The scene, not the picture. It is there before the first pass.
    Fixed,
}

/// One pass and why this scene needs it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// Which.
    pub kind: PassKind,
    /// How many elements it computes.
    pub at: Resolution,
    /// Why it is in the plan, for a person: a sentence.
    pub reason: String,
}

impl Pass {
    /// What the pass reads.
    pub fn reads(&self) -> &'static [Resource] {
        use Resource::*;
        let half = self.at == Resolution::Halves;
        match self.kind {
            PassKind::Gbuffer => &[Surfaces],
            PassKind::Irradiance => &[Receivers, Light],
            PassKind::Shadow if half => &[HalfReceivers, Blockers, Light],
            PassKind::Shadow => &[Receivers, Blockers, Light],
            PassKind::LightUpdate => &[SurfacePoints, Blockers, Light],
            PassKind::LightGather if half => &[HalfReceivers, HalfRadiance, Blockers, Emission],
            PassKind::LightGather => &[Receivers, Radiance, Blockers, Emission],
            PassKind::Upsample => &[HalfReceivers, HalfRadiance, Receivers, Blockers, Light],
            PassKind::Resolve => &[Receivers, Albedo, Radiance, Environment],
        }
    }

    /// What the pass writes.
    pub fn writes(&self) -> &'static [Resource] {
        use Resource::*;
        let half = self.at == Resolution::Halves;
        match self.kind {
            PassKind::Gbuffer if half => &[HalfReceivers],
            PassKind::Gbuffer => &[Receivers, Albedo],
            PassKind::Shadow | PassKind::LightGather if half => &[HalfRadiance],
            PassKind::LightUpdate => &[Emission],
            PassKind::LightGather => &[Radiance],
            PassKind::Irradiance | PassKind::Shadow | PassKind::Upsample => &[Radiance],
            PassKind::Resolve => &[Picture],
        }
    }
}

/// The passes of a frame, in order.
///
/// ```
/// # use sh_scene::*;
/// # fn plan_of(scene: &Scene) {
/// for pass in &Plan::new(scene).passes {
///     println!("{}: {}", pass.kind.name(), pass.reason);
/// }
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// In the order they run.
    pub passes: Vec<Pass>,
}

impl Plan {
    /// The passes that `scene` needs.
    pub fn new(scene: &Scene) -> Self {
        let blockers: usize = scene.objects.iter().map(|o| o.spheres.len()).sum();
        let (order, accumulation) = (scene.settings.order, scene.settings.accumulation);
        let mut passes = Vec::new();
        let mut add = |kind, at, reason: String| passes.push(Pass { kind, at, reason });
        let (gbuffer, shadow) = (PassKind::Gbuffer, PassKind::Shadow);

        let shadows = scene.settings.shadows && blockers > 0;
        let half = shadows && scene.settings.half_resolution;
        let light = match scene.lights.len() {
            0 => format!("Environment light of order {order}"),
            n => format!(
                "Environment light of order {order} and that of {}",
                counted(n, "lamp", "lamps")
            ),
        };
        let spheres = counted(blockers, "blocker sphere", "blocker spheres");
        let accumulated = if accumulation == order {
            String::new()
        } else {
            format!(", whose logarithms are accumulated in order {accumulation}")
        };
        let bounce = bounce(scene);
        if let Some((update, _)) = &bounce {
            add(PassKind::LightUpdate, Resolution::Spheres, update.clone());
        }
        if half {
            let reason = "Soft light changes little from pixel to pixel: a ray for every two by two is enough.";
            add(gbuffer, Resolution::Halves, reason.to_string());
            let reason = format!("{light} is cast into shadow by {spheres}{accumulated}.");
            add(shadow, Resolution::Halves, reason);
            if let Some((_, gather)) = &bounce {
                add(PassKind::LightGather, Resolution::Halves, gather.clone());
            }
        }
        let bodies = counted(scene.objects.len(), "object", "objects");
        let surfaces = match scene.ground {
            Some(_) => format!("{bodies} and the ground"),
            None => bodies,
        };
        add(
            gbuffer,
            Resolution::Samples,
            format!("The camera's rays have to find {surfaces}."),
        );
        if half {
            let reason = "Samples take the light of their surface from half resolution; edges and small folds are shaded by themselves.";
            add(PassKind::Upsample, Resolution::Samples, reason.to_string());
        } else if shadows {
            let reason = format!("{light} is cast into shadow by {spheres}{accumulated}.");
            add(shadow, Resolution::Samples, reason);
        } else {
            let reason = format!("{light} reaches every receiver unblocked.");
            add(PassKind::Irradiance, Resolution::Samples, reason);
        }
        if let Some((_, gather)) = bounce.filter(|_| !half) {
            add(PassKind::LightGather, Resolution::Samples, gather);
        }
        add(
            PassKind::Resolve,
            Resolution::Pixels,
            "Lit samples become pixels, with the environment behind them.".to_string(),
        );
        Self { passes }
    }

    /// Whether a pass of this kind is in the plan.
    pub fn has(&self, kind: PassKind) -> bool {
        self.passes.iter().any(|pass| pass.kind == kind)
    }
}

/// One line a pass: its name and why it is there.
impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, pass) in self.passes.iter().enumerate() {
            let end = if i == 0 { "" } else { "\n" };
            write!(f, "{end}{:<10} {}", pass.kind.name(), pass.reason)?;
        }
        Ok(())
    }
}

/// Why light is sent on and why it is gathered, for a scene that asks for it and has bodies that can see another.
fn bounce(scene: &Scene) -> Option<(String, String)> {
    let indirect = scene.settings.indirect?;
    let shining = |o: &&Object| !o.surface.points.is_empty();
    let lights: usize = scene
        .objects
        .iter()
        .filter(shining)
        .map(|o| o.spheres.len())
        .sum();
    let bodies = scene
        .objects
        .iter()
        .filter(|o| !o.mesh.triangles.is_empty() || !o.spheres.is_empty())
        .count();
    let seen = bodies + usize::from(scene.ground.is_some());
    if lights == 0 || seen < 2 && lights < 2 {
        return None;
    }
    let bounces = counted(indirect.bounces as usize, "bounce", "bounces");
    let spheres = counted(lights, "sphere sends", "spheres send");
    let update = format!("{spheres} on what falls on the surface around them, for {bounces}.");
    let hides = match indirect.blocking {
        Blocking::Discs => {
            "each is a disc in the sky that nearer ones cover in part, in an order that is right whether bodies interlock or not"
        }
        Blocking::Runs => {
            "what is summed up for nearer spheres serves farther ones, and pairs are looked at one by one only where bodies interlock"
        }
        Blocking::Sphere => "every sphere is looked at with all that are nearer",
        Blocking::Object => "bodies hide each other as a whole",
    };
    let gather = format!("Bodies light each other and the ground; {hides}.");
    Some((update, gather))
}

/// "1 object", "3 objects".
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::SurfacePoint;
    use crate::{
        Camera, EnvironmentMap, Ground, Indirect, Material, Mesh, Object, Settings, Sphere,
    };
    use glam::{Affine3A, Vec3};

    fn scene(spheres: usize, shadows: bool) -> Scene {
        let object = Object {
            name: "ball".into(),
            mesh: Mesh::default(),
            material: Material {
                albedo: [0.5; 3],
                texture: None,
            },
            transform: Affine3A::IDENTITY,
            spheres: vec![
                Sphere {
                    center: [0.0; 3],
                    radius: 1.0
                };
                spheres
            ],
            surface: Default::default(),
        };
        Scene {
            objects: vec![object],
            environment: EnvironmentMap::constant([1.0; 3]),
            lights: Vec::new(),
            ground: Some(Ground {
                height: 0.0,
                albedo: [0.5; 3],
            }),
            camera: Camera {
                eye: Vec3::Z,
                target: Vec3::ZERO,
                fov: 1.0,
            },
            settings: Settings {
                shadows,
                ..Settings::default()
            },
        }
    }

    #[test]
    fn an_effect_taken_away_leaves_the_plan_of_a_scene_that_never_had_it() {
        let never = Plan::new(&scene(0, false));
        assert_eq!(
            Plan::new(&scene(0, true)),
            never,
            "shadows on, but nothing blocks"
        );
        assert_eq!(
            Plan::new(&scene(8, false)),
            never,
            "blockers, but shadows off"
        );
        let with = Plan::new(&scene(8, true));
        assert_ne!(with, never);
        assert!(with.has(PassKind::Shadow) && !with.has(PassKind::Irradiance));
        assert!(never.has(PassKind::Irradiance) && !never.has(PassKind::Shadow));
        assert!(with.has(PassKind::Upsample) && !never.has(PassKind::Upsample));
    }

    #[test]
    fn light_is_sent_on_only_where_something_can_see_it() {
        let mut bounced = scene(8, true);
        let without = Plan::new(&bounced);
        bounced.settings.indirect = Some(Indirect::default());
        assert_eq!(Plan::new(&bounced), without, "no surface has been sampled");
        for _ in 0..8 {
            bounced.objects[0].surface.push([SurfacePoint::default()]);
        }
        let with = Plan::new(&bounced);
        assert!(with.has(PassKind::LightUpdate) && with.has(PassKind::LightGather));
        bounced.settings.half_resolution = false;
        assert!(Plan::new(&bounced).has(PassKind::LightGather));
        bounced.settings.indirect = None;
        bounced.settings.half_resolution = true;
        assert_eq!(Plan::new(&bounced), without);
        // One convex body alone sees nothing that it lights.
        let mut alone = scene(1, true);
        alone.settings.indirect = Some(Indirect::default());
        alone.objects[0].surface.push([SurfacePoint::default()]);
        assert!(
            Plan::new(&alone).has(PassKind::LightGather),
            "the ground does"
        );
        alone.ground = None;
        assert!(!Plan::new(&alone).has(PassKind::LightGather));
    }

    #[test]
    fn every_pass_reads_what_is_there() {
        let mut full = scene(8, true);
        full.settings.half_resolution = false;
        let mut bounced = full.clone();
        bounced.settings.indirect = Some(Indirect::default());
        bounced.objects[0].surface.push([SurfacePoint::default()]);
        let mut half = bounced.clone();
        half.settings.half_resolution = true;
        for scene in [scene(8, true), scene(0, true), full, bounced, half] {
            let plan = Plan::new(&scene);
            let mut there = Vec::new();
            for pass in &plan.passes {
                for read in pass.reads() {
                    let made = read.resolution() == Resolution::Fixed || there.contains(read);
                    assert!(
                        made,
                        "{} reads {read:?} before it is written",
                        pass.kind.name()
                    );
                }
                there.extend_from_slice(pass.writes());
            }
            assert!(there.contains(&Resource::Picture));
        }
    }

    #[test]
    fn reasons_are_sentences() {
        for pass in Plan::new(&scene(1, true)).passes {
            assert!(
                pass.reason.ends_with('.') && pass.reason.contains(' '),
                "{}",
                pass.reason
            );
        }
        let text = Plan::new(&scene(1, true)).to_string();
        assert!(
            text.contains("1 object and the ground") && text.contains("1 blocker sphere."),
            "{text}"
        );
    }

    #[test]
    fn a_higher_order_of_accumulation_is_told() {
        let mut scene = scene(3, true);
        assert!(!Plan::new(&scene).to_string().contains("accumulated"));
        scene.settings.accumulation = 6;
        let text = Plan::new(&scene).to_string();
        assert!(
            text.contains("order 4") && text.contains("accumulated in order 6."),
            "{text}"
        );
        scene.settings.shadows = false;
        assert!(!Plan::new(&scene).to_string().contains("accumulated"));
    }
}
