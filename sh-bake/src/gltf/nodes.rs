//! The tree of nodes: where each mesh stands, and how skins bend it.

use super::check;
use crate::mesh::RawPart;
use glam::{Mat3, Mat4, Vec3};
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::Data;

/// A mesh and where it stands.
pub(crate) struct Placed<'a> {
    pub(crate) mesh: gltf::Mesh<'a>,
    pub(crate) placement: Placement,
}

/// What takes a mesh's points to the scene.
pub(crate) enum Placement {
    /// One transform.
    Rigid(Mat4),
    /// One for each joint; the vertices say how much of which (glTF 2.0, section 3.7.3.3).
    Skinned(Vec<Mat4>),
}

/// Every mesh of the scene. Messages end in a full stop.
pub(crate) fn placed<'a>(
    document: &'a gltf::Document,
    scene: &gltf::Scene<'a>,
    buffers: &[Data],
) -> Result<Vec<Placed<'a>>, String> {
    let mut world: Vec<Option<Mat4>> = vec![None; document.nodes().count()];
    let mut meshes = Vec::new();
    let mut open: Vec<_> = scene.nodes().map(|node| (node, Mat4::IDENTITY)).collect();
    open.reverse();
    while let Some((node, parent)) = open.pop() {
        let local = Mat4::from_cols_array_2d(&node.transform().matrix());
        let index = node.index();
        if world[index].replace(parent * local).is_some() {
            return Err(format!(
                "nodes[{index}] is met twice, but nodes have to form a tree."
            ));
        }
        let first = open.len();
        open.extend(node.children().map(|child| (child, parent * local)));
        open[first..].reverse();
        if let Some(mesh) = node.mesh() {
            meshes.push((index, mesh, node.skin()));
        }
    }
    meshes
        .into_iter()
        .map(|(index, mesh, skin)| {
            let placement = match skin {
                // A skinned mesh ignores its own node's transform.
                Some(skin) => Placement::Skinned(joints(&skin, &world, buffers)?),
                None => Placement::Rigid(world[index].unwrap_or_default()),
            };
            Ok(Placed { mesh, placement })
        })
        .collect()
}

/// Scene from mesh for each joint of a skin, in the pose its nodes are in.
fn joints(
    skin: &gltf::Skin,
    world: &[Option<Mat4>],
    buffers: &[Data],
) -> Result<Vec<Mat4>, String> {
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
    let joint = |(k, node): (usize, gltf::Node)| {
        let inverse = inverses
            .get(k)
            .map_or(Mat4::IDENTITY, Mat4::from_cols_array_2d);
        // A joint outside the scene stands in its origin.
        world[node.index()].unwrap_or_default() * inverse
    };
    Ok(skin.joints().enumerate().map(joint).collect())
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
