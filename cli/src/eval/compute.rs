//! Requests on the processor, by the routines of `sh-core`.

use super::{CapLog, LogMethod, Op, Request};
use crate::exponential::{self, Real};
use sh_core::log::{Logarithm, clipped_samples};
use sh_core::{OrderError, Routines, cap, for_order};

/// Degree of the rule that samples of a logarithm are taken on.
const SAMPLES_DEGREE: usize = 100;

/// What clipped samples are clipped to, from below (ε in Ren et al. 2006, eq. 25): as much as the eigen
/// logarithm leaves of the largest eigenvalue.
const SAMPLES_FLOOR: f64 = 0.02;

/// Computes a request with numbers of type `L`; what there is in double precision alone is computed so and
/// rounded. The error is a sentence.
pub fn compute<L: Real>(request: &Request) -> Result<Vec<f64>, String> {
    for_order!(
        request.order, C => Ok(of_order::<L, C>(&request.op)),
        else => Err(OrderError(request.order).to_string())
    )
}

fn of_order<L: Real, const C: usize>(op: &Op) -> Vec<f64>
where
    [L; C]: Routines<L>,
    [f64; C]: Logarithm,
{
    let vector = |f: &[f64]| -> [L; C] { std::array::from_fn(|i| L::round(f[i])) };
    let zonal = |values: &[f64]| {
        let mut z = <[L; C]>::cap_visibility(L::round(1.0), L::round(0.0));
        for (slot, value) in z.as_mut().iter_mut().zip(values) {
            *slot = L::round(*value);
        }
        z
    };
    match op {
        Op::Basis(dir) => wide(<[L; C]>::basis(dir.map(L::round))),
        Op::Cosine(dir) => wide(<[L; C]>::cosine(dir.map(L::round))),
        Op::Product(f, g) => wide(vector(f).product(&vector(g))),
        Op::Square(f) => wide(vector(f).square()),
        Op::Triple(f, g, h) => wide([vector(f).triple(&vector(g), &vector(h))]),
        Op::Rotate(f, quat) => wide(vector(f).rotate(quat.map(L::round))),
        Op::Zonal(z, dir) => wide(<[L; C]>::zonal(zonal(z), dir.map(L::round))),
        Op::Cap(angle) => wide(<[L; C]>::cap_visibility(
            L::round(angle.cos()),
            L::round(angle.sin()),
        )),
        Op::CapLog(angle, CapLog::Fitted) => wide(<[L; C]>::cap_log(
            L::round(angle.sin()),
            L::round(angle.cos()),
        )),
        Op::CapLog(angle, CapLog::FittedTo(fit)) => {
            rounded::<L>(cap::log_fitted_to::<C>(*fit, *angle))
        }
        Op::CapLog(angle, CapLog::Table) => rounded::<L>(cap::log_table::<C>(*angle)),
        Op::CapLog(angle, CapLog::Eigen) => rounded::<L>(exponential::eigen_log::<C>(*angle)),
        Op::CapLog(angle, CapLog::Samples) => rounded::<L>(clipped_samples::<C>(
            cap::visibility::<C>(*angle),
            SAMPLES_FLOOR,
        )),
        Op::Log(f, LogMethod::Eigen) => {
            let f: [f64; C] = std::array::from_fn(|i| f[i]);
            rounded::<L>(f.log())
        }
        Op::Log(f, LogMethod::Samples) => {
            rounded::<L>(sh_reference::log::samples(f, SAMPLES_FLOOR, SAMPLES_DEGREE))
        }
        Op::Exp(f, exponential) => wide(exponential.of(&vector(f))),
        Op::Window(f, h) => wide(vector(f).window(L::round(*h))),
    }
}

fn wide<L: Real>(values: impl AsRef<[L]>) -> Vec<f64> {
    values.as_ref().iter().map(|v| (*v).into()).collect()
}

fn rounded<L: Real>(values: impl AsRef<[f64]>) -> Vec<f64> {
    values
        .as_ref()
        .iter()
        .map(|v| L::round(*v).into())
        .collect()
}
