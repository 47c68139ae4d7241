//! Those of the `[[lights]]` of a scene file that have sharp shadows: spots, points and suns.

use crate::error::Error;
use crate::keys::{FAR, Section, towards};
use crate::objects::{ObjectEntry, bound};
use glam::Vec3;
use sh_scene::{PunctualLight, PunctualShape};
use std::ops::Range;

/// One of `[[lights]]` that says its kind.
pub(crate) struct PunctualEntry {
    /// Without what it is bound to.
    pub(crate) light: PunctualLight,
    /// Which of `[[objects]]` it is bound to.
    pub(crate) object: Option<usize>,
}

impl PunctualEntry {
    /// The light, bound to the first of the bodies that its object became.
    pub(crate) fn bound(&self, bodies: &[Range<usize>]) -> PunctualLight {
        PunctualLight {
            object: self.object.map(|object| bodies[object].start),
            ..self.light
        }
    }
}

/// Keys that it has beside others of `[[lights]]`.
pub(crate) const KEYS: [&str; 5] = ["kind", "position", "blend", "color", "intensity"];

/// The keys that each kind knows.
const KINDS: [(&str, &[&str]); 3] = [
    (
        "spot",
        &[
            "kind",
            "position",
            "towards",
            "angle",
            "blend",
            "radius",
            "color",
            "intensity",
            "object",
        ],
    ),
    (
        "point",
        &["kind", "position", "radius", "color", "intensity", "object"],
    ),
    ("sun", &["kind", "direction", "angle", "color", "intensity"]),
];

/// Reads a light that says its kind; `all` are the keys that any light may have.
pub(crate) fn read(
    s: &Section,
    kind: &str,
    all: &[&str],
    objects: &[ObjectEntry],
) -> Result<PunctualEntry, Error> {
    let Some((_, known)) = KINDS.iter().find(|(name, _)| *name == kind) else {
        let message = format!(
            "is \"{kind}\", but it has to be \"spot\", \"point\" or \"sun\"; discs in the sky and glowing balls have none."
        );
        return Err(s.error("kind", message));
    };
    if let Some(key) = all.iter().find(|key| s.has(key) && !known.contains(key)) {
        let message = format!(
            "has no place in a {kind}, which has {}.",
            known[1..].join(", ")
        );
        return Err(s.error(key, message));
    }
    let missing = |key: &str, what: &str| s.error(key, format!("is missing: {what}"));
    let position = || {
        let position = s.triple("position", "of metres", false, |n| n.abs() < FAR)?;
        let position = position.ok_or_else(|| missing("position", "it is where the light is."));
        position.map(Vec3::from)
    };
    let radius = || {
        let radius = s.number("radius", "of metres, not below 0", |n| {
            (0.0..FAR).contains(&n)
        })?;
        Ok(radius.unwrap_or(0.0))
    };
    let shape = match kind {
        "spot" => {
            let way = towards(s, "towards", "shine to")?;
            let way = way.ok_or_else(|| missing("towards", "it is the way that a spot shines."))?;
            let angle = s.number("angle", "of degrees above 0 and below 180", |n| {
                n > 0.0 && n < 180.0
            })?;
            let blend = s.number("blend", "from 0 to 1", |n| (0.0..=1.0).contains(&n))?;
            PunctualShape::Spot {
                position: position()?,
                towards: way,
                angle: angle.unwrap_or(45.0).to_radians(),
                blend: blend.unwrap_or(0.15),
                radius: radius()?,
            }
        }
        "point" => PunctualShape::Point {
            position: position()?,
            radius: radius()?,
        },
        _ => {
            let direction = towards(s, "direction", "shine from")?;
            let angle = s.number("angle", "of degrees from 0 to 45", |n| {
                (0.0..=45.0).contains(&n)
            })?;
            PunctualShape::Sun {
                direction: direction
                    .ok_or_else(|| missing("direction", "it is the way towards the sun."))?,
                angle: angle.unwrap_or(0.267).to_radians(),
            }
        }
    };
    let bright = |n: f32| (0.0..=1e9).contains(&n);
    let intensity = s.triple("intensity", "from 0 to 1e9", true, bright)?;
    let intensity = intensity.ok_or_else(|| {
        let unit = match kind {
            "sun" => "the irradiance of what faces it, radiance times steradians.",
            _ => "its radiant intensity, radiance times square metres.",
        };
        missing("intensity", &format!("it is {unit}"))
    })?;
    let color = s.triple("color", "from 0 to 1", true, |n| (0.0..=1.0).contains(&n))?;
    let color = color.unwrap_or([1.0; 3]);
    Ok(PunctualEntry {
        light: PunctualLight::new(shape, [0, 1, 2].map(|c| intensity[c] * color[c])),
        object: bound(s, objects)?,
    })
}
