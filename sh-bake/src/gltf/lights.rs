//! The lights of a file: KHR_lights_punctual.

use super::nodes::Tree;
use glam::{Mat4, Vec3};
use gltf::khr_lights_punctual::{Kind, Light};
use sh_scene::{PunctualLight, PunctualShape};

/// Lumens of a watt of light of 555 nm, by which files tell how bright lights are. A radiance of 1 is a watt per steradian and square metre.
const LUMENS: f32 = 683.0;

/// The widest cone there is here; files may have one of 180 degrees.
const WIDEST: f32 = 179.9 * std::f32::consts::PI / 180.0;

/// Those of the scene, in the file's space, and sentences about them.
pub(super) fn all(tree: &Tree, moves: bool, warnings: &mut Vec<String>) -> Vec<PunctualLight> {
    let lights: Vec<_> = tree
        .lights
        .iter()
        .map(|(light, world)| one(light, *world))
        .collect();
    if lights.is_empty() {
        return lights;
    }
    let count = match lights.len() {
        1 => "its light is in the scene, its candela or lux".into(),
        count => format!("its {count} lights are in the scene, their candela and lux"),
    };
    warnings.push(format!(
        "{count} over 683, so that a radiance of 1 is a watt per steradian and square metre; lights = false under [[objects]] leaves them out."
    ));
    if moves {
        warnings.push("its lights do not move with its clips.".into());
    }
    if tree.lights.iter().any(|(light, _)| light.range().is_some()) {
        warnings.push("the range of its lights was passed over: they shine however far.".into());
    }
    lights
}

fn one(light: &Light, world: Mat4) -> PunctualLight {
    let position = world.transform_point3(Vec3::ZERO);
    let way = world.transform_vector3(Vec3::NEG_Z);
    let way = way.try_normalize().unwrap_or(Vec3::NEG_Z);
    let shape = match light.kind() {
        Kind::Directional => PunctualShape::Sun {
            direction: -way,
            angle: 0.0,
        },
        Kind::Point => PunctualShape::Point {
            position,
            radius: 0.0,
        },
        Kind::Spot {
            inner_cone_angle,
            outer_cone_angle,
        } => {
            let angle = (2.0 * outer_cone_angle).clamp(1e-4, WIDEST);
            PunctualShape::Spot {
                position,
                towards: way,
                angle,
                blend: (1.0 - 2.0 * inner_cone_angle / angle).clamp(0.0, 1.0),
                radius: 0.0,
            }
        }
    };
    let bright = |c: f32| (c * light.intensity() / LUMENS).max(0.0);
    PunctualLight::new(shape, light.color().map(bright))
}
