//! The hierarchy's topology: which spheres stand together (Ren et al. 2006, section 6.3, "Construction").

use super::forest::enclosing;
use crate::Sphere;
use crate::lloyd::{curve, lloyd};

/// Children a node has on average.
const BRANCHING: usize = 4;

/// Spheres that are clustered at once. More are first cut into stretches of a space-filling curve, so that the
/// time grows with their number and not with its square.
const AT_ONCE: usize = 1024;

/// A part of the tree while it grows.
pub(super) struct Part {
    pub(super) ball: Sphere,
    /// The sphere of the scene, for a leaf.
    pub(super) leaf: Option<u32>,
    pub(super) children: Vec<Self>,
}

/// Puts parts under one root, level by level from below: each level has a quarter of the nodes of the one under
/// it.
pub(super) fn raise(mut parts: Vec<Part>) -> Option<Part> {
    while parts.len() > 1 {
        parts = level(parts);
    }
    parts.pop()
}

/// One level up.
fn level(parts: Vec<Part>) -> Vec<Part> {
    let centers: Vec<[f32; 3]> = parts.iter().map(|p| p.ball.center).collect();
    let groups = if parts.len() <= BRANCHING {
        vec![(0..parts.len()).collect()]
    } else {
        let mut groups = Vec::new();
        for stretch in curve(&centers).chunks(AT_ONCE) {
            groups.extend(lloyd(&centers, stretch, stretch.len().div_ceil(BRANCHING)));
        }
        groups
    };
    let mut parts: Vec<Option<Part>> = parts.into_iter().map(Some).collect();
    groups
        .into_iter()
        .map(|group| {
            let mut children: Vec<Part> = group.iter().filter_map(|&i| parts[i].take()).collect();
            if children.len() == 1 {
                return children.remove(0);
            }
            let ball = children.iter().map(|c| c.ball).reduce(enclosing);
            Part {
                ball: ball.unwrap_or(Sphere {
                    center: [0.0; 3],
                    radius: 0.0,
                }),
                leaf: None,
                children,
            }
        })
        .collect()
}
