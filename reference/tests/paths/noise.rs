//! Errors that are told, and answers that do not depend on who asks.

use super::{UP, bounces, object, scene};
use glam::Vec3;
use sh_bake::shapes;
use sh_reference::paths::{PathTracer, Radiance};
use sh_scene::{Scene, Sky};

fn still_life() -> Scene {
    let mut scene = scene(Sky::default().map(128, 64));
    scene.objects = vec![
        object(
            shapes::ball(0.5, 3),
            [0.8, 0.4, 0.2],
            Vec3::new(0.6, 0.5, 0.0),
        ),
        object(
            shapes::cone(0.4, 1.0),
            [0.2, 0.8, 0.4],
            Vec3::new(-0.5, 0.5, 0.2),
        ),
    ];
    scene
}

fn many(tracer: &PathTracer, paths: u32) -> Vec<Radiance> {
    let one = |seed| tracer.radiance([0.0; 3], UP, paths, seed);
    (0..200).map(one).collect()
}

/// Root of the mean square about the mean, and of the errors that were told.
fn spread(found: &[Radiance], of: impl Fn(&Radiance) -> [f64; 2]) -> [f64; 2] {
    let count = found.len() as f64;
    let mean = found.iter().map(|r| of(r)[0]).sum::<f64>() / count;
    let root = |sum: f64| (sum / count).sqrt();
    [
        root(found.iter().map(|r| (of(r)[0] - mean).powi(2)).sum()),
        root(found.iter().map(|r| of(r)[1].powi(2)).sum()),
    ]
}

#[test]
fn errors_are_told() {
    let scene = still_life();
    let tracer = PathTracer::new(&scene, bounces(2)).expect("a light");
    for paths in [16, 128, 1000] {
        let found = many(&tracer, paths);
        for [true_error, told] in [
            spread(&found, |r| [r.direct[1], r.direct_error[1]]),
            spread(&found, |r| [r.indirect[1], r.indirect_error[1]]),
        ] {
            // Not below the truth but by chance, and no idle threat.
            assert!(
                told > 0.9 * true_error,
                "{paths} paths: {told} for {true_error}"
            );
            assert!(
                told < 5.0 * true_error,
                "{paths} paths: {told} for {true_error}"
            );
        }
    }
}

#[test]
fn paths_that_are_spread_evenly_converge_faster_than_random_ones() {
    let scene = still_life();
    let tracer = PathTracer::new(&scene, bounces(1)).expect("a light");
    let error = |paths: u32| spread(&many(&tracer, paths), |r| [r.direct[1], 0.0])[0];
    let (few, many) = (error(16), error(1024));
    // Random ones: an eighth.
    assert!(many < few / 14.0, "{few} to {many}");
}

#[test]
fn every_thread_finds_the_same() {
    let scene = still_life();
    let tracer = PathTracer::new(&scene, bounces(2)).expect("a light");
    let alone = many(&tracer, 32);
    let ask = |i: u32| tracer.radiance([0.0; 3], UP, 32, i);
    let ask = &ask;
    let apart: Vec<Radiance> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..200).map(|i| scope.spawn(move || ask(i))).collect();
        threads
            .into_iter()
            .map(|t| t.join().expect("no panic"))
            .collect()
    });
    assert_eq!(alone, apart);
    assert_ne!(alone[0], alone[1]);
    let again = PathTracer::new(&scene, bounces(2)).expect("a light");
    assert_eq!(again.radiance([0.0; 3], UP, 32, 7), alone[7]);
}

#[test]
fn one_path_tells_no_error() {
    let scene = still_life();
    let tracer = PathTracer::new(&scene, bounces(1)).expect("a light");
    let one = tracer.radiance([0.0; 3], UP, 1, 3);
    assert_eq!(one.direct_error, [f64::INFINITY; 3]);
    assert!(one.total().iter().all(|c| c.is_finite() && *c >= 0.0));
}
