//! Coordinate systems, told by where their axes point.

use super::signed;
use crate::{Lane, Routines, Sh, ShRgb};

/// Where an axis points, seen as here: +X right, +Y up, +Z backwards.
///
/// ```
/// use sh_core::convention::{Axes, Axis};
/// let blender = Axes::new(Axis::Right, Axis::Forward, Axis::Up).expect("three different axes");
/// assert_eq!(blender.direction([1.0_f64, 2.0, 3.0]), [1.0, -3.0, 2.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// +X here.
    Right,
    /// −X here.
    Left,
    /// +Y here.
    Up,
    /// −Y here.
    Down,
    /// +Z here: towards the viewer.
    Back,
    /// −Z here: where a camera looks.
    Forward,
}

impl Axis {
    /// Which of x, y, z it is here, and whether it points the other way.
    const fn place(self) -> (usize, bool) {
        match self {
            Self::Right => (0, false),
            Self::Left => (0, true),
            Self::Up => (1, false),
            Self::Down => (1, true),
            Self::Back => (2, false),
            Self::Forward => (2, true),
        }
    }
}

/// Another coordinate system: where its x, y and z axes point, seen as here.
///
/// Any of the 48 that have axes along ours, right- or left-handed. What changes is how a direction is written, not
/// where it points: a vector turned by [`Axes::sh`] has at a direction turned by [`Axes::direction`] the value
/// that it had before. Lengths are not touched: Unreal counts centimetres, and a caller scales positions.
///
/// Which way *forward* is, is a habit of cameras; importers of glTF files into Unity and Unreal keep another axis
/// than a camera would. Where an engine has two habits, both are here.
///
/// ```
/// use sh_core::{Sh4, convention::Axes};
/// let light = Sh4::cosine([0.36, 0.48, 0.8]);
/// let d = [0.0, 0.6, -0.8];
/// let there = Axes::UNREAL.sh(&light).evaluate(Axes::UNREAL.direction(d));
/// assert!((there - light.evaluate(d)).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Axes {
    /// For each axis there: which one here, and whether it points the other way.
    places: [(usize, bool); 3],
}

impl Axes {
    /// As here: right-handed, +Y up, a camera looks along −Z. Those of glTF ("+Y up", right-handed), Bevy,
    /// three.js, Filament, OpenGL.
    ///
    /// Source: glTF 2.0, section 3.4; each engine's manual.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::GLTF.direction([1.0_f32, 2.0, 3.0]), [1.0, 2.0, 3.0]);
    /// ```
    pub const GLTF: Self = Self::of(Axis::Right, Axis::Up, Axis::Back);

