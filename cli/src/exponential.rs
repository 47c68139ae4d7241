//! The exponentials by name: what `gaunt eval` computes and `gaunt-lab accuracy` compares.

use sh_codegen::sampled::{self, Fineness};
use sh_core::cap::{self, Fit};
use sh_core::exp::{self, Outlined};
use sh_core::log::Logarithm;
use sh_core::{Lane, Routines};
use std::fmt;

/// Most terms of a product series.
const MOST_TERMS: usize = 64;

/// Ways from a log visibility to a visibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exponential {
    /// `saturating`: a bounded function of samples.
    Saturating,
    /// `sampled`, or `sampled:50` by the number of points: e^x of samples, clamped.
    Sampled(Fineness),
    /// `ps:21`: the product series of a degree.
    Series(usize),
    /// `ps*:2`: the factored product series of a degree, scaled and squared.
    Factored(usize),
    /// `ol`: the optimal linear approximation.
    OptimalLinear,
    /// `hyb`: the same, scaled and squared.
    Hybrid,
    /// `eigen`: the limit of the product series, by eigenanalysis.
    Eigen,
}

/// A number to compute with.
pub trait Real: Lane + Default + Into<f64> {
    /// Rounded from double precision.
    fn round(value: f64) -> Self;
}

impl Real for f64 {
    fn round(value: f64) -> Self {
        value
    }
}

impl Real for f32 {
    fn round(value: f64) -> Self {
        value as f32
    }
}

impl Exponential {
    /// By its name, at an order. The error is a sentence's end: what the name is, and what there is.
    ///
    /// ```
    /// use gaunt::exponential::Exponential;
    /// assert_eq!(Exponential::parse("ps*:2", 4), Ok(Exponential::Factored(2)));
    /// assert!(Exponential::parse("sampled:7", 4).is_err());
    /// ```
    pub fn parse(text: &str, order: usize) -> Result<Self, String> {
        let degree = |prefix: &str| {
            let digits = text.strip_prefix(prefix)?;
            let degree: usize = digits.parse().ok()?;
            (1..=MOST_TERMS).contains(&degree).then_some(degree)
        };
        let by_points = || {
            let points: usize = text.strip_prefix("sampled:")?.parse().ok()?;
            FINENESSES
                .into_iter()
                .find(|fineness| sampled::points(order, *fineness) == points)
        };
        match text {
            "saturating" => return Ok(Self::Saturating),
            "sampled" => return Ok(Self::Sampled(Fineness::Medium)),
            "ol" => return Ok(Self::OptimalLinear),
            "hyb" => return Ok(Self::Hybrid),
            "eigen" => return Ok(Self::Eigen),
            _ => {}
        }
        let found = degree("ps*:").map(Self::Factored);
        let found = found.or_else(|| degree("ps:").map(Self::Series));
        let found = found.or_else(|| by_points().map(Self::Sampled));
        found.ok_or_else(|| {
            let points = FINENESSES.map(|fineness| sampled::points(order, fineness).to_string());
            format!(
                "\"{text}\", which is none of saturating, sampled, sampled:Q with Q = {} (at order {order}), \
                 ps*:N and ps:N with N from 1 to {MOST_TERMS}, ol, hyb and eigen",
                points.join(", ")
            )
        })
    }

    /// Its name at an order, which [`Self::parse`] reads.
    pub fn name(self, order: usize) -> String {
        match self {
            Self::Saturating => "saturating".into(),
            Self::Sampled(fineness) => format!("sampled:{}", sampled::points(order, fineness)),
            Self::Series(degree) => format!("ps:{degree}"),
            Self::Factored(degree) => format!("ps*:{degree}"),
            Self::OptimalLinear => "ol".into(),
            Self::Hybrid => "hyb".into(),
            Self::Eigen => "eigen".into(),
        }
    }

    /// The logarithm of a cap that is fitted to it. The eigen exponential is the limit of the series and takes
    /// theirs.
    pub fn fit(self) -> Fit {
        match self {
            Self::Saturating => Fit::Saturating,
            Self::Sampled(Fineness::Coarse) => Fit::SampledCoarse,
            Self::Sampled(Fineness::Medium) => Fit::Sampled,
            Self::Sampled(Fineness::Fine) => Fit::SampledFine,
            Self::Series(_) | Self::Factored(_) | Self::Eigen => Fit::Series,
            Self::OptimalLinear => Fit::OptimalLinear,
            Self::Hybrid => Fit::Hybrid,
        }
    }

    /// Of one vector. The eigen exponential is computed in double precision and rounded.
    pub fn of<L: Real, const C: usize>(self, f: &[L; C]) -> [L; C]
    where
        [L; C]: Routines<L>,
        [f64; C]: Logarithm,
    {
        match self {
            Self::Saturating => out_of_line(f, |f| f.exp_saturating()),
            Self::Sampled(Fineness::Coarse) => out_of_line(f, |f| f.exp_sampled_coarse()),
            Self::Sampled(Fineness::Medium) => out_of_line(f, |f| f.exp_sampled()),
            Self::Sampled(Fineness::Fine) => out_of_line(f, |f| f.exp_sampled_fine()),
            Self::Series(degree) => exp::product_series_by::<Outlined, L, C>(f, degree),
            Self::Factored(degree) => exp::ps_star_by::<Outlined, L, C>(f, degree),
            Self::OptimalLinear => out_of_line(f, |f| exp::optimal_linear(f)),
            Self::Hybrid => exp::hyb_by::<Outlined, L, C>(f),
            Self::Eigen => {
                let wide: [f64; C] = std::array::from_fn(|i| f[i].into());
                let g = Logarithm::exp(&wide);
                std::array::from_fn(|i| L::round(g[i]))
            }
        }
    }
}

/// Every rule that samples are taken on.
pub const FINENESSES: [Fineness; 3] = [Fineness::Coarse, Fineness::Medium, Fineness::Fine];

/// The eigen logarithm of the visibility beside a cap of angular radius `angle`: its zonal coefficients.
///
/// ```
/// // A cap without extent hides nothing: the logarithm of 1.
/// let log = gaunt::exponential::eigen_log::<16>(0.0);
/// assert!(log.len() == 4 && log.iter().all(|l| l.abs() < 1e-9));
/// ```
pub fn eigen_log<const C: usize>(angle: f64) -> Vec<f64>
where
    [f64; C]: Logarithm,
{
    let zonal = cap::visibility::<C>(angle);
    let log = <[f64; C]>::zonal(zonal, [0.0, 0.0, 1.0]).log();
    (0..<[f64; C]>::ORDER).map(|l| log[l * l + l]).collect()
}

/// A function of its own for each routine: all of them inlined into one would take minutes to compile.
#[inline(never)]
fn out_of_line<T: Copy, R>(f: &T, routine: impl Fn(&T) -> R) -> R {
    routine(f)
}

impl fmt::Display for Exponential {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sampled(Fineness::Coarse) => write!(f, "sampled (coarse)"),
            Self::Sampled(Fineness::Medium) => write!(f, "sampled"),
            Self::Sampled(Fineness::Fine) => write!(f, "sampled (fine)"),
            other => write!(f, "{}", other.name(4)),
        }
    }
}
