//! A scene, loaded and resolved: nothing in it refers to a file or needs a default any more.

use crate::{
    AreaLight, Camera, EnvironmentMap, Finish, Forest, Indirect, IrradianceBasis, Light,
    LightError, Limits, PunctualLight, Quality, Sphere, SurfaceSamples, Texture,
};
use glam::{Affine3A, Vec3};
use std::sync::Arc;

/// A triangle mesh in its object's own space.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Vertex positions, in metres.
    pub positions: Vec<[f32; 3]>,
    /// Unit vertex normals, as many as positions.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates, as many as positions, or none; (0, 0) is the texture's first texel.
    pub uvs: Vec<[f32; 2]>,
    /// Colours that the material's albedo is multiplied with, linear Rec.709, each in 0..=1, as many as positions, or
    /// none.
    pub colors: Vec<[f32; 3]>,
    /// Vertex indices, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// How a surface reflects: in its base colour, `albedo` times the texture and the mesh's colours, and by its finish.
#[derive(Clone, Debug)]
pub struct Material {
    /// Linear Rec.709 reflectance, each in 0..=1.
    pub albedo: [f32; 3],
    /// Multiplied with the albedo, if there.
    pub texture: Option<Texture>,
    /// How polished it is.
    pub finish: Finish,
    /// Multiplied with the finish, if there: green with the roughness, blue with metallic, as numbers and not as colours.
    pub finish_texture: Option<Texture>,
}

impl Material {
    /// One colour, and nothing else.
    ///
    /// ```
    /// let red = sh_scene::Material::diffuse([0.8, 0.1, 0.1]);
    /// assert!(red.texture.is_none());
    /// ```
    pub const fn diffuse(albedo: [f32; 3]) -> Self {
        Self {
            albedo,
            texture: None,
            finish: Finish::DIFFUSE,
            finish_texture: None,
        }
    }

    /// The finish at texture coordinates.
    ///
    /// ```
    /// use sh_scene::{Finish, Material};
    /// assert_eq!(Material::default().finish_at(None), Finish::DIFFUSE);
    /// ```
    pub fn finish_at(&self, uv: Option<[f32; 2]>) -> Finish {
        let Finish {
            roughness,
            metallic,
        } = self.finish;
        match (&self.finish_texture, uv) {
            (Some(texture), Some(uv)) => {
                let [_, green, blue] = texture.numbers(uv).to_array();
                Finish {
                    roughness: roughness * green,
                    metallic: metallic * blue,
                }
            }
            _ => self.finish,
        }
    }

    /// Whether any place of it may mirror light.
    ///
    /// ```
    /// assert!(!sh_scene::Material::default().is_glossy());
    /// ```
    pub fn is_glossy(&self) -> bool {
        self.finish.is_glossy() || self.finish_texture.is_some()
    }
}

impl Default for Material {
    /// White.
    fn default() -> Self {
        Self::diffuse([1.0; 3])
    }
}

/// One body: a mesh, how it reflects, where it stands, and the spheres that block light in its place.
///
/// ```
/// use sh_scene::{Material, Object};
/// let body = Object { material: Material::diffuse([0.5; 3]), ..Object::default() };
/// assert!(body.bounds().is_none());
/// ```
#[derive(Clone, Debug, Default)]
pub struct Object {
    /// What messages call it.
    pub name: String,
    /// The surface, in object space.
    pub mesh: Mesh,
    /// How it reflects.
    pub material: Material,
    /// World from object; a rotation, a uniform scale and a translation.
    pub transform: Affine3A,
    /// A bounding set of spheres, in object space.
    pub spheres: Vec<Sphere>,
    /// What each sphere's log visibility is multiplied with, so that together they hide what the mesh does
    /// ([`Forest::weighted`]); fewer than spheres: the rest is 1.
    pub weights: Vec<f32>,
    /// Of an object that is a part of another one's body, which has the spheres of all: the index of that one. Blockers of
    /// a receiver's own body count otherwise than those of others ([`sh_core::seen`]).
    pub part_of: Option<usize>,
    /// What makes the spheres lights: points of the surface, as many groups as spheres, or empty where they are none.
    pub surface: SurfaceSamples,
    /// What tells its light in few functions, of a rigid body whose patches send it on: of all parts of a body, at the first.
    pub basis: Option<Arc<IrradianceBasis>>,
}

