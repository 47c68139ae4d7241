//! The tree of nodes: where each mesh stands, and how skins bend it.

use super::check;
use crate::raw::RawPart;
use glam::{Affine3A, Mat3, Mat4, Vec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::Data;
use sh_scene::motion::{Bone, Influences, Joint};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A mesh and where it stands.
pub(crate) struct Placed<'a> {
    pub(crate) mesh: gltf::Mesh<'a>,
    pub(crate) placement: Placement,
    /// The first of its bones in [`Tree::bones`].
    pub(crate) first_bone: u32,
}

/// What takes a mesh's points to the scene.
pub(crate) enum Placement {
    /// One transform.
    Rigid(Mat4),
    /// One for each joint; the vertices say how much of which (glTF 2.0, section 3.7.3.3).
    Skinned(Rc<[Mat4]>),
}

/// The scene's nodes and what stands on them.
pub(crate) struct Tree<'a> {
    pub(crate) meshes: Vec<Placed<'a>>,
    /// All nodes of the scene, parents first.
    pub(crate) joints: Vec<Joint>,
    /// Which of the joints each of the document's nodes is; none for nodes outside the scene.
    pub(crate) joint_of: Vec<Option<u32>>,
    /// For each mesh without a skin the node it stands on; for each with one the skin's joints, and a bone that
    /// stays in the origin, for vertices without weights.
    pub(crate) bones: Vec<Bone>,
    /// The cameras of nodes, with the nodes' names, and what takes their space to the scene's.
    pub(crate) cameras: Vec<(gltf::Camera<'a>, Option<String>, Mat4)>,
    /// The lights of nodes, and what takes their space to the scene's.
    pub(crate) lights: Vec<(gltf::khr_lights_punctual::Light<'a>, Mat4)>,
}

impl<'a> Tree<'a> {
    /// Every node and mesh of the scene. Messages end in a full stop.
    pub(crate) fn new(
        document: &'a gltf::Document,
        scene: &gltf::Scene<'a>,
        buffers: &[Data],
    ) -> Result<Self, String> {
        let count = document.nodes().count();
        let mut world: Vec<Option<Mat4>> = vec![None; count];
        let (mut joints, mut joint_of) = (Vec::new(), vec![None; count]);
        let mut standing = Vec::new();
        let (mut lights, mut cameras) = (Vec::new(), Vec::new());
        let mut open: Vec<_> = scene
            .nodes()
            .map(|node| (node, Mat4::IDENTITY, None))
            .collect();
        open.reverse();
        while let Some((node, above, parent)) = open.pop() {
            let local = Mat4::from_cols_array_2d(&node.transform().matrix());
            let index = node.index();
            if world[index].replace(above * local).is_some() {
                return Err(format!(
                    "nodes[{index}] is met twice, but nodes have to form a tree."
                ));
            }
            let joint = joints.len() as u32;
            joint_of[index] = Some(joint);
            joints.push(Joint {
                parent,
                local: Affine3A::from_mat4(local),
            });
            let first = open.len();
            let children = node.children();
            open.extend(children.map(|child| (child, above * local, Some(joint))));
            open[first..].reverse();
            if let Some(light) = node.light() {
                lights.push((light, above * local));
            }
            if let Some(camera) = node.camera() {
                cameras.push((camera, node.name().map(String::from), above * local));
            }
            if let Some(mesh) = node.mesh() {
                standing.push((index, mesh, node.skin()));
            }
        }
        let mut tree = Self {
            meshes: Vec::new(),
            joints,
            joint_of,
            bones: Vec::new(),
            lights,
            cameras,
        };
        // Several meshes may share a skin.
        let mut skins: BTreeMap<usize, (u32, Rc<[Mat4]>)> = BTreeMap::new();
        for (index, mesh, skin) in standing {
            let mut first_bone = tree.bones.len() as u32;
            let placement = match skin {
                // A skinned mesh ignores its own node's transform.
                Some(skin) => {
                    let matrices = match skins.get(&skin.index()) {
                        Some((first, matrices)) => {
                            first_bone = *first;
                            Rc::clone(matrices)
                        }
                        None => tree.bind(&skin, &world, buffers)?,
                    };
                    skins.insert(skin.index(), (first_bone, Rc::clone(&matrices)));
                    Placement::Skinned(matrices)
                }
                None => {
                    tree.bones.push(Bone {
                        joint: tree.joint_of[index],
                        inverse_bind: Affine3A::IDENTITY,
                    });
                    Placement::Rigid(world[index].unwrap_or_default())
                }
            };
            tree.meshes.push(Placed {
                mesh,
                placement,
                first_bone,
            });
        }
        Ok(tree)
    }

    /// Scene from mesh for each joint of a skin, in the pose its nodes are in. Adds its bones.
    fn bind(
        &mut self,
        skin: &gltf::Skin,
        world: &[Option<Mat4>],
        buffers: &[Data],
    ) -> Result<Rc<[Mat4]>, String> {
        let index = skin.index();
        let mut inverses = Vec::new();
        if let Some(accessor) = skin.inverse_bind_matrices() {
            check::accessor(&accessor, buffers, Dimensions::Mat4, &[DataType::F32])
                .map_err(|e| format!("skins[{index}].inverseBindMatrices: {e}."))?;
            let reader = skin.reader(|buffer| buffers.get(buffer.index()).map(|data| &data.0[..]));
            inverses = reader
                .read_inverse_bind_matrices()
                .map(Iterator::collect)
                .unwrap_or_default();
        }
        let mut matrices = Vec::new();
        for (k, node) in skin.joints().enumerate() {
            let inverse = inverses
                .get(k)
                .map_or(Mat4::IDENTITY, Mat4::from_cols_array_2d);
            self.bones.push(Bone {
                joint: self.joint_of[node.index()],
                inverse_bind: Affine3A::from_mat4(inverse),
            });
            // A joint outside the scene stands in its origin.
            matrices.push(world[node.index()].unwrap_or_default() * inverse);
        }
        self.bones.push(Bone {
            joint: None,
            inverse_bind: Affine3A::IDENTITY,
        });
        Ok(matrices.into())
    }
}

impl Placement {
    /// Takes a part's points and normals to the scene. Messages have no full stop.
    pub(crate) fn apply(
        &self,
        part: &mut RawPart,
        joints: &[[u16; 4]],
        weights: &[[f32; 4]],
    ) -> Result<(), String> {
        match self {
            Self::Rigid(matrix) => {
                let turn = normal_matrix(matrix);
                part.positions
                    .iter_mut()
                    .for_each(|p| *p = point(matrix, p));
                part.normals
                    .iter_mut()
                    .for_each(|n| *n = direction(&turn, n));
                if matrix.determinant() < 0.0 {
                    part.triangles.iter_mut().for_each(|t| t.swap(1, 2));
                }
            }
            Self::Skinned(matrices) => {
                if joints.len() != part.positions.len() || weights.len() != part.positions.len() {
                    return Err(
                        "JOINTS_0 and WEIGHTS_0: a skinned mesh needs both for every vertex".into(),
                    );
                }
                for (i, (joints, weights)) in joints.iter().zip(weights).enumerate() {
                    let mut matrix = Mat4::ZERO;
                    for (&joint, &weight) in joints.iter().zip(weights) {
                        if weight != 0.0 {
                            let Some(m) = matrices.get(usize::from(joint)) else {
                                let count = matrices.len();
                                return Err(format!(
                                    "JOINTS_0: joint {joint} is out of range 0..{count}"
                                ));
                            };
                            matrix += *m * weight;
                        }
                    }
                    let total = weights.iter().sum::<f32>();
                    if total > 0.0 {
                        matrix *= 1.0 / total;
                    } else {
                        matrix = Mat4::IDENTITY;
                    }
                    part.positions[i] = point(&matrix, &part.positions[i]);
                    if let Some(n) = part.normals.get_mut(i) {
                        *n = direction(&normal_matrix(&matrix), n);
                    }
                }
            }
        }
        Ok(())
    }

    /// What carries each of a part's vertices, with bones counted from `first_bone` on. Joints and weights are
    /// those that [`apply`](Self::apply) has taken.
    pub(crate) fn influences(
        &self,
        first_bone: u32,
        count: usize,
        joints: &[[u16; 4]],
        weights: &[[f32; 4]],
    ) -> Vec<Influences> {
        let Self::Skinned(matrices) = self else {
            return vec![Influences::one(first_bone); count];
        };
        let origin = first_bone + matrices.len() as u32;
        let of = |(joints, weights): (&[u16; 4], &[f32; 4])| {
            let total = weights.iter().sum::<f32>();
            if total.is_nan() || total <= 0.0 {
                return Influences::one(origin);
            }
            // A joint of weight 0 may be any, even one that is not there.
            let bone = |k: usize| match weights[k] == 0.0 {
                true => origin,
                false => first_bone + u32::from(joints[k]),
            };
            Influences {
                bones: std::array::from_fn(bone),
                weights: weights.map(|weight| weight / total),
            }
        };
        joints.iter().zip(weights).map(of).collect()
    }
}

fn point(matrix: &Mat4, p: &[f32; 3]) -> [f32; 3] {
    matrix.transform_point3(Vec3::from(*p)).to_array()
}

fn direction(matrix: &Mat3, n: &[f32; 3]) -> [f32; 3] {
    (*matrix * Vec3::from(*n)).normalize_or_zero().to_array()
}

/// What normals turn by: the cofactors, which are the inverse transpose times the determinant and exist
/// for every matrix. The determinant's sign is taken out, since a mirrored triangle is turned round as well.
fn normal_matrix(matrix: &Mat4) -> Mat3 {
    let m = Mat3::from_mat4(*matrix);
    let sign = if m.determinant() < 0.0 { -1.0 } else { 1.0 };
    Mat3::from_cols(
        m.y_axis.cross(m.z_axis) * sign,
        m.z_axis.cross(m.x_axis) * sign,
        m.x_axis.cross(m.y_axis) * sign,
    )
}
