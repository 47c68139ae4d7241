//! The table of constants that kernels and Rust share: what each is called, its value, and why it has that value.
//!
//! sh-core's build script prints all as Rust, that of the kernels as WGSL, where only those stay that a pass uses. A
//! constant that one language alone needs is no row here: it stays where it is needed. `tests/tests/constants.rs` watches
//! over both.
//!
//! ```
//! use sh_codegen::{constants, emit};
//! let largest = constants::find("HALF_MAX").unwrap();
//! assert_eq!(largest.value, constants::Value::Single(65504.0));
//! assert!(emit::rust::constants().contains("pub const HALF_MAX: f32 = 65504.0;"));
//! assert!(emit::wgsl::constants().contains("const HALF_MAX: f32 = 65504.0;"));
//! ```

use crate::routines::ORDERS;
use Value::{Byte, Count, Double, Single, Word};

/// A value, as what Rust has it. WGSL has `f32` for both kinds of numbers, and `u32` for all others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// `f64`: for lanes of any precision.
    Double(f64),
    /// `f32`.
    Single(f32),
    /// `usize`: the length of something.
    Count(usize),
    /// `u32`.
    Word(u32),
    /// `u8`.
    Byte(u8),
}

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    /// The name in both languages: it does not end in a digit, which translators of WGSL would rename.
    pub name: &'static str,
    /// The value.
    pub value: Value,
    /// What it is, with its unit, and why it is as large as it is.
    pub doc: &'static str,
}

/// All constants, topic by topic.
pub fn all() -> impl Iterator<Item = &'static Constant> {
    [
        ORDER, STORAGE, GRID, BALL, CUT, COARSE, LAMP, SENDER, PATCH, GLOSS, PUNCTUAL, ANGLE,
    ]
    .into_iter()
    .flatten()
}

/// The constant of a name.
pub fn find(name: &str) -> Option<&'static Constant> {
    all().find(|constant| constant.name == name)
}

const HIGHEST: usize = *ORDERS.end();

/// Orders, and the function 1.
const ORDER: &[Constant] = &[
    Constant {
        name: "MAX_ORDER",
        value: Count(HIGHEST),
        doc: "The highest SH order, that of the last routines that are generated. Records have room for it, so that one \
              serves all orders.",
    },
    Constant {
        name: "MOST_COEFFICIENTS",
        value: Count(HIGHEST * HIGHEST),
        doc: "Coefficients of the highest order: its square. Those of a lower order come first.",
    },
    Constant {
        name: "ROOT_FOUR_PI",
        value: Double(3.544_907_701_811_032),
        doc: "√(4π): the DC coefficient of the function that is 1 everywhere, because y₀ is 1/√(4π).",
    },
];

/// How vectors are stored.
const STORAGE: &[Constant] = &[Constant {
    name: "HALF_MAX",
    value: Single(65504.0),
    doc: "The largest finite number in half precision: (2 − 1/1024) · 32768. What is beyond is brought there.",
}];

const TILE: u32 = 16;

/// Grids of rays, and how work on them is cut up.
const GRID: &[Constant] = &[
    Constant {
        name: "WORKGROUP",
        value: Word(64),
        doc: "Invocations in a workgroup of every compute entry point: a multiple of the 32 or 64 that GPUs run side by \
              side, and a quarter of what WebGPU grants on every device.",
    },
    Constant {
        name: "OVERSAMPLE",
        value: Word(2),
        doc: "Samples per pixel in each direction: four a pixel smooth edges, and each more costs shading like the first.",
    },
    Constant {
        name: "SIDE",
        value: Word(TILE),
        doc: "Cells of a tile across and down. A tile is a cluster of receivers with a cut of its own: smaller ones make more \
              cuts, larger ones longer cuts. 16 by 16 cells are four workgroups.",
    },
    Constant {
        name: "AREA",
        value: Count((TILE * TILE) as usize),
        doc: "Cells of a tile.",
    },
];

/// Balls above a receiver's horizon.
const BALL: &[Constant] = &[
    Constant {
        name: "TINY",
        value: Double(1e-18),
        doc: "Smallest divisor, in metres: far below any distance that matters, far above the point where its reciprocal, or \
              that of two of them, overflows.",
    },
    Constant {
        name: "FOOT",
        value: Double(1e-6),
        doc: "Smallest square of the distance of a ball that stands for another, over the square of the other's: above what \
              rounding makes of a foot that is 0, some 2^-22 of it.",
    },
    Constant {
        name: "OWN",
        value: Double(0.3),
        doc: "1 − sin² of the angular radius from which on a ball of the receiver's own body counts as others do: .2 radii \
              outside. Nearer than that, what of it rises above the horizon is for the most part not there.",
    },
];

