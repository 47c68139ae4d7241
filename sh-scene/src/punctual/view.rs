//! What is seen from a light: the pictures that tell what is before it.
//!
//! A view is a square of texels. Each keeps how near to the light the first surface along its ray is, as a number that falls with
//! distance: of a view in perspective one over the depth along its axis, of a sun's the height above its farthest plane; far below 0
//! where there is nothing. By that number what a light of some size leaves of a place grows evenly: of a blocker at k before a receiver at k', the shadow of a ball
//! of radius R is blurred by R (k − k') in the picture, whatever the distance.

use super::light::{PunctualLight, PunctualShape, WIDEST};
use super::record::PunctualRecord;
use crate::{LightError, Scene};
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// What a view shows beyond its light's cone, and each of several beyond the 90° that are its own: receivers at the edge look at their
/// surroundings.
const MARGIN: f32 = 1.2;

/// Texels of all views together, at most, unless views would be smaller than [`LightViews::LEAST_SIDE`].
const TEXELS: usize = 1 << 22;

/// A picture from a light: 64 bytes, as `struct LightView { origin: vec3f, distant: f32, right: vec3f, far: f32, up: vec3f, near: f32, forward:
/// vec3f, inverse: f32 }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct LightView {
    /// Where it is taken from, in metres; of a sun the middle of the nearest plane.
    pub origin: [f32; 3],
    /// 1 for a sun, else 0.
    pub distant: f32,
    /// From the middle to the right edge, 1 m before the origin; of a sun in metres.
    pub right: [f32; 3],
    /// Of a sun how far its farthest plane is from its nearest, in metres.
    pub far: f32,
    /// From the middle to the upper edge, as long as `right`.
    pub up: [f32; 3],
    /// What is nearer than this, in metres along `forward`, is not in the picture.
    pub near: f32,
    /// The unit vector along its axis.
    pub forward: [f32; 3],
    /// One over the length of `right`.
    pub inverse: f32,
}

impl LightView {
    /// A view from a place along a unit vector; `half` is the tangent of half its angle.
    fn perspective(origin: Vec3, axes: [Vec3; 3], half: f32, near: f32) -> Self {
        let [right, up, forward] = axes;
        Self {
            origin: origin.into(),
            distant: 0.0,
            right: (right * half).into(),
            far: 0.0,
            up: (up * half).into(),
            near,
            forward: forward.into(),
            inverse: 1.0 / half,
        }
    }

    /// A place's picture: from −1 to 1 across and up where it is in the view, and how near it is; none of what is nearer than all
    /// that is shown.
    ///
    /// ```
    /// use glam::Vec3;
    /// # use sh_scene::{Camera, EnvironmentMap, LightViews, PunctualLight, PunctualShape, Scene, Settings};
    /// # let camera = Camera { eye: Vec3::Z, target: Vec3::ZERO, fov: 1.0 };
    /// let shape = PunctualShape::Point { position: Vec3::ZERO, radius: 0.0 };
    /// let punctual = vec![PunctualLight::new(shape, [1.0; 3])];
    /// # let environment = EnvironmentMap::constant([0.0; 3]);
    /// # let (objects, lights, ground, settings) = (vec![], vec![], None, Settings::default());
    /// let scene = Scene { punctual, objects, environment, lights, ground, camera, settings };
    /// let views = LightViews::of(&scene)?;
    /// let seen = views.views.iter().filter_map(|view| view.place(Vec3::new(0.0, 0.0, 2.0)));
    /// assert!(seen.into_iter().any(|[x, y, near]| [x, y, near] == [0.0, 0.0, 0.5]));
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    #[inline]
    pub fn place(&self, place: Vec3) -> Option<[f32; 3]> {
        let relative = place - Vec3::from(self.origin);
        let depth = relative.dot(self.forward.into());
        if depth.is_nan() || depth <= self.near {
            return None;
        }
        let scale = self.inverse * self.inverse;
        let across = relative.dot(self.right.into()) * scale;
        let along = relative.dot(self.up.into()) * scale;
        Some(match self.distant == 0.0 {
            true => [across / depth, along / depth, 1.0 / depth],
            false => [across, along, self.far - depth],
        })
    }

    /// The place of which something is the picture: [`place`](Self::place) undone.
    ///
    /// ```
    /// # use glam::Vec3;
    /// # use sh_scene::LightView;
    /// # fn same(view: &LightView, place: Vec3) {
    /// let seen = view.place(place).expect("before the view");
    /// assert!(view.position(seen).abs_diff_eq(place, 1e-5));
    /// # }
    /// ```
    #[inline]
    pub fn position(&self, [across, up, near]: [f32; 3]) -> Vec3 {
        let aside = Vec3::from(self.right) * across + Vec3::from(self.up) * up;
        let (origin, forward) = (Vec3::from(self.origin), Vec3::from(self.forward));
        match self.distant == 0.0 {
            true => origin + (forward + aside) / near,
            false => origin + aside + forward * (self.far - near),
        }
    }

    /// The ray through a place of the picture: where it begins, and its direction, along which `forward` advances by 1.
    pub fn ray(&self, [across, up]: [f32; 2]) -> [Vec3; 2] {
        let aside = Vec3::from(self.right) * across + Vec3::from(self.up) * up;
        let (origin, forward) = (Vec3::from(self.origin), Vec3::from(self.forward));
        match self.distant == 0.0 {
            true => [origin + self.near * (forward + aside), forward + aside],
            false => [origin + aside, forward],
        }
    }
}

