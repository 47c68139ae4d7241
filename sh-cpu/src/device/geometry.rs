//! The scene's triangles in world space, ready for casting rays.

use crate::error::Error;
use glam::{Mat3A, Vec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::cwbvh::CwBvh;
use obvhs::cwbvh::builder::build_cwbvh;
use obvhs::ray::{Ray, RayHit};
use obvhs::{Boundable, BvhBuildParams};
use sh_scene::{Object, Scene, fingerprint};
use std::sync::Arc;
use std::time::Duration;

/// All triangles of a scene and a bounding volume hierarchy over them. Built once per scene.
#[derive(Debug)]
pub struct Geometry<'a> {
    pub(crate) scene: &'a Scene,
    hierarchy: Arc<Hierarchy>,
}

/// What rays are cast against, kept while nothing of it moves.
#[derive(Debug)]
pub(crate) struct Hierarchy {
    /// That of the triangles and transforms that it was built from.
    fingerprint: u64,
    /// None where there is no triangle.
    hierarchy: Option<CwBvh>,
    /// What the hierarchy's coordinates are over those of the world, a power of two ([`own_scale`]).
    scale: f32,
    /// World space corners, in the hierarchy's order.
    corners: Vec<[Vec3A; 3]>,
    /// Which triangle of the scene each is.
    sources: Vec<Source>,
}

/// A triangle of the scene.
#[derive(Clone, Copy, Debug)]
struct Source {
    object: u32,
    triangle: u32,
}

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Metres along the ray.
    pub distance: f32,
    /// Position on the triangle, world space.
    pub position: Vec3A,
    /// Unit normal, interpolated between the vertices' and turned to the viewer's side of the surface.
    pub normal: Vec3A,
    /// Index of the object.
    pub object: u32,
    /// Texture coordinates, where the mesh has them.
    pub uv: Option<[f32; 2]>,
    /// What the albedo is multiplied with, where the mesh has colours.
    pub color: Option<Vec3A>,
}

/// The box of a triangle, a little larger: the hierarchy's slab test rounds, and a ray through an edge must
/// not slip past both neighbours.
struct Bounds(Aabb);

impl Boundable for Bounds {
    fn aabb(&self) -> Aabb {
        self.0
    }
}

impl<'a> Geometry<'a> {
    /// Gathers the triangles and builds the hierarchy. Triangles of zero area are left out.
    pub fn new(scene: &'a Scene) -> Result<Self, Error> {
        Self::reusing(scene, None)
    }

    /// As [`new`](Self::new), with a hierarchy that was built before if it is of the same triangles in the same places.
    pub(crate) fn reusing(
        scene: &'a Scene,
        before: Option<&Arc<Hierarchy>>,
    ) -> Result<Self, Error> {
        let mut fingerprint = 0_u64;
        for (index, object) in scene.objects.iter().enumerate() {
            check(object).map_err(|problem| Error::Object {
                index,
                name: object.name.clone(),
                problem,
            })?;
            fingerprint = fingerprint.rotate_left(7).wrapping_add(shape(object));
        }
        let hierarchy = match before.filter(|known| known.fingerprint == fingerprint) {
            Some(known) => Arc::clone(known),
            None => Arc::new(Hierarchy::new(scene, fingerprint)),
        };
        Ok(Self { scene, hierarchy })
    }

    /// What may be handed to [`reusing`](Self::reusing).
    pub(crate) fn hierarchy(&self) -> &Arc<Hierarchy> {
        &self.hierarchy
    }

    /// The nearest triangle along a ray with unit `direction`, from either side.
    ///
    /// Edges are tight: a ray that passes between two triangles with common corners hits one of them, as
    /// both see the same projected corners (after Woop, Benthin and Wald, 2013, "Watertight ray/triangle
    /// intersection").
    ///
    /// The outside of a triangle is the side its vertex normals point to. Seen from behind (an open mesh),
    /// the interpolated normal is turned round; seen from the front it is left alone even where the
    /// interpolation leans away from the viewer, as it does along silhouettes.
    pub fn cast(&self, origin: Vec3A, direction: Vec3A) -> Option<Hit> {
        let Hierarchy {
            hierarchy,
            scale,
            corners,
            ..
        } = &*self.hierarchy;
        let hierarchy = hierarchy.as_ref()?;
        let view = ViewSpace::new(origin, direction);
        let mut nearest = RayHit::none();
        // + 0 turns -0 into 0: the slab test takes the sign of a component once by comparison and once from
        // its reciprocal, and for -0 the two differ.
        let ray = Ray::new_inf(origin * *scale, direction + Vec3A::ZERO);
        let found = hierarchy.ray_traverse(ray, &mut nearest, |_, id| {
            view.meet(&corners[id])
                .map_or(f32::INFINITY, |(_, distance)| distance * scale)
        });
        if !found {
            return None;
        }
        let id = nearest.primitive_id as usize;
        let (weights, distance) = view.meet(&corners[id])?;
        Some(self.hit(id, weights, distance, direction))
    }

