//! Against closed forms, circles of latitude, cells, samples, and itself after a turn.

use super::*;
use crate::basis::{basis, distance, index};
use crate::quadrature::gauss_legendre;
use crate::rotation::{about, rotate, turn};
use crate::testing::{assert_close, numbers};
use crate::vec3::normalize;
use crate::zonal::rotated;
use crate::{blockers, cap, sampled, visibility};

/// Truth by other means: integrals over circles of latitude, exact in azimuth, by Gauss-Legendre in height
/// between all heights where an edge begins, ends or meets another, with the nodes' density such that
/// square roots at the ends are smooth.
fn by_latitude(order: usize, caps: &[Cap], nodes: usize) -> Vec<f64> {
    let mut cuts = vec![-1.0, 1.0];
    for (i, a) in caps.iter().enumerate() {
        let polar = a.axis[2].clamp(-1.0, 1.0).acos();
        cuts.extend([(polar + a.angle).cos(), (polar - a.angle).cos()]);
        for b in &caps[..i] {
            cuts.extend(meeting_heights(a, b));
        }
    }
    cuts.sort_by(f64::total_cmp);
    let rule = gauss_legendre(nodes, -FRAC_PI_2, FRAC_PI_2);
    let mut sum = vec![0.0; order * order];
    for ends in cuts.windows(2) {
        let (middle, half) = (0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0]));
        if half < 1e-15 {
            continue;
        }
        for (t, w) in &rule {
            let z = middle + half * t.sin();
            add_latitude(&mut sum, order, w * half * t.cos(), z, caps);
        }
    }
    sum
}

/// Heights where two edges meet: points α a + β b ± γ a×b.
fn meeting_heights(a: &Cap, b: &Cap) -> Vec<f64> {
    let (d, ca, cb) = (dot(a.axis, b.axis), a.angle.cos(), b.angle.cos());
    let det = 1.0 - d * d;
    let (alpha, beta) = ((ca - d * cb) / det, (cb - d * ca) / det);
    let gamma2 = (1.0 - alpha * ca - beta * cb) / det;
    if gamma2.is_nan() || gamma2 < 0.0 {
        return Vec::new();
    }
    let (z, aside) = (
        alpha * a.axis[2] + beta * b.axis[2],
        gamma2.sqrt() * cross(a.axis, b.axis)[2],
    );
    vec![(z + aside).clamp(-1.0, 1.0), (z - aside).clamp(-1.0, 1.0)]
}

fn add_latitude(sum: &mut [f64], order: usize, weight: f64, z: f64, caps: &[Cap]) {
    let r = ((1.0 - z) * (1.0 + z)).max(0.0).sqrt();
    let mut covered = vec![(TAU, TAU)];
    for cap in caps {
        let [x, y, h] = cap.axis;
        let (above, below) = (cap.angle.cos() - z * h, r * (x * x + y * y).sqrt());
        if above <= -below {
            return;
        }
        if above < below {
            let width = (above / below).acos();
            let from = (y.atan2(x) - width).rem_euclid(TAU);
            covered.push((from, from + 2.0 * width));
            covered.push((from - TAU, from + 2.0 * width - TAU));
        }
    }
    covered.sort_by(|a, b| a.0.total_cmp(&b.0));
    let y = basis(order, [r, 0.0, z]);
    let mut until = 0.0;
    for (from, to) in covered {
        for m in 0..order {
            let k = m as f64;
            let (cos, sin) = match m {
                _ if from <= until => break,
                0 => (from - until, 0.0),
                _ => (
                    ((k * from).sin() - (k * until).sin()) / k,
                    ((k * until).cos() - (k * from).cos()) / k,
                ),
            };
            for l in m..order {
                let plus = index(l, m as isize);
                sum[plus] += weight * y[plus] * cos;
                if m > 0 {
                    sum[index(l, -(m as isize))] += weight * y[plus] * sin;
                }
            }
        }
        until = to.max(until);
    }
}

fn turned(caps: &[Cap], q: [f64; 4]) -> Vec<Cap> {
    caps.iter()
        .map(|cap| Cap {
            axis: turn(q, cap.axis),
            ..*cap
        })
        .collect()
}

