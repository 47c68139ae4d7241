//! Named choices between a fast picture and an accurate one.

/// How much work the light of a picture gets: the SH orders and the resolution of [`crate::Settings`] under one
/// name. ACCURACY.md
/// has the error and the cost of each.
///
/// ```
/// use sh_scene::{Quality, Settings};
/// let settings = Settings::default().with_quality(Quality::Accurate);
/// assert!(settings.accumulation > Settings::default().accumulation);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Quality {
    /// The softest light, in .9 of the time of shadows. Against rays under the map itself, direct light of the bunny in a city
    /// is 3.1 % off.
    Fast,
    /// The middle, and what is taken where nothing is said: the paper's order, 2.4 % off.
    #[default]
    Balanced,
    /// The sharpest light and the truest shadows, 1.9 % off, in 1.4 times the time of shadows.
    Accurate,
}

impl Quality {
    /// All of them, from the fastest on.
    pub const ALL: [Self; 3] = [Self::Fast, Self::Balanced, Self::Accurate];

    /// The table: name, order of the light, order of accumulation, half resolution.
    const fn row(self) -> (&'static str, usize, usize, bool) {
        match self {
            Self::Fast => ("fast", 3, 3, true),
            Self::Balanced => ("balanced", 4, 4, true),
            Self::Accurate => ("accurate", 6, 6, false),
        }
    }

    /// The name that files and messages use.
    pub const fn name(self) -> &'static str {
        self.row().0
    }

    /// The SH order of the light.
    pub const fn order(self) -> usize {
        self.row().1
    }

    /// The SH order in which blockers' logarithms are accumulated.
    pub const fn accumulation(self) -> usize {
        self.row().2
    }

    /// Whether shadows are computed at half the picture's resolution.
    pub const fn half_resolution(self) -> bool {
        self.row().3
    }
}
