//! Light of a whole scene, path by path: shadows and any number of diffuse bounces.
//!
//! A path starts at a receiver and leaves every surface in a direction in proportion to the cosine; what it meets
//! multiplies it by its albedo (Kajiya, "The Rendering Equation", 1986). At each of its points every light is asked
//! along one more ray: a lamp evenly over the solid angle it covers, the map in proportion to its luminance. What the
//! path itself finds of the map and what is asked there are weighed by the balance heuristic (Veach & Guibas,
//! "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995, eq. 13), so that suns and even skies both
//! converge. The mean is the truth, whatever the number of paths; only its standard error depends on it, and is told.
//!
//! # What counts as what
//! *Direct* is light that no body has reflected, *indirect* what at least one has; a bounce is a reflection by a body.
//! The ground is, as `sh_scene::Light::project` has it, part of the light: from below comes its albedo times the
//! irradiance of the open upper half. It receives light and shadows and hides what is below it, but what falls on it
//! from bodies is lost. With [`Options::ground_reflects`] it reflects what really arrives there instead: the sky behind
//! shadows, lamps, and what bodies send. That is no bounce of its own, since the light has it already.
//!
//! A receiver reflects with albedo 1, so that an even sky of radiance 1 gives 1 in the open; its own albedo is the
//! caller's to multiply. Surfaces are shaded with the normals of their vertices, as pictures are. Balls that glow hide
//! nothing and cast no shadow; spots, points and suns are balls and discs that the camera does not see.
//!
//! ```
//! use sh_reference::paths::{Options, PathTracer};
//! # use sh_scene::{Camera, EnvironmentMap, Scene, Settings};
//! # let camera = Camera { eye: glam::Vec3::Z, target: glam::Vec3::ZERO, fov: 1.0 };
//! # let (objects, lights, ground, settings) = (vec![], vec![], None, Settings::default());
//! let environment = EnvironmentMap::constant([2.0; 3]);
//! let scene = Scene { punctual: vec![], objects, environment, lights, ground, camera, settings };
//! let tracer = PathTracer::new(&scene, Options::default())?;
//! let seen = tracer.radiance([0.0; 3], [0.0, 1.0, 0.0], 64, 1);
//! assert!((seen.direct[0] - 2.0).abs() < 0.05 && seen.indirect == [0.0; 3]);
//! # Ok::<(), sh_scene::LightError>(())
//! ```

mod lamps;
mod mean;
mod points;
mod punctual;
mod sky;
mod surfaces;
mod texture;

use crate::gloss::Gloss;
use crate::vec3::{Vec3, add, scale};
use lamps::{Lamp, cosine, cosine_density};
use mean::Mean;
pub use mean::Radiance;
use points::{Points, mix};
use punctual::Punctual;
use sh_scene::{LightError, LightViews, Scene};
use sky::{MapSky, Sky};
use surfaces::{Met, Surfaces};

/// What is traced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// How often bodies reflect on the way from a light to the receiver, at most; 0 leaves direct light alone.
    pub bounces: u32,
    /// Whether the ground reflects what arrives there, or only shows itself in the open.
    pub ground_reflects: bool,
    /// What the light is.
    pub light: Source,
}

/// The light that is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Source {
    /// The environment map, texel by texel, and lamps of their shapes.
    #[default]
    Map,
    /// The SH vectors that the passes have in their place ([`Scene::light`]): what is left of a difference to the
    /// passes is the error of the passes, without that of the light's order. Where vectors ring, radiance along a
    /// path may be negative; what a receiver reflects is not. The ground does not hide them, since it is in them.
    Projected,
}

/// A scene, ready for paths. It is the same to the last bit for every thread that asks.
pub struct PathTracer<'a> {
    options: Options,
    surfaces: Surfaces,
    sky: Sky<'a>,
    lamps: Vec<Lamp>,
    punctual: Vec<Punctual>,
}

/// A point where a path is, and how the surface reflects there.
struct Place {
    start: Vec3,
    normal: Vec3,
    /// Its lobe, where it mirrors light and does not reflect it diffusely.
    gloss: Option<Gloss>,
}

impl Place {
    /// A direction for a path to leave in, and what light from there counts; none where it counts nothing.
    fn leave(&self, pair: [f64; 2]) -> Option<(Vec3, f64)> {
        match &self.gloss {
            None => Some((cosine(self.normal, pair), 1.0)),
            Some(gloss) => gloss.sample(pair),
        }
    }

