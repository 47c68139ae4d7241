//! What a body hides of its own patches.

/// How much of a patch the rest of its body leaves to be seen: a quadratic function of the direction u that it is seen
/// from, b · u + uᵀ C u, held between 0 and 1. Only directions in front of the patch count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Escape {
    /// b.
    pub linear: [f32; 3],
    /// C: xx, yy, zz, and each of xy, yz, zx once.
    pub square: [f32; 6],
}

impl Escape {
    /// Nothing hides it.
    pub const OPEN: Self = Self {
        linear: [0.0; 3],
        square: [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    };

    /// The share that is seen from a direction.
    ///
    /// ```
    /// use sh_scene::basis::Escape;
    /// assert!((Escape::OPEN.seen([0.6, 0.0, 0.8]) - 1.0).abs() < 1e-6);
    /// ```
    pub fn seen(&self, [x, y, z]: [f32; 3]) -> f32 {
        let ([a, b, c], [xx, yy, zz, xy, yz, zx]) = (self.linear, self.square);
        let even = xx * x * x + yy * y * y + zz * z * z;
        let mixed = 2.0 * (xy * x * y + yz * y * z + zx * z * x);
        (a * x + b * y + c * z + even + mixed).clamp(0.0, 1.0)
    }
}