/// Cuts of the tree of blockers, and the order of their spheres.
const CUT: &[Constant] = &[
    Constant {
        name: "NEGLIGIBLE",
        value: Single(1.0 / 512.0),
        doc: "What the blockers that are left out of a cut because they are too small take together of the light of an even \
              sky, at most: half a step of a picture of 8 bits.",
    },
    Constant {
        name: "WIDENED",
        value: Single(1.001),
        doc: "What a cluster's radius is multiplied with where a blocker must be aside of a lamp for all of it: rounding moves \
              its bounds by less.",
    },
    Constant {
        name: "SHARPEST",
        value: Single(0.01),
        doc: "The least width over which an order of spheres changes, over the radius of the smaller one: above 0, because \
              what one hides of the other would jump otherwise, and too little to be seen.",
    },
    Constant {
        name: "ROOM",
        value: Count(128),
        doc: "Spheres of a cut that are kept while each is looked at against the others. Of a larger cut pairs are computed \
              anew, and what several leave of one is the product of what each leaves; so both backends change over at the same \
              count. They take at most 9 KiB of the 16 KiB of workgroup memory that WebGPU grants on every device.",
    },
];

/// Cuts of spheres that hide patches.
const COARSE: &[Constant] = &[
    Constant {
        name: "COARSER",
        value: Single(1.5),
        doc: "How much larger nodes may be, seen from a cluster, each time that its cut has more of them than there is ROOM for.",
    },
    Constant {
        name: "COARSEST",
        value: Word(12),
        doc: "How often that is tried: up to 129 times as large. What does not fit then hides nothing.",
    },
];

/// Lamps, and what is behind them.
const LAMP: &[Constant] = &[
    Constant {
        name: "NEAREST",
        value: Double(1e-30),
        doc: "Below this distance, in metres, a receiver is taken to be at a light's centre: far below any that matters, \
              with a reciprocal that is finite.",
    },
    Constant {
        name: "MOST_LAMPS",
        value: Count(32),
        doc: "Lamps of a light that are hidden only by what is before them: as many as a word has bits, which tell which of \
              them have a blocker behind them. Any further one is hidden by all that is in its direction.",
    },
    Constant {
        name: "ASIDE",
        value: Double(0.5),
        doc: "Cosine of the angle between a lamp and a blocker, plus the sine of the blocker's radius, up to which the blocker \
              counts as aside: 60° from its edge, as far as a light of a finite order mixes directions up.",
    },
    Constant {
        name: "STEEP",
        value: Double(4.0),
        doc: "One over the width of the change from ASIDE to where a blocker counts as in the lamp's direction: a quarter, \
              in the same measure, so that nothing jumps where one moves past a lamp.",
    },
    Constant {
        name: "ASIDE_EDGE",
        value: Single(1.0655),
        doc: "No sphere within a ball whose edge is so far from a lamp, in radians, is nearer to it than aside: \
              π/2 − 2 asin (ASIDE/2), rounded up.",
    },
    Constant {
        name: "REACH",
        value: Single(1.42),
        doc: "What takes the place of a blocker across a tangent plane lies within so many of its radii from its centre, for \
              receivers that are not nearer to that than NEAR radii. A test of sh-cpu looks for the farthest.",
    },
    Constant {
        name: "NEAR",
        value: Single(1.5),
        doc: "Radii from a blocker's centre from which on REACH holds.",
    },
];

/// Spheres that send light on.
const SENDER: &[Constant] = &[
    Constant {
        name: "DIRECTIONS",
        value: Count(92),
        doc: "How many directions a sphere is seen in as a light: the vertices of an icosahedron's geodesic sphere of \
              frequency 3, 10 · 3² + 2.",
    },
    Constant {
        name: "NO_POINT",
        value: Byte(u8::MAX),
        doc: "None of a sphere's points, where a byte says which: none has this index, as there is at most one for each of \
              DIRECTIONS.",
    },
    Constant {
        name: "NO_BODY",
        value: Word(u32::MAX),
        doc: "The body of a node that stands for spheres of several: none has this index.",
    },
    Constant {
        name: "MOST_GAIN",
        value: Single(4.0),
        doc: "No node gives so many times what its mean radiance says: where that is next to nothing, the quotient of what \
              its spheres give and what it gives says nothing any more.",
    },
    Constant {
        name: "ANGLES_ERR",
        value: Double(3e-4),
        doc: "More than three angles err by together, in radians: three times 6.8e-5, and rounding. Discs that are apart by so \
              much cover nothing of each other.",
    },
];

