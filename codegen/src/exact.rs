//! Exact coefficients: every constant of the library starts as a signed square root of a rational number.
//!
//! A real spherical harmonic factors into a polynomial in z and a trigonometric function of the azimuth,
//!
//! ```text
//! y_lm = √(k_lm / π) · Q_lm(z) · sin^m θ · (cos mφ  or  sin |m|φ),      Q_lm = dᵐ/dzᵐ P_l(z),
//! k_lm = (2l+1)/4 · (l−m)!/(l+m)! · (2 if m ≠ 0)
//! ```
//!
//! so that the integral of three of them (the Gaunt coefficient Γ of Ren et al. 2006, eq. 4) is a rational
//! integral over z times a rational multiple of π over φ times √(k₁k₂k₃/π³): its square is a rational number
//! over π. Everything here is computed in 128-bit integers and rounded once, at the end.

use crate::real::Real;

/// A rational number in lowest terms with a positive denominator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rational {
    /// Numerator, signed.
    pub num: i128,
    /// Denominator, positive.
    pub den: i128,
}

fn gcd(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs().max(1)
}

impl Rational {
    /// Zero.
    pub const ZERO: Self = Self { num: 0, den: 1 };
    /// One.
    pub const ONE: Self = Self { num: 1, den: 1 };

    /// `num / den` in lowest terms. `den` must not be zero.
    pub fn new(num: i128, den: i128) -> Self {
        let g = gcd(num, den) * den.signum();
        Self {
            num: num / g,
            den: den / g,
        }
    }

    /// The sum. Overflow cannot happen for the orders this crate supports; it would panic.
    #[expect(
        clippy::should_implement_trait,
        reason = "only four operations, all by value, none generic"
    )]
    pub fn add(self, o: Self) -> Self {
        let g = gcd(self.den, o.den);
        Self::new(
            self.num * (o.den / g) + o.num * (self.den / g),
            self.den / g * o.den,
        )
    }

    /// The product.
    #[expect(
        clippy::should_implement_trait,
        reason = "only four operations, all by value, none generic"
    )]
    pub fn mul(self, o: Self) -> Self {
        let (g, h) = (gcd(self.num, o.den), gcd(o.num, self.den));
        Self {
            num: (self.num / g) * (o.num / h),
            den: (self.den / h) * (o.den / g),
        }
    }

    /// To working precision.
    pub fn real(self) -> Real {
        Real::from_i128(self.num) / Real::from_i128(self.den)
    }
}

/// `sign · √square`, exact.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Root {
    /// −1, 0 or 1.
    pub sign: i32,
    /// The square, not negative.
    pub square: Rational,
}

impl Root {
    /// To working precision.
    pub fn real(self) -> Real {
        let r = self.square.real().sqrt();
        if self.sign < 0 { -r } else { r }
    }
}

/// Coefficient vectors of polynomials in z, lowest power first.
type Poly = Vec<Rational>;

fn poly_mul(a: &Poly, b: &Poly) -> Poly {
    let mut out = vec![Rational::ZERO; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] = out[i + j].add(x.mul(*y));
        }
    }
    out
}

/// Q_lm = dᵐ/dzᵐ P_l(z), lowest power first.
pub fn legendre_derivative(l: usize, m: usize) -> Vec<Rational> {
    let mut before: Poly = vec![Rational::ZERO];
    let mut p: Poly = vec![Rational::ONE];
    for k in 0..l as i128 {
        let up = poly_mul(&p, &vec![Rational::ZERO, Rational::new(2 * k + 1, k + 1)]);
        let down = poly_mul(&before, &vec![Rational::new(-k, k + 1)]);
        let next = (0..up.len())
            .map(|i| up[i].add(down.get(i).copied().unwrap_or(Rational::ZERO)))
            .collect();
        before = std::mem::replace(&mut p, next);
    }
    for _ in 0..m {
        p = (1..p.len())
            .map(|i| p[i].mul(Rational::new(i as i128, 1)))
            .collect();
    }
    p
}

