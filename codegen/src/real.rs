//! Numbers of about 31 digits, as unevaluated sums of two doubles.
//!
//! Constants are computed in this precision and rounded once to f64; rounding that f64 to f32 then gives
//! the same as rounding directly (a test looks at every constant the generator emits).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `hi + lo` with |lo| at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Real {
    hi: f64,
    lo: f64,
}

/// a + b and its rounding error (Knuth 1969).
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let t = s - a;
    (s, (a - (s - t)) + (b - t))
}

/// a · b and its rounding error (Dekker 1971); without a fused multiply-add, which is slow where the build
/// machine lacks it.
fn two_product(a: f64, b: f64) -> (f64, f64) {
    let split = |x: f64| {
        let t = 134_217_729.0 * x;
        let hi = t - (t - x);
        (hi, x - hi)
    };
    let p = a * b;
    let ((ah, al), (bh, bl)) = (split(a), split(b));
    (p, ((ah * bh - p) + ah * bl + al * bh) + al * bl)
}

fn quick(hi: f64, lo: f64) -> Real {
    let s = hi + lo;
    Real {
        hi: s,
        lo: lo - (s - hi),
    }
}

impl Real {
    /// π to 32 digits.
    pub const PI: Self = Self {
        hi: std::f64::consts::PI,
        lo: 1.224_646_799_147_353_2e-16,
    };

    /// An integer; exact below 2¹⁰⁶.
    pub fn from_i128(n: i128) -> Self {
        let hi = n as f64;
        quick(hi, (n - hi as i128) as f64)
    }

    /// Rounded to f64.
    pub fn to_f64(self) -> f64 {
        self.hi
    }

    /// Square root of a number that is not negative.
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 {
            return Self { hi: 0.0, lo: 0.0 };
        }
        let r = Self::from(self.hi.sqrt());
        // Two Newton steps from a 53-bit guess are more than enough for 106 bits.
        let r = (r + self / r) * Self::from(0.5);
        (r + self / r) * Self::from(0.5)
    }
}

impl From<f64> for Real {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Real {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        let (s, e) = two_sum(self.hi, o.hi);
        let (t, f) = two_sum(self.lo, o.lo);
        let r = quick(s, e + t);
        quick(r.hi, r.lo + f)
    }
}

impl Sub for Real {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self + -o
    }
}

impl Neg for Real {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            hi: -self.hi,
            lo: -self.lo,
        }
    }
}

impl Mul for Real {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        let (p, e) = two_product(self.hi, o.hi);
        quick(p, e + (self.hi * o.lo + self.lo * o.hi))
    }
}

impl Div for Real {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let q = self.hi / o.hi;
        let r = self - o * Self::from(q);
        let q2 = r.hi / o.hi;
        let r = r - o * Self::from(q2);
        quick(q, q2) + Self::from(r.hi / o.hi)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_digits() {
        let third = Real::from(1.0) / Real::from(3.0);
        assert!((third * Real::from(3.0) - Real::from(1.0)).hi.abs() < 1e-31);
        let root = Real::from(2.0).sqrt();
        assert!((root * root - Real::from(2.0)).hi.abs() < 1e-31);
        assert_eq!(Real::from_i128((1 << 100) + 1).lo, 1.0);
    }
}
