//! What brings a node's light to that of the spheres it stands for.

use crate::device::emission::Emission;
use glam::Vec3;
use sh_core::constants::MOST_GAIN;
use sh_scene::Forest;

/// The reflection ratio of a node whose disc has this radius: what the spheres below it give to `from`, each by the square
/// of its disc's sine and as much of it as its body leaves to be seen from there, over what the node gives in their place. 1 for
/// a sphere, and where there is nothing to be brought to anything.
pub(super) fn gain(
    from: Vec3,
    at: usize,
    radius: f32,
    forest: &Forest,
    lights: &Emission,
) -> [f32; 3] {
    let node = &forest.nodes()[at];
    if node.is_leaf(at) || !lights.shines(at as u32) {
        return [1.0; 3];
    }
    let given = |at: usize, radius: f32| {
        let to = Vec3::from(forest.nodes()[at].center) - from;
        let square = to.length_squared();
        let sine = (radius * radius / square.max(f32::MIN_POSITIVE))
            .min(1.0)
            .sqrt();
        let radiance = lights.radiance(at as u32, sine, -to / square.sqrt());
        radiance.map(|c| sine * sine * c)
    };
    let mut sum = [0.0; 3];
    for (at, leaf) in forest
        .nodes()
        .iter()
        .enumerate()
        .take(node.skip as usize)
        .skip(at + 1)
    {
        if leaf.is_leaf(at) {
            let towards = from - Vec3::from(leaf.center);
            let exposed = lights.exposed(at as u32, towards.normalize_or(Vec3::Y));
            for (sum, given) in sum.iter_mut().zip(given(at, leaf.radius)) {
                *sum += exposed * given;
            }
        }
    }
    let own = given(at, radius);
    std::array::from_fn(|c| {
        if own[c] > 0.0 && sum[c] > 0.0 {
            (sum[c] / own[c]).min(MOST_GAIN)
        } else {
            1.0
        }
    })
}
