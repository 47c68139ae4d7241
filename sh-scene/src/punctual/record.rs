//! A light with sharp shadows as the passes read it.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use sh_core::constants::{CLOSEST, TINY};

/// A [`crate::PunctualLight`] as the passes read it: 64 bytes, as `struct Punctual { position: vec3f, radius: f32, axis: vec3f, outer: f32,
/// radiance: vec3f, steep: f32, distant: f32, first: u32, views: u32, unused: u32 }` in WGSL.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct PunctualRecord {
    /// The centre in metres, or the unit vector towards a sun.
    pub position: [f32; 3],
    /// The radius in metres, or the tangent of a sun's angular radius.
    pub radius: f32,
    /// The unit vector that it shines along.
    pub axis: [f32; 3],
    /// 1 − the cosine of half the cone's angle: beyond that there is no light.
    pub outer: f32,
    /// The intensity over π.
    pub radiance: [f32; 3],
    /// One over the part of that over which the cone fades.
    pub steep: f32,
    /// 1 for a sun, else 0.
    pub distant: f32,
    /// The first of its views.
    pub first: u32,
    /// How many there are.
    pub views: u32,
    /// 0.
    pub unused: u32,
}

impl PunctualRecord {
    /// What albedo 1 reflects of it at a place with a unit normal, where nothing is in the way.
    ///
    /// With the cosine c of its direction and the sine s of its angular radius, a ball of radius r at a distance d gives I g / (π d²), where g is c of one
    /// that is wholly above the horizon (that is exact), 0 below, and (c + s)² / 4s of one that the horizon cuts, which is off by at most .04 s.
    /// Nearer than the radius it is as bright as there.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{PunctualLight, PunctualShape};
    /// let sun = PunctualShape::Sun { direction: Vec3::Y, angle: 0.0 };
    /// let sun = PunctualLight::new(sun, [std::f32::consts::PI; 3]).record()?;
    /// assert_eq!(sun.radiance(Vec3::ZERO, Vec3::Y), [1.0; 3]);
    /// assert_eq!(sun.radiance(Vec3::ZERO, Vec3::NEG_Y), [0.0; 3]);
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    pub fn radiance(&self, place: Vec3, normal: Vec3) -> [f32; 3] {
        let seen = self.seen(place);
        let share = seen.share * above(seen.direction.dot(normal), seen.sine);
        self.radiance.map(|c| c * share)
    }

    /// Where a place sees it, and how bright it is there.
    ///
    /// ```
    /// use glam::Vec3;
    /// use sh_scene::{PunctualLight, PunctualShape};
    /// let lamp = PunctualShape::Point { position: Vec3::Y, radius: 0.5 };
    /// let seen = PunctualLight::new(lamp, [1.0; 3]).record()?.seen(Vec3::ZERO);
    /// assert_eq!((seen.direction, seen.sine, seen.share), (Vec3::Y, 0.5, 1.0));
    /// # Ok::<(), sh_scene::LightError>(())
    /// ```
    #[inline]
    pub fn seen(&self, place: Vec3) -> Seen {
        let position = Vec3::from(self.position);
        if self.distant != 0.0 {
            let sine = self.radius / (1.0 + self.radius * self.radius).sqrt();
            return Seen {
                direction: position,
                sine,
                share: 1.0,
            };
        }
        let towards = position - place;
        let far = towards.length().max(self.radius).max(CLOSEST);
        let direction = towards / far;
        // Of both unit vectors half the squared difference is 1 − the cosine.
        let aside = direction + Vec3::from(self.axis);
        let within = ((self.outer - 0.5 * aside.dot(aside)) * self.steep).clamp(0.0, 1.0);
        Seen {
            direction,
            sine: (self.radius / far).min(1.0),
            share: within * within / (far * far),
        }
    }
}

/// Where a place sees a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// The unit vector towards its middle; shorter within the light.
    pub direction: Vec3,
    /// The sine of its angular radius.
    pub sine: f32,
    /// What its radiance is multiplied with: what is left of it in the cone, over the square of the distance.
    pub share: f32,
}

/// The mean cosine of what of a ball is above the horizon, by the cosine of its middle and the sine of its angular radius.
///
/// ```
/// use sh_scene::punctual::above;
/// assert_eq!([above(0.5, 0.1), above(-0.2, 0.1), above(0.0, 0.0)], [0.5, 0.0, 0.0]);
/// assert!((above(0.0, 0.2) - 0.05).abs() < 1e-6);
/// ```
#[inline]
pub fn above(cosine: f32, sine: f32) -> f32 {
    if cosine >= sine {
        return cosine.max(0.0);
    }
    let over = (cosine + sine).max(0.0);
    over * over / (4.0 * sine).max(TINY as f32)
}