/// k_lm: the square of the normalisation times π.
pub fn normalisation(l: usize, m: usize) -> Rational {
    let mut k = Rational::new((2 * l as i128 + 1) * if m > 0 { 2 } else { 1 }, 4);
    for i in (l - m + 1)..=(l + m) {
        k = k.mul(Rational::new(1, i as i128));
    }
    k
}

/// ∫ of three azimuthal functions (cos mφ for m ≥ 0, sin |m|φ for m < 0) over the circle, over π.
fn azimuth_integral(m: [i32; 3]) -> Rational {
    let sines = m.iter().filter(|m| **m < 0).count();
    if sines % 2 == 1 {
        return Rational::ZERO;
    }
    let mut sum = 0;
    for signs in 0..8 {
        let sign = |i: usize| if signs >> i & 1 == 1 { -1 } else { 1 };
        if (0..3).map(|i| sign(i) * m[i].abs()).sum::<i32>() == 0 {
            // cos is (e + ē)/2 and sin is (e − ē)/2i; two sines bring 1/i² = −1.
            sum += (0..3)
                .map(|i| if m[i] < 0 { sign(i) } else { 1 })
                .product::<i32>()
                * if sines == 2 { -1 } else { 1 };
        }
    }
    Rational::new(2 * sum as i128, 8)
}

/// (l, m) of a coefficient's index l·l + l + m.
pub fn band(index: usize) -> (usize, i32) {
    let l = index.isqrt();
    (l, index as i32 - (l * l + l) as i32)
}

/// √π · Γ_ijk, exactly: the integral of three basis functions, times √π.
pub fn gaunt(i: usize, j: usize, k: usize) -> Root {
    let bands = [band(i), band(j), band(k)];
    let azimuth = azimuth_integral(bands.map(|b| b.1));
    let degree: usize = bands.iter().map(|b| b.0).sum();
    let orders: usize = bands.iter().map(|b| b.1.unsigned_abs() as usize).sum();
    if azimuth.num == 0 || degree % 2 == 1 {
        return Root {
            sign: 0,
            square: Rational::ZERO,
        };
    }
    let mut poly: Poly = vec![Rational::ONE];
    let mut norm = Rational::ONE;
    for (l, m) in bands {
        let m = m.unsigned_abs() as usize;
        poly = poly_mul(&poly, &legendre_derivative(l, m));
        norm = norm.mul(normalisation(l, m));
    }
    for _ in 0..orders / 2 {
        poly = poly_mul(
            &poly,
            &vec![Rational::ONE, Rational::ZERO, Rational::new(-1, 1)],
        );
    }
    let integral = poly
        .iter()
        .enumerate()
        .filter(|(i, _)| i % 2 == 0)
        .fold(Rational::ZERO, |sum, (i, c)| {
            sum.add(c.mul(Rational::new(2, i as i128 + 1)))
        });
    let value = integral.mul(azimuth);
    // Multiplied factor by factor, so that common divisors leave early and 128 bits suffice.
    let square = norm.mul(value).mul(value);
    Root {
        sign: value.num.signum() as i32,
        square,
    }
}

/// A monomial's exponents in x, y and z, and its coefficient.
type Monomial = ([u32; 3], Rational);

/// The basis function without its √(k/π), as a polynomial in x, y and z.
fn cartesian(l: usize, m: i32) -> Vec<Monomial> {
    let order = m.unsigned_abs() as usize;
    let mut out = Vec::new();
    // (x + iy)^m, whose real part belongs to m ≥ 0 and whose imaginary part to m < 0.
    let mut binomial = Rational::ONE;
    for y in 0..=order {
        let imaginary = y % 2 == 1;
        let sign = if y % 4 >= 2 { -1 } else { 1 };
        if imaginary == (m < 0) {
            for (z, q) in legendre_derivative(l, order).iter().enumerate() {
                if q.num != 0 {
                    let c = q.mul(binomial).mul(Rational::new(sign, 1));
                    out.push(([(order - y) as u32, y as u32, z as u32], c));
                }
            }
        }
        binomial = binomial.mul(Rational::new((order - y) as i128, y as i128 + 1));
    }
    out
}

