//! What polished surfaces reflect, in metallic-roughness terms.
//!
//! ```
//! use sh_core::gloss::Reflectance;
//! // Copper under an even sky of radiance 2: the mean of what it sees in its lobe is the sky.
//! let copper = Reflectance::new([0.95_f32, 0.64, 0.54], 1.0, 0.4, 0.8);
//! let seen = copper.mirrored.map(|c| 2.0 * c);
//! assert!(seen[0] > 1.8 && seen[2] < 1.3);
//! ```

use crate::constants::DIELECTRIC;
use crate::{Lane, Routines};

/// What a surface makes of light: factors for the mean of what it sees in the lobe in which it mirrors, and for what albedo 1
/// would reflect diffusely.
///
/// ```
/// # use sh_core::gloss::Reflectance;
/// let plastic = Reflectance::new([0.5_f32; 3], 0.0, 0.3, 1.0);
/// let (mirrored, irradiance) = (1.5, 0.8);
/// let radiance = plastic.mirrored[0] * mirrored + plastic.diffuse[0] * irradiance;
/// assert!((radiance - 0.44).abs() < 0.02);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflectance<L> {
    /// What is mirrored, by channel.
    pub mirrored: [L; 3],
    /// What is reflected diffusely, by channel.
    pub diffuse: [L; 3],
}

impl<L: Lane> Reflectance<L> {
    /// Of a surface of a base colour, 0 to 1 `metallic`, of a `roughness` 0 to 1, under the cosine of normal and view.
    ///
    /// With F the reflectance from the front, that of a dielectric or of a metal the base colour, E and B those of
    /// [`Routines::gloss_energy`], once mirrored is F (E − B) + B; light that the surface's valleys throw back and forth makes that larger
    /// by 1 + F (1/E − 1) (Turquin 2019, "Practical multiple scattering compensation for microfacet models"). What a dielectric
    /// does not mirror it reflects diffusely, in its colour. A white surface reflects all light, rough or smooth, dielectric or
    /// metal.
    ///
    /// ```
    /// use sh_core::gloss::Reflectance;
    /// let white = Reflectance::new([1.0_f32; 3], 0.0, 0.5, 0.7);
    /// assert!((white.mirrored[0] + white.diffuse[0] - 1.0).abs() < 1e-6);
    /// assert!(white.mirrored[0] < 0.1);
    /// let gold = Reflectance::new([1.0_f32, 0.8, 0.3], 1.0, 0.2, 0.9);
    /// assert_eq!(gold.diffuse, [0.0; 3]);
    /// assert!((gold.mirrored[1] - 0.8).abs() < 0.02);
    /// ```
    #[inline(always)]
    pub fn new(base: [L; 3], metallic: L, roughness: L, facing: L) -> Self
    where
        [L; 4]: Routines<L>,
    {
        let one = metallic.lift(1.0);
        let [energy, grazing] = <[L; 4]>::gloss_energy(roughness, facing);
        let again = one / energy - one;
        let dielectric = one.lift(DIELECTRIC);
        let of = |front: L| {
            let once = front.mul_add(energy - grazing, grazing);
            (once * front.mul_add(again, one)).min(one)
        };
        let matt = (one - metallic) * (one - of(dielectric));
        let front = |c: usize| metallic.mul_add(base[c] - dielectric, dielectric);
        Self {
            mirrored: [of(front(0)), of(front(1)), of(front(2))],
            diffuse: [base[0] * matt, base[1] * matt, base[2] * matt],
        }
    }
}