    /// Interpolates the vertices' attributes.
    fn hit(&self, id: usize, weights: [f32; 3], distance: f32, direction: Vec3A) -> Hit {
        let [a, b, c] = self.hierarchy.corners[id];
        let source = self.hierarchy.sources[id];
        let object = &self.scene.objects[source.object as usize];
        let indices = object.mesh.triangles[source.triangle as usize].map(|i| i as usize);
        let to_world: Mat3A = object.transform.matrix3;
        let normals = indices.map(|i| to_world * Vec3A::from_array(object.mesh.normals[i]));

        let plane = (b - a).cross(c - a);
        let outside = if plane.dot(normals[0] + normals[1] + normals[2]) < 0.0 {
            -plane
        } else {
            plane
        };
        let smooth = normals[0] * weights[0] + normals[1] * weights[1] + normals[2] * weights[2];
        let smooth = smooth
            .try_normalize()
            .unwrap_or_else(|| outside.normalize());
        let normal = if outside.dot(direction) > 0.0 {
            -smooth
        } else {
            smooth
        };

        let uv = (!object.mesh.uvs.is_empty()).then(|| {
            let [u, v, w] = indices.map(|i| object.mesh.uvs[i]);
            core::array::from_fn(|k| u[k] * weights[0] + v[k] * weights[1] + w[k] * weights[2])
        });
        let color = (!object.mesh.colors.is_empty()).then(|| {
            let [u, v, w] = indices.map(|i| Vec3A::from_array(object.mesh.colors[i]));
            u * weights[0] + v * weights[1] + w * weights[2]
        });
        Hit {
            distance,
            position: a * weights[0] + b * weights[1] + c * weights[2],
            normal,
            object: source.object,
            uv,
            color,
        }
    }
}

impl Hierarchy {
    fn new(scene: &Scene, fingerprint: u64) -> Self {
        let mut corners = Vec::new();
        let mut sources = Vec::new();
        for (index, object) in scene.objects.iter().enumerate() {
            let world: Vec<Vec3A> = object
                .mesh
                .positions
                .iter()
                .map(|&p| object.transform.transform_point3a(p.into()))
                .collect();
            for (triangle, indices) in object.mesh.triangles.iter().enumerate() {
                let [a, b, c] = indices.map(|i| world[i as usize]);
                let area = (b - a).cross(c - a);
                if area != Vec3A::ZERO && area.is_finite() {
                    corners.push([a, b, c]);
                    sources.push(Source {
                        object: index as u32,
                        triangle: triangle as u32,
                    });
                }
            }
        }
        if corners.is_empty() {
            return Self {
                fingerprint,
                hierarchy: None,
                scale: 1.0,
                corners,
                sources,
            };
        }

        let reach = corners
            .iter()
            .flatten()
            .fold(0.0, |reach: f32, p| reach.max(p.abs().max_element()));
        let scale = own_scale(reach);
        let pad = Vec3A::splat(reach * 1e-6);
        let bounds: Vec<Bounds> = corners
            .iter()
            .map(|corners| {
                let tight = Aabb::from_points(corners);
                Bounds(Aabb {
                    min: (tight.min - pad) * scale,
                    max: (tight.max + pad) * scale,
                })
            })
            .collect();
        let hierarchy = build_cwbvh(
            &bounds,
            BvhBuildParams::medium_build(),
            &mut Duration::default(),
        );
        let order = &hierarchy.primitive_indices;
        let corners = order.iter().map(|&i| corners[i as usize]).collect();
        let sources = order.iter().map(|&i| sources[i as usize]).collect();
        Self {
            fingerprint,
            hierarchy: Some(hierarchy),
            scale,
            corners,
            sources,
        }
    }