/// Patches of surfaces that send light on, and regions of them.
const PATCH: &[Constant] = &[
    Constant {
        name: "PATCH_SAMPLES",
        value: Count(4),
        doc: "Samples of a patch of a surface, each for as much area as the others. Irradiance is looked up at the first: as \
              many points as patches.",
    },
    Constant {
        name: "REGION_PATCHES",
        value: Count(16),
        doc: "Patches of a region, which stands for them from afar.",
    },
    Constant {
        name: "QUARTERS",
        value: Count(4),
        doc: "Parts of a region that are one disc each where their patches are flat together.",
    },
    Constant {
        name: "FEWER",
        value: Count(4),
        doc: "Of so many points of a body's patches one takes the light that bodies have sent, which varies less than what comes from \
              lights.",
    },
    Constant {
        name: "REFINED",
        value: Double(3.0),
        doc: "Nearer to the centre of a region than so many of its radii its patches count in its place.",
    },
    Constant {
        name: "ENTIRE",
        value: Double(4.5),
        doc: "Farther away than so many radii a region counts as a whole; between this and REFINED it changes gradually, so that \
              nothing jumps.",
    },
    Constant {
        name: "SPLIT",
        value: Double(2.0),
        doc: "Nearer to the centre of a disc than so many roots of its area its parts count in its place. What a disc gives from there \
              on is right to the fourth power of its radius over the distance, .6 %.",
    },
    Constant {
        name: "JOINED",
        value: Double(2.6),
        doc: "Farther away than so many roots of its area a disc counts as a whole.",
    },
    Constant {
        name: "WITHIN",
        value: Double(6.0),
        doc: "A receiver takes of what its body gives itself what is told no farther away than so many roots of a patch's area.",
    },
    Constant {
        name: "ASKEW",
        value: Double(0.05),
        doc: "What a patch counts among these that faces another way than the receiver, over one that faces the same way: where \
              no other is near it is what there is.",
    },
    Constant {
        name: "LIFTED",
        value: Double(0.5),
        doc: "How far a receiver is lifted off the plane of a disc that it lies in, over the root of the disc's area: half of what \
              discs are apart. So near single ones would be seen, and from there a plane of them is even within 4 %.",
    },
    Constant {
        name: "BEHIND",
        value: Double(0.25),
        doc: "How far behind its plane a disc is gone, over what receivers are lifted: no more than what is curved sticks out.",
    },
];

/// Polished surfaces.
const GLOSS: &[Constant] = &[
    Constant {
        name: "ROUGHNESS_STEPS",
        value: Single(253.0),
        doc: "Steps between roughness 0 and 1 that pictures tell apart, from 1 on in a byte.",
    },
    Constant {
        name: "MATT",
        value: Word(255),
        doc: "The byte of a sample that reflects diffusely alone.",
    },
    Constant {
        name: "ROUGHNESS_SHIFT",
        value: Word(8),
        doc: "Bits of what a receiver says of being covered below the byte of its roughness.",
    },
    Constant {
        name: "SMOOTHEST",
        value: Double(0.0025),
        doc: "The least α of a lobe, that of roughness 1/20: below it squares of cosines near 1 have no digits left in single \
              precision.",
    },
    Constant {
        name: "FACING",
        value: Double(0.02),
        doc: "The least cosine between normal and view that a lobe is found for: interpolated normals lean away from the eye, where \
              there is none.",
    },
    Constant {
        name: "DIELECTRIC",
        value: Double(0.04),
        doc: "What a surface that is no metal mirrors of light from the front: a refractive index of 1.5.",
    },
];