/// ∫ xᵃ yᵇ zᶜ over the sphere, over 4π.
fn monomial_integral(e: [u32; 3]) -> Rational {
    if e.iter().any(|e| e % 2 == 1) {
        return Rational::ZERO;
    }
    let double_factorial = |n: u32| (1..=n as i128).rev().step_by(2).product::<i128>();
    let odd = |e: u32| if e == 0 { 1 } else { double_factorial(e - 1) };
    Rational::new(
        e.iter().map(|e| odd(*e)).product(),
        double_factorial(e.iter().sum::<u32>() + 1),
    )
}

/// The matrix element ⟨y_lm, R y_lk⟩ of R, the rotation by +90° about x ((x, y, z) → (x, −z, y)), exactly.
pub fn quarter_turn(l: usize, m: i32, k: i32) -> Root {
    let mut sum = Rational::ZERO;
    for (a, c) in cartesian(l, m) {
        for (b, d) in cartesian(l, k) {
            // (R f)(s) = f(R⁻¹ s) and R⁻¹ (x, y, z) = (x, z, −y).
            let e = [a[0] + b[0], a[1] + b[2], a[2] + b[1]];
            let sign = Rational::new(if b[2] % 2 == 1 { -1 } else { 1 }, 1);
            sum = sum.add(c.mul(d).mul(sign).mul(monomial_integral(e)));
        }
    }
    let norm = normalisation(l, m.unsigned_abs() as usize)
        .mul(normalisation(l, k.unsigned_abs() as usize))
        .mul(Rational::new(16, 1));
    Root {
        sign: sum.num.signum() as i32,
        square: norm.mul(sum).mul(sum),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ordered and unique counts per order; Ren et al. 2006 lists the selection-rule counts instead, with a
    /// misprint at order 4.
    #[test]
    fn nonzero_counts() {
        for (n, ordered, unique) in [(2, 10, 4), (3, 83, 25), (4, 353, 77), (5, 1158, 238)] {
            let c = n * n;
            let (mut o, mut u) = (0, 0);
            for i in 0..c {
                for j in i..c {
                    for k in j..c {
                        if gaunt(i, j, k).sign != 0 {
                            u += 1;
                            o += if i == j && j == k {
                                1
                            } else if i == j || j == k {
                                3
                            } else {
                                6
                            };
                        }
                    }
                }
            }
            assert_eq!((o, u), (ordered, unique), "order {n}");
        }
    }

    #[test]
    fn known_values() {
        // Γ_000 = 1/(2√π).
        assert_eq!(
            gaunt(0, 0, 0),
            Root {
                sign: 1,
                square: Rational::new(1, 4)
            }
        );
        // ∫ y20³ = √(5/π)/7.
        assert_eq!(
            gaunt(6, 6, 6),
            Root {
                sign: 1,
                square: Rational::new(5, 49)
            }
        );
        // Allowed by every selection rule, and zero all the same: (2,0)(3,2)(3,2).
        assert_eq!(gaunt(6, 14, 14).sign, 0);
    }

    #[test]
    fn quarter_turn_of_a_vector() {
        // Band 1 is (y, z, x): the turn sends ŷ to ẑ and ẑ to −ŷ.
        assert_eq!(
            quarter_turn(1, 0, -1),
            Root {
                sign: 1,
                square: Rational::ONE
            }
        );
        assert_eq!(
            quarter_turn(1, -1, 0),
            Root {
                sign: -1,
                square: Rational::ONE
            }
        );
        assert_eq!(
            quarter_turn(1, 1, 1),
            Root {
                sign: 1,
                square: Rational::ONE
            }
        );
    }
}
