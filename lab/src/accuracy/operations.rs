//! Operations of the methods, from the generator's counts.

use super::methods::Method;
use gaunt::exponential::Exponential;
use sh_codegen::expr::Ops;
use sh_codegen::routines::find;
use sh_codegen::sampled::Fineness;

/// Operations a receiver, on average.
#[derive(Clone, Copy, Debug, Default)]
pub struct Operations {
    /// Multiplications; a division or a root counts as one.
    pub mul: f64,
    /// Additions; a minimum or maximum counts as one.
    pub add: f64,
    /// Exponentials of numbers.
    pub exp: f64,
}

impl Operations {
    fn plus(self, times: f64, ops: Ops) -> Self {
        Self {
            mul: self.mul + times * ops.mul as f64,
            add: self.add + times * ops.add as f64,
            exp: self.exp + times * ops.exp as f64,
        }
    }
}

/// Operations of a method for `blockers` blockers. Squares come as often as the vectors of the random sets are
/// halved on average; the scaling around them, linear in the coefficients, is counted, the eigenanalysis is not.
pub fn of_method(method: &Method, order: usize, blockers: f64, halvings: f64) -> Operations {
    let ops = |name: &str| find(name).expect("a routine of this name").ops(order);
    let coefficients = order * order;
    let none = Operations::default();
    let Some(exponential) = method.exponential else {
        let each = none
            .plus(blockers, ops("cap_visibility"))
            .plus(blockers, ops("zonal"));
        return each.plus(blockers - 1.0, ops("product"));
    };
    let blocker = match exponential {
        Exponential::Saturating => "add_cap_log_saturating",
        _ => "add_cap_log",
    };
    let sum = none.plus(blockers, ops(blocker));
    // A term's weight, or what isolating the mean and scaling does to each coefficient.
    let scaling = |times: usize| Ops {
        mul: times * coefficients,
        add: times * coefficients,
        exp: 0,
    };
    let mean = Ops {
        mul: 1,
        add: 0,
        exp: 1,
    };
    match exponential {
        Exponential::Saturating => sum.plus(1.0, ops("exp_saturating")),
        Exponential::Sampled(Fineness::Coarse) => sum.plus(1.0, ops("exp_sampled_coarse")),
        Exponential::Sampled(Fineness::Medium) => sum.plus(1.0, ops("exp_sampled")),
        Exponential::Sampled(Fineness::Fine) => sum.plus(1.0, ops("exp_sampled_fine")),
        Exponential::Series(degree) => sum
            .plus((degree - 1) as f64, ops("product"))
            .plus(1.0, scaling(degree)),
        Exponential::Factored(degree) => {
            let products = match degree {
                0..=2 => 0,
                degree => degree / 2,
            };
            sum.plus(halvings + 1.0, ops("square"))
                .plus(products as f64, ops("product"))
                .plus(1.0, scaling(degree + 1))
                .plus(1.0, ops("dot"))
                .plus(1.0, mean)
        }
        Exponential::OptimalLinear => sum
            .plus(1.0, ops("optimal_linear_wide"))
            .plus(1.0, ops("dot"))
            .plus(1.0, scaling(1))
            .plus(1.0, mean),
        Exponential::Hybrid => sum
            .plus(halvings, ops("square"))
            .plus(1.0, ops("optimal_linear"))
            .plus(1.0, ops("dot"))
            .plus(1.0, scaling(2))
            .plus(1.0, mean),
        // Both products with the eigenvectors; the eigenanalysis itself is iterative.
        Exponential::Eigen => sum
            .plus(1.0, ops("product_matrix"))
            .plus(2.0 * coefficients as f64, scaling(1)),
    }
}
