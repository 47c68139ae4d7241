//! Clusters of receivers with cuts of a hierarchy, against the same pass without one.

mod common;

use common::{Random, light_of, receiver};
use glam::{Vec3, vec3};
use sh_cpu::{CutOptions, Cuts, Path, Shadow, bake, shadow_clusters};
use sh_scene::{Clusters, Forest, Light, Limits, Receiver, Sphere};
use std::ops::Range;

/// A floor of `side` by `side` receivers, 12 m wide, and bodies over it: swarms of small spheres.
fn scene(side: usize) -> (Vec<Receiver>, Vec<Sphere>, Vec<usize>) {
    let floor = (0..side * side).map(|i| {
        let at = |i: usize| 12.0 * ((i as f32 + 0.5) / side as f32 - 0.5);
        receiver(vec3(at(i % side), 0.0, at(i / side)), Vec3::Y)
    });
    let mut random = Random(7);
    let mut spheres = Vec::new();
    let mut counts = Vec::new();
    for place in [
        vec3(-3.0, 1.0, 1.0),
        vec3(2.5, 1.4, -2.0),
        vec3(1.0, 0.8, 3.0),
    ] {
        for _ in 0..40 {
            let center = place + random.direction() * random.within(0.0, 0.7);
            spheres.push(Sphere {
                center: center.into(),
                radius: random.within(0.08, 0.25),
            });
        }
        counts.push(40);
    }
    (floor.collect(), spheres, counts)
}

fn sky(order: usize) -> Light {
    light_of(order, |d| {
        let sun = 12.0 * (5.0 * (d.dot(vec3(0.6, 0.8, 0.0)) - 1.0)).exp();
        [0.4 + sun; 3]
    })
}

fn options(limits: Limits, ratios: bool) -> CutOptions {
    CutOptions {
        limits,
        ratios,
        accumulation: 4,
    }
}

/// Radiance, and pairs of receiver and blocker.
fn lit(
    receivers: &[Receiver],
    clusters: &[Range<usize>],
    forest: &Forest,
    options: CutOptions,
) -> (Vec<f32>, usize) {
    let mut cuts = Cuts::default();
    cuts.bound(receivers, clusters, 0..clusters.len());
    cuts.find(Path::best(), forest, &sky(4), options);
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    let shadow = Shadow {
        clusters,
        cuts: &cuts,
        light: &sky(4),
        accumulation: options.accumulation,
        baked: None,
        eye: None,
    };
    shadow_clusters(Path::best(), receivers, &shadow, &mut radiance).unwrap();
    (radiance.iter().map(|c| c[0]).collect(), cuts.pairs())
}

#[test]
fn without_a_hierarchy_clusters_change_nothing_but_rounding() {
    let (receivers, spheres, counts) = scene(40);
    let forest = Forest::new(&spheres, &counts);
    let clusters = Clusters::new(&receivers, 23);
    let sorted = clusters.sorted(&receivers);
    let leaves = options(Limits::LEAVES, true);
    let (got, pairs) = lit(&sorted, &clusters.ranges, &forest, leaves);
    let mut expected = vec![[0.0; 3]; sorted.len()];
    sh_cpu::shadow(&sorted, &spheres, &sky(4), 4, &mut expected).unwrap();
    assert!(pairs <= sorted.len() * spheres.len() && pairs > sorted.len() * 100);
    for (got, expected) in got.iter().zip(&expected) {
        assert!((got - expected[0]).abs() < 2e-5, "{got} {expected:?}");
    }
}

/// What the hierarchy costs in accuracy and saves in blockers, and that ratio vectors are worth it.
#[test]
fn ratio_vectors_keep_the_picture_and_remove_the_seams() {
    const SIDE: usize = 96;
    const TILE: usize = 12;
    let (floor, spheres, counts) = scene(SIDE);
    let forest = Forest::new(&spheres, &counts);
    // Square tiles as clusters, so that it is known where their edges lie.
    let place = |i: usize| (i % SIDE / TILE, i / SIDE / TILE);
    let mut order: Vec<usize> = (0..floor.len()).collect();
    order.sort_by_key(|&i| place(i));
    let tiled: Vec<Receiver> = order.iter().map(|&i| floor[i]).collect();
    let clusters: Vec<Range<usize>> = (0..tiled.len())
        .step_by(TILE * TILE)
        .map(|first| first..first + TILE * TILE)
        .collect();
    let picture = |limits, ratios| {
        let (values, pairs) = lit(&tiled, &clusters, &forest, options(limits, ratios));
        let mut picture = vec![0.0; values.len()];
        for (&i, value) in order.iter().zip(values) {
            picture[i] = value;
        }
        (picture, pairs)
    };
    let (truth, all) = picture(Limits::LEAVES, true);
    let limits = Limits::default();
    let (with, pairs) = picture(limits, true);
    let (without, _) = picture(limits, false);
    assert!(pairs * 4 < all, "{pairs} of {all} pairs are left");

    let mean = truth.iter().sum::<f32>() / truth.len() as f32;
    let rms = |picture: &[f32]| {
        let sum: f32 = picture
            .iter()
            .zip(&truth)
            .map(|(a, b)| (a - b).powi(2))
            .sum();
        (sum / truth.len() as f32).sqrt() / mean
    };
    // A seam: how much more the error changes across the edge of a tile than within tiles, root mean square over
    // all edges.
    let seam = |picture: &[f32]| {
        let error: Vec<f32> = picture.iter().zip(&truth).map(|(a, b)| a - b).collect();
        let (mut across, mut n) = (0.0, 0.0);
        for y in 0..SIDE {
            for x in (TILE..SIDE).step_by(TILE) {
                let step = error[y * SIDE + x] - error[y * SIDE + x - 1];
                across += step * step;
                n += 1.0;
            }
        }
        (across / n as f32).sqrt() / mean
    };
    let (error, plain) = (rms(&with), rms(&without));
    let (seams, plain_seams) = (seam(&with), seam(&without));
    println!(
        "pairs {pairs} of {all}; error {error:.5}, without ratios {plain:.5}; seams {seams:.5}, {plain_seams:.5}"
    );
    assert!(error < 0.006 && plain > 4.0 * error, "{error} {plain}");
    // A step of one 8-bit grey level at mean brightness is 0.008.
    assert!(
        seams < 0.0045 && plain_seams > 3.5 * seams,
        "{seams} {plain_seams}"
    );
}