/// Lights with sharp shadows, and what is seen from them.
const PUNCTUAL: &[Constant] = &[
    Constant {
        name: "CLOSEST",
        value: Single(1e-4),
        doc: "Below this distance, in metres, a light without a radius gets no brighter.",
    },
    Constant {
        name: "VIEW_BLOCK",
        value: Word(8),
        doc: "Texels along a side of a view of which the nearest is kept, and of these, and of these again, so that most receivers \
              know by a few of them that nothing is before them.",
    },
    Constant {
        name: "SEARCH_TAPS",
        value: Word(16),
        doc: "Texels among which a receiver looks for what may be before a light, as far apart as the light's size asks. With four \
              samples a pixel, of which each turns them by another quarter, a pixel looks at 64.",
    },
    Constant {
        name: "SHADOW_TAPS",
        value: Word(32),
        doc: "Texels whose share says how much of a light is left: with four samples a pixel 128, so that penumbrae have no steps \
              that 8 bits show.",
    },
    Constant {
        name: "SHARP_TAPS",
        value: Word(8),
        doc: "The same for both, where all that is looked at lies within SHARP texels: there are few of them.",
    },
    Constant {
        name: "SHARP",
        value: Single(1.5),
        doc: "Texels of a view that are few: a disc of that radius has seven.",
    },
    Constant {
        name: "GOLDEN_COSINE",
        value: Single(-0.737_368_9),
        doc: "The cosine of the golden angle, 2.39996, by which points of a spiral that fills a disc evenly are turned from one to the next.",
    },
    Constant {
        name: "GOLDEN_SINE",
        value: Single(0.675_490_3),
        doc: "The sine of the golden angle.",
    },
    Constant {
        name: "RISE",
        value: Single(0.03),
        doc: "The sine of how high above a receiver's own plane something has to rise to hide a light from it: by less, facets of a \
              mesh with smooth normals would hide their neighbours; what lies flatter hides light that hardly counts there.",
    },
    Constant {
        name: "LEAST_BLUR",
        value: Single(0.75),
        doc: "Texels of a view by which every shadow is blurred: half a texel's diagonal, and a little.",
    },
    Constant {
        name: "NOWHERE",
        value: Single(-1e30),
        doc: "How near what is seen from a light is where nothing is seen: farther than any receiver.",
    },
    Constant {
        name: "WIDE",
        value: Single(0.5),
        doc: "The farthest that a receiver looks for what is before a light, in halves of the side of a view.",
    },
];

/// The angle of a cosine x of 0 to 1, by Abramowitz and Stegun 1964, 4.4.45: √(1 − x) times a polynomial.
const ANGLE: &[Constant] = &[
    Constant {
        name: "ANGLE_CUBIC",
        value: Double(-0.018_729_3),
        doc: "The factor of x³ of the polynomial of Abramowitz and Stegun 1964, 4.4.45: arccos x is √(1 − x) times that, \
              within 6.8e-5.",
    },
    Constant {
        name: "ANGLE_SQUARE",
        value: Double(0.074_261_0),
        doc: "The factor of x² of the same.",
    },
    Constant {
        name: "ANGLE_LINEAR",
        value: Double(-0.212_114_4),
        doc: "The factor of x of the same.",
    },
    Constant {
        name: "ANGLE_CONSTANT",
        value: Double(1.570_728_8),
        doc: "The constant of the same: not π/2, which would be exact at 0 and err more elsewhere.",
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn names_are_whole_and_used_once() {
        let mut seen = HashSet::new();
        for Constant { name, .. } in all() {
            assert!(seen.insert(name), "{name} is there twice");
            let fine = |c: char| c.is_ascii_uppercase() || c == '_';
            assert!(name.chars().all(fine) && !name.contains("__"), "{name}");
        }
    }

    #[test]
    fn each_says_what_it_is() {
        for Constant { name, doc, .. } in all() {
            assert!(doc.ends_with('.') && doc.len() > name.len(), "{name}");
        }
    }

    #[test]
    fn derived_ones_are_what_they_say() {
        let value = |name: &str| match find(name).expect(name).value {
            Double(value) => value,
            Single(value) => f64::from(value),
            Count(value) => value as f64,
            Word(value) => f64::from(value),
            Byte(value) => f64::from(value),
        };
        let pi = std::f64::consts::PI;
        assert!((value("ROOT_FOUR_PI") - (4.0 * pi).sqrt()).abs() <= 2.0 * f64::EPSILON);
        assert_eq!(value("AREA"), value("SIDE") * value("SIDE"));
        assert!(value("DIRECTIONS") < value("NO_POINT"));
        let edge = pi / 2.0 - 2.0 * (value("ASIDE") / 2.0).asin();
        assert!((edge..edge + 1e-4).contains(&value("ASIDE_EDGE")), "{edge}");
        // What Abramowitz and Stegun promise of their polynomial, and what is made of that.
        let angle = |x: f64| {
            let p = value("ANGLE_CUBIC") * x + value("ANGLE_SQUARE");
            let p = (p * x + value("ANGLE_LINEAR")) * x + value("ANGLE_CONSTANT");
            (1.0 - x).sqrt() * p
        };
        let errors = (0..=1000).map(|i| f64::from(i) / 1000.0);
        let most = errors.fold(0.0, |most: f64, x| most.max((angle(x) - x.acos()).abs()));
        assert!(most > 6.5e-5 && most < 6.8e-5, "{most}");
        assert!(value("ANGLES_ERR") > 3.0 * most);
    }
}
