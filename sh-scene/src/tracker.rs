//! What a scene's frames keep from one to the next, so that what has not changed is no work.
//!
//! | what did not change | what is not done |
//! |---|---|
//! | an object's transform and spheres | its spheres are not placed, its branch of the tree is not renewed |
//! | the environment, the ground, order and window | the environment is not projected |
//! | a lamp | its emitter is not made, its window not looked for |
//!
//! Objects and lamps are compared with what they were. An environment map is known again by a 64-bit fingerprint of all
//! its texels: two that differ are taken for the same with a chance of 2⁻⁶⁴. Taking it reads the map once, at the
//! speed of memory.

use crate::{
    AreaLight, Emitter, EnvironmentMap, Forest, Ground, IrradianceBasis, Light, LightError, Object,
    Scene, Sphere,
};
use glam::Affine3A;
use std::ops::Range;
use std::sync::Arc;

/// The tree of blockers and the light of a scene, and what has changed of them from frame to frame.
///
/// ```
/// # use sh_scene::*;
/// # fn frames(scene: &mut Scene, motion: &mut motion::Motion) -> Result<(), LightError> {
/// let mut tracker = Tracker::default();
/// for frame in 0..60 {
///     motion.pose(f64::from(frame) / 30.0, scene);
///     tracker.update(scene)?;
///     let (forest, light) = (tracker.forest(), tracker.light());
///     println!("{} nodes, {} projections", tracker.changes().nodes, tracker.changes().projections);
/// #   let _ = (forest, light);
/// }
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, Default)]
pub struct Tracker {
    objects: Vec<Known>,
    /// Of all objects, in world space.
    spheres: Vec<Sphere>,
    forest: Forest,
    sky: Option<Sky>,
    /// Where they are in the world, with the emitter that was made of each, for the order of `sky`.
    lamps: Vec<(AreaLight, Emitter)>,
    light: Option<Light>,
    /// Fingerprints of the objects' surface points.
    surfaces: Vec<u64>,
    /// The objects' bases.
    bases: Vec<Option<Arc<IrradianceBasis>>>,
    changes: Changes,
    /// Room for the indices of objects that moved.
    moved: Vec<usize>,
}

/// What a frame had to do that the one before it had not done.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Changes {
    /// Whether the tree was built anew: at first, and where objects or their numbers of spheres have changed.
    pub rebuilt: bool,
    /// Objects whose spheres were placed.
    pub objects: usize,
    /// Spheres that were placed.
    pub spheres: usize,
    /// Nodes of the tree that were renewed.
    pub nodes: usize,
    /// Which they are.
    pub ranges: Vec<Range<u32>>,
    /// How many times the environment was projected: 0 or 1.
    pub projections: usize,
    /// Lamps whose emitters were made.
    pub lamps: usize,
    /// Whether the light is not what it was.
    pub light: bool,
}

impl Changes {
    /// Whether everything is as it was.
    pub fn none(&self) -> bool {
        !self.rebuilt && self.nodes == 0 && !self.light
    }
}

/// An object as it was.
#[derive(Clone, Debug)]
struct Known {
    transform: Affine3A,
    spheres: Vec<Sphere>,
    weights: Vec<f32>,
}

impl Known {
    fn is(&self, object: &Object) -> bool {
        self.transform == object.transform && self.spheres == object.spheres
    }
}

/// What the environment's light is made from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Sky {
    fingerprint: u64,
    size: [u32; 2],
    ground: Option<Ground>,
    order: usize,
    window: Option<f32>,
}

impl Tracker {
    /// Takes over the scene's state. The light has the bits of [`Scene::light`], the tree those of one that was built from
    /// the scene of the first update and [moved](Forest::update) as a whole: its topology stays.
    ///
    /// # Errors
    /// As [`Scene::light`]; the light stays what it was then.
    pub fn update(&mut self, scene: &Scene) -> Result<&Changes, LightError> {
        self.place(scene);
        self.relight(scene)?;
        Ok(&self.changes)
    }

