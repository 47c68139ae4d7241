//! What is compared.

use gaunt::exponential::{Exponential, FINENESSES};
use sh_codegen::sampled::Fineness;

/// What stands for a blocker in a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Logarithm {
    /// Its visibility: nothing is summed, everything multiplied.
    None,
    /// Fitted to the exponential.
    Fitted,
    /// By eigenanalysis (Ren et al. 2006, eq. 30–32).
    Eigen,
    /// Clipped samples, projected (eq. 25).
    Samples,
}

impl Logarithm {
    /// The name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Fitted => "fitted",
            Self::Eigen => "eigen",
            Self::Samples => "samples",
        }
    }
}

/// One way from blockers to a visibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    /// None for the product of all visibilities.
    pub exponential: Option<Exponential>,
    /// What is exponentiated the sum of.
    pub logarithm: Logarithm,
}

impl Method {
    /// The exponential's name at an order.
    pub fn name(&self, order: usize) -> String {
        match self.exponential {
            None => "product chain".into(),
            Some(exponential) => exponential.name(order),
        }
    }
}

/// All methods. Degree 21 is that of Figure 9 of Ren et al. 2006; degree 6 shows what terms beyond the second
/// gain.
pub fn all() -> Vec<Method> {
    let mut methods = vec![
        Method {
            exponential: None,
            logarithm: Logarithm::None,
        },
        // Its logarithm is no other's.
        Method {
            exponential: Some(Exponential::Saturating),
            logarithm: Logarithm::Fitted,
        },
    ];
    let sampled = FINENESSES.map(Exponential::Sampled);
    let products = [
        Exponential::Series(21),
        Exponential::Factored(2),
        Exponential::Factored(6),
        Exponential::OptimalLinear,
        Exponential::Hybrid,
        Exponential::Eigen,
    ];
    for exponential in sampled.into_iter().chain(products) {
        let logarithms: &[Logarithm] = match exponential {
            // What the number of points does is seen with one logarithm.
            Exponential::Sampled(Fineness::Coarse | Fineness::Fine) => &[Logarithm::Fitted],
            _ => &[Logarithm::Fitted, Logarithm::Eigen, Logarithm::Samples],
        };
        methods.extend(logarithms.iter().map(|logarithm| Method {
            exponential: Some(exponential),
            logarithm: *logarithm,
        }));
    }
    methods
}
