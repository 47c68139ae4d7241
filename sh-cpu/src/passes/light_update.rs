//! The `light_update` pass: what every sphere of a body sends on (Guerrero et al. 2008, section 5).
//!
//! Each point of the surface around a sphere sends on its radiance times the albedo of its direction's Voronoi cell, and
//! the sum over all of them, in spherical harmonics, is what the sphere emits (equation 10), turned to world space. The
//! paper leaves it as it is and turns the weights at every receiver; there are many more receivers than spheres.
//!
//! A node of the forest that stands for several spheres emits their mean by cross-section; what is left between its light
//! and theirs is made up for each cluster (section 7.3, [`crate::LightCuts`]).

use crate::device::emission::Emission;
use crate::device::spherical_lights::Points;
use crate::error::Error;
use sh_core::{OrderError, ROOT_FOUR_PI, Routines, for_order};
use sh_scene::surface::{DIRECTIONS, SurfacePoint, cell_sums};
use sh_scene::{Body, Forest, Node};

/// Finds what every node of `forest` sends on of the light on the `points` of all `bodies`, in this SH order.
/// `within_bodies`: whether spheres of one body hide each other.
///
/// # Errors
/// Where there is no such order, or the bodies do not have the forest's spheres.
pub(crate) fn light_update<'a>(
    points: &Points,
    bodies: impl IntoIterator<Item = Body<'a>> + Clone,
    forest: &Forest,
    (order, within_bodies): (usize, bool),
    emission: &mut Emission,
) -> Result<(), Error> {
    let counts = || bodies.clone().into_iter().map(|body| body.spheres);
    let spheres: usize = counts().sum();
    if spheres != forest.spheres() {
        return Err(Error::Length {
            buffer: "bodies",
            expected: forest.spheres(),
            found: spheres,
        });
    }
    emission.order = order;
    emission.own(counts(), forest);
    emission.emit(points, bodies, forest, within_bodies)
}

impl Emission {
    /// Emission of all nodes from the points' radiance.
    fn emit<'a>(
        &mut self,
        points: &Points,
        bodies: impl IntoIterator<Item = Body<'a>>,
        forest: &Forest,
        within_bodies: bool,
    ) -> Result<(), Error> {
        for_order!(
            self.order, C => self.emit_in::<C>(points, bodies, forest, within_bodies),
            else => return Err(OrderError(self.order).into())
        );
        Ok(())
    }

    fn emit_in<'a, const C: usize>(
        &mut self,
        points: &Points,
        bodies: impl IntoIterator<Item = Body<'a>>,
        forest: &Forest,
        within_bodies: bool,
    ) where
        [f32; C]: Routines<f32>,
    {
        let nodes = forest.nodes();
        self.coefficients.clear();
        self.coefficients.resize(nodes.len() * C, [0.0; 3]);
        self.exposed.clear();
        self.exposed.resize(nodes.len() * C, 0.0);
        self.brightest.clear();
        self.brightest.resize(nodes.len(), [0.0; 3]);
        self.emit_spheres::<C>(points, bodies, within_bodies);
        for (at, node) in nodes.iter().enumerate().rev() {
            if !node.is_leaf(at) {
                self.emit_mean::<C>(at, nodes);
            }
        }
        self.most = self.brightest.first().copied().unwrap_or_default();
    }

    /// What each sphere emits: found in object space, and turned.
    fn emit_spheres<'a, const C: usize>(
        &mut self,
        points: &Points,
        bodies: impl IntoIterator<Item = Body<'a>>,
        within_bodies: bool,
    ) where
        [f32; C]: Routines<f32>,
    {
        let mut leaves = self.leaves.iter();
        let mut lit = points.radiance.iter().zip(&points.sent);
        for body in bodies {
            let turn = body.turn();
            for sphere in 0..body.spheres {
                let sent = Sent::of(body.surface.of(sphere), &mut lit, within_bodies);
                let vector = sent.vector::<C>(body.surface.stands(sphere, within_bodies));
                let turn = body.frame(turn, sphere).to_array();
                let [red, green, blue] = vector.map(|v| v.rotate(turn));
                let Some(node) = leaves.next().map(|&node| node as usize) else {
                    continue;
                };
                let all = body.surface.exposed(sphere, within_bodies);
                // Those of a lower order come first.
                let seen: [f32; C] = std::array::from_fn(|i| all[i]);
                self.exposed[node * C..][..C].copy_from_slice(&seen.rotate(turn));
                self.brightest[node] = sent.brightest;
                for (i, out) in self.coefficients[node * C..][..C].iter_mut().enumerate() {
                    *out = [red[i], green[i], blue[i]];
                }
            }
        }
    }

    /// What a node emits that stands for several: the mean of its children by their cross-sections, of a sphere as much as
    /// its body leaves to be seen of it.
    fn emit_mean<const C: usize>(&mut self, at: usize, nodes: &[Node]) {
        let (above, below) = self.coefficients.split_at_mut((at + 1) * C);
        let own = &mut above[at * C..];
        for child in children(at, nodes) {
            let share = if nodes[at].area > 0.0 {
                // In the mean over all directions.
                let seen = match nodes[child].is_leaf(child) {
                    true => self.exposed[child * C] / ROOT_FOUR_PI as f32,
                    false => 1.0,
                };
                nodes[child].area / nodes[at].area * seen
            } else {
                0.0
            };
            for (own, from) in own.iter_mut().zip(&below[(child - at - 1) * C..][..C]) {
                for (own, from) in own.iter_mut().zip(from) {
                    *own += share * from;
                }
            }
            let below = self.brightest[child];
            for (most, c) in self.brightest[at].iter_mut().zip(below) {
                *most = most.max(c);
            }
        }
    }
}

