//! What is said about light that comes by way of other bodies.

/// How bodies light each other: they send on, diffusely, what light falls on their surface, and block it for each other.
///
/// ```
/// use sh_scene::{Indirect, Settings};
/// let settings = Settings { indirect: Some(Indirect::default()), ..Settings::default() };
/// assert_eq!(settings.indirect.map(|indirect| indirect.bounces), Some(1));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Indirect {
    /// By what they send it.
    pub method: Method,
    /// How often light is sent on before it reaches the receiver, from 1 on.
    pub bounces: u32,
    /// How bodies block the light of spheres.
    pub blocking: Blocking,
}

/// By what bodies send light on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Their spheres (Guerrero et al. 2008): of any body, of one that bends as well.
    #[default]
    SphericalLights,
    /// Patches of their surface, whose irradiance is told in few functions ([`crate::basis`], Iwasaki et al. 2007): of bodies
    /// that are rigid. Those that bend send by their spheres.
    BasisIrradiance,
}

impl Method {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::SphericalLights, Self::BasisIrradiance];

    /// The name that files and messages use.
    ///
    /// ```
    /// assert_eq!(sh_scene::Method::default().name(), "spherical-lights");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::SphericalLights => "spherical-lights",
            Self::BasisIrradiance => "basis-irradiance",
        }
    }
}

impl Indirect {
    /// The most bounces there may be.
    pub const MOST_BOUNCES: u32 = 16;
}

impl Default for Indirect {
    /// One bounce by spheres, with what is nearest the truth.
    fn default() -> Self {
        Self {
            method: Method::default(),
            bounces: 1,
            blocking: Blocking::Discs,
        }
    }
}

/// What hides one light from a receiver.
///
/// All but [`Blocking::Discs`] take the visibility of a light as the difference of two exponentials (Guerrero et al. 2008,
/// equation 23), which is as blurred as the order makes it: at order 4 a small light wholly behind another still gives
/// most of what it would give alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Blocking {
    /// Each light is a disc in the sky, of which every nearer sphere leaves the part that its own disc does not cover. No
    /// exponential, and no order of bodies.
    #[default]
    Discs,
    /// [`Sphere`](Self::Sphere) where spheres interlock, and what has been summed up before serves for all behind them:
    /// the same result in less time.
    Runs,
    /// Every sphere that is nearer (section 7.2, per-sphere blocking). The cost grows with the square of the number of
    /// spheres.
    Sphere,
    /// Every body that is nearer, as a whole (per-object blocking). Wrong where each of two bodies hides a part of the
    /// other.
    Object,
}

impl Blocking {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Discs, Self::Runs, Self::Sphere, Self::Object];

    /// Whether intersecting spheres of one body hide each other, as those of two bodies do, so that together they give
    /// what their union gives. A sphere then needs light for every direction ([`SurfaceSamples::stands`]). Otherwise
    /// what one hides of the other is dark in its samples, whatever it is seen from (Guerrero et al. 2008, section 4.2).
    ///
    /// [`SurfaceSamples::stands`]: crate::SurfaceSamples::stands
    ///
    /// ```
    /// use sh_scene::Blocking;
    /// assert!(Blocking::Discs.within_bodies() && !Blocking::Runs.within_bodies());
    /// ```
    pub const fn within_bodies(self) -> bool {
        matches!(self, Self::Discs)
    }

    /// The name that files and messages use.
    ///
    /// ```
    /// assert_eq!(sh_scene::Blocking::default().name(), "discs");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::Discs => "discs",
            Self::Runs => "runs",
            Self::Sphere => "sphere",
            Self::Object => "object",
        }
    }
}
