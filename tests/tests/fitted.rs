//! Fitted functions against what they were fitted to: exact integrals and areas, true visibilities and transfers. What a
//! routine's documentation says it errs by is the bound here, and each bound is far below what the function is worth: the
//! largest value of what it stands for, or what the next simpler answer would miss.

use sh_core::{ROOT_FOUR_PI, Routines};
use sh_reference as reference;
use sh_reference::lens::{covered, covered_on_sphere};
use sh_tests::every_order;

fn distance(a: &[f64], b: &[f64]) -> f64 {
    reference::basis::distance(a, b)
}

/// The mean of each band over what is seen of a ball, at any distance: its integral, to 3e-6. (A disc that is lit evenly,
/// band 0 alone, would miss by up to 1.)
#[test]
fn what_is_seen_of_a_ball_is_its_integral() {
    let mut worst = [0.0_f64; 6];
    for i in 0..=1000 {
        let sine = f64::from(i) / 1000.0;
        let cosine = (1.0 - sine * sine).max(0.0).sqrt();
        let up = [0.0, 0.0, 1.0];
        let weights = <[f64; 36]>::ball_average(sine, cosine, up);
        let means = reference::ball::means(6, sine.min(1.0 - 1e-9));
        let basis = reference::basis::basis(6, up);
        for (l, mean) in means.iter().enumerate() {
            let at = l * l + l;
            worst[l] = worst[l].max((weights[at] / basis[at] - mean).abs());
        }
    }
    println!("largest error of each band {worst:?}");
    assert!(worst.iter().all(|off| *off < 3.5e-6), "{worst:?}");
}

/// What a disc covers of another, flat: to .016. (A straight edge, whatever the radii, would miss by .1.)
#[test]
fn a_disc_covers_what_the_lens_of_two_circles_says() {
    let mut worst = 0.0_f64;
    for i in 1..=100 {
        let ratio = f64::from(i) / 100.0;
        for j in 0..=200 {
            let depth = f64::from(j) / 200.0;
            let apart = 0.3 * (1.0 + ratio - 2.0 * ratio * depth);
            let found = <[f64; 4]>::disc_covered(0.3 * ratio, 0.3, apart);
            worst = worst.max((found - covered(ratio, depth)).abs());
            // The larger is covered in proportion.
            let larger = <[f64; 4]>::disc_covered(0.3, 0.3 * ratio, apart);
            worst = worst.max((larger - ratio * ratio * covered(ratio, depth)).abs());
        }
    }
    println!("largest error {worst:.4}");
    assert!(worst < 0.016, "{worst}");
}

/// The same on the sphere, where discs really are: by the largest radius, in degrees, and what it errs by at most.
#[test]
fn a_disc_in_the_sky_covers_what_caps_on_the_sphere_say() {
    for (largest, bound) in [
        (20, 0.0165),
        (40, 0.0205),
        (60, 0.045),
        (80, 0.087),
        (90, 0.12),
    ] {
        let (mut worst, mut at) = (0.0_f64, [0.0; 3]);
        let (mut squares, mut count) = (0.0, 0.0);
        let largest = f64::from(largest).to_radians();
        for i in 1..=40 {
            let a = largest * f64::from(i) / 40.0;
            for j in 1..=40 {
                let b = largest * f64::from(j) / 40.0;
                for k in 0..=80 {
                    let d = (a - b).abs() + (a + b - (a - b).abs()) * f64::from(k) / 80.0;
                    let off = <[f64; 4]>::disc_covered(a, b, d) - covered_on_sphere(a, b, d);
                    squares += off * off;
                    count += 1.0;
                    if off.abs() > worst {
                        (worst, at) = (off.abs(), [a, b, d].map(f64::to_degrees));
                    }
                }
            }
        }
        let mean = f64::sqrt(squares / count);
        println!(
            "up to {:.0} degrees: {worst:.4} at {at:.1?}, RMS {mean:.4}",
            largest.to_degrees()
        );
        assert!(worst < bound, "{worst}");
    }
}

/// What each exponential makes of its own logarithm of one cap is that cap's visibility, at any radius up to the horizon; without
/// a shadow .66 to .69 would be missed of the visibility, and 1 of an even sky's light on a surface that faces the cap.
#[test]
fn exponentials_give_back_the_visibility_of_a_cap() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        let order = <[f64; C]>::ORDER;
        let up = [0.0, 0.0, 1.0];
        let (mut worst, mut none) = (0.0_f64, 0.0_f64);
        let (mut worst_share, mut at_share) = (0.0_f64, 0.0_f64);
        let one = reference::product::one(order);
        for degree in 1..=90 {
            let angle = f64::from(degree).to_radians();
            let (sin, cos) = angle.sin_cos();
            let truth = reference::zonal::upright(&reference::cap::visibility(order, angle));
            let log = <[f64; C]>::zonal(<[f64; C]>::cap_log_saturating(sin, cos), up);
            let off = distance(&log.exp_saturating(), &truth) / ROOT_FOUR_PI;
            worst = worst.max(off);
            none = none.max(distance(&one, &truth) / ROOT_FOUR_PI);
            // The light of an even sky that a surface facing the cap gets: 1 − sin² θ.
            let log = <[f64; C]>::zonal(<[f64; C]>::cap_log_shading(sin, cos), up);
            let share = log.transfer(up)[0] * ROOT_FOUR_PI;
            let off = (share - cos * cos).abs();
            if off > worst_share {
                (worst_share, at_share) = (off, f64::from(degree));
            }
        }
        println!(
            "order {order}: visibility {worst:.4} of {none:.4}, light {worst_share:.4} at {at_share}"
        );
        let (visibility, light) = match order {
            2 => (0.09, 0.055),
            3 => (0.05, 0.078),
            4 => (0.04, 0.012),
            5 => (0.028, 0.008),
            _ => (0.024, 0.018),
        };
        assert!(
            worst < visibility && worst_share < light,
            "order {order}: {worst} {worst_share}"
        );
    }
    every_order!(check);
}