    /// How much light from a direction counts, per steradian, and how often paths leave that way.
    fn counts(&self, direction: Vec3) -> [f64; 2] {
        match &self.gloss {
            None => [cosine_density(self.normal, direction); 2],
            Some(gloss) => [gloss.value(direction), gloss.density(direction)],
        }
    }
}

impl<'a> PathTracer<'a> {
    /// Sorts the triangles and the texels.
    ///
    /// # Errors
    /// Where the scene has no [`Scene::light`].
    ///
    /// # Panics
    /// If an index of a mesh is out of range, or a map or texture has not the pixels that it says.
    pub fn new(scene: &'a Scene, options: Options) -> Result<Self, LightError> {
        let light = scene.light()?;
        let placed = scene.placed_lights()?;
        let shining = placed.iter().filter(|lamp| lamp.shines());
        let lamps = shining.zip(&light.emitters);
        Ok(Self {
            options,
            surfaces: Surfaces::new(scene),
            sky: match options.light {
                Source::Map => Sky::Map(MapSky::new(&scene.environment, scene.ground)),
                Source::Projected => Sky::projected(&light),
            },
            lamps: lamps
                .map(|(lamp, emitter)| {
                    let whole = lamp.distribution.as_ref();
                    let whole = whole.filter(|_| options.light == Source::Map);
                    Lamp::new(emitter, light.order, whole)
                })
                .collect(),
            punctual: LightViews::of(scene)?
                .lights
                .iter()
                .map(Punctual::new)
                .collect(),
        })
    }

    /// What a receiver with a unit `normal` reflects at albedo 1: the mean of so many paths, best a power of two and
    /// at least 8. Different seeds make independent errors; a receiver's number is a good seed.
    ///
    /// # Panics
    /// If there are no paths.
    pub fn radiance(&self, point: [f64; 3], normal: [f64; 3], paths: u32, seed: u32) -> Radiance {
        self.mean([point, normal], None, paths, seed)
    }

    /// The mean of what a receiver sees in the lobe in which it mirrors light towards a viewer in a unit direction, by its
    /// roughness: as [`radiance`](Self::radiance), with [`Gloss`] in the place of the cosine. What it meets reflects diffusely.
    ///
    /// ```
    /// # use sh_reference::paths::{Options, PathTracer};
    /// # use sh_scene::{Camera, EnvironmentMap, Scene, Settings};
    /// # let camera = Camera { eye: glam::Vec3::Z, target: glam::Vec3::ZERO, fov: 1.0 };
    /// # let (objects, lights, ground, settings) = (vec![], vec![], None, Settings::default());
    /// let environment = EnvironmentMap::constant([2.0; 3]);
    /// let scene = Scene { punctual: vec![], objects, environment, lights, ground, camera, settings };
    /// let tracer = PathTracer::new(&scene, Options::default())?;
    /// let seen = tracer.mirrored([[0.0; 3], [0.0, 1.0, 0.0]], ([0.6, 0.8, 0.0], 0.3), 64, 1);
    /// assert!((seen.direct[0] - 2.0).abs() < 0.05);
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    ///
    /// # Panics
    /// If there are no paths.
    pub fn mirrored(
        &self,
        [point, normal]: [[f64; 3]; 2],
        (view, roughness): ([f64; 3], f64),
        paths: u32,
        seed: u32,
    ) -> Radiance {
        let gloss = Gloss::new(roughness, normal, view);
        self.mean([point, normal], Some(gloss), paths, seed)
    }

    fn mean(
        &self,
        [point, normal]: [Vec3; 2],
        gloss: Option<Gloss>,
        paths: u32,
        seed: u32,
    ) -> Radiance {
        let seed = mix(seed);
        let mut mean = Mean::new(paths);
        for index in 0..paths {
            let place = Place {
                start: self.surfaces.start(point, normal),
                normal,
                gloss,
            };
            mean.add(self.path(place, Points::new(index, seed)));
        }
        mean.radiance(self.options.light == Source::Projected)
    }

