//! How the cost of shadows grows: with spheres, with and without the hierarchy, and with receivers.
//!
//! A floor stands under the middle of a crowd. The floor stays as it is; the crowd's ground grows with its number, as
//! that of a crowd does, so that bodies never stand closer. What is far away is small, and the hierarchy makes one
//! blocker of it; without it every sphere counts for every receiver. Shadows are in steady light, from all sides and
//! from above more than from below.

use super::body::{self, Body};
use super::scenes::figures::character;
use super::world::ORDER;
use gaunt::Error;
use glam::{Affine3A, Vec3};
use sh_cpu::{CutOptions, Cuts, Path, Shadow, shadow_clusters};
use sh_scene::{Forest, Light, Limits, Receiver, Sky, Sphere};
use std::fmt::Write;
use std::ops::Range;
use std::time::Instant;

/// How many spheres, one row each.
pub const SPHERES: [usize; 5] = [60, 250, 1_000, 4_000, 16_000];

/// Receivers along both sides of a tile of the floor, which is a cluster; one row each.
pub const DENSITIES: [[usize; 2]; 3] = [[16, 16], [32, 16], [32, 32]];

/// Tiles of 1 m along a side of the floor.
const TILES: usize = 8;

/// Metres from body to body.
const APART: f32 = 2.0;

/// Spheres of a body, about.
const OF_A_BODY: usize = 62;

/// What one way of finding blockers takes, on one thread.
#[derive(Clone, Copy, Debug)]
pub struct Cost {
    /// Blockers a receiver.
    pub pairs: f64,
    /// Milliseconds of finding blockers for all clusters.
    pub cut_ms: f64,
    /// Milliseconds of the shadow pass.
    pub shadow_ms: f64,
}

impl Cost {
    /// Milliseconds of both.
    pub fn ms(&self) -> f64 {
        self.cut_ms + self.shadow_ms
    }
}

/// A crowd of one size over a floor of one size.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Leaf spheres.
    pub spheres: usize,
    /// Receivers.
    pub receivers: usize,
    /// Milliseconds of following the spheres in the tree.
    pub tree_ms: f64,
    /// With the hierarchy.
    pub tree: Cost,
    /// With the leaves alone.
    pub leaves: Cost,
    /// Root of the mean square of the difference in radiance between the two, over the mean.
    pub rms: f64,
    /// The largest difference, over the mean.
    pub largest: f64,
    /// The mean without the hierarchy, over that in the open.
    pub left: f64,
}

/// Both tables.
#[derive(Clone, Debug)]
pub struct Scaling {
    /// One row for each of [`SPHERES`].
    pub spheres: Vec<Row>,
    /// One row for each of [`DENSITIES`], with 1,000 spheres.
    pub receivers: Vec<Row>,
}

/// Measures and prints: tables, or JSON.
///
/// # Errors
/// Where a pass refuses what it is given or no thread can be started, which does not happen.
pub fn run(json: bool) -> Result<String, Error> {
    let scaling = measure(15)?;
    if json {
        return Ok(serde_json::to_string_pretty(&scaling.json())?);
    }
    Ok(scaling.table())
}

/// Measures both tables on one thread; times are the least of so many rounds, in which both ways take turns.
///
/// # Errors
/// As [`run`].
pub fn measure(rounds: usize) -> Result<Scaling, Error> {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let one = one.map_err(|error| Error::Usage(format!("cannot start a thread: {error}")))?;
    one.install(|| {
        let rows = SPHERES.map(|spheres| row(spheres, DENSITIES[0], rounds));
        let more = DENSITIES.map(|density| row(1_000, density, rounds));
        Ok(Scaling {
            spheres: rows.into_iter().collect::<Result<_, _>>()?,
            receivers: more.into_iter().collect::<Result<_, _>>()?,
        })
    })
}

fn row(spheres: usize, density: [usize; 2], rounds: usize) -> Result<Row, Error> {
    let path = Path::best();
    let bodies = crowd(spheres);
    let (balls, counts) = standing(&bodies);
    let (receivers, clusters) = floor(density);
    let light = Light::project(&Sky::default().map(256, 128), None, ORDER, f32::INFINITY)?;
    let mut forest = Forest::weighted(&balls, &body::weights(&bodies), &counts);
    let mut tree_ms = f64::INFINITY;
    let mut ways = [Limits::default(), Limits::LEAVES].map(|limits| Way {
        options: CutOptions {
            limits,
            ratios: true,
            accumulation: ORDER,
        },
        cuts: Cuts::default(),
        radiance: vec![[0.0; 3]; receivers.len()],
        cost: [f64::INFINITY; 2],
    });
    for way in &mut ways {
        way.cuts.bound(&receivers, &clusters, 0..clusters.len());
    }
    for _ in 0..rounds {
        let start = Instant::now();
        forest.update(&balls);
        tree_ms = tree_ms.min(start.elapsed().as_secs_f64() * 1e3);
        for way in &mut ways {
            way.round(path, &forest, &receivers, &clusters, &light)?;
        }
    }
    let [tree, leaves] = &ways;
    let (rms, largest) = difference(&tree.radiance, &leaves.radiance);
    let sum = leaves
        .radiance
        .as_flattened()
        .iter()
        .map(|c| f64::from(*c))
        .sum::<f64>();
    let open: f32 = light.irradiance([0.0, 1.0, 0.0]).iter().sum();
    let left = sum / (f64::from(open) * receivers.len() as f64);
    Ok(Row {
        spheres: balls.len(),
        receivers: receivers.len(),
        tree_ms,
        tree: tree.cost(),
        leaves: leaves.cost(),
        rms,
        largest,
        left,
    })
}

