//! How polished a surface is.

use crate::Receiver;
use sh_core::constants::{MATT, ROUGHNESS_SHIFT, ROUGHNESS_STEPS};

/// How a place of a surface reflects besides its base colour, as glTF's metallic-roughness materials have it: in a lobe
/// about the mirrored direction (GGX of α = roughness²) besides diffusely.
///
/// ```
/// use sh_scene::Finish;
/// let brushed = Finish { roughness: 0.4, metallic: 1.0 };
/// assert!(brushed.is_glossy() && !Finish::DIFFUSE.is_glossy());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// 0 a mirror, 1 rough.
    pub roughness: f32,
    /// 0 a dielectric, of which 4 % of light that comes from the front is mirrored and the rest is reflected diffusely; 1 a
    /// metal, which mirrors light in its base colour and reflects none diffusely.
    pub metallic: f32,
}

impl Finish {
    /// All light is reflected evenly: nothing is mirrored.
    pub const DIFFUSE: Self = Self {
        roughness: 1.0,
        metallic: 0.0,
    };

    /// Whether it mirrors anything: what is as rough as can be and no metal counts as diffuse.
    pub fn is_glossy(&self) -> bool {
        self.roughness < 1.0 || self.metallic > 0.0
    }

    /// What samples of pictures keep of it, 16 bits that are not 0: the roughness's byte, and in the upper one that of
    /// metallic. What is not a number is diffuse.
    ///
    /// ```
    /// use sh_scene::Finish;
    /// assert_eq!(Finish::DIFFUSE.packed(), 255);
    /// assert_eq!(Finish { roughness: 0.0, metallic: 1.0 }.packed(), 0xff01);
    /// ```
    pub fn packed(self) -> u32 {
        if !self.is_glossy() {
            return MATT;
        }
        let roughness = 1.0 + (self.roughness.clamp(0.0, 1.0) * ROUGHNESS_STEPS).round();
        let metallic = (self.metallic.clamp(0.0, 1.0) * 255.0).round();
        // A cast takes what is not a number to 0.
        (roughness as u32).max(1) | (metallic as u32) << 8
    }

    /// What [`Receiver::covered`] says of a surface whose finish was packed.
    ///
    /// ```
    /// use sh_scene::Finish;
    /// let covered = Finish::covered(Finish { roughness: 0.4, metallic: 1.0 }.packed());
    /// assert!(covered > 1);
    /// assert_eq!(Finish::covered(Finish::DIFFUSE.packed()), 1);
    /// ```
    pub fn covered(packed: u32) -> u32 {
        match packed & MATT {
            MATT => 1,
            roughness => 1 | roughness << ROUGHNESS_SHIFT,
        }
    }

    /// How metallic a packed one was.
    ///
    /// ```
    /// use sh_scene::Finish;
    /// assert_eq!(Finish::metallic(Finish { roughness: 0.4, metallic: 1.0 }.packed()), 1.0);
    /// ```
    pub fn metallic(packed: u32) -> f32 {
        (packed >> 8 & 255) as f32 / 255.0
    }
}

impl Receiver {
    /// The roughness of one that mirrors light, as [`Receiver::covered`] has it; none of one that does not.
    ///
    /// ```
    /// use sh_scene::{Finish, Receiver};
    /// let finish = Finish { roughness: 0.4, metallic: 0.0 };
    /// let covered = Finish::covered(finish.packed());
    /// let receiver = Receiver { position: [0.0; 3], covered, normal: [0.0, 1.0, 0.0], object: 0 };
    /// assert!((receiver.roughness().unwrap() - 0.4).abs() < 0.002);
    /// assert_eq!(Receiver { covered: 1, ..receiver }.roughness(), None);
    /// ```
    pub fn roughness(&self) -> Option<f32> {
        let byte = self.covered >> ROUGHNESS_SHIFT & MATT;
        (byte > 0).then(|| (byte - 1) as f32 / ROUGHNESS_STEPS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_samples_keep_is_within_half_a_step() {
        for i in 0..=1000 {
            let (roughness, metallic) = (i as f32 / 1000.0, 1.0 - i as f32 / 1000.0);
            let packed = Finish {
                roughness,
                metallic,
            }
            .packed();
            assert!((1..=0xffff).contains(&packed));
            let covered = Finish::covered(packed);
            let receiver = Receiver {
                position: [0.0; 3],
                covered,
                normal: [0.0; 3],
                object: 0,
            };
            if i == 1000 {
                assert_eq!((covered, receiver.roughness()), (1, None));
                continue;
            }
            let kept = receiver.roughness().unwrap();
            assert!(
                (kept - roughness).abs() <= 0.501 / ROUGHNESS_STEPS,
                "{kept} of {roughness}"
            );
            let kept = Finish::metallic(packed);
            assert!(
                (kept - metallic).abs() <= 0.501 / 255.0,
                "{kept} of {metallic}"
            );
        }
        // Rough metal mirrors light, and says so.
        let rough = Finish {
            roughness: 1.0,
            metallic: 1.0,
        };
        assert!(Finish::covered(rough.packed()) > 1);
    }

    #[test]
    fn what_is_no_number_is_diffuse_or_a_number() {
        for wrong in [f32::NAN, f32::INFINITY, -1.0, 7.0] {
            let packed = Finish {
                roughness: wrong,
                metallic: wrong,
            }
            .packed();
            assert!((1..=0xffff).contains(&packed), "{wrong}");
        }
    }
}
