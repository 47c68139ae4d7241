//! What it costs to gather the light of more and more spheres, for each way in which they hide each other.
//!
//! A cloud of balls hangs over a floor, each a body of its own, or eight together in one. The floor's receivers see all
//! of them as they are: no hierarchy. Time is that of finding their order and of gathering, on the threads of the
//! current rayon pool, the least of several rounds in which all ways take turns.

use super::body::{Body, Segment, Way};
use super::scenes::{Face, Plan};
use super::world::{GATHER, ORDER_OF_LIGHTS, World};
use crate::accuracy::chart;
use gaunt::Error;
use gaunt::progress::Progress;
use glam::Vec3;
use serde::Serialize;
use sh_cpu::Path;
use sh_scene::{Blocking, Indirect, Limits};
use std::fmt::Write;

/// Numbers of lights.
const LIGHTS: [usize; 6] = [4, 8, 16, 32, 64, 128];

/// Spheres of a body.
const BODIES: [usize; 2] = [1, 8];

/// Receivers along a side of the floor, and its clusters.
const SIDE: usize = 64;
const CLUSTERS: usize = 16;

/// Rounds.
const ROUNDS: usize = 7;

/// One number of lights, one kind of body, one way of blocking.
#[derive(Clone, Copy, Debug, Serialize)]
struct Row {
    lights: usize,
    spheres_per_body: usize,
    blocking: &'static str,
    /// Spheres that are looked at for each, on average.
    hiders_per_light: f32,
    /// Milliseconds of finding the lights' order.
    cut_ms: f64,
    /// Milliseconds of gathering.
    gather_ms: f64,
    /// Of these, nanoseconds a receiver and light.
    pair_ns: f64,
}

/// Measures, draws a chart if asked for one, and prints: a table, or JSON.
///
/// # Errors
/// A chart that cannot be written; where a pass refuses what it is given, which does not happen.
pub fn run(json: bool, plot: Option<&std::path::Path>) -> Result<String, Error> {
    if let Some(file) = plot {
        chart::check(file)?;
    }
    let rows = measure(&LIGHTS, ROUNDS)?;
    if let Some(file) = plot {
        draw(&rows, file)?;
    }
    if json {
        return Ok(serde_json::to_string_pretty(&rows)?);
    }
    Ok(table(&rows))
}

/// So many lights in bodies of so many over a floor.
fn plan(lights: usize, together: usize, blocking: Blocking) -> Plan {
    // Golden steps around an axis, and a layer up each time: no two balls touch that are not of one body.
    let place = |i: usize, count: usize| {
        let turn = 2.4 * i as f32;
        let out = 3.0 * ((i as f32 + 0.5) / count as f32).sqrt();
        Vec3::new(
            out * turn.cos(),
            1.0 + 2.0 * (0.618 * i as f32).fract(),
            out * turn.sin(),
        )
    };
    let bodies = lights.div_ceil(together);
    let body = |i: usize| {
        let spheres = together.min(lights - i * together);
        // The bodies of one ball and of many are of one size.
        let size = 0.9 / (bodies as f32).sqrt();
        let ball = |k: usize| {
            let corner = Vec3::from([0, 1, 2].map(|axis| ((k >> axis & 1) * 2) as f32 - 1.0));
            match spheres {
                1 => Segment::ball(Vec3::ZERO, Vec3::ZERO, size),
                _ => Segment::ball(Vec3::ZERO, corner * 0.5 * size, 0.6 * size),
            }
        };
        Body {
            segments: (0..spheres).map(ball).collect(),
            receivers: 0,
            spheres,
            clusters: 1,
            place: place(i, bodies),
            way: Way::Stands,
            pace: 0.0,
            albedo: [0.5; 3],
        }
    };
    Plan {
        bodies: (0..bodies).map(body).collect(),
        faces: vec![Face {
            middle: Vec3::ZERO,
            across: Vec3::X * 6.0,
            along: Vec3::Z * 6.0,
            counts: [SIDE; 2],
            clusters: CLUSTERS,
        }],
        lamps: Vec::new(),
        indirect: Some(Indirect {
            blocking,
            ..Indirect::default()
        }),
    }
}

