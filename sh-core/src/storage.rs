//! Vectors in buffers and files: rows of four for uniform and storage buffers, half precision (feature `half`).
//!
//! | type | holds | bytes | in a shader | std140 | std430 |
//! |---|---|---|---|---|---|
//! | [`Rgb2`] | order 2, three channels | 48 | `vec4[3]` | as it is | as it is |
//! | [`Rgb3`] | order 3, three channels | 112 | `vec4[7]` | as it is | as it is |
//! | [`HalfRgb2`] | the same as [`Rgb2`] in f16 | 24 | `uvec2[3]` | [`HalfRgb2::std140`], 32 bytes, `uvec4[2]` | as it is |
//! | [`HalfRgb3`] | the same as [`Rgb3`] in f16 | 64 | `uvec4[4]` | as it is | as it is |
//! | `Sh::to_half` | one channel, orders 2 to 6 | 8, 20, 32, 52, 72 | `uint[…]` | | as it is |
//!
//! std140 gives every element of an array 16 bytes, std430 the bytes it has; that is why rows have four numbers here. WGSL's
//! uniform and storage buffers follow the same two rules, HLSL's constant buffers the first. [`ShRgb`] itself lies as
//! 3 n² numbers in a row: `float[]` of std430, and of no std140.
//!
//! # Half precision
//! Two coefficients a word, the one of lower index in the lower half, as `unpack2x16float` and `unpackHalf2x16` take
//! them apart; an odd one at the end of a channel is followed by 0. Rounding to nearest errs by at most 2⁻¹¹ of a
//! coefficient, and by 2⁻²⁵ of 1 below 2⁻¹⁴; the function that comes back errs nowhere by more than
//! 2⁻¹¹ ‖f‖ n/√(4π). What is beyond ±65504 is brought there, infinities with it; NaN stays NaN.
//!
//! ```
//! use sh_core::{Sh2, ShRgb, storage::Rgb2};
//! let light = ShRgb::gray(Sh2::cosine([0.0, 1.0, 0.0]));
//! assert_eq!(light, Rgb2::from(light).into());
//! ```

#[cfg(feature = "half")]
mod half;

#[cfg(feature = "half")]
pub use half::{HalfRgb2, HalfRgb3};

use crate::{Sh, ShRgb};

/// RGB of order 2: a row of four a channel. 48 bytes in std140 and std430.
///
/// ```text
/// rows[0]  red    c0 c1 c2 c3
/// rows[1]  green  c0 c1 c2 c3          value at d: dot(row, 0.2821 (1, √3 y, √3 z, √3 x))
/// rows[2]  blue   c0 c1 c2 c3
/// ```
///
/// Exact. With feature `bytemuck` its bytes go to a buffer as they are.
///
/// ```
/// use sh_core::{Sh2, ShRgb, storage::Rgb2};
/// let packed = Rgb2::from(ShRgb::gray(Sh2::ONE));
/// assert_eq!(packed.rows[1], Sh2::ONE.0);
/// assert_eq!((size_of::<Rgb2>(), align_of::<Rgb2>()), (48, 16));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(16))]
pub struct Rgb2 {
    /// Red, green, blue.
    pub rows: [[f32; 4]; 3],
}

/// RGB of order 3: 27 numbers, channel after channel, and a 0 in seven rows of four. 112 bytes in std140 and std430.
///
/// ```text
/// rows[0]  r0 r1 r2 r3
/// rows[1]  r4 r5 r6 r7
/// rows[2]  r8 g0 g1 g2          number i of a channel c lies at 9 c + i
/// …
/// rows[6]  b6 b7 b8 0
/// ```
///
/// Exact. For shading alone, the seven rows of [`crate::convention::unity::shader`] take fewer instructions.
///
/// ```
/// use sh_core::{Sh3, ShRgb, storage::Rgb3};
/// let light = ShRgb::gray(Sh3::cosine([0.36, 0.48, 0.8]));
/// let packed = Rgb3::from(light);
/// assert_eq!((packed.rows[2][0], packed.rows[2][1]), (light.r[8], light.g[0]));
/// assert_eq!(light, packed.into());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C, align(16))]
pub struct Rgb3 {
    /// 27 numbers and a 0.
    pub rows: [[f32; 4]; 7],
}

impl From<ShRgb<f32, 4>> for Rgb2 {
    fn from(f: ShRgb<f32, 4>) -> Self {
        Self {
            rows: [f.r.0, f.g.0, f.b.0],
        }
    }
}

impl From<Rgb2> for ShRgb<f32, 4> {
    fn from(packed: Rgb2) -> Self {
        let [r, g, b] = packed.rows.map(Sh);
        Self { r, g, b }
    }
}

impl From<ShRgb<f32, 9>> for Rgb3 {
    fn from(f: ShRgb<f32, 9>) -> Self {
        let mut rows = [[0.0; 4]; 7];
        let numbers = rows.as_flattened_mut();
        for (channel, f) in [f.r, f.g, f.b].iter().enumerate() {
            numbers[channel * 9..][..9].copy_from_slice(&f.0);
        }
        Self { rows }
    }
}

impl From<Rgb3> for ShRgb<f32, 9> {
    fn from(packed: Rgb3) -> Self {
        let numbers = packed.rows.as_flattened();
        let channel = |c: usize| Sh(core::array::from_fn(|i| numbers[c * 9 + i]));
        Self {
            r: channel(0),
            g: channel(1),
            b: channel(2),
        }
    }
}