    /// The part of [`update`](Self::update) that is about blockers: for a plan with shadows.
    pub fn place(&mut self, scene: &Scene) {
        let changes = &mut self.changes;
        changes.ranges.clear();
        (changes.rebuilt, changes.objects, changes.spheres) = (false, 0, 0);
        self.move_spheres(scene);
    }

    /// The part of [`update`](Self::update) that is about light.
    ///
    /// # Errors
    /// As [`update`](Self::update).
    pub fn relight(&mut self, scene: &Scene) -> Result<&Light, LightError> {
        let changes = &mut self.changes;
        (changes.projections, changes.lamps, changes.light) = (0, 0, false);
        self.change_light(scene)
    }

    /// Whether the surface points of any object, or how their spheres are turned, are not what they were: for a plan in
    /// which bodies light each other. They are known again by a fingerprint, as environments are.
    pub fn resurface(&mut self, scene: &Scene) -> bool {
        let mut changed = scene.objects.len() != self.surfaces.len();
        self.surfaces.resize(scene.objects.len(), 0);
        for (known, object) in self.surfaces.iter_mut().zip(&scene.objects) {
            let points: &[u32] = bytemuck::cast_slice(&object.surface.points);
            let turns: &[u32] = bytemuck::cast_slice(&object.surface.rotations);
            let own = fingerprint(points) ^ fingerprint(turns).rotate_left(1);
            changed |= *known != own;
            *known = own;
        }
        // Bases are shared and never change, so that it is enough to know which they are.
        let bases = scene.objects.iter().map(|object| object.basis.as_ref());
        let known = self.bases.iter().map(Option::as_ref);
        let alike =
            |(a, b): (Option<&Arc<_>>, Option<&Arc<_>>)| a.map(Arc::as_ptr) == b.map(Arc::as_ptr);
        changed |= !known.zip(bases.clone()).all(alike);
        self.bases = bases.map(Option::<&Arc<_>>::cloned).collect();
        changed
    }

    /// The tree of all blockers, as they stand now.
    pub fn forest(&self) -> &Forest {
        &self.forest
    }

    /// All blocker spheres in world space, object by object.
    pub fn spheres(&self) -> &[Sphere] {
        &self.spheres
    }

    /// The light, or none before the first [`update`](Self::update).
    pub fn light(&self) -> Option<&Light> {
        self.light.as_ref()
    }

    /// What the last [`update`](Self::update) had to do.
    pub fn changes(&self) -> &Changes {
        &self.changes
    }

    fn move_spheres(&mut self, scene: &Scene) {
        let Self {
            objects,
            spheres,
            forest,
            changes,
            moved,
            ..
        } = self;
        let known = |object: &Object| Known {
            transform: object.transform,
            spheres: object.spheres.clone(),
            weights: object.weights.clone(),
        };
        let same = |(known, object): (&Known, &Object)| {
            known.spheres.len() == object.spheres.len() && known.weights == object.weights
        };
        if objects.len() != scene.objects.len() || !objects.iter().zip(&scene.objects).all(same) {
            *objects = scene.objects.iter().map(known).collect();
            *spheres = scene.world_spheres();
            *forest = scene.forest();
            changes.rebuilt = true;
            (changes.objects, changes.spheres) = (objects.len(), spheres.len());
            changes.nodes = forest.nodes().len();
            changes.ranges.push(0..changes.nodes as u32);
            return;
        }
        moved.clear();
        let mut first = 0;
        for (index, (known, object)) in objects.iter_mut().zip(&scene.objects).enumerate() {
            let own = first..first + object.spheres.len();
            first = own.end;
            if known.is(object) {
                continue;
            }
            known.transform = object.transform;
            known.spheres.copy_from_slice(&object.spheres);
            for (to, from) in spheres[own].iter_mut().zip(object.world_spheres()) {
                *to = from;
            }
            changes.spheres += object.spheres.len();
            moved.push(index);
        }
        changes.objects = moved.len();
        changes.nodes = forest.update_objects(spheres, moved, &mut changes.ranges);
    }

