//! The `[[lights]]` of a scene file.

use crate::error::Error;
use crate::keys::Section;
use crate::scene_file::FAR;
use glam::Vec3;
use sh_scene::{AreaLight, AreaShape};

/// What a light is, for one that says too little or too much.
const NEEDS: &str = "a light needs a direction and an angle, or a center and a radius.";

/// All lights of a scene.
pub(crate) fn read(root: &Section) -> Result<Vec<AreaLight>, Error> {
    let known = [
        "direction",
        "angle",
        "center",
        "radius",
        "radiance",
        "window",
    ];
    let entries = root
        .sections("lights", "lights", &known)?
        .unwrap_or_default();
    entries.iter().map(light).collect()
}

fn light(s: &Section) -> Result<AreaLight, Error> {
    let metres = |key| s.triple(key, "of metres", false, |n| n.abs() < FAR);
    let direction = s.triple("direction", "of any length but 0", false, |n| n.abs() < FAR)?;
    let angle = s.number("angle", "of degrees above 0, up to 90", |n| {
        n > 0.0 && n <= 90.0
    })?;
    let center = metres("center")?;
    let radius = s.number("radius", "of metres above 0", |n| n > 0.0 && n < FAR)?;
    let missing = |key: &str| s.error(key, format!("is missing: {NEEDS}"));
    let beside =
        |key: &str, other: &str| s.error(key, format!("has no place beside {other}: {NEEDS}"));
    let shape = match (direction, center) {
        (Some(direction), None) => {
            if radius.is_some() {
                return Err(beside("radius", "direction"));
            }
            let direction = Vec3::from(direction);
            if direction.try_normalize().is_none() {
                let message = "has no length, so there is nowhere to shine from.";
                return Err(s.error("direction", message));
            }
            AreaShape::Distant {
                direction,
                angle: angle.ok_or_else(|| missing("angle"))?.to_radians(),
            }
        }
        (None, Some(center)) => {
            if angle.is_some() {
                return Err(beside("angle", "center"));
            }
            AreaShape::Local {
                center: center.into(),
                radius: radius.ok_or_else(|| missing("radius"))?,
            }
        }
        (Some(_), Some(_)) => return Err(beside("center", "direction")),
        (None, None) => return Err(missing("direction")),
    };
    let radiance = s.triple("radiance", "from 0 to 1e9", true, |n| {
        (0.0..=1e9).contains(&n)
    })?;
    Ok(AreaLight {
        shape,
        radiance: radiance.ok_or_else(|| {
            s.error(
                "radiance",
                "is missing: it is how bright the light's surface is.",
            )
        })?,
        window: s.number("window", "above 0", |n| n > 0.0)?,
    })
}