/// One way of finding blockers, and what it found and took.
struct Way {
    options: CutOptions,
    cuts: Cuts,
    radiance: Vec<[f32; 3]>,
    cost: [f64; 2],
}

impl Way {
    fn round(
        &mut self,
        path: Path,
        forest: &Forest,
        receivers: &[Receiver],
        clusters: &[Range<usize>],
        light: &Light,
    ) -> Result<(), Error> {
        let start = Instant::now();
        self.cuts.find(path, forest, light, self.options);
        let found = start.elapsed().as_secs_f64();
        let shadow = Shadow {
            clusters,
            cuts: &self.cuts,
            light,
            accumulation: ORDER,
            baked: None,
            eye: None,
        };
        shadow_clusters(path, receivers, &shadow, &mut self.radiance)?;
        let shaded = start.elapsed().as_secs_f64() - found;
        for (least, seconds) in self.cost.iter_mut().zip([found, shaded]) {
            *least = least.min(seconds * 1e3);
        }
        Ok(())
    }

    fn cost(&self) -> Cost {
        Cost {
            pairs: self.cuts.pairs() as f64 / self.cuts.receivers() as f64,
            cut_ms: self.cost[0],
            shadow_ms: self.cost[1],
        }
    }
}

/// Bodies of about 62 spheres, together so many, on a square of ground around the origin.
fn crowd(spheres: usize) -> Vec<Body> {
    let bodies = spheres.div_ceil(OF_A_BODY + 1);
    let side = (bodies as f32).sqrt().ceil() as usize;
    let at = |k: usize| APART * (k as f32 - 0.5 * (side as f32 - 1.0));
    let body = |i: usize| Body {
        segments: character(1.0, 0.14),
        receivers: 100,
        spheres: (i + 1) * spheres / bodies - i * spheres / bodies,
        clusters: 1,
        place: Vec3::new(at(i % side), 0.0, at(i / side)),
        way: body::Way::Circle(0.4),
        pace: 1.0,
        albedo: [0.0; 3],
    };
    (0..bodies).map(body).collect()
}

/// Spheres of bodies that are each at another step, one body after another, and how many each has.
fn standing(bodies: &[Body]) -> (Vec<Sphere>, Vec<usize>) {
    let (mut all, mut counts) = (Vec::new(), Vec::new());
    for (i, body) in bodies.iter().enumerate() {
        let mut poses: Vec<Affine3A> = Vec::new();
        body.pose(1.7 * i as f32, &mut poses);
        let parts = body.parts(i as u32 + 1);
        counts.push(parts.spheres.len());
        let on = parts.spheres.iter();
        all.extend(on.map(|(s, sphere)| body::placed_sphere(sphere, &poses[*s])));
    }
    (all, counts)
}

/// The floor around the origin, tile by tile, with so many receivers along both sides of a tile; and the tiles.
fn floor([across, along]: [usize; 2]) -> (Vec<Receiver>, Vec<Range<usize>>) {
    let of_a_tile = across * along;
    let at = |tile: usize, place: usize, places: usize| {
        tile as f32 - 0.5 * TILES as f32 + (place as f32 + 0.5) / places as f32
    };
    let receivers = (0..TILES * TILES * of_a_tile).map(|i| {
        let (tile, place) = (i / of_a_tile, i % of_a_tile);
        let x = at(tile % TILES, place % across, across);
        let z = at(tile / TILES, place / across, along);
        Receiver {
            position: [x, 0.0, z],
            covered: 1,
            normal: [0.0, 1.0, 0.0],
            object: 0,
        }
    });
    let clusters = (0..TILES * TILES).map(|i| i * of_a_tile..(i + 1) * of_a_tile);
    (receivers.collect(), clusters.collect())
}