    fn change_light(&mut self, scene: &Scene) -> Result<&Light, LightError> {
        let settings = scene.settings;
        let EnvironmentMap { width, height, .. } = scene.environment;
        let sky = Sky {
            fingerprint: fingerprint(bytemuck::cast_slice(&scene.environment.pixels)),
            size: [width, height],
            ground: scene.ground,
            order: settings.order,
            window: settings.window,
        };
        let before = self.light.as_ref().map(|light| light.order);
        let light = match self.light.take().filter(|_| self.sky == Some(sky)) {
            Some(light) => self.light.insert(light),
            None => {
                let light = scene.environment_light()?;
                if before != Some(light.order) {
                    self.lamps.clear();
                }
                self.sky = Some(sky);
                (self.changes.projections, self.changes.light) = (1, true);
                self.light.insert(light)
            }
        };
        self.changes.light |= self.lamps.len() != scene.lights.len();
        self.lamps.truncate(scene.lights.len());
        for (i, lamp) in scene.lights.iter().enumerate() {
            let placed = lamp.placed(&scene.objects);
            let is_known = |(known, _): &(AreaLight, Emitter)| placed.as_ref() == Ok(known);
            if self.lamps.get(i).is_some_and(is_known) {
                continue;
            }
            let made = placed.and_then(|lamp| Ok((lamp, lamp.emitter(light.order)?)));
            let made = match made {
                Ok(made) => made,
                Err(error) => {
                    // The next time it is looked at anew.
                    self.lamps.truncate(i);
                    return Err(error);
                }
            };
            match self.lamps.get_mut(i) {
                Some(known) => *known = made,
                None => self.lamps.push(made),
            }
            self.changes.lamps += 1;
            self.changes.light = true;
        }
        if self.changes.light {
            light.emitters.clear();
            let shining = self.lamps.iter().filter(|(lamp, _)| lamp.shines());
            light.emitters.extend(shining.map(|(_, emitter)| emitter));
        }
        Ok(light)
    }
}

