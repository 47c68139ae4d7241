//! What of a scene decides about its passes.

use super::passes::SHADOW;
use super::{Domain, Entry, LeftOut, Resource, Run};
use crate::{BasisBody, Method, Object, Scene, Settings};
use sh_core::{Routines, for_order};

/// What of a scene and its settings decides about passes and shaders.
pub struct Facts<'a> {
    /// The scene itself.
    pub scene: &'a Scene,
    /// Its settings.
    pub settings: Settings,
    /// Whether receivers are the caller's, and not what a camera sees.
    pub brought: bool,
    /// What somebody asked for beside the picture.
    pub asked: Vec<Resource>,
    /// Blocker spheres.
    pub blockers: usize,
    /// Lamps that shine.
    pub lamps: usize,
    /// Those of them that have a distribution.
    pub uneven: usize,
    /// Bodies with a triangle.
    pub drawn: usize,
    /// Whether blockers cast shadows.
    pub shadows: bool,
    /// Whether they do so at half resolution.
    pub half: bool,
    /// How many spheres send light on, or why none does.
    pub senders: Result<usize, &'static str>,
    /// Points on the surfaces around them.
    pub points: usize,
    /// How many bodies send light on by their patches, or why none does; nothing where nobody asked for it.
    pub patched: Result<usize, &'static str>,
    /// The points of these.
    pub patches: usize,
    /// How many objects mirror light.
    pub glossy: usize,
    /// Spots, points and suns that shine.
    pub punctual: usize,
}

impl<'a> Facts<'a> {
    /// Of a scene; `brought` says whether its receivers are the caller's.
    pub fn of(scene: &'a Scene, brought: bool) -> Self {
        let settings = scene.settings;
        let blockers = scene.objects.iter().map(|o| o.spheres.len()).sum();
        let shadows = settings.shadows && blockers > 0;
        let shining = || scene.lights.iter().filter(|lamp| lamp.shines());
        let triangles = |o: &&Object| !o.mesh.triangles.is_empty();
        Self {
            scene,
            settings,
            brought,
            asked: Vec::new(),
            blockers,
            lamps: shining().count(),
            uneven: shining().filter(|lamp| lamp.distribution.is_some()).count(),
            drawn: scene.objects.iter().filter(triangles).count(),
            shadows,
            half: shadows && settings.half_resolution && !brought,
            senders: senders(scene),
            points: scene.objects.iter().map(|o| o.surface.points.len()).sum(),
            patched: patched(scene),
            patches: BasisBody::all(&scene.objects)
                .map(|body| body.basis.patches())
                .sum(),
            glossy: match settings.gloss && !brought {
                true => scene.objects.iter().filter(|o| o.mirrors()).count(),
                false => 0,
            },
            punctual: scene.punctual.iter().filter(|light| light.shines()).count(),
        }
    }

    /// Whether anything may be before lights with sharp shadows, and shadows are asked for.
    pub fn views(&self) -> bool {
        self.punctual > 0 && self.settings.shadows && self.drawn > 0
    }

    /// The receivers that have to be lit in the end.
    pub fn finest(&self) -> Domain {
        match self.brought {
            true => Domain::Receivers,
            false => Domain::Samples,
        }
    }

    /// Whether bodies send light on, by whatever.
    pub fn sends(&self) -> bool {
        self.senders.is_ok() || self.patched.is_ok()
    }

    /// The points of bodies at which light is looked up, by domain: those around spheres, and those of patches.
    pub fn lit_points(&self) -> Vec<Domain> {
        let all = [
            (Domain::Points, self.senders.is_ok()),
            (Domain::Patches, self.patched.is_ok()),
        ];
        all.into_iter()
            .filter(|(_, any)| *any)
            .map(|(at, _)| at)
            .collect()
    }

    /// Runs of a pass over what is seen: at half resolution and over the rest, or over the finest.
    pub(super) fn seen(&self, reason: impl Into<String>, rest: &str) -> Vec<Run> {
        match self.half {
            true => vec![
                Run::once(Domain::Halves, reason),
                Run::once(Domain::Rest, rest),
            ],
            false => vec![Run::once(self.finest(), reason)],
        }
    }

    /// The run of a pass over what mirrors light.
    pub(super) fn gloss(&self, reason: &str) -> Option<Run> {
        (self.glossy > 0).then(|| Run::once(Domain::Gloss, reason))
    }

    /// An entry of a pass as it is, and as it is for what mirrors light, where anything does.
    pub(super) fn with_gloss(&self, entry: Entry) -> Vec<Entry> {
        let kinds: &[bool] = if self.glossy > 0 {
            &[false, true]
        } else {
            &[false]
        };
        let of = |gloss: &bool| entry.clone().with(&[("GLOSS", *gloss)]);
        kinds.iter().map(of).collect()
    }

    /// Runs of a pass over all points of bodies in the turns of further bounces.
    pub(super) fn bounced(&self, reason: &str) -> Vec<Run> {
        let turns = 1..self.bounces();
        let points = self.lit_points().into_iter().filter(|_| !turns.is_empty());
        points
            .map(|at| Run::in_turns(at, turns.clone(), reason))
            .collect()
    }