    /// Bevy's where its glTF loader was asked to convert (`GltfConvertCoordinates`): half a turn about +Y, so that the
    /// front of a model, +Z in glTF, becomes −Z.
    ///
    /// Source: Bevy's documentation of that setting. Without it Bevy takes files as they are: [`Axes::GLTF`].
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::BEVY_CONVERTED.direction([1.0_f32, 2.0, 3.0]), [-1.0, 2.0, -3.0]);
    /// ```
    pub const BEVY_CONVERTED: Self = Self::of(Axis::Left, Axis::Up, Axis::Forward);

    /// Unity's and Direct3D's by habit: left-handed, +Y up, +Z forward.
    ///
    /// Source: Unity's manual; a camera that looks forward here looks forward there.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::UNITY.direction([0.0_f32, 0.0, -1.0]), [0.0, 0.0, 1.0]);
    /// ```
    pub const UNITY: Self = Self::of(Axis::Right, Axis::Up, Axis::Forward);

    /// Unity's as its glTF importers take files over: z is kept and x mirrored, so that the front of a model, +Z
    /// in glTF, stays +Z. Half a turn about +Y from [`Axes::UNITY`].
    ///
    /// Source: what UnityGLTF states it does; no specification says so.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::UNITY_IMPORT.direction([1.0_f32, 2.0, 3.0]), [-1.0, 2.0, 3.0]);
    /// ```
    pub const UNITY_IMPORT: Self = Self::of(Axis::Left, Axis::Up, Axis::Back);

    /// Unreal's by habit: left-handed, +X forward, +Y right, +Z up.
    ///
    /// Source: Unreal's manual; a camera that looks forward here looks forward there.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::UNREAL.direction([1.0_f32, 2.0, 3.0]), [-3.0, 1.0, 2.0]);
    /// ```
    pub const UNREAL: Self = Self::of(Axis::Forward, Axis::Right, Axis::Up);

    /// Unreal's as its glTF importer takes files over: y and z change places.
    ///
    /// Source: what Unreal's glTF exporter and importer do; no specification says so.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::UNREAL_IMPORT.direction([1.0_f32, 2.0, 3.0]), [1.0, 3.0, 2.0]);
    /// ```
    pub const UNREAL_IMPORT: Self = Self::of(Axis::Right, Axis::Back, Axis::Up);

    /// Right-handed, +Z up, +Y forward: Blender and most CAD.
    ///
    /// Source: Blender's manual; its glTF exporter turns by the same rule.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::Z_UP.direction([0.0_f32, 1.0, 0.0]), [0.0, 0.0, 1.0]);
    /// ```
    pub const Z_UP: Self = Self::of(Axis::Right, Axis::Forward, Axis::Up);

    /// The system whose x, y and z axes point there; `None` where two lie on one line.
    ///
    /// ```
    /// use sh_core::convention::{Axes, Axis};
    /// assert_eq!(Axes::new(Axis::Right, Axis::Up, Axis::Forward), Some(Axes::UNITY));
    /// assert_eq!(Axes::new(Axis::Right, Axis::Left, Axis::Up), None);
    /// ```
    pub const fn new(x: Axis, y: Axis, z: Axis) -> Option<Self> {
        let (a, b, c) = (x.place().0, y.place().0, z.place().0);
        if a == b || b == c || c == a {
            return None;
        }
        Some(Self::of(x, y, z))
    }

    const fn of(x: Axis, y: Axis, z: Axis) -> Self {
        Self {
            places: [x.place(), y.place(), z.place()],
        }
    }

    /// The way back: from there to here.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// let d = [0.36_f32, 0.48, 0.8];
    /// assert_eq!(Axes::UNREAL.inverse().direction(Axes::UNREAL.direction(d)), d);
    /// ```
    pub const fn inverse(self) -> Self {
        let mut places = [(0, false); 3];
        let mut there = 0;
        while there < 3 {
            let (here, negative) = self.places[there];
            places[here] = (there, negative);
            there += 1;
        }
        Self { places }
    }

    /// Whether x × y = z there, as it is here.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert!(Axes::Z_UP.is_right_handed() && !Axes::UNITY.is_right_handed());
    /// ```
    pub const fn is_right_handed(self) -> bool {
        let [(x, a), (y, b), (_, c)] = self.places;
        ((x + 1) % 3 == y) != (a ^ b ^ c)
    }

    /// The direction `d` of here as it is written there. Exact; for positions and normals as well.
    ///
    /// ```
    /// use sh_core::convention::Axes;
    /// assert_eq!(Axes::Z_UP.direction([1.0_f64, 2.0, 3.0]), [1.0, -3.0, 2.0]);
    /// ```
    pub fn direction<L: Lane>(self, d: [L; 3]) -> [L; 3] {
        self.places
            .map(|(here, negative)| if negative { -d[here] } else { d[here] })
    }

    /// The vector `f` of here as it is written there: f′(d′) = f(d) for `d′ = direction(d)`.
    ///
    /// Exact where axes keep their places and only signs change, as for Unity; a rotation's error, 1e-6 ‖f‖ in
    /// f32, where they change places.
    ///
    /// ```
    /// use sh_core::{Sh3, convention::Axes};
    /// let up = Axes::UNREAL.sh(&Sh3::cosine([0.0, 1.0, 0.0]));
    /// assert!((up - Sh3::cosine([0.0, 0.0, 1.0])).norm() < 1e-6);
    /// ```
    pub fn sh<L: Lane, const C: usize>(self, f: &Sh<L, C>) -> Sh<L, C>
    where
        [L; C]: Routines<L>,
    {
        if self.places.map(|(here, _)| here) == [0, 1, 2] {
            let [x, y, z] = self.places.map(|(_, negative)| negative);
            // Azimuth φ becomes π − φ, −φ; z of band l, m has parity l + m.
            return signed(f, |l, m| {
                (x && (m % 2 != 0) != (m < 0)) ^ (y && m < 0) ^ (z && (l + m) % 2 != 0)
            });
        }
        // A left-handed system is a rotation and a mirror image through the centre.
        let mirrored = !self.is_right_handed();
        let (zero, one) = (f[0].lift(0.0), f[0].lift(1.0));
        let mut matrix = [zero; 9];
        for (row, (here, negative)) in self.places.into_iter().enumerate() {
            matrix[row * 3 + here] = if negative != mirrored { -one } else { one };
        }
        let turned = f.rotate_matrix(matrix);
        signed(&turned, |l, _| mirrored && l % 2 != 0)
    }

    /// [`Axes::sh`] for every channel.
    ///
    /// ```
    /// use sh_core::{Sh3, ShRgb, convention::Axes};
    /// let light = ShRgb::gray(Sh3::cosine([0.0, 0.0, 1.0]));
    /// assert_eq!(Axes::UNITY.rgb(&light).r, Sh3::cosine([0.0, 0.0, -1.0]));
    /// ```
    pub fn rgb<L: Lane, const C: usize>(self, f: &ShRgb<L, C>) -> ShRgb<L, C>
    where
        [L; C]: Routines<L>,
    {
        f.map(|channel| self.sh(&channel))
    }
}
