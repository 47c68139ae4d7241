//! The `[[lights]]` of a scene file.

use crate::error::Error;
use crate::keys::{FAR, Section, beside, towards};
use crate::load_environment;
use crate::objects::{ObjectEntry, bound};
use crate::punctual::{self, PunctualEntry};

use sh_scene::{AreaLight, AreaShape, Distribution};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// One of `[[lights]]`.
pub(crate) struct LightEntry {
    /// Without what it is bound to and, before [`load`](Self::load), without its map.
    pub(crate) light: AreaLight,
    /// Which of `[[objects]]` it is bound to.
    pub(crate) object: Option<usize>,
    /// The map of its brightness.
    map: Option<PathBuf>,
}

/// What a light is, for one that says too little or too much.
const NEEDS: &str = "a light needs a direction and an angle, or a center and a radius.";

/// Keys that say how bright a ball is where, of which it has one at most.
const DISTRIBUTIONS: [&str; 3] = ["towards", "map", "distribution"];

/// All lights of the scene in a file, whose objects are known: those in spherical harmonics, and those with sharp shadows.
pub(crate) fn read(
    root: &Section,
    path: &Path,
    objects: &[ObjectEntry],
) -> Result<(Vec<LightEntry>, Vec<PunctualEntry>), Error> {
    let soft = [
        "direction",
        "angle",
        "center",
        "radius",
        "radiance",
        "window",
        "object",
        "towards",
        "spread",
        "map",
        "distribution",
    ];
    let known = [&soft[..], &punctual::KEYS].concat();
    let entries = root
        .sections("lights", "lights", &known)?
        .unwrap_or_default();
    let (mut lights, mut sharp) = (Vec::new(), Vec::new());
    for entry in &entries {
        match entry.string("kind")? {
            Some(kind) => sharp.push(punctual::read(entry, kind, &known, objects)?),
            None => lights.push(light(entry, path, objects)?),
        }
    }
    Ok((lights, sharp))
}

impl LightEntry {
    /// Reads its map.
    pub(crate) fn load(&mut self) -> Result<(), Error> {
        if let Some(map) = &self.map {
            self.light.distribution = Some(Distribution::of_map(&load_environment(map)?));
        }
        Ok(())
    }

    /// The light, bound to the first of the bodies that its object became.
    pub(crate) fn bound(&self, bodies: &[Range<usize>]) -> AreaLight {
        AreaLight {
            object: self.object.map(|object| bodies[object].start),
            ..self.light
        }
    }
}

fn light(s: &Section, path: &Path, objects: &[ObjectEntry]) -> Result<LightEntry, Error> {
    if let Some(key) = punctual::KEYS.iter().find(|key| s.has(key)) {
        let message =
            "is for a light with sharp shadows: it needs kind = \"spot\", \"point\" or \"sun\".";
        return Err(s.error(key, message));
    }
    let shape = shape(s)?;
    if let AreaShape::Distant { .. } = shape {
        let mut only_balls = DISTRIBUTIONS.iter().chain(&["spread", "object"]);
        if let Some(key) = only_balls.find(|key| s.has(key)) {
            let message = "has no place beside direction: it is for a ball, which has a center.";
            return Err(s.error(key, message));
        }
    }
    let map = s.string("map")?.map(|map| beside(path, map));
    let radiance = s.triple("radiance", "from 0 to 1e9", true, |n| {
        (0.0..=1e9).contains(&n)
    })?;
    // A map says all by itself.
    let of_map = map.as_ref().map(|_| [1.0; 3]);
    let radiance = radiance.or(of_map).ok_or_else(|| {
        let message = "is missing: it is how bright the light's surface is.";
        s.error("radiance", message)
    })?;
    Ok(LightEntry {
        light: AreaLight {
            window: s.number("window", "above 0", |n| n > 0.0)?,
            distribution: distribution(s)?,
            ..AreaLight::of(shape, radiance)
        },
        object: bound(s, objects)?,
        map,
    })
}

fn shape(s: &Section) -> Result<AreaShape, Error> {
    let metres = |key| s.triple(key, "of metres", false, |n| n.abs() < FAR);
    let direction = towards(s, "direction", "shine from")?;
    let angle = s.number("angle", "of degrees above 0, up to 90", |n| {
        n > 0.0 && n <= 90.0
    })?;
    let center = metres("center")?;
    let radius = s.number("radius", "of metres above 0", |n| n > 0.0 && n < FAR)?;
    let missing = |key: &str| s.error(key, format!("is missing: {NEEDS}"));
    let beside =
        |key: &str, other: &str| s.error(key, format!("has no place beside {other}: {NEEDS}"));
    match (direction, center) {
        (Some(_), None) if radius.is_some() => Err(beside("radius", "direction")),
        (Some(direction), None) => Ok(AreaShape::Distant {
            direction,
            angle: angle.ok_or_else(|| missing("angle"))?.to_radians(),
        }),
        (None, Some(_)) if angle.is_some() => Err(beside("angle", "center")),
        (None, Some(center)) => Ok(AreaShape::Local {
            center: center.into(),
            radius: radius.ok_or_else(|| missing("radius"))?,
        }),
        (Some(_), Some(_)) => Err(beside("center", "direction")),
        (None, None) => Err(missing("direction")),
    }
}

/// How bright a ball is where, but for what a map says.
fn distribution(s: &Section) -> Result<Option<Distribution>, Error> {
    let mut said = DISTRIBUTIONS.iter().filter(|key| s.has(key));
    if let (Some(first), Some(second)) = (said.next(), said.next()) {
        let message =
            format!("has no place beside {first}: one of them says how bright a ball is where.");
        return Err(s.error(second, message));
    }
    let spread = s.number("spread", "of degrees above 0, up to 180", |n| {
        n > 0.0 && n <= 180.0
    })?;
    match (towards(s, "towards", "glow to")?, spread) {
        (Some(direction), Some(spread)) => {
            // 180 degrees in single precision may be a little more than π.
            let angle = spread.to_radians().min(std::f32::consts::PI);
            let cap = Distribution::cap(direction, angle);
            return cap.map(Some).map_err(|e| s.error("towards", e));
        }
        (Some(_), None) => {
            let message = "is missing: it is the angle about `towards` within which a ball glows.";
            return Err(s.error("spread", message));
        }
        (None, Some(_)) => {
            let message = "says within which angle a ball glows, but there is no `towards`.";
            return Err(s.error("spread", message));
        }
        (None, None) => {}
    }
    let Some(coefficients) = s.colors("distribution")? else {
        return Ok(None);
    };
    Distribution::new(&coefficients).map(Some).map_err(|_| {
        let found = coefficients.len();
        let message = format!(
            "has {found} SH coefficients, but an order has 1, 4, 9, 16, 25 or 36 of them, and all have to be finite."
        );
        s.error("distribution", message)
    })
}