    /// Direct and indirect light of one path.
    fn path(&self, mut place: Place, mut points: Points) -> [[f64; 3]; 2] {
        let mut found = [[0.0; 3]; 2];
        let mut share = [1.0; 3];
        let mut bounces = 0;
        loop {
            let sum = &mut found[usize::from(bounces > 0)];
            let asked = self.ask(&place, &mut points);
            for c in 0..3 {
                sum[c] += share[c] * asked[c];
            }
            let Some((direction, counts)) = place.leave(points.pair()) else {
                return found;
            };
            share = share.map(|share| share * counts);
            let met = self.surfaces.meet(place.start, direction);
            let seen = self.look(&place, direction, &met);
            for c in 0..3 {
                sum[c] += share[c] * seen[c];
            }
            let meeting = match met {
                Met::Ground(ground) if self.options.ground_reflects => ground,
                Met::Body(body) if bounces < self.options.bounces => {
                    bounces += 1;
                    body
                }
                _ => return found,
            };
            share = [0, 1, 2].map(|c| share[c] * meeting.albedo[c]);
            if share == [0.0; 3] {
                return found;
            }
            place = Place {
                start: meeting.start,
                normal: meeting.normal,
                gloss: None,
            };
        }
    }

    /// What the lights that can be asked send to a place, reflected by albedo 1.
    fn ask(&self, place: &Place, points: &mut Points) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let mut add = |radiance: [f64; 3], factor: f64| {
            for (sum, radiance) in sum.iter_mut().zip(radiance) {
                *sum += factor * radiance;
            }
        };
        for light in &self.punctual {
            let sample = light.sample(place.start, points.pair());
            let [counts, _] = place.counts(sample.direction);
            if counts > 0.0
                && !self
                    .surfaces
                    .blocked(place.start, sample.direction, sample.distance)
            {
                add(sample.radiance, counts / sample.density);
            }
        }
        if let Sky::Map(_) = &self.sky {
            let pair = points.pair();
            if let Some(sample) = self.sky.sample(pair).filter(|s| s.density > 0.0) {
                let [counts, density] = place.counts(sample.direction);
                if counts > 0.0
                    && !self
                        .surfaces
                        .blocked(place.start, sample.direction, f64::INFINITY)
                {
                    add(sample.radiance, counts / (density + sample.density));
                }
            }
            for lamp in &self.lamps {
                let sample = lamp.sample(place.start, points.pair());
                let [counts, _] = place.counts(sample.direction);
                if counts > 0.0
                    && !self
                        .surfaces
                        .blocked(place.start, sample.direction, sample.distance)
                {
                    add(sample.radiance, counts / sample.density);
                }
            }
        }
        sum
    }

    /// What a path itself sees of the lights where it leaves a place, by the weights of [`ask`](Self::ask).
    fn look(&self, place: &Place, direction: Vec3, met: &Met) -> [f64; 3] {
        let open = match met {
            // No sky is seen under the ground.
            Met::Nothing => !self.surfaces.buried(place.start),
            Met::Ground(_) => !self.options.ground_reflects,
            Met::Body(_) | Met::Dark => false,
        };
        match &self.sky {
            Sky::Map(_) if open => self.weighed(place, direction),
            Sky::Map(_) => [0.0; 3],
            Sky::Projected(_) => self.smooth(place, direction, met, open),
        }
    }

    /// The map's radiance, by the share that the cosine has in finding it.
    fn weighed(&self, place: &Place, direction: Vec3) -> [f64; 3] {
        let [_, density] = place.counts(direction);
        let other = self.sky.density(direction);
        if density + other <= 0.0 {
            return [0.0; 3];
        }
        scale(self.sky.radiance(direction), density / (density + other))
    }

    /// The SH vectors of the sky and of all lamps that nothing hides.
    fn smooth(&self, place: &Place, direction: Vec3, met: &Met, open: bool) -> [f64; 3] {
        let limit = match met {
            _ if open => f64::INFINITY,
            Met::Body(meeting) | Met::Ground(meeting) => meeting.distance,
            Met::Nothing | Met::Dark => 0.0,
        };
        let mut sum = [0.0; 3];
        if open {
            sum = self.sky.radiance(direction);
        }
        for lamp in &self.lamps {
            let lobe = lamp.lobe(place.start, place.normal);
            if limit >= lobe.distance {
                sum = add(sum, scale(lobe.radiance, lobe.value(direction)));
            }
        }
        sum
    }
}