#[test]
fn what_is_baked_and_what_moves_make_the_whole() {
    let (receivers, spheres, _) = scene(30);
    let clusters = Clusters::new(&receivers, 9);
    let receivers = clusters.sorted(&receivers);
    let ranges = &clusters.ranges;
    let (still, moving) = spheres.split_at(40);
    let light = sky(4);
    for accumulation in [4, 6] {
        let all_of = |spheres: &[Sphere]| {
            let mut cuts = Cuts::default();
            let forest = Forest::new(spheres, &[spheres.len()]);
            let limits = Limits::LEAVES;
            let ratios = true;
            let options = CutOptions {
                limits,
                ratios,
                accumulation,
            };
            cuts.bound(&receivers, ranges, 0..ranges.len());
            cuts.find(Path::best(), &forest, &light, options);
            cuts
        };
        let baked = bake(&receivers, ranges, &all_of(still), accumulation).unwrap();
        let shaded = |cuts: &Cuts, baked: Option<&[f32]>| {
            let mut radiance = vec![[0.0; 3]; receivers.len()];
            let shadow = Shadow {
                clusters: ranges,
                cuts,
                light: &light,
                accumulation,
                baked,
                eye: None,
            };
            shadow_clusters(Path::best(), &receivers, &shadow, &mut radiance).unwrap();
            radiance
        };
        let together = shaded(&all_of(&spheres), None);
        let apart = shaded(&all_of(moving), Some(&baked));
        let alone = shaded(&all_of(moving), None);
        let largest = |a: &[[f32; 3]], b: &[[f32; 3]]| {
            let each = a.iter().flatten().zip(b.iter().flatten());
            each.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
        };
        assert!(largest(&together, &apart) < 5e-5);
        assert!(
            largest(&together, &alone) > 0.05,
            "what is baked casts shadows"
        );

        let cuts = all_of(moving);
        let short = Shadow {
            clusters: ranges,
            cuts: &cuts,
            light: &light,
            accumulation,
            baked: Some(&baked[1..]),
            eye: None,
        };
        let mut radiance = vec![[0.0; 3]; receivers.len()];
        let error = shadow_clusters(Path::best(), &receivers, &short, &mut radiance).unwrap_err();
        assert!(error.to_string().contains("for each receiver"), "{error}");
    }
}

#[test]
fn clusters_that_leave_receivers_out_are_refused() {
    let (receivers, spheres, counts) = scene(8);
    let forest = Forest::new(&spheres, &counts);
    let mut radiance = vec![[0.0; 3]; 64];
    let light = sky(4);
    for clusters in [
        vec![0..30, 31..64],
        vec![0..30, 29..64],
        vec![0..30, 30..60],
        vec![],
    ] {
        let mut cuts = Cuts::default();
        cuts.bound(&receivers, &clusters, 0..clusters.len());
        let options = options(Limits::default(), true);
        cuts.find(Path::best(), &forest, &light, options);
        let shadow = Shadow {
            clusters: &clusters,
            cuts: &cuts,
            light: &light,
            accumulation: 4,
            baked: None,
            eye: None,
        };
        let refused = shadow_clusters(Path::best(), &receivers, &shadow, &mut radiance);
        assert!(refused.is_err(), "{clusters:?}");
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (receivers, spheres, counts) = scene(64);
    let forest = Forest::new(&spheres, &counts);
    let clusters = Clusters::new(&receivers, 5);
    let receivers = clusters.sorted(&receivers);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let options = options(Limits::default(), true);
        pool.install(|| lit(&receivers, &clusters.ranges, &forest, options))
    };
    let one = on(1);
    for threads in [2, 3] {
        assert!(one == on(threads), "{threads} threads differ from one");
    }
}
