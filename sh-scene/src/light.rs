//! Environment light as SH vectors.

/// An environment's radiance as three SH vectors of one order, windowed, ready for the passes.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// SH order, 2 to 6.
    pub order: usize,
    /// `order²` coefficients, each red, green and blue.
    pub coefficients: Vec<[f32; 3]>,
}