    /// Bytes of triangles and nodes.
    pub fn bytes(&self) -> usize {
        let tree = self.hierarchy.as_ref();
        let nodes = tree.map_or(0, |tree| {
            size_of_val(&tree.nodes[..]) + size_of_val(&tree.primitive_indices[..])
        });
        nodes + size_of_val(&self.corners[..]) + size_of_val(&self.sources[..])
    }
}

/// A fingerprint of an object's triangles and of where they stand.
fn shape(object: &Object) -> u64 {
    let transform = object.transform.to_cols_array().map(f32::to_bits);
    let parts = [
        fingerprint(bytemuck::cast_slice(&object.mesh.positions)),
        fingerprint(object.mesh.triangles.as_flattened()),
        fingerprint(&transform),
    ];
    let mixed = |all: u64, part: u64| all.rotate_left(21) ^ part;
    parts.into_iter().fold(0, mixed)
}

/// The power of two that brings `reach`, the largest coordinate, to 8..16.
///
/// The hierarchy is made for scenes of some metres: it misses boxes that end within 1e-4 of a ray's start, and
/// where debug assertions are on it refuses what rounds by more than 1e-5. In coordinates of its own these are
/// 1e-5 and 1e-6 of the scene whatever its size.
fn own_scale(reach: f32) -> f32 {
    let exponent = (3.0 - reach.log2().floor()).clamp(-126.0, 126.0);
    exponent.exp2()
}

/// A ray's own coordinates: x and y across it, z along.
struct ViewSpace {
    origin: Vec3A,
    axes: Mat3A,
}

impl ViewSpace {
    #[inline(always)]
    fn new(origin: Vec3A, direction: Vec3A) -> Self {
        let (x, y) = Vec3::from(direction).any_orthonormal_pair();
        let axes = Mat3A::from_cols(x.into(), y.into(), direction).transpose();
        Self { origin, axes }
    }

    /// Barycentric weights and distance where the ray meets the triangle, if it does in front.
    #[inline(always)]
    fn meet(&self, corners: &[Vec3A; 3]) -> Option<([f32; 3], f32)> {
        let [a, b, c] = corners.map(|p| self.axes * (p - self.origin));
        let u = c.x * b.y - c.y * b.x;
        let v = a.x * c.y - a.y * c.x;
        let w = b.x * a.y - b.y * a.x;
        let mixed = (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0);
        let sum = u + v + w;
        if mixed || sum == 0.0 {
            return None;
        }
        let weights = [u / sum, v / sum, w / sum];
        let distance = a.z * weights[0] + b.z * weights[1] + c.z * weights[2];
        (distance > 0.0 && distance < f32::INFINITY).then_some((weights, distance))
    }
}

/// Whether the parts of an object fit each other; the sentence that says what does not.
fn check(object: &Object) -> Result<(), String> {
    let mesh = &object.mesh;
    let vertices = mesh.positions.len();
    if mesh.normals.len() != vertices {
        return Err(format!(
            "{vertices} positions but {} normals; each position needs one",
            mesh.normals.len()
        ));
    }
    if !mesh.uvs.is_empty() && mesh.uvs.len() != vertices {
        return Err(format!(
            "{vertices} positions but {} texture coordinates; each position needs one, or none has",
            mesh.uvs.len()
        ));
    }
    if !mesh.colors.is_empty() && mesh.colors.len() != vertices {
        return Err(format!(
            "{vertices} positions but {} colours; each position needs one, or none has",
            mesh.colors.len()
        ));
    }
    if let Some(at) = mesh.positions.iter().flatten().position(|c| !c.is_finite()) {
        return Err(format!("position {} is not finite", at / 3));
    }
    for (at, triangle) in mesh.triangles.iter().enumerate() {
        if let Some(index) = triangle.iter().find(|&&index| index as usize >= vertices) {
            return Err(format!(
                "triangle {at} refers to vertex {index} of {vertices}"
            ));
        }
    }
    if !object.transform.is_finite() {
        return Err("its transform is not finite".into());
    }
    if let Some(texture) = &object.material.texture {
        let bytes = texture.width as usize * texture.height as usize * 4;
        if bytes == 0 || texture.rgba.len() != bytes {
            return Err(format!(
                "a texture of {} by {} texels needs {bytes} bytes (and at least one texel), not {}",
                texture.width,
                texture.height,
                texture.rgba.len()
            ));
        }
    }
    Ok(())
}
