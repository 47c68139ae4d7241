//! Half precision: two coefficients a word.

use crate::constants::HALF_MAX;
use crate::{Sh, ShRgb};
use half::f16;

/// Two numbers as one word, the first in its lower half.
fn word(first: f32, second: f32) -> u32 {
    let bits = |x: f32| u32::from(f16::from_f32(x.clamp(-HALF_MAX, HALF_MAX)).to_bits());
    bits(first) | bits(second) << 16
}

/// Number i of the words.
fn number(words: &[u32], i: usize) -> f32 {
    let bits = words[i / 2] >> (i % 2 * 16);
    f16::from_bits(bits as u16).to_f32()
}

macro_rules! to_half {
    ($($order:literal: $c:literal in $words:literal;)*) => { $(
        impl Sh<f32, $c> {
            #[doc = concat!("Order ", $order, " in half precision: ", $words, " words. See [`crate::storage`].")]
            ///
            /// ```
            #[doc = concat!("use sh_core::Sh", $order, ";")]
            #[doc = concat!("let f = Sh", $order, "::cosine([0.36, 0.48, 0.8]);")]
            #[doc = concat!("let back = Sh", $order, "::from_half(&f.to_half());")]
            /// assert!((back - f).norm() < f.norm() / 2048.0);
            /// ```
            pub fn to_half(&self) -> [u32; $words] {
                let at = |i: usize| self.0.get(i).copied().unwrap_or(0.0);
                core::array::from_fn(|i| word(at(2 * i), at(2 * i + 1)))
            }

            #[doc = concat!("Order ", $order, " from half precision; exact. The way back from [`Self::to_half`].")]
            ///
            /// ```
            #[doc = concat!("use sh_core::Sh", $order, ";")]
            /// // 1.0 is 0x3c00.
            #[doc = concat!("let mut words = [0; ", $words, "];")]
            /// words[0] = 0x3c00_0000;
            #[doc = concat!("assert_eq!(Sh", $order, "::from_half(&words)[1], 1.0);")]
            /// ```
            pub fn from_half(words: &[u32; $words]) -> Self {
                Self(core::array::from_fn(|i| number(words, i)))
            }
        }
    )* };
}
to_half! {
    2: 4 in 2;
    3: 9 in 5;
    4: 16 in 8;
    5: 25 in 13;
    6: 36 in 18;
}

/// RGB of order 2 in half precision: two words a channel, 24 bytes.
///
/// ```text
/// words[0]  red    c0 | c1 << 16
/// words[1]         c2 | c3 << 16
/// words[2]  green  c0 | c1 << 16          unpack2x16float(word) = (lower, upper)
/// …
/// ```
///
/// `uvec2[3]` in std430. In std140, where an array of `uvec2` would take 48 bytes, use [`HalfRgb2::std140`].
///
/// ```
/// use sh_core::{Sh2, ShRgb, storage::HalfRgb2};
/// let light = ShRgb::gray(Sh2::cosine([0.36, 0.48, 0.8]));
/// let back = ShRgb::from(HalfRgb2::from(light));
/// assert!((back.g - light.g).norm() < light.g.norm() / 2048.0);
/// assert_eq!((size_of::<HalfRgb2>(), align_of::<HalfRgb2>()), (24, 8));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C, align(8))]
pub struct HalfRgb2 {
    /// Red, green, blue, two words each.
    pub words: [u32; 6],
}

impl HalfRgb2 {
    /// The six words and two that are 0, as `uvec4[2]` for a uniform buffer in std140: 32 bytes.
    ///
    /// ```
    /// use sh_core::{Sh2, ShRgb, storage::HalfRgb2};
    /// let packed = HalfRgb2::from(ShRgb::gray(Sh2::ONE));
    /// assert_eq!(packed.std140()[1], [packed.words[4], packed.words[5], 0, 0]);
    /// ```
    pub fn std140(&self) -> [[u32; 4]; 2] {
        let [a, b, c, d, e, f] = self.words;
        [[a, b, c, d], [e, f, 0, 0]]
    }

    /// From the rows of [`HalfRgb2::std140`].
    ///
    /// ```
    /// use sh_core::{Sh2, ShRgb, storage::HalfRgb2};
    /// let packed = HalfRgb2::from(ShRgb::gray(Sh2::ONE));
    /// assert_eq!(HalfRgb2::from_std140(&packed.std140()), packed);
    /// ```
    pub fn from_std140(rows: &[[u32; 4]; 2]) -> Self {
        let [[a, b, c, d], [e, f, _, _]] = *rows;
        Self {
            words: [a, b, c, d, e, f],
        }
    }
}

/// RGB of order 3 in half precision: five words a channel and one that is 0, 64 bytes.
///
/// ```text
/// words[0]  red    c0 | c1 << 16
/// …
/// words[4]         c8 |  0 << 16
/// words[5]  green  c0 | c1 << 16
/// …
/// words[15] 0
/// ```
///
/// `uvec4[4]` in std140 and std430; word i of channel c is component (5 c + i) % 4 of row (5 c + i) / 4.
///
/// ```
/// use sh_core::{Sh3, ShRgb, storage::HalfRgb3};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// let packed = HalfRgb3::from(light);
/// assert_eq!(packed.words[5..10], light.g.to_half());
/// let back = ShRgb::from(packed);
/// assert!((back.b - light.b).norm() < light.b.norm() / 2048.0);
/// assert_eq!((size_of::<HalfRgb3>(), align_of::<HalfRgb3>()), (64, 16));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(C, align(16))]
pub struct HalfRgb3 {
    /// Red, green, blue, five words each, and a 0.
    pub words: [u32; 16],
}

macro_rules! channels {
    ($($type:ident, $c:literal, $words:literal;)*) => { $(
        impl From<ShRgb<f32, $c>> for $type {
            fn from(f: ShRgb<f32, $c>) -> Self {
                let mut out = Self::default();
                let channels = [f.r, f.g, f.b].map(|channel| channel.to_half());
                for (to, words) in out.words.chunks_mut($words).zip(channels) {
                    to.copy_from_slice(&words);
                }
                out
            }
        }

        impl From<$type> for ShRgb<f32, $c> {
            fn from(packed: $type) -> Self {
                let channel = |c: usize| {
                    let words = &packed.words[c * $words..][..$words];
                    Sh(core::array::from_fn(|i| number(words, i)))
                };
                Self {
                    r: channel(0),
                    g: channel(1),
                    b: channel(2),
                }
            }
        }
    )* };
}
channels! {
    HalfRgb2, 4, 2;
    HalfRgb3, 9, 5;
}