/// The nodes directly below one.
fn children(at: usize, nodes: &[Node]) -> impl Iterator<Item = usize> {
    let end = nodes[at].skip as usize;
    let first = Some(at + 1).filter(|&child| child < end);
    std::iter::successors(first, move |&child| {
        Some(nodes[child].skip as usize).filter(|&next| next < end)
    })
}

/// What the points of a sphere send on.
struct Sent {
    points: [[f32; 3]; DIRECTIONS],
    /// The most that any of them does.
    brightest: [f32; 3],
}

impl Sent {
    /// `lit` tells the light on each point: what no body and what bodies have sent.
    fn of<'p>(
        points: &[SurfacePoint],
        lit: &mut impl Iterator<Item = (&'p [f32; 3], &'p [f32; 3])>,
        within_bodies: bool,
    ) -> Self {
        let mut sent = Self {
            points: [[0.0; 3]; DIRECTIONS],
            brightest: [0.0; 3],
        };
        for (i, (point, (direct, indirect))) in points.iter().zip(lit).enumerate() {
            let reflected = point.reflectance(within_bodies);
            let of_point: [f32; 3] =
                std::array::from_fn(|k| (reflected[k] * (direct[k] + indirect[k])).max(0.0));
            for (most, sent) in sent.brightest.iter_mut().zip(of_point) {
                *most = most.max(sent);
            }
            if let Some(slot) = sent.points.get_mut(i) {
                *slot = of_point;
            }
        }
        sent
    }

    /// As SH vectors: each direction's cell is as bright as the point that `stands` for it, and dark where none does.
    fn vector<const C: usize>(&self, stands: [u8; DIRECTIONS]) -> [[f32; C]; 3] {
        let mut vector = [[0.0; C]; 3];
        for (cell, point) in cell_sums().iter().zip(stands) {
            let Some(sent) = self.points.get(usize::from(point)) else {
                continue;
            };
            for (vector, sent) in vector.iter_mut().zip(sent) {
                for (v, y) in vector.iter_mut().zip(cell) {
                    *v += sent * y;
                }
            }
        }
        vector
    }
}
