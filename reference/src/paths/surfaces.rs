//! What paths meet: triangles with their materials, and the infinite ground.

use super::texture::Texels;
use crate::raycast::{Caster, Triangle, world_triangles};
use crate::vec3::{Vec3, add, cross, dot, length, normalize, scale, sub, widen};
use sh_scene::{Object, Scene};

/// Where a path meets a surface.
pub(super) struct Meeting {
    /// Metres along the ray.
    pub distance: f64,
    /// Where the next ray starts: off the surface, on the side that the last one came from.
    pub start: Vec3,
    /// Unit normal towards that side, interpolated between the vertices' as pictures are shaded.
    pub normal: Vec3,
    /// Reflectance.
    pub albedo: [f64; 3],
}

/// What a ray meets first.
pub(super) enum Met {
    Nothing,
    Body(Meeting),
    /// The ground, from above.
    Ground(Meeting),
    /// The ground from below, or the surface itself that the ray starts from: no light comes from there.
    Dark,
}

struct Material {
    albedo: [f64; 3],
    texture: Option<Texels>,
}

/// A triangle's corners' normals in world space, texture coordinates and colours, and the index of its material.
struct Face {
    normals: Option<[Vec3; 3]>,
    uvs: Option<[[f64; 2]; 3]>,
    colors: Option<[[f64; 3]; 3]>,
    material: usize,
}

/// All surfaces of a scene.
pub(super) struct Surfaces {
    caster: Caster,
    triangles: Vec<Triangle>,
    faces: Vec<Face>,
    materials: Vec<Material>,
    /// Height and reflectance.
    ground: Option<(f64, [f64; 3])>,
    /// Metres that rays start above their surface.
    off: f64,
}

impl Surfaces {
    pub fn new(scene: &Scene) -> Self {
        let mut world = Vec::new();
        let mut faces = Vec::new();
        let mut materials = Vec::new();
        for (material, object) in scene.objects.iter().enumerate() {
            world.extend(world_triangles(object));
            faces.extend(all_faces(object, material));
            materials.push(Material {
                albedo: reflectance(object.material.albedo),
                texture: object.material.texture.as_ref().map(Texels::new),
            });
        }
        let reach = world.iter().flatten().flatten();
        let reach = reach.fold(0.0, |reach: f64, c| reach.max(c.abs()));
        Self {
            caster: Caster::new(world.clone()),
            triangles: world,
            faces,
            materials,
            ground: scene
                .ground
                .map(|g| (f64::from(g.height), reflectance(g.albedo))),
            // Receivers come in single precision: this is some hundred times its rounding.
            off: 1e-5 * reach.max(1e-3),
        }
    }

    /// Where rays from a receiver start.
    pub fn start(&self, point: Vec3, normal: Vec3) -> Vec3 {
        add(point, scale(normal, self.off))
    }

    /// Whether a point lies under the ground.
    pub fn buried(&self, point: Vec3) -> bool {
        self.ground.is_some_and(|(height, _)| point[1] < height)
    }

    /// Whether anything is in the way for so many metres.
    pub fn blocked(&self, start: Vec3, direction: Vec3, limit: f64) -> bool {
        self.ground_at(start, direction).is_some_and(|d| d < limit)
            || self.caster.blocked_within(start, direction, 0.0, limit)
    }

