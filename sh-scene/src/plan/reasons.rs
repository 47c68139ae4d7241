//! What a scene calls for, and the sentences that say why.

use super::LeftOut;
use crate::{Blocking, Object, Scene, Settings};

/// What of a scene and its settings decides about passes and shaders.
pub(super) struct Called<'a> {
    pub scene: &'a Scene,
    pub settings: Settings,
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
    /// Why light is sent on, and why it is gathered, or why neither is.
    pub bounce: Option<(String, String)>,
    no_bounce: &'static str,
}

impl<'a> Called<'a> {
    pub fn of(scene: &'a Scene) -> Self {
        let settings = scene.settings;
        let blockers = scene.objects.iter().map(|o| o.spheres.len()).sum();
        let shadows = settings.shadows && blockers > 0;
        let (bounce, no_bounce) = match bounce(scene) {
            Ok(both) => (Some(both), ""),
            Err(none) => (None, none),
        };
        let shining = || scene.lights.iter().filter(|lamp| lamp.shines());
        let triangles = |o: &&Object| !o.mesh.triangles.is_empty();
        Self {
            scene,
            settings,
            blockers,
            lamps: shining().count(),
            uneven: shining().filter(|lamp| lamp.distribution.is_some()).count(),
            drawn: scene.objects.iter().filter(triangles).count(),
            shadows,
            half: shadows && settings.half_resolution,
            bounce,
            no_bounce,
        }
    }

    fn light(&self) -> String {
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

    pub fn shadow(&self) -> String {
        let spheres = counted(self.blockers, "blocker sphere", "blocker spheres");
        let accumulation = self.settings.accumulation;
        let accumulated = match accumulation == self.settings.order {
            true => String::new(),
            false => format!(", whose logarithms are accumulated in order {accumulation}"),
        };
        format!(
            "{} is cast into shadow by {spheres}{accumulated}.",
            self.light()
        )
    }

    pub fn irradiance(&self) -> String {
        format!("{} reaches every receiver unblocked.", self.light())
    }

    pub fn gbuffer(&self) -> String {
        let bodies = counted(self.scene.objects.len(), "object", "objects");
        let surfaces = match self.scene.ground {
            Some(_) => format!("{bodies} and the ground"),
            None => bodies,
        };
        format!("The camera's rays have to find {surfaces}.")
    }

    /// What there is no work for.
    pub fn left_out(&self) -> Vec<LeftOut> {
        let mut all = Vec::new();
        let mut add = |name, reason: &str| {
            let reason = reason.to_string();
            all.push(LeftOut { name, reason });
        };
        if !self.shadows {
            add(
                "shadow",
                match self.settings.shadows {
                    true => "Nothing in the scene has blocker spheres.",
                    false => "Shadows are switched off.",
                },
            );
        } else {
            add(
                "irradiance",
                "The shadow pass gives unblocked light as well.",
            );
        }
        if !self.half {
            add(
                "upsample",
                match self.shadows {
                    true => "Shadows are computed for every sample, as the settings ask.",
                    false => {
                        "Without shadows, light costs less than taking it from half resolution."
                    }
                },
            );
        }
        if self.bounce.is_none() {
            add("light_update", self.no_bounce);
            add("light_gather", self.no_bounce);
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
        if self.scene.ground.is_none() {
            add("ground", "There is no ground plane: it is not drawn.");
        }
        if self.drawn == 0 {
            add("bodies", "No object has a triangle: none is drawn.");
        }
        all
    }
}

/// Why light is sent on and why it is gathered, for a scene that asks for it and has bodies that can see another, or why
/// it is not.
fn bounce(scene: &Scene) -> Result<(String, String), &'static str> {
    let indirect = scene
        .settings
        .indirect
        .ok_or("Bodies do not light each other, because the settings do not ask for it.")?;
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
    if lights == 0 {
        return Err("No sphere has surface samples that could send light on.");
    }
    if seen < 2 && lights < 2 {
        return Err("Nothing can see the only sphere that would send light on.");
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
    Ok((update, gather))
}

/// "1 object", "3 objects".
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