/// The factors of the optimal linear exponential for small norms are those of circles: a and b, which leave 1 by up to .0024 and
/// .09, to a ten-thousandth of that.
#[test]
fn linear_factors_of_small_norms_are_those_of_circles() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        let order = <[f64; C]>::ORDER;
        let (mut worst, mut most) = ([0.0_f64; 2], [0.0_f64; 2]);
        for degree in 1..=160 {
            let angle = f64::from(degree).to_radians() / 4.0;
            let g = reference::zonal::upright(&reference::cap::visibility(order, angle));
            let f = reference::log::eigen(&g, reference::log::CLIP).expect("something is visible");
            let norm = reference::basis::norm(&f[1..]);
            if norm > 0.25 {
                break;
            }
            let (a, b) = reference::exp::fit_linear(&g, &f);
            for (k, (ours, circle)) in <[f64; C]>::optimal_linear(norm)
                .into_iter()
                .zip([a, b])
                .enumerate()
            {
                worst[k] = worst[k].max((ours - circle).abs());
                most[k] = most[k].max((circle - 1.0).abs());
            }
        }
        println!("order {order}: errors {worst:?}, of {most:.4?}");
        assert!(
            worst[0] < 1e-7 && worst[1] < 4e-6,
            "order {order}: {worst:?}"
        );
    }
    every_order!(check);
}

/// What an order tells of a lobe is nowhere far below 0, from order 3 on; of one that is a fifth smoother it would be. (Two bands are,
/// whatever the lobe: those of the cosine by a third.)
#[test]
fn no_order_is_asked_for_a_lobe_that_rings() {
    fn told<const C: usize>() -> f64
    where
        [f64; C]: Routines<f64>,
    {
        <[f64; C]>::gloss_told(0.0)
    }
    assert_eq!(told::<4>(), 1.0);
    let all = [told::<9>(), told::<16>(), told::<25>(), told::<36>()];
    for (order, told) in (3..).zip(all) {
        let lowest = |roughness: f64| {
            let bands = <[f64; 36]>::gloss_lobe(roughness, 0.8);
            let zonal: Vec<f64> = (0..order)
                .map(|l| bands[l] * ((2 * l + 1) as f64 / (4.0 * std::f64::consts::PI)).sqrt())
                .collect();
            let values = (0..=400).map(|i| f64::from(i) / 200.0 - 1.0);
            let values = values.map(|t| reference::zonal::evaluate(&zonal, t));
            values.fold(0.0, f64::min) / reference::zonal::evaluate(&zonal, 1.0)
        };
        let (here, smoother) = (lowest(told), lowest(0.8 * told));
        println!("order {order}: {here:.4} of the peak, {smoother:.4} if it were smoother");
        assert!(here > -0.045 && smoother < -0.045, "order {order}");
    }
}

/// The lobe of a polished surface: what it mirrors, where it points and how wide it is, from roughness .1 on and from cosine .1 on.
/// (A mirror's lobe in the place of that of roughness 1 would miss band 1 by .3 and the energy by .6; an axis in the mirrored direction
/// would miss the tilt by 1.)
#[test]
fn a_polished_surface_has_the_lobe_that_its_facets_make() {
    let mut worst = [0.0_f64; 8];
    for i in 2..=20 {
        for j in 2..=19 {
            let (roughness, cosine) = (f64::from(i) / 20.0, f64::from(j) / 20.0);
            let sine = (1.0 - cosine * cosine).sqrt();
            let gloss =
                reference::gloss::Gloss::new(roughness, [0.0, 0.0, 1.0], [sine, 0.0, cosine]);
            let [x, z] = [0, 2].map(|k| gloss.sum(|d| d[k]));
            let (x, z) = (x / x.hypot(z), z / x.hypot(z));
            let [energy, grazing] = <[f64; 36]>::gloss_energy(roughness, cosine);
            worst[0] = worst[0].max((energy - gloss.energy()).abs());
            worst[1] = worst[1].max((grazing - gloss.grazing()).abs());
            let tilt = <[f64; 36]>::gloss_tilt(roughness, cosine);
            worst[2] = worst[2].max((tilt + x / sine).abs());
            let bands = <[f64; 36]>::gloss_lobe(roughness, cosine);
            for l in 1..6 {
                let about = |d: [f64; 3]| reference::ball::legendre(l, x * d[0] + z * d[2]);
                let mean = gloss.sum(about) / gloss.energy();
                worst[2 + l] = worst[2 + l].max((bands[l] - mean).abs());
            }
        }
    }
    println!("largest error of energy, grazing, tilt and bands {worst:.4?}");
    let bounds = [0.028, 0.033, 0.013, 0.011, 0.021, 0.024, 0.03, 0.038];
    for (worst, bound) in worst.iter().zip(bounds) {
        assert!(*worst < bound, "{worst} of {bound}");
    }
}
