//! Real spherical harmonics of any order, for directions of places: the library's go to order 6.

/// Order² values at a unit direction, band by band from −l to l, as [`sh_core::Routines::basis`] has them. Recurrences of
/// associated Legendre functions with their powers of the sine left out, which sines and cosines of m φ bring along.
pub(super) fn harmonics([x, y, z]: [f64; 3], order: usize, out: &mut [f64]) {
    let (mut real, mut imaginary) = (1.0, 0.0);
    // P of degree m and order m, over the sine's power.
    let mut first = 1.0;
    for m in 0..order {
        if m > 0 {
            first *= 2.0 * m as f64 - 1.0;
            (real, imaginary) = (real * x - imaginary * y, real * y + imaginary * x);
        }
        let (mut before, mut here) = (0.0, first);
        for l in m..order {
            if l > m {
                let (l, m) = (l as f64, m as f64);
                let next = ((2.0 * l - 1.0) * z * here - (l + m - 1.0) * before) / (l - m);
                (before, here) = (here, next);
            }
            let scale = norm(l, m) * here;
            out[l * l + l + m] = scale * real;
            if m > 0 {
                out[l * l + l - m] = scale * imaginary;
            }
        }
    }
}

/// √((2 l + 1) / 4π · (l − m)! / (l + m)!), and √2 more where m is not 0.
fn norm(l: usize, m: usize) -> f64 {
    let ratio: f64 = (l - m + 1..=l + m).map(|k| k as f64).product();
    let square = (2 * l + 1) as f64 / (4.0 * std::f64::consts::PI) / ratio;
    (if m > 0 { 2.0 * square } else { square }).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use sh_core::Routines;

    #[test]
    fn the_first_are_the_librarys() {
        for k in 0..50 {
            let (a, b) = (0.7 * f64::from(k), 1.3 * f64::from(k) + 0.2);
            let direction = [a.cos() * b.sin(), b.cos(), a.sin() * b.sin()];
            let mut all = [0.0; 64];
            harmonics(direction, 8, &mut all);
            let known = <[f64; 36]>::basis(direction);
            for (i, (ours, known)) in all.iter().zip(known).enumerate() {
                assert!((ours - known).abs() < 1e-12, "{i}: {ours} {known}");
            }
            // What is beyond them: the sum of squares of a band is the same everywhere (Unsöld).
            let square: f64 = all[49..].iter().map(|y| y * y).sum();
            assert!((square - 15.0 / (4.0 * std::f64::consts::PI)).abs() < 1e-12);
        }
    }
}
