//! Nothing of the sky is left: at most a thousandth of the light may get through.

use crate::blockers::{FULL, NUMBERS, error, lattice, visibility};
use sh_reference::{arcs, visibility::Cap};
use sh_tests::call::call_f64;
use sh_tests::worst::worst;

fn caps(degrees: f64, axes: impl IntoIterator<Item = [f64; 3]>) -> Vec<Cap> {
    let angle = degrees.to_radians();
    axes.into_iter().map(|axis| Cap { axis, angle }).collect()
}

/// Arrangements that hide everything.
fn arrangements() -> Vec<(String, Vec<Cap>)> {
    let both = |x: [f64; 3]| [x, x.map(|x| -x)];
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let third = 3.0_f64.sqrt().recip();
    let mut all = vec![
        ("two half spaces along z".into(), caps(90.0, both(axes[2]))),
        (
            "two half spaces askew".into(),
            caps(90.0, both([0.36, 0.48, 0.8])),
        ),
        (
            "two half spaces along a diagonal".into(),
            caps(90.0, both([third; 3])),
        ),
        (
            "six caps of 56 degrees on the axes".into(),
            caps(56.0, axes.into_iter().flat_map(both)),
        ),
    ];
    for (count, degrees) in [
        (64, 30.0),
        (64, 45.0),
        (128, 30.0),
        (256, 30.0),
        (400, 20.0),
        (1000, 10.0),
    ] {
        all.push((
            format!("{count} caps of {degrees} degrees on a lattice"),
            caps(degrees, lattice(count)),
        ));
    }
    all
}

/// A cap of 90 degrees hides half the sky whatever its place, and two opposite ones hide all. At order 5 their
/// logarithms, each the other's mirror image, have sums of only −0.8 about their poles (−4 and less all around
/// the horizon between them), where the saturating function needs −1 for full darkness after compression: what
/// gets through there is a known exception from the thousandth.
const HALF_SPACES_OF_ORDER_5: f64 = 6e-3;

#[test]
fn total_occlusion_is_dark() {
    for (name, caps) in arrangements() {
        let truth = arcs::project(4, &caps).coefficients[0] / FULL;
        assert!(truth.abs() < 1e-12, "{name} leaves {truth} of the sky");
        for order in 2..=6 {
            for (number, call) in NUMBERS {
                let through = visibility(call, order, &caps)[0] / FULL;
                let half_spaces = order == 5 && name.starts_with("two half spaces");
                let most = if half_spaces {
                    HALF_SPACES_OF_ORDER_5
                } else {
                    1e-3
                };
                assert!(
                    through <= most,
                    "order {order}, {number}, {name}: {through:.1e} of the light gets through"
                );
                // An exception that is needed no longer has to go.
                assert!(
                    !half_spaces || through > 1e-3,
                    "order {order}, {name}: {through:.1e}"
                );
            }
        }
    }
}

/// How many caps a cover has at most.
const MOST: usize = 8;

/// Caps that together hide all of the sky, of three numbers each in 0..1 and two for all: how many there are, and by how
/// much they are wider than they have to be. None where even half spaces about these axes leave something.
fn cover(numbers: &[f64; 3 * MOST + 2]) -> Option<Vec<Cap>> {
    let count = 2 + ((MOST - 1) as f64 * numbers[0]) as usize;
    let mut caps: Vec<Cap> = numbers[2..]
        .chunks(3)
        .take(count.min(MOST))
        .map(|of| {
            let (z, turn) = (2.0 * of[0] - 1.0, std::f64::consts::TAU * of[1]);
            let flat = (1.0 - z * z).max(0.0).sqrt();
            Cap {
                axis: [flat * turn.cos(), flat * turn.sin(), z],
                angle: 0.3 + 1.2 * of[2],
            }
        })
        .collect();
    // The least factor with which every direction is in one of them.
    let factor = lattice(2000).map(|d| {
        let shares = caps.iter().map(|cap| {
            let cos: f64 = cap.axis.iter().zip(d).map(|(a, d)| a * d).sum();
            cos.clamp(-1.0, 1.0).acos() / cap.angle
        });
        shares.fold(f64::MAX, f64::min)
    });
    // Directions between those of the lattice are up to 3 degrees away.
    let factor = factor.fold(0.0, f64::max) * (1.0 + 0.3 * numbers[1]) + 0.06;
    let half = std::f64::consts::FRAC_PI_2;
    if caps
        .iter()
        .map(|cap| cap.angle * factor)
        .fold(0.0, f64::max)
        > half + 1e-9
    {
        return None;
    }
    caps.iter_mut().for_each(|cap| cap.angle *= factor);
    Some(caps)
}

/// What is left behind any cover of the sky by two to eight caps, looked for.
#[test]
fn any_cover_is_dark() {
    for (order, most) in COVERED {
        let (left, at) = worst(order as u64, 1200, |numbers| {
            cover(&numbers).map_or(0.0, |caps| visibility(call_f64, order, &caps)[0] / FULL)
        });
        println!("order {order}: {left:.2e}");
        let caps = cover(&at);
        assert!(
            left <= most,
            "order {order}: {left:.1e} is left by {caps:?}"
        );
    }
}

/// By order.
const COVERED: [(usize, f64); 5] = [(2, 1.0), (3, 1.0), (4, 1.0), (5, 1.0), (6, 1.0)];

/// The light itself comes back unharmed where nothing is in its way.
#[test]
fn no_blocker_is_full_visibility() {
    for order in 2..=6 {
        for (number, call) in NUMBERS {
            let g = visibility(call, order, &[]);
            let one: Vec<f64> = (0..order * order)
                .map(|i| if i == 0 { FULL } else { 0.0 })
                .collect();
            assert!(error(&g, &one) < 1e-6, "order {order}, {number}: {g:?}");
        }
    }
}
