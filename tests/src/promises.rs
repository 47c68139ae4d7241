//! What every generated routine promises at the edges of the numbers' range: one table.
//!
//! Zeros of both signs and denormals in any element of a vector are numbers like others for every routine: the
//! result is finite and as accurate as elsewhere.

use crate::case::is_vector;
use sh_codegen::routines::Routine;

/// What a result says of an argument that is not a number or infinite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Poison {
    /// Every result that depends on the element is not finite: nothing wrong passes for a number.
    Shows,
    /// Results are finite and within the routine's bound, or NaN; never infinite.
    Bounded(f64),
}

/// Up to which magnitude of its vectors a routine of f32 is finite, up to which it is accurate, and what it makes of
/// infinities and NaN.
pub struct Promise {
    /// The routine's name.
    pub routine: &'static str,
    /// The largest magnitude of a vector's elements for which it is finite, and within its bound where it has one.
    pub largest: f32,
    /// The largest for which it is as accurate as at 1.
    pub accurate: f32,
    /// What comes of what is not finite.
    pub poison: Poison,
}

const fn promise(routine: &'static str, largest: f32, poison: Poison) -> Promise {
    Promise {
        routine,
        largest,
        accurate: largest,
        poison,
    }
}

impl Promise {
    /// The same, as accurate as at 1 up to another magnitude.
    const fn accurate_to(self, accurate: f32) -> Self {
        Self { accurate, ..self }
    }
}

/// The largest norm over √(4π) that samples of up to `h` and the largest gain of a band can make.
const fn bound(h: f64) -> Poison {
    Poison::Bounded(h * sh_core::ROOT_FOUR_PI * 1.03)
}

/// Arguments of which a value that is not finite means something: tested one by one below.
pub const MEANT: [(&str, &str); 2] = [("window", "h"), ("optimal_linear_wide", "norm")];

/// Compression tells norms up to 3e18 apart; 36 coefficients of this magnitude have a norm of at most 6e17.
const COMPRESSED: f32 = 1e17;

/// The norm of arguments beyond which an exponential at samples, whose values are of the size of 1 whatever goes in, may err no
/// more: rounding of x makes e^x err by as much as x is long, until all samples are clamped or dark.
pub const LONGEST: f64 = 64.0;

/// Magnitudes are of every coefficient; directions, quaternions, matrices and angles are as they should be.
pub const PROMISES: &[Promise] = &[
    promise("basis", 1.0, Poison::Shows),
    promise("cosine", 1.0, Poison::Shows),
    promise("zonal", 1e37, Poison::Shows),
    promise("product", 1e17, Poison::Shows),
    promise("square", 1e17, Poison::Shows),
    promise("product_cosine", 1e36, Poison::Shows),
    promise("triple", 1e11, Poison::Shows),
    promise("dot", 1e17, Poison::Shows),
    promise("product_matrix", 1e36, Poison::Shows),
    promise("matrix_apply", 1e17, Poison::Shows),
    promise("rotate", 1e36, Poison::Shows),
    promise("rotate_matrix", 1e36, Poison::Shows),
    promise("window", 1e37, Poison::Shows),
    promise("cap_visibility", 1.0, Poison::Shows),
    promise("cap_log", 1.0, Poison::Shows),
    promise("cap_log_saturating", 1.0, Poison::Shows),
    promise("add_cap_log", 1e37, Poison::Shows),
    promise("add_cap_log_saturating", 1e37, Poison::Shows),
    promise("cap_log_shading", 1.0, Poison::Shows),
    promise("accumulate_blocker", 1e35, Poison::Shows),
    promise("accumulate_blocker_saturating", 1e35, Poison::Shows),
    promise("accumulated_log", 1e35, Poison::Shows),
    promise("ball_average", 1.0, Poison::Shows),
    promise("disc_covered", 1.0, Poison::Bounded(1.0)),
    promise("exp_saturating", f32::MAX, bound(1.2996)).accurate_to(COMPRESSED),
    promise("transfer", f32::MAX, Poison::Bounded(0.85)).accurate_to(COMPRESSED),
    promise("transfer_lobe", f32::MAX, Poison::Bounded(17.0)).accurate_to(COMPRESSED),
    promise("gloss_lobe", 1.0, Poison::Bounded(3.0)),
    promise("gloss_told", 1.0, Poison::Bounded(2.0)),
    promise("gloss_tilt", 1.0, Poison::Bounded(1.0)),
    promise("gloss_energy", 1.0, Poison::Bounded(1.5)),
    promise("horizon_radius", 1.0, Poison::Bounded(3.0)),
    promise("exp_sampled", 1e36, bound(1.1619)),
    promise("exp_sampled_coarse", 1e36, bound(1.1619)),
    promise("exp_sampled_fine", 1e36, bound(1.1619)),
    promise("optimal_linear", 1.0, Poison::Shows),
    promise("optimal_linear_wide", f32::MAX, Poison::Shows),
];

/// What is promised of a routine.
///
/// # Panics
/// If the table leaves it out.
pub fn promised(routine: &Routine) -> &'static Promise {
    PROMISES
        .iter()
        .find(|p| p.routine == routine.name)
        .unwrap_or_else(|| panic!("nothing is promised of `{}`", routine.name))
}

/// Makes a routine's vectors larger by so much: at most as large as it promises to take them.
pub fn enlarge(routine: &Routine, arguments: &mut [Vec<f32>], largest: f32) {
    for (a, (name, shape)) in arguments.iter_mut().zip(routine.arguments) {
        if is_vector(*shape) || *name == "norm" && largest > 1.0 {
            a.iter_mut().for_each(|x| *x *= largest);
        }
    }
}