impl Object {
    /// The weight of a sphere.
    pub fn weight(&self, sphere: usize) -> f32 {
        self.weights.get(sphere).copied().unwrap_or(1.0)
    }

    /// Whether any of its surface mirrors light.
    pub fn mirrors(&self) -> bool {
        self.material.is_glossy() && !self.mesh.triangles.is_empty()
    }

    /// Its blocker spheres in world space.
    pub fn world_spheres(&self) -> impl Iterator<Item = Sphere> {
        let scale = self.transform.matrix3.x_axis.length();
        self.spheres.iter().map(move |s| Sphere {
            center: self.transform.transform_point3(s.center.into()).into(),
            radius: s.radius * scale,
        })
    }

    /// The lowest and the highest corner of the mesh's bounding box in world space, or none for an empty
    /// mesh.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        let world = |p: &[f32; 3]| self.transform.transform_point3(Vec3::from(*p));
        let used = self
            .mesh
            .triangles
            .iter()
            .flatten()
            .map(|&i| world(&self.mesh.positions[i as usize]));
        used.fold(None, |bounds, p| {
            let [low, high] = bounds.unwrap_or([p, p]);
            Some([low.min(p), high.max(p)])
        })
    }
}

/// An infinite horizontal plane that receives light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Height above the origin, in metres.
    pub height: f32,
    /// Linear Rec.709 reflectance.
    pub albedo: [f32; 3],
}

/// What the user may set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// SH order of the light and of its shadows, 2 to 6. The cost of shading a receiver grows with its fourth
    /// power.
    pub order: usize,
    /// SH order in which the logarithms of blockers' visibility are summed and exponentiated, from `order` to
    /// 6. A higher one makes the shadows truer; the cost of a blocker grows with its square.
    pub accumulation: usize,
    /// Whether blockers cast shadows.
    pub shadows: bool,
    /// Window width h of the environment's SH vector; none: it is taken as it is. A window dims open ground, and no picture
    /// that was measured came nearer to the truth by one.
    pub window: Option<f32>,
    /// Whether shadows are computed at half the picture's resolution, and at the full one only where that does not do.
    pub half_resolution: bool,
    /// How coarse the cuts of blockers may be.
    pub limits: Limits,
    /// How bodies light each other, if they do.
    pub indirect: Option<Indirect>,
    /// Whether polished surfaces mirror light.
    pub gloss: bool,
}

/// Everything a picture needs.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The bodies.
    pub objects: Vec<Object>,
    /// The light from all around, already rotated and scaled by its intensity.
    pub environment: EnvironmentMap,
    /// Analytic lights besides it.
    pub lights: Vec<AreaLight>,
    /// Lights with sharp shadows: spots, points and suns.
    pub punctual: Vec<PunctualLight>,
    /// The plane everything stands on, if any.
    pub ground: Option<Ground>,
    /// Where the picture is taken from.
    pub camera: Camera,
    /// The rest.
    pub settings: Settings,
}

impl Default for Settings {
    /// Balanced quality with shadows.
    fn default() -> Self {
        let quality = Quality::default();
        Self {
            order: quality.order(),
            accumulation: quality.accumulation(),
            shadows: true,
            window: None,
            half_resolution: quality.half_resolution(),
            limits: Limits::default(),
            indirect: None,
            gloss: true,
        }
    }
}

impl Settings {
    /// These settings with another order. A window that is set keeps its width relative to it; an order of accumulation
    /// that was the same stays the same, and one above it stays where it is unless the order passes it.
    ///
    /// ```
    /// let settings = sh_scene::Settings::default().with_order(6);
    /// assert_eq!((settings.order, settings.accumulation), (6, 6));
    /// ```
    pub fn with_order(self, order: usize) -> Self {
        let accumulation = if self.accumulation == self.order {
            order
        } else {
            self.accumulation.max(order)
        };
        Self {
            order,
            accumulation,
            window: self.window.map(|h| h * order as f32 / self.order as f32),
            ..self
        }
    }

    /// These settings with the orders and the resolution of a quality; a window that is set keeps its width relative
    /// to the order.
    pub fn with_quality(self, quality: Quality) -> Self {
        Self {
            accumulation: quality.accumulation(),
            half_resolution: quality.half_resolution(),
            ..self.with_order(quality.order())
        }
    }
}

