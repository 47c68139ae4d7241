//! Linear blend skinning: vertices that follow several bones (glTF 2.0, section 3.7.3.3).

use super::MotionError;
use crate::Mesh;
use glam::{Affine3A, Mat3A, Vec3A};

/// Which bones carry a vertex, and how much of it. Weights sum to 1; bones of weight 0 count for nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influences {
    /// Indices of bones.
    pub bones: [u32; 4],
    /// The share of each.
    pub weights: [f32; 4],
}

impl Influences {
    /// A vertex that one bone carries.
    pub fn one(bone: u32) -> Self {
        Self {
            bones: [bone; 4],
            weights: [1.0, 0.0, 0.0, 0.0],
        }
    }

    /// Bones and their weights, without those of weight 0.
    pub fn each(&self) -> impl Iterator<Item = (u32, f32)> {
        let each = self.bones.into_iter().zip(self.weights);
        each.filter(|(_, weight)| *weight != 0.0)
    }
}

/// A mesh at rest and what carries its vertices.
#[derive(Clone, Debug)]
pub struct Skin {
    positions: Vec<Vec3A>,
    normals: Vec<Vec3A>,
    bound: Bound,
}

#[derive(Clone, Debug)]
enum Bound {
    /// All to the same bone.
    One(u32),
    Each(Vec<Influences>),
}

impl Skin {
    /// A skin: positions and unit normals where the vertices were bound, and what carries each.
    ///
    /// # Errors
    /// Where the lists are not equally long.
    pub fn new(
        positions: &[[f32; 3]],
        normals: &[[f32; 3]],
        influences: Vec<Influences>,
    ) -> Result<Self, MotionError> {
        let expected = positions.len();
        for (what, found) in [("normals", normals.len()), ("influences", influences.len())] {
            if found != expected {
                return Err(MotionError::Length {
                    what,
                    found,
                    expected,
                });
            }
        }
        let first = influences.first().map_or(0, |first| first.bones[0]);
        let rigid = influences.iter().all(|i| *i == Influences::one(first));
        Ok(Self {
            positions: positions.iter().map(|p| Vec3A::from(*p)).collect(),
            normals: normals.iter().map(|n| Vec3A::from(*n)).collect(),
            bound: match rigid {
                true => Bound::One(first),
                false => Bound::Each(influences),
            },
        })
    }

    /// How many vertices there are.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no vertex.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Where a vertex was bound.
    pub fn position(&self, vertex: usize) -> [f32; 3] {
        self.positions[vertex].to_array()
    }

    /// What carries a vertex.
    pub fn influences(&self, vertex: usize) -> Influences {
        match &self.bound {
            Bound::One(bone) => Influences::one(*bone),
            Bound::Each(influences) => influences[vertex],
        }
    }

    /// The bones that carry anything, each as often as it comes.
    pub(super) fn bones(&self) -> impl Iterator<Item = u32> {
        let (one, each) = match &self.bound {
            Bound::One(bone) => (Some(*bone), &[][..]),
            Bound::Each(influences) => (None, &influences[..]),
        };
        let each = each.iter().flat_map(|i| i.each().map(|(bone, _)| bone));
        one.into_iter().chain(each)
    }

    /// Writes positions and unit normals of the mesh where the bones, root from mesh each, carry them.
    /// Vertices that the mesh has not are passed over. Takes about 20 ns a vertex, a quarter of that where all
    /// hang on one bone.
    ///
    /// # Panics
    /// If a bone is missing, which [`Rig::new`](super::Rig::new) sees to.
    pub fn pose(&self, bones: &[Affine3A], mesh: &mut Mesh) {
        self.pose_from(0, bones, &mut mesh.positions, &mut mesh.normals);
    }

    /// [`pose`](Self::pose) for as many vertices as there is room for, from `first` on: a host may share a large
    /// mesh out among threads.
    ///
    /// # Panics
    /// As [`pose`](Self::pose).
    pub fn pose_from(
        &self,
        first: usize,
        bones: &[Affine3A],
        positions: &mut [[f32; 3]],
        normals: &mut [[f32; 3]],
    ) {
        let rest = self.positions.iter().zip(&self.normals).skip(first);
        let posed = positions.iter_mut().zip(normals);
        match &self.bound {
            Bound::One(bone) => {
                let bone = bones[*bone as usize];
                let turn = normal_matrix(&bone.matrix3);
                for ((p, n), (position, normal)) in rest.zip(posed) {
                    *position = bone.transform_point3a(*p).to_array();
                    *normal = unit(turn * *n, *n);
                }
            }
            Bound::Each(influences) => {
                let influences = influences.iter().skip(first);
                for (((p, n), influences), (position, normal)) in rest.zip(influences).zip(posed) {
                    let matrix = blend(bones, influences);
                    *position = matrix.transform_point3a(*p).to_array();
                    *normal = unit(normal_matrix(&matrix.matrix3) * *n, *n);
                }
            }
        }
    }
}

/// The weighted sum of bones.
#[inline(always)]
pub(super) fn blend(bones: &[Affine3A], influences: &Influences) -> Affine3A {
    let Influences { bones: of, weights } = influences;
    let first = &bones[of[0] as usize];
    let mut matrix3 = first.matrix3 * weights[0];
    let mut translation = first.translation * weights[0];
    for k in 1..4 {
        if weights[k] != 0.0 {
            let bone = &bones[of[k] as usize];
            matrix3 += bone.matrix3 * weights[k];
            translation += bone.translation * weights[k];
        }
    }
    Affine3A {
        matrix3,
        translation,
    }
}

fn unit(n: Vec3A, rest: Vec3A) -> [f32; 3] {
    // Where a bone shrinks to nothing there is no normal: any will do.
    n.normalize_or(rest).to_array()
}

/// What normals turn by: the cofactors, which are the inverse transpose times the determinant and exist for
/// every matrix. The determinant's sign is taken out: a mirrored mesh still faces outwards.
#[inline(always)]
fn normal_matrix(m: &Mat3A) -> Mat3A {
    let x = m.y_axis.cross(m.z_axis);
    let sign = if m.x_axis.dot(x) < 0.0 { -1.0 } else { 1.0 };
    Mat3A::from_cols(
        x * sign,
        m.z_axis.cross(m.x_axis) * sign,
        m.x_axis.cross(m.y_axis) * sign,
    )
}