/// Root of the mean square and largest difference over all values, both over the mean of the second.
fn difference(a: &[[f32; 3]], b: &[[f32; 3]]) -> (f64, f64) {
    let (mut squares, mut largest, mut sum) = (0.0, 0.0_f64, 0.0);
    for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
        let d = f64::from(a - b);
        squares += d * d;
        largest = largest.max(d.abs());
        sum += f64::from(*b);
    }
    let count = (3 * b.len()) as f64;
    let mean = sum / count;
    ((squares / count).sqrt() / mean, largest / mean)
}

impl Scaling {
    /// Two tables in Markdown.
    pub fn table(&self) -> String {
        let mut text = String::new();
        head(&mut text, "spheres");
        for row in &self.spheres {
            line(&mut text, row.spheres, row, &self.spheres[0]);
        }
        text.push('\n');
        head(&mut text, "receivers");
        for row in &self.receivers {
            line(&mut text, row.receivers, row, &self.receivers[0]);
        }
        text
    }

    /// The same as JSON: `{spheres: [row], receivers: [row]}`.
    pub fn json(&self) -> serde_json::Value {
        let cost = |cost: &Cost| {
            serde_json::json!({
                "spheres_per_receiver": cost.pairs,
                "cut_ms": cost.cut_ms,
                "shadow_ms": cost.shadow_ms,
            })
        };
        let rows = |rows: &[Row]| -> Vec<serde_json::Value> {
            let value = |row: &Row| {
                serde_json::json!({
                    "spheres": row.spheres,
                    "receivers": row.receivers,
                    "tree_ms": row.tree_ms,
                    "hierarchy": cost(&row.tree),
                    "leaves": cost(&row.leaves),
                    "rms": row.rms,
                    "max": row.largest,
                    "light_left": row.left,
                })
            };
            rows.iter().map(value).collect()
        };
        serde_json::json!({
            "spheres": rows(&self.spheres),
            "receivers": rows(&self.receivers),
        })
    }
}

fn head(text: &mut String, first: &str) {
    text.push_str("| ");
    text.push_str(first);
    text.push_str(
        " | blockers a receiver | without | tree, ms | cut, ms | shadow, ms | without: cut, ms | shadow, ms | without / with | grown | without, grown | light left | RMS | largest |\n|",
    );
    text.push_str(&"---|".repeat(14));
    text.push('\n');
}

fn line(text: &mut String, what: usize, row: &Row, first: &Row) {
    let (with, without) = (row.tree_ms + row.tree.ms(), row.leaves.ms());
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "| {what} | {:.1} | {:.1} | {:.3} | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} | {:.1} | {:.1} | {:.0} % | {:.2} % | {:.1} % |",
        row.tree.pairs,
        row.leaves.pairs,
        row.tree_ms,
        row.tree.cut_ms,
        row.tree.shadow_ms,
        row.leaves.cut_ms,
        row.leaves.shadow_ms,
        without / with,
        with / (first.tree_ms + first.tree.ms()),
        without / first.leaves.ms(),
        100.0 * row.left,
        100.0 * row.rms,
        100.0 * row.largest,
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crowd_has_the_spheres_that_it_is_asked_for() {
        for spheres in SPHERES {
            let (balls, counts) = standing(&crowd(spheres));
            assert_eq!(balls.len(), spheres);
            assert_eq!(counts.iter().sum::<usize>(), spheres);
            assert!(counts.iter().all(|n| (55..=65).contains(n)), "{counts:?}");
        }
    }

    #[test]
    fn with_the_hierarchy_blockers_grow_less_than_spheres_and_the_picture_stays()
    -> Result<(), Error> {
        let [few, many] = [row(250, [8, 8], 1)?, row(4_000, [8, 8], 1)?];
        assert!(many.tree.pairs > few.tree.pairs);
        // 16 times the spheres: not half as many times the blockers.
        assert!(many.tree.pairs < 8.0 * few.tree.pairs, "{few:?} {many:?}");
        // Without it all count, but those that are wholly below the floor.
        assert!(
            many.leaves.pairs > 12.0 * few.leaves.pairs,
            "{few:?} {many:?}"
        );
        for row in [few, many] {
            assert!(row.rms > 0.0 && row.rms < 0.05, "{row:?}");
        }
        Ok(())
    }

    #[test]
    fn tiles_lie_side_by_side_and_hold_their_receivers() {
        let (receivers, clusters) = floor([4, 2]);
        assert_eq!((receivers.len(), clusters.len()), (64 * 8, 64));
        let mut tiles = std::collections::BTreeSet::new();
        for range in clusters {
            let tile = |r: &Receiver| [0, 2].map(|k| r.position[k].floor() as i32);
            let first = tile(&receivers[range.start]);
            assert!(receivers[range].iter().all(|r| tile(r) == first));
            assert!(first.iter().all(|k| (-4..4).contains(k)) && tiles.insert(first));
        }
    }
}