/// All lights with sharp shadows that shine, as records, and what is to be seen from them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LightViews {
    /// The lights.
    pub lights: Vec<PunctualRecord>,
    /// Their views, light by light; none where the settings ask for no shadows.
    pub views: Vec<LightView>,
    /// Texels along the side of a view, a multiple of the least.
    pub side: usize,
}

impl LightViews {
    /// The fewest texels along the side of a view.
    pub const LEAST_SIDE: usize = 64;

    /// The most: that of a scene with up to four views.
    pub const MOST_SIDE: usize = 1024;

    /// Those of a scene.
    ///
    /// ```
    /// # use sh_scene::{LightViews, Scene};
    /// # fn of(scene: &Scene) -> Result<(), sh_scene::LightError> {
    /// let seen = LightViews::of(scene)?;
    /// println!("{} views of {} by {} texels", seen.views.len(), seen.side, seen.side);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Where a light is none, or is bound to what is not there.
    pub fn of(scene: &Scene) -> Result<Self, LightError> {
        let mut all = Self::default();
        if scene.punctual.is_empty() {
            return Ok(all);
        }
        let bounds = scene.bounds().unwrap_or([Vec3::ZERO; 2]);
        for light in &scene.punctual {
            let placed = light.placed(&scene.objects)?;
            let mut record = placed.record()?;
            if !placed.shines() {
                continue;
            }
            record.first = all.views.len() as u32;
            match scene.settings.shadows {
                true => all.views.extend(views(&placed, &record, bounds)),
                false => record.views = 0,
            }
            all.lights.push(record);
        }
        all.side = Self::side(all.views.len());
        Ok(all)
    }

    /// How many views the lights that shine have, all together.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{LightViews, PunctualLight, PunctualShape};
    /// let shape = PunctualShape::Point { position: Vec3::Y, radius: 0.0 };
    /// let lights = [[1.0; 3], [0.0; 3]].map(|bright| PunctualLight::new(shape, bright));
    /// assert_eq!(LightViews::count(&lights), 6);
    /// ```
    pub fn count(lights: &[PunctualLight]) -> usize {
        let shining = lights.iter().filter(|light| light.shines());
        shining.map(PunctualLight::views).sum()
    }

    /// Texels along the side of each of so many views.
    ///
    /// ```
    /// use sh_scene::LightViews;
    /// assert_eq!([1, 6, 64 * 6].map(LightViews::side), [1024, 832, 64]);
    /// ```
    pub fn side(views: usize) -> usize {
        let side = (TEXELS / views.max(1)).isqrt() / Self::LEAST_SIDE * Self::LEAST_SIDE;
        side.clamp(Self::LEAST_SIDE, Self::MOST_SIDE)
    }

    /// Whether none shines.
    pub fn is_empty(&self) -> bool {
        self.lights.is_empty()
    }
}

/// The views of a light that is placed, in a scene of these bounds.
fn views(light: &PunctualLight, record: &PunctualRecord, bounds: [Vec3; 2]) -> Vec<LightView> {
    let [low, high] = bounds;
    let reach = (high - low).length();
    // What is within a light hides nothing of it; of one without a size, what is a ten-thousandth of the scene away.
    let near = |radius: f32| match radius > 0.0 {
        true => radius,
        false => (1e-4 * reach).max(f32::MIN_POSITIVE),
    };
    match light.shape {
        PunctualShape::Spot {
            position,
            angle,
            radius,
            ..
        } if angle <= WIDEST => {
            let half = (0.5 * angle).tan() * MARGIN;
            let axes = axes(record.axis.into());
            vec![LightView::perspective(position, axes, half, near(radius))]
        }
        PunctualShape::Spot {
            position, radius, ..
        } => {
            let axes = axes(record.axis.into());
            let all = faces(axes).into_iter().take(5);
            all.map(|axes| LightView::perspective(position, axes, MARGIN, near(radius)))
                .collect()
        }
        PunctualShape::Point { position, radius } => {
            let all = faces([Vec3::X, Vec3::Y, Vec3::Z]).into_iter();
            all.map(|axes| LightView::perspective(position, axes, MARGIN, near(radius)))
                .collect()
        }
        PunctualShape::Sun { .. } => {
            let [right, up, forward] = axes(record.axis.into());
            let middle = 0.5 * (low + high);
            // A ball about the scene is seen alike from everywhere, so that a sun that moves changes no texel's size.
            let half = (0.5 * reach * (1.0 + 1e-3)).max(f32::MIN_POSITIVE);
            vec![LightView {
                origin: (middle - forward * half).into(),
                distant: 1.0,
                right: (right * half).into(),
                far: 2.0 * half,
                up: (up * half).into(),
                near: f32::MIN,
                forward: forward.into(),
                inverse: 1.0 / half,
            }]
        }
    }
}

/// Axes to the right, up and forward along a unit vector.
fn axes(forward: Vec3) -> [Vec3; 3] {
    let (right, up) = forward.any_orthonormal_pair();
    [right, up, forward]
}

/// The six faces of a cube about these axes; the one behind last.
fn faces([x, y, z]: [Vec3; 3]) -> [[Vec3; 3]; 6] {
    [
        [x, y, z],
        [y, z, x],
        [z, x, y],
        [y, z, -x],
        [z, x, -y],
        [x, y, -z],
    ]
}