fn measure(lights: &[usize], rounds: usize) -> Result<Vec<Row>, Error> {
    let progress = Progress::new("timing lights");
    let mut rows = Vec::new();
    for (step, &lights) in lights.iter().enumerate() {
        progress.set(step as f32 / LIGHTS.len() as f32);
        let mut ways = Vec::new();
        for together in BODIES {
            for blocking in Blocking::ALL {
                let mut world = World::new(plan(lights, together, blocking))?;
                world.limits = Limits::LEAVES;
                ways.push((together, blocking, world, [f64::INFINITY; 2]));
            }
        }
        for _ in 0..rounds {
            for (_, _, world, least) in &mut ways {
                let spent = world.frame(Path::best(), 0.0)?;
                for (least, stage) in least.iter_mut().zip([ORDER_OF_LIGHTS, GATHER]) {
                    *least = least.min(spent[stage]);
                }
            }
        }
        for (spheres_per_body, blocking, world, [cut_ms, gather_ms]) in ways {
            let Some(sent) = &world.sent else { continue };
            rows.push(Row {
                lights,
                spheres_per_body,
                blocking: blocking.name(),
                hiders_per_light: sent.cuts.hiders_per_light(),
                cut_ms,
                gather_ms,
                pair_ns: gather_ms * 1e6 / sent.cuts.pairs() as f64,
            });
        }
    }
    progress.finish();
    Ok(rows)
}

fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{} receivers of a floor in {CLUSTERS} clusters, {} threads.\n\n\
         | lights | in a body | blocking | hiders a light | their order, ms | gathering, ms | ns a receiver and light |\n|",
        SIDE * SIDE,
        rayon::current_num_threads()
    );
    text.push_str(&"---|".repeat(7));
    text.push('\n');
    for row in rows {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.1} | {:.3} | {:.3} | {:.1} |",
            row.lights,
            row.spheres_per_body,
            row.blocking,
            row.hiders_per_light,
            row.cut_ms,
            row.gather_ms,
            row.pair_ns
        );
    }
    text
}

/// Marks of a series, with what stands beside them.
type Points = Vec<(f64, f64, String)>;

/// Time against the number of lights.
fn draw(rows: &[Row], file: &std::path::Path) -> Result<(), Error> {
    let mut series: Vec<(String, Points)> = Vec::new();
    for together in BODIES {
        for blocking in Blocking::ALL {
            let own = rows
                .iter()
                .filter(|row| row.spheres_per_body == together && row.blocking == blocking.name());
            let points = own.map(|row| {
                let ms = row.cut_ms + row.gather_ms;
                (
                    row.lights as f64,
                    ms,
                    format!("{:.1}", row.hiders_per_light),
                )
            });
            let name = format!("{}, {together} in a body", blocking.name());
            series.push((name, points.collect()));
        }
    }
    let series: Vec<chart::Series> = series
        .iter()
        .map(|(name, points)| (name.as_str(), points.clone()))
        .collect();
    let lines = [
        "Up: milliseconds of finding the order of lights and of gathering what they send, 4,096 receivers. Right: lights.",
        "Numbers at marks: spheres that are looked at for each light. Both scales are logarithmic.",
    ];
    let title = "What more lights cost, by what hides them";
    chart::series_of_points(title, lines, ["lights", "ms"], &series, file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_way_is_measured() -> Result<(), Error> {
        let rows = measure(&[4, 16], 1)?;
        assert_eq!(rows.len(), 2 * BODIES.len() * Blocking::ALL.len());
        assert!(rows.iter().all(|row| row.gather_ms > 0.0));
        // Sphere by sphere all are looked at for each.
        let of = |blocking: Blocking| {
            let row = rows
                .iter()
                .rfind(|row| row.spheres_per_body == 1 && row.blocking == blocking.name());
            row.map_or(0.0, |row| row.hiders_per_light)
        };
        assert!(of(Blocking::Sphere) > 12.0);
        assert!(of(Blocking::Discs) < 5.0 && of(Blocking::Object) < 5.0);
        let text = table(&rows);
        assert_eq!(text.lines().count(), 4 + rows.len());
        Ok(())
    }
}
