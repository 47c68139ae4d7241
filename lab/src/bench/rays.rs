//! The environment's shadows in the battle scene against ray casting: how many rays a receiver reach the same error,
//! and how long they take on the same threads.
//!
//! Both sides are given the same light: the sky as spherical harmonics of one order. Rays get the capsules that the
//! bodies are made of as triangles, a hierarchy that is built beforehand and not counted, directions in proportion to
//! the cosine from a low-discrepancy set, and stop at the first hit. Ours counts the whole frame but for the motion:
//! tree, cuts and shadows of all receivers. Error is the root of the mean square over a subset of the receivers, over
//! the mean radiance, against 4,096 rays of another set.

mod cast;
mod print;
mod scene;

use cast::Samples;
use gaunt::Error;
use glam::Vec3A;
use scene::{Frame, Scene};
use std::path::Path;

/// Rays a receiver, from the fewest.
pub const RAYS: [u32; 11] = [1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024];

/// Rays a receiver of the truth.
const TRUTH: u32 = 4096;

/// One of so many receivers is looked at.
const EVERY: usize = 16;

/// Orders of the light, each with a truth of its own; the sky as it is comes after them.
const ORDERS: [usize; 4] = [3, 4, 5, 6];

/// Lights that errors are measured under.
const LIGHTS: usize = ORDERS.len() + 1;

/// Order of the light, order of accumulation.
const OURS: [[usize; 2]; 6] = [[3, 3], [4, 4], [4, 5], [4, 6], [5, 5], [6, 6]];

/// Receivers that rays are timed for at once.
const CHUNK: usize = 32;

/// The moment of the scene, in seconds.
const MOMENT: f32 = 0.7;

/// Triangles around a capsule.
const AROUND: usize = 32;

/// So many rays a receiver.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    /// How many.
    pub count: u32,
    /// Error under the light of each of [`ORDERS`], and under the sky as it is.
    pub errors: [f64; LIGHTS],
    /// Nanoseconds a receiver, under light of order 4.
    pub ns: f64,
    /// The same under the sky as it is, which is looked up in its map.
    pub raw_ns: f64,
}

/// One way of ours.
#[derive(Clone, Copy, Debug)]
pub struct Ours {
    /// Order of the light.
    pub order: usize,
    /// Order of accumulation.
    pub accumulation: usize,
    /// Error under the light of this order.
    pub error: f64,
    /// Error against the sky as it is.
    pub raw_error: f64,
    /// Error with the leaf spheres alone.
    pub leaves: f64,
    /// The difference that the hierarchy makes.
    pub hierarchy: f64,
    /// Nanoseconds a receiver.
    pub ns: f64,
    /// The number of rays a receiver that reach this error, and what they take over what this takes.
    pub equal: Equal,
    /// The same for the sky as it is.
    pub raw: Equal,
}

/// Where rays reach an error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equal {
    /// Rays a receiver; between two numbers that were measured it follows a power law.
    pub rays: f64,
    /// Their time over ours.
    pub times: f64,
}

/// All that was measured.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// One row for each of [`RAYS`].
    pub rays: Vec<Rays>,
    /// One row for each way of ours.
    pub ours: Vec<Ours>,
    /// Receivers that errors are taken over.
    pub receivers: usize,
    /// Triangles that rays are cast at.
    pub triangles: usize,
    /// Milliseconds of building their hierarchy.
    pub build_ms: f64,
    /// Threads.
    pub threads: usize,
}

/// Measures, draws a chart if asked for one, and prints: tables, or JSON. Takes about a minute.
///
/// # Errors
/// A chart that cannot be written; where a pass refuses what it is given, which does not happen.
pub fn run(json: bool, chart: Option<&Path>) -> Result<String, Error> {
    if let Some(file) = chart {
        crate::accuracy::chart::check(file)?;
    }
    let comparison = measure(3)?;
    if let Some(file) = chart {
        comparison.chart(file)?;
    }
    if json {
        return Ok(serde_json::to_string_pretty(&comparison.json())?);
    }
    Ok(comparison.table())
}