#[test]
fn one_cap_is_its_closed_form() {
    let poles = [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    for axis in directions(20).chain(poles) {
        // Through the pole of the coordinates, too.
        let polar = crate::vec3::angle(axis, poles[0]);
        for angle in [1e-9, 1e-3, 0.4, FRAC_PI_2, 2.0, PI - 1e-3, polar] {
            let found = project(8, &[Cap { axis, angle }]);
            let truth = rotated(&cap::visibility(8, angle), axis);
            assert_close(&found.coefficients, &truth, 3e-14);
        }
    }
}

#[test]
fn disjoint_caps_add_and_nested_ones_do_not() {
    let up = [0.0, 0.0, 1.0];
    let [outer, apart] =
        [(up, 0.6), ([0.6, 0.0, -0.8], 0.7)].map(|(axis, angle)| Cap { axis, angle });
    let inner = |tilt: f64| Cap {
        axis: [tilt.sin(), 0.0, tilt.cos()],
        angle: 0.4,
    };
    let mut truth = rotated(&cap::visibility(6, 0.6), up);
    accumulate(
        &mut truth,
        -1.0,
        &rotated(&cap::blocked(6, 0.7), apart.axis),
    );
    // The last one touches from within.
    for tilt in [0.0, 1e-9, 0.1, 0.2] {
        let found = project(6, &[inner(tilt), outer, apart, inner(-tilt)]);
        assert_close(&found.coefficients, &truth, 2e-14);
        assert!(distance(&found.coefficients, &truth) < found.error);
    }
}

#[test]
fn sets_agree_with_latitudes() {
    let sets = blockers::random(5, 30);
    for caps in sets.iter().chain(&blockers::heavy(5, 20)) {
        let found = project(7, caps);
        let off = distance(&found.coefficients, &by_latitude(7, caps, 128));
        assert!(off < 1e-12, "{off:e} off with {} caps", caps.len());
        assert!(off < found.error && found.error < 1e-10);
    }
}

#[test]
fn sets_agree_with_cells_and_samples() {
    let sets = blockers::random(9, 4);
    for caps in sets.iter().chain(&blockers::heavy(9, 2)) {
        let found = project(6, caps).coefficients;
        let cells = visibility::project(6, caps, 1e-2);
        let off = distance(&found, &cells.coefficients);
        assert!(off < cells.error && off < 2e-4, "{off:e} off the cells");
        let lit = |s| f64::from(u8::from(visibility::visible(caps, s)));
        let samples = sampled::project(6, 200_000, lit);
        let off = distance(&found, &samples.coefficients);
        assert!(off < samples.error && off < 2e-3, "{off:e} off the samples");
    }
}

#[test]
fn thousands_of_one_cap_are_one() {
    for angle in [0.05, 0.7, 2.5] {
        let found = project(6, &blockers::stacked(angle, 4096)[0]);
        assert_close(
            &crate::zonal::axial(&found.coefficients),
            &cap::visibility(6, angle),
            1e-14,
        );
    }
}

#[test]
fn a_turn_about_z_turns_the_vector() {
    let q = about([0.0, 0.0, 1.0], 2.1);
    for caps in blockers::random(13, 50) {
        let expected = rotate(&project(6, &caps).coefficients, q);
        assert_close(
            &project(6, &turned(&caps, q)).coefficients,
            &expected,
            1e-14,
        );
    }
}

/// Contacts, points where many edges meet, opposite caps, coverings that just close, all of them disturbed
/// by nothing, rounding, or more. The truth is found by turning the set, so that it is rounded elsewhere,
/// and roughly by latitudes.
#[test]
fn the_estimate_holds_where_edges_touch_and_coincide() {
    let around: Vec<Vec3> = (0..27)
        .filter(|i| *i != 13)
        .map(|i| normalize([i % 3, i / 3 % 3, i / 9].map(|c| c as f64 - 1.0)))
        .collect();
    let mut numbers = numbers(77, 100_000).into_iter().map(|n| 0.5 * (n + 1.0));
    let mut below = |n: usize| (numbers.next().unwrap() * n as f64) as usize;
    let mut closed = 0;
    for round in 0..600 {
        let jitter = [
            0.0, 1e-16, 1e-14, 1e-13, 1e-12, 1e-11, 1e-9, 1e-6, 1e-3, 0.1,
        ][round % 10];
        let pivot = below(26);
        let caps: Vec<Cap> = (0..1 + below(12))
            .map(|_| {
                let (a, b) = (around[below(26)], around[below(26)]);
                let between = crate::vec3::angle(a, b);
                let (axis, angle) = match round / 10 % 4 {
                    0 => (around[pivot], 0.7),
                    1 => (a, (15.0 * (1 + below(5)) as f64).to_radians()),
                    2 => (a, 0.5 * between),
                    _ => (a, between.min(PI - between)),
                };
                let mut disturbance = || jitter * (below(1 << 20) as f64 / 1e6 - 0.5);
                Cap {
                    axis: normalize(axis.map(|c| c + disturbance())),
                    angle: angle * (1.0 + disturbance()),
                }
            })
            .collect();
        let q = about([0.6, 0.48, 0.64], round as f64);
        let caps_turned = turned(&caps, q);
        let [found, other] = [&caps, &caps_turned].map(|caps| project(6, caps));
        let off = distance(&other.coefficients, &rotate(&found.coefficients, q));
        assert!(off <= found.error + other.error, "{off:e} off: {caps:?}");
        assert!(found.error < 2e-11, "{:e}: {caps:?}", found.error);
        if round % 3 == 0 {
            let rough = by_latitude(6, &caps_turned, 40);
            let off = distance(&other.coefficients, &rough);
            assert!(off < 1e-5, "{off:e} off the latitudes: {caps:?}");
        }
        closed += usize::from(found.coefficients[0] == 0.0);
    }
    assert!((1..100).contains(&closed));
}

#[test]
fn everything_and_nothing() {
    let cap = |axis, angle| Cap { axis, angle };
    let one = crate::product::one(4);
    for none in [
        &[][..],
        &[cap([0.0, 1.0, 0.0], 0.0)],
        &[cap([1.0, 0.0, 0.0], -1.0)],
    ] {
        assert_close(&project(4, none).coefficients, &one, 1e-15);
    }
    let halves = [1.0, -1.0].map(|z| cap([0.0, 0.0, z], FRAC_PI_2));
    let axes: Vec<Cap> = (0..6)
        .map(|i| {
            let mut axis = [0.0; 3];
            axis[i / 2] = if i % 2 == 0 { 1.0 } else { -1.0 };
            cap(axis, 0.96)
        })
        .collect();
    let wide = [cap([0.0, 0.3, 0.0], PI), cap([1.0, 0.0, 0.0], 0.1)];
    for all in [&halves[..], &axes, &wide, &[cap([1.0, 1.0, 0.0], 9.0)]] {
        assert_eq!(project(4, all).coefficients, [0.0; 16]);
    }
    // Six caps that leave eight little holes: the corners of a cube are 0.9553 from its faces.
    let holes: Vec<Cap> = axes.iter().map(|c| Cap { angle: 0.95, ..*c }).collect();
    let found = project(4, &holes).coefficients;
    assert!(found[0] > 1e-5 && found[0] < 1e-3, "{}", found[0]);
}

#[test]
fn numbers_of_any_size_stay_finite() {
    for size in [1e-310, 1e-160, 1.0, 1e160, 1e308] {
        for angle in [1e-310, 1e-13, 1e-7, 1.0, PI - 1e-9, PI.next_down(), 1e308] {
            let caps = [
                [size, 0.0, size],
                [0.0, 0.0, size],
                [size, 0.0, 0.999 * size],
            ]
            .map(|axis| Cap { axis, angle });
            let found = project(3, &caps);
            assert!(found.coefficients.iter().all(|c| c.is_finite()) && found.error < 1e-11);
        }
    }
}

#[test]
#[should_panic(expected = "cap 1 has no direction")]
fn an_axis_of_0_is_refused() {
    let cap = |z| Cap {
        axis: [0.0, 0.0, z],
        angle: 0.5,
    };
    project(2, &[cap(1.0), cap(0.0)]);
}