impl Scene {
    /// The light that the passes use: the environment over the ground, of the order and with the window
    /// that the settings say, and all analytic lights.
    ///
    /// # Errors
    /// Where the settings' order or window is none that there is, or a light is none.
    pub fn light(&self) -> Result<Light, LightError> {
        self.environment_light()?
            .with_lights(&self.placed_lights()?)
    }

    /// The analytic lights where they are in the world.
    ///
    /// # Errors
    /// Where one is bound to what is not there.
    pub fn placed_lights(&self) -> Result<Vec<AreaLight>, LightError> {
        let placed = self.lights.iter().map(|light| light.placed(&self.objects));
        placed.collect()
    }

    /// The light of the environment alone.
    ///
    /// # Errors
    /// Where the settings' order or window is none that there is.
    pub fn environment_light(&self) -> Result<Light, LightError> {
        let Settings { order, window, .. } = self.settings;
        let window = window.unwrap_or(f32::INFINITY);
        Light::project(&self.environment, self.ground, order, window)
    }

    /// The tree of all blockers, as they stand now.
    pub fn forest(&self) -> Forest {
        let counts: Vec<usize> = self.objects.iter().map(|o| o.spheres.len()).collect();
        Forest::weighted(&self.world_spheres(), &self.weights(), &counts)
    }

    /// The body that an object is of, as receivers carry it ([`crate::Receiver::object`]).
    pub fn body(&self, object: usize) -> u32 {
        let part_of = self.objects.get(object).and_then(|o| o.part_of);
        part_of.unwrap_or(object) as u32 + 1
    }

    /// Whether a picture of it mirrors light in any surface.
    pub fn mirrors(&self) -> bool {
        self.settings.gloss && self.objects.iter().any(Object::mirrors)
    }

    /// The weights of all blocker spheres, object by object.
    pub fn weights(&self) -> Vec<f32> {
        let of = |o: &'_ Object| {
            (0..o.spheres.len())
                .map(|i| o.weight(i))
                .collect::<Vec<_>>()
        };
        self.objects.iter().flat_map(of).collect()
    }

    /// The lowest and the highest corner of the bounding box of all objects in world space, or none where
    /// there is no triangle.
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        self.objects
            .iter()
            .filter_map(Object::bounds)
            .reduce(|[a, b], [c, d]| [a.min(c), b.max(d)])
    }

    /// All blocker spheres in world space, object by object.
    pub fn world_spheres(&self) -> Vec<Sphere> {
        let objects = self.objects.iter();
        objects.flat_map(Object::world_spheres).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(order: usize, accumulation: usize) -> Settings {
        Settings {
            order,
            accumulation,
            window: Some(3.0 * order as f32),
            ..Settings::default()
        }
    }

    #[test]
    fn accumulation_is_never_below_the_order() {
        for order in 2..=6 {
            for accumulation in order..=6 {
                for other in 2..=6 {
                    let changed = settings(order, accumulation).with_order(other);
                    assert_eq!(
                        (changed.order, changed.window),
                        (other, Some(3.0 * other as f32))
                    );
                    let expected = if accumulation == order {
                        other
                    } else {
                        accumulation.max(other)
                    };
                    assert_eq!(
                        changed.accumulation, expected,
                        "{order}, {accumulation} to {other}"
                    );
                }
            }
        }
    }

    #[test]
    fn a_quality_sets_both_orders_whatever_they_were() {
        for quality in Quality::ALL {
            let (order, accumulation) = (quality.order(), quality.accumulation());
            assert!(2 <= order && order <= accumulation && accumulation <= 6);
            for before in [settings(2, 6), settings(6, 6), Settings::default()] {
                let after = before.with_quality(quality);
                assert_eq!((after.order, after.accumulation), (order, accumulation));
                let relative = before.window.map(|h| h / before.order as f32);
                assert_eq!(after.window, relative.map(|h| h * order as f32));
                assert_eq!(after.half_resolution, quality.half_resolution());
            }
        }
        let default = Settings::default();
        assert_eq!(default.with_quality(Quality::default()), default);
    }

    #[test]
    fn a_better_quality_works_more() {
        let work = Quality::ALL.map(|quality| (quality.accumulation(), quality.order()));
        assert!(work.is_sorted_by(|a, b| a < b), "{work:?}");
        let names = Quality::ALL.map(Quality::name);
        assert_eq!(names, ["fast", "balanced", "accurate"]);
    }
}