    /// How often light is sent on.
    pub fn bounces(&self) -> u32 {
        self.settings.indirect.unwrap_or_default().bounces.max(1)
    }

    /// Why nothing that anyone sees is cast into shadow, if nothing is.
    pub fn unblocked(&self) -> Option<&'static str> {
        if !self.settings.shadows {
            Some("Shadows are switched off.")
        } else if !self.shadows {
            Some("Nothing in the scene has blocker spheres.")
        } else {
            None
        }
    }

    /// Whether somebody asked for something.
    pub fn asks(&self, resource: Resource) -> bool {
        self.asked.contains(&resource)
    }

    /// The override constants of kernels that know of lamps.
    pub fn lamp_constants(&self) -> [(&'static str, bool); 2] {
        [
            ("LAMPS", self.lamps > 0),
            ("DISTRIBUTIONS", self.uneven > 0),
        ]
    }

    /// The light, as sentences begin with it.
    pub fn light(&self) -> String {
        let order = self.settings.order;
        let lamps = counted(self.lamps, "lamp", "lamps");
        match [self.lamps, self.uneven] {
            [0, _] => format!("Environment light of order {order}"),
            [_, 0] => format!("Environment light of order {order} and that of {lamps}"),
            [_, n] => format!(
                "Environment light of order {order} and that of {lamps}, {n} with a distribution of its own,"
            ),
        }
    }

    /// What a picture that mirrors light says of it: from which roughness on the order of light blurs what is mirrored of the
    /// environment.
    pub(super) fn mirrored(&self) -> String {
        let objects = counted(self.glossy, "object mirrors", "objects mirror");
        let order = self.settings.order;
        format!(
            "{objects} light; the environment is of order {order}, so that what is smoother than roughness {:.2} mirrors it as blurred as that, but lamps and bodies sharply{}.",
            sharpest(order),
            match self.sends() {
                true => "",
                false => "; bodies are black there, since they send no light on",
            }
        )
    }

    /// What parts of passes there is no work for.
    pub(super) fn left_out(&self) -> Vec<LeftOut> {
        let mut all = Vec::new();
        let mut add = |name, reason: &str| {
            let reason = reason.to_string();
            all.push(LeftOut { name, reason });
        };
        // Where bodies light each other, it runs all the same, but no receiver of the picture sees it.
        if let (true, Some(why)) = (self.sends(), self.unblocked()) {
            add(SHADOW.name, why);
        }
        let dark = self.scene.lights.len() - self.lamps;
        if self.lamps == 0 && dark == 0 {
            add(
                "lamps",
                "There is none: shaders are made without the code for them.",
            );
        } else if dark > 0 {
            let lamps = counted(dark, "lamp has", "lamps have");
            add("lamps", &format!("{lamps} no radiance."));
        }
        if self.scene.ground.is_none() && !self.brought {
            add("ground", "There is no ground plane: it is not drawn.");
        }
        let polished = self.scene.objects.iter().filter(|o| o.mirrors()).count();
        if !self.brought && polished > 0 && !self.settings.gloss {
            let bodies = counted(
                polished,
                "polished object reflects",
                "polished objects reflect",
            );
            add(
                "gloss",
                &format!("The settings do not ask for it: {bodies} diffusely."),
            );
        }
        if self.drawn == 0 && !self.brought {
            add("bodies", "No object has a triangle: none is drawn.");
        }
        all
    }
}

/// How many spheres send light on, in a scene that asks for it and has bodies that can see another; or why none does.
fn senders(scene: &Scene) -> Result<usize, &'static str> {
    scene
        .settings
        .indirect
        .ok_or("Bodies do not light each other, because the settings do not ask for it.")?;
    let shining = |o: &&Object| !o.surface.points.is_empty();
    let by_patches = scene.objects.iter().any(|o| o.basis.is_some());
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
    if lights == 0 && by_patches {
        return Err("Bodies send light on by their patches: none does by its spheres.");
    }
    if lights == 0 {
        return Err("No sphere has surface samples that could send light on.");
    }
    if seen < 2 && lights < 2 {
        return Err("Nothing can see the only sphere that would send light on.");
    }
    Ok(lights)
}

/// How many bodies send light on by their patches, in a scene that asks for it; or why none does, in no words where nobody
/// asked for it.
fn patched(scene: &Scene) -> Result<usize, &'static str> {
    let Some(indirect) = scene.settings.indirect else {
        return Err("");
    };
    // A body of its own method is asked for by having functions.
    match (BasisBody::all(&scene.objects).count(), indirect.method) {
        (0, Method::BasisIrradiance) => Err("No body has functions that tell its irradiance."),
        (0, Method::SphericalLights) => Err(""),
        (count, _) => Ok(count),
    }
}

/// The roughness of the sharpest lobe that light of an order tells.
fn sharpest(order: usize) -> f32 {
    fn told<const C: usize>() -> f32
    where
        [f32; C]: Routines<f32>,
    {
        <[f32; C]>::gloss_told(0.0)
    }
    for_order!(order, C => told::<C>(), else => 1.0)
}

/// "1 object", "3 objects".
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