/// Measures on the threads of the current rayon pool; times are the least of so many rounds, in which
/// all take turns: of whole frames for ours, of each chunk of receivers for rays.
///
/// # Errors
/// As [`run`].
pub fn measure(rounds: usize) -> Result<Comparison, Error> {
    let (scene, build_ms) = Scene::new()?;
    let truth = scene.cast(&Samples::new(TRUTH, 1));
    let samples = RAYS.map(|count| Samples::new(count, 2));
    let mut rays = Vec::new();
    for (count, samples) in RAYS.iter().zip(&samples) {
        let cast = scene.cast(samples);
        rays.push(Rays {
            count: *count,
            errors: std::array::from_fn(|light| rms(&cast, light, &truth, light)),
            ns: f64::INFINITY,
            raw_ns: f64::INFINITY,
        });
    }
    let mut frames = OURS.map(|orders| Frame::new(&scene, orders));
    let chunks = scene.receivers.len().div_ceil(CHUNK);
    let mut least = RAYS.map(|_| [(); 2].map(|()| vec![f64::INFINITY; chunks]));
    for _ in 0..rounds {
        for ([smooth, raw], samples) in least.iter_mut().zip(&samples) {
            for frame in &mut frames {
                frame.round(&scene)?;
            }
            scene.time(samples, |d| [scene.lights.of_order_4(d)], smooth);
            scene.time(samples, |d| [scene.lights.raw(d)], raw);
        }
    }
    let a_receiver =
        |seconds: &Vec<f64>| 1e9 * seconds.iter().sum::<f64>() / scene.receivers.len() as f64;
    for (rays, [smooth, raw]) in rays.iter_mut().zip(&least) {
        (rays.ns, rays.raw_ns) = (a_receiver(smooth), a_receiver(raw));
    }
    let ours = frames
        .iter()
        .map(|frame| frame.result(&scene, &truth, &rays));
    Ok(Comparison {
        ours: ours.collect::<Result<_, _>>()?,
        rays,
        receivers: scene.receivers.len(),
        triangles: scene.caster.triangles(),
        build_ms,
        threads: rayon::current_num_threads(),
    })
}
/// Root of the mean square of the difference of two columns over all receivers and channels, over the second's mean.
fn rms<const A: usize, const B: usize>(
    found: &[[Vec3A; A]],
    a: usize,
    truth: &[[Vec3A; B]],
    b: usize,
) -> f64 {
    let (mut squares, mut sum) = (0.0, 0.0);
    for (found, truth) in found.iter().zip(truth) {
        squares += f64::from(found[a].distance_squared(truth[b]));
        sum += f64::from(truth[b].element_sum());
    }
    let count = (3 * truth.len()) as f64;
    (squares / count).sqrt() / (sum / count)
}

/// Where a curve of rays, errors and nanoseconds a receiver reaches an error. Beyond its ends the nearest two points
/// are continued.
fn equal(curve: &[[f64; 3]], error: f64, ours_ns: f64) -> Equal {
    let beyond = curve.iter().position(|[_, e, _]| *e <= error);
    let i = beyond.unwrap_or(curve.len() - 1).max(1);
    let [a, b] = [curve[i - 1], curve[i]].map(|point| point.map(f64::ln));
    let t = (error.ln() - a[1]) / (b[1] - a[1]);
    let between = |k: usize| (a[k] + t * (b[k] - a[k])).exp();
    Equal {
        rays: between(0),
        times: between(2) / ours_ns,
    }
}
#[cfg(test)]
mod tests {
    use super::scene::{Lights, capsules};
    use super::*;
    use crate::bench::scenes::{Name, plan};
    use crate::bench::world::World;
    use sh_scene::Receiver;

    #[test]
    fn in_the_open_rays_find_the_irradiance() -> Result<(), Error> {
        let lights = Lights::new()?;
        let normal = glam::Vec3::new(0.3, 0.8, -0.5).normalize();
        let receiver = Receiver {
            position: [0.0; 3],
            covered: 1,
            normal: normal.into(),
            object: 0,
        };
        let all = Samples::new(TRUTH, 1).mean(&receiver, 0, |d| Some(lights.all(d)));
        for (found, light) in all.iter().zip(&lights.projected) {
            let expected = Vec3A::from(light.irradiance(normal.into()));
            assert!(
                (*found - expected).length() < 2e-3 * expected.length(),
                "{found} {expected}"
            );
        }
        let [one] = Samples::new(TRUTH, 1).mean(&receiver, 0, |d| Some([lights.of_order_4(d)]));
        assert!((one - all[1]).length() < 1e-4);
        Ok(())
    }

    #[test]
    fn equal_errors_are_found_between_and_beyond_what_was_measured() {
        // Error 1/K, time 10 K.
        let curve = [1.0, 4.0, 16.0].map(|k| [k, 1.0 / k, 10.0 * k]);
        for k in [0.5, 1.0, 2.0, 9.0, 16.0, 50.0] {
            let found = equal(&curve, 1.0 / k, 5.0);
            assert!((found.rays / k - 1.0).abs() < 1e-9, "{k} {found:?}");
            assert!((found.times / (2.0 * k) - 1.0).abs() < 1e-9);
        }
    }

    /// Weights leave a third of the error at equal orders that one each left (20 %).
    #[test]
    fn shadows_are_near_those_of_rays() -> Result<(), Error> {
        let (scene, _) = Scene::new()?;
        let truth = scene.cast(&Samples::new(256, 1));
        for (orders, most) in [([4, 4], 0.062), ([4, 6], 0.05)] {
            let mut frame = Frame::new(&scene, orders);
            frame.round(&scene)?;
            let error = frame.error(&scene, &truth);
            assert!(error < most, "{orders:?}: {error}");
        }
        Ok(())
    }

    #[test]
    fn capsules_carry_their_receivers() -> Result<(), Error> {
        let mut world = World::new(plan(Name::Battle))?;
        world.pose(MOMENT);
        let capsules = capsules();
        for receiver in world.receivers[..world.moving()].iter().step_by(101) {
            let point = receiver.position.into();
            let on = capsules.iter().any(|c| c.distance(point).abs() < 1e-4);
            assert!(on, "{receiver:?}");
        }
        Ok(())
    }
}
