//! The cameras of a file.

use super::nodes::Tree;
use crate::error::one_line;
use crate::model::ModelCamera;
use glam::Vec3;
use gltf::camera::Projection;

/// The cameras of the scene in perspective, in the file's space, and a sentence about the others.
pub(super) fn all(tree: &Tree, moves: bool, warnings: &mut Vec<String>) -> Vec<ModelCamera> {
    let mut all = Vec::new();
    let mut flat = 0;
    for (camera, node, world) in &tree.cameras {
        let Projection::Perspective(perspective) = camera.projection() else {
            flat += 1;
            continue;
        };
        let eye = world.transform_point3(Vec3::ZERO);
        let ahead = world.transform_vector3(Vec3::NEG_Z).try_normalize();
        let name = camera.name().or(node.as_deref()).map(one_line);
        all.push(ModelCamera {
            name: name.unwrap_or_default(),
            eye,
            ahead: ahead.unwrap_or(Vec3::NEG_Z),
            fov: perspective.yfov().clamp(0.02, 3.0),
        });
    }
    if moves && !all.is_empty() {
        warnings.push("its cameras do not move with its clips.".into());
    }
    if flat > 0 {
        let cameras = if flat == 1 {
            "camera is"
        } else {
            "cameras are"
        };
        warnings.push(format!(
            "{flat} {cameras} orthographic and passed over: pictures are in perspective."
        ));
    }
    all
}