/// 64 bits that are others for other numbers: four sums of products side by side, mixed at the end.
pub fn fingerprint(numbers: &[u32]) -> u64 {
    /// Odd, with no pattern in its bits: from the digits of the golden ratio.
    const STEP: u64 = 0x9e37_79b9_7f4a_7c15;
    let mut sums = [1, 2, 3, 4].map(|i: u64| i.wrapping_mul(STEP));
    let (blocks, rest) = numbers.as_chunks::<8>();
    let mut take = |block: &[u32; 8]| {
        for (i, sum) in sums.iter_mut().enumerate() {
            let pair = u64::from(block[2 * i]) | u64::from(block[2 * i + 1]) << 32;
            *sum = (*sum ^ pair).wrapping_mul(STEP).rotate_left(29);
        }
    };
    blocks.iter().for_each(&mut take);
    let mut last = [0; 8];
    last[..rest.len()].copy_from_slice(rest);
    take(&last);
    sums.iter().fold(numbers.len() as u64, |all, sum| {
        let mixed = (all ^ sum).wrapping_mul(STEP);
        mixed ^ mixed >> 32
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Camera, Distribution, Material, Mesh, Settings};
    use glam::Vec3;

    fn scene() -> Scene {
        let object = |x: f32, spheres: usize| Object {
            name: "row".into(),
            mesh: Mesh::default(),
            material: Material::diffuse([0.5; 3]),
            transform: Affine3A::from_translation(Vec3::X * x),
            spheres: (0..spheres)
                .map(|i| Sphere {
                    center: [0.0, i as f32, 0.0],
                    radius: 0.4,
                })
                .collect(),
            ..Object::default()
        };
        let lamp = |radiance| AreaLight::local(Vec3::Y, 0.1, radiance);
        Scene {
            punctual: Vec::new(),
            objects: vec![object(0.0, 40), object(3.0, 20), object(6.0, 0)],
            environment: crate::Sky::default().map(32, 16),
            lights: vec![lamp([1.0; 3]), lamp([0.0; 3]), lamp([0.0, 2.0, 0.0])],
            ground: None,
            camera: Camera {
                eye: Vec3::Z,
                target: Vec3::ZERO,
                fov: 1.0,
            },
            settings: Settings::default(),
        }
    }

    /// What a tracker has after a frame is what the scene gives by itself.
    fn check(tracker: &mut Tracker, scene: &Scene) -> Changes {
        let changes = tracker.update(scene).unwrap().clone();
        let mut whole = tracker.forest().clone();
        whole.update(&scene.world_spheres());
        assert!(*tracker.forest() == whole);
        assert_eq!(tracker.spheres(), scene.world_spheres());
        assert_eq!(tracker.light(), Some(&scene.light().unwrap()));
        changes
    }

    #[test]
    fn what_does_not_change_is_no_work() {
        let mut scene = scene();
        let mut tracker = Tracker::default();
        let first = check(&mut tracker, &scene);
        assert!(first.rebuilt && first.light);
        assert_eq!((first.spheres, first.projections, first.lamps), (60, 1, 3));
        assert!(check(&mut tracker, &scene).none());

        // One of two objects: its branch, and what is above.
        scene.objects[1].transform.translation.y += 1.0;
        let moved = check(&mut tracker, &scene);
        assert_eq!(
            (moved.objects, moved.spheres, moved.projections),
            (1, 20, 0)
        );
        let all = tracker.forest().nodes().len();
        assert!(
            moved.nodes < all / 2 && !moved.light,
            "{} of {all}",
            moved.nodes
        );

        // Spheres that bend move without their transform.
        scene.objects[0].spheres[7].center[2] += 0.1;
        assert_eq!(check(&mut tracker, &scene).spheres, 40);

        scene.lights[0].radiance = [3.0; 3];
        let lit = check(&mut tracker, &scene);
        assert_eq!((lit.lamps, lit.projections, lit.nodes), (1, 0, 0));

        scene.environment.pixels[100][2] += 1e-3;
        let sky = check(&mut tracker, &scene);
        assert_eq!((sky.projections, sky.lamps, sky.nodes), (1, 0, 0));

        // Another order is other light altogether.
        scene.settings = scene.settings.with_order(3);
        let order = check(&mut tracker, &scene);
        assert_eq!((order.projections, order.lamps), (1, 3));

        scene.lights.pop();
        assert!(check(&mut tracker, &scene).light);

        // A lamp that is bound to an object goes with it, and stays where it is while the object does.
        scene.lights[0].object = Some(1);
        scene.lights[0].distribution = Distribution::cap(Vec3::X, 1.0).ok();
        assert_eq!(check(&mut tracker, &scene).lamps, 1);
        assert!(check(&mut tracker, &scene).none());
        scene.objects[1].transform *= Affine3A::from_rotation_y(1.0);
        let carried = check(&mut tracker, &scene);
        assert_eq!((carried.lamps, carried.objects), (1, 1));
        scene.objects[0].transform.translation.y += 1.0;
        assert!(!check(&mut tracker, &scene).light);
        scene.lights[0].object = Some(3);
        assert!(tracker.update(&scene).is_err());
        scene.lights[0].object = None;

        scene.objects.pop();
        assert!(check(&mut tracker, &scene).rebuilt);
        assert!(check(&mut tracker, &scene).none());
    }

    #[test]
    fn light_that_cannot_be_is_refused_and_looked_at_again() {
        let mut scene = scene();
        let mut tracker = Tracker::default();
        check(&mut tracker, &scene);
        let good = scene.lights[0];
        scene.lights[0].radiance[1] = f32::NAN;
        for _ in 0..2 {
            assert!(tracker.update(&scene).is_err());
        }
        scene.lights[0] = good;
        check(&mut tracker, &scene);
    }

    #[test]
    fn fingerprints_tell_every_texel() {
        let mut map = crate::Sky::default().map(9, 7);
        let fingerprint = |map: &EnvironmentMap| fingerprint(bytemuck::cast_slice(&map.pixels));
        let known = fingerprint(&map);
        for i in 0..map.pixels.len() * 3 {
            let before = map.pixels.as_flattened()[i];
            map.pixels.as_flattened_mut()[i] = f32::from_bits(before.to_bits() ^ 1);
            assert_ne!(fingerprint(&map), known, "{i}");
            map.pixels.as_flattened_mut()[i] = before;
        }
        assert_eq!(fingerprint(&map), known);
        map.pixels.swap(3, 40);
        assert_ne!(fingerprint(&map), known);
    }
}