    /// What a ray meets first.
    pub fn meet(&self, start: Vec3, direction: Vec3) -> Met {
        let hit = self.caster.nearest_hit(start, direction, 0.0);
        if let Some(distance) = self.ground_at(start, direction)
            && hit.is_none_or(|hit| distance < hit.distance)
            && let Some((height, albedo)) = self.ground
        {
            if direction[1] > 0.0 {
                return Met::Dark;
            }
            let mut point = add(start, scale(direction, distance));
            point[1] = height;
            let normal = [0.0, 1.0, 0.0];
            return Met::Ground(Meeting {
                distance,
                start: self.start(point, normal),
                normal,
                albedo,
            });
        }
        let Some(hit) = hit else {
            return Met::Nothing;
        };
        let corners = &self.triangles[hit.triangle];
        let plane = cross(sub(corners[1], corners[0]), sub(corners[2], corners[0]));
        let plane = normalize(plane);
        // Normals of vertices lean: what is above the plane that they stand for may be below the triangle's own, and a
        // ray that starts just above a triangle may meet that very triangle.
        if dot(plane, sub(start, corners[0])).abs() < 1.5 * self.off {
            return Met::Dark;
        }
        let face = &self.faces[hit.triangle];
        let side = if dot(plane, direction) > 0.0 {
            -1.0
        } else {
            1.0
        };
        let facing = scale(plane, side);
        let normal = face.normals.map_or(facing, |normals| {
            smooth(normals, hit.weights, plane, direction).unwrap_or(facing)
        });
        let point = add(start, scale(direction, hit.distance));
        let material = &self.materials[face.material];
        let mut albedo = material.albedo;
        let mut tint = |color: [f64; 3]| albedo = [0, 1, 2].map(|c| albedo[c] * color[c]);
        if let (Some(texels), Some(uvs)) = (&material.texture, face.uvs) {
            tint(texels.color(mixed(uvs, hit.weights)));
        }
        if let Some(colors) = face.colors {
            tint(mixed(colors, hit.weights));
        }
        Met::Body(Meeting {
            distance: hit.distance,
            start: add(point, scale(facing, self.off)),
            normal,
            albedo,
        })
    }

    fn ground_at(&self, start: Vec3, direction: Vec3) -> Option<f64> {
        let (height, _) = self.ground?;
        let distance = (height - start[1]) / direction[1];
        (distance > 0.0 && distance.is_finite()).then_some(distance)
    }
}

/// The interpolated normal, turned to the side that a ray comes from. The outside of a triangle is where its vertices'
/// normals point.
fn smooth(normals: [Vec3; 3], weights: [f64; 3], plane: Vec3, direction: Vec3) -> Option<Vec3> {
    let [a, b, c] = normals;
    let sum = add(
        add(scale(a, weights[0]), scale(b, weights[1])),
        scale(c, weights[2]),
    );
    let length = length(sum);
    let outside = if dot(plane, add(add(a, b), c)) < 0.0 {
        -1.0
    } else {
        1.0
    };
    let side = if outside * dot(plane, direction) > 0.0 {
        -1.0
    } else {
        1.0
    };
    (length > 0.0).then(|| scale(sum, side / length))
}

/// What corners have, at a point between them.
fn mixed<const N: usize>(corners: [[f64; N]; 3], weights: [f64; 3]) -> [f64; N] {
    std::array::from_fn(|k| (0..3).map(|i| weights[i] * corners[i][k]).sum())
}

fn all_faces(object: &Object, material: usize) -> impl Iterator<Item = Face> {
    let mesh = &object.mesh;
    // Rotation and uniform scale: normals turn as vectors do.
    let m = object.transform.matrix3.to_cols_array().map(f64::from);
    let turned = move |i: u32| {
        let [x, y, z] = widen(mesh.normals[i as usize]);
        normalize([0, 1, 2].map(|k| m[k] * x + m[3 + k] * y + m[6 + k] * z))
    };
    let (smooth, textured) = (!mesh.normals.is_empty(), !mesh.uvs.is_empty());
    let colored = !mesh.colors.is_empty();
    mesh.triangles.iter().map(move |corners| Face {
        normals: smooth.then(|| corners.map(turned)),
        uvs: textured.then(|| corners.map(|i| mesh.uvs[i as usize].map(f64::from))),
        colors: colored.then(|| corners.map(|i| reflectance(mesh.colors[i as usize]))),
        material,
    })
}

/// Between 0 and 1; what is not a number reflects nothing.
fn reflectance(albedo: [f32; 3]) -> [f64; 3] {
    albedo.map(|c| if c > 0.0 { f64::from(c).min(1.0) } else { 0.0 })
}
