//! What whoever loads a scene may ask for beyond what its files say.

use crate::ClipChoice;

/// What is loaded otherwise than a scene's files say.
///
/// ```
/// use sh_bake::{Choices, ClipChoice};
/// let half = Choices { spheres: 0.5, ..ClipChoice::First.into() };
/// assert_eq!([half.count(64), half.count(1)], [32, 1]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choices<'a> {
    /// The clip that a mesh file plays.
    pub clip: ClipChoice<'a>,
    /// What the number of every mesh's spheres is multiplied with.
    pub spheres: f32,
    /// Whether surfaces are sampled even where the scene has no indirect light, so that it can be switched on later.
    pub surfaces: bool,
}

impl Choices<'_> {
    /// How many spheres a mesh gets for which the scene asks for `count`: 1 to 4096, or none if that is what it asks for.
    pub fn count(&self, count: usize) -> usize {
        if count == 0 {
            return 0;
        }
        let scaled = (count as f32 * self.spheres).round() as usize;
        scaled.clamp(1, count.max(4096))
    }
}

impl Default for Choices<'_> {
    /// What the files say.
    fn default() -> Self {
        ClipChoice::None.into()
    }
}

impl<'a> From<ClipChoice<'a>> for Choices<'a> {
    fn from(clip: ClipChoice<'a>) -> Self {
        Self {
            clip,
            spheres: 1.0,
            surfaces: false,
        }
    }
}
