//! Tables in Markdown.

use super::Report;
use super::tables::Row;
use std::fmt::Write;

/// All tables that have rows.
pub(super) fn tables(report: &Report) -> String {
    let mut parts = Vec::new();
    for (title, rows) in [
        ("The scenes", &report.scenes),
        ("By number of spheres", &report.counts),
        ("By order", &report.orders),
        ("Bent bodies", &report.bends),
    ] {
        if !rows.is_empty() {
            parts.push(format!("{title}\n\n{}", scenes(rows)));
        }
    }
    for rows in [&report.scenes, &report.counts] {
        if rows.is_empty() {
            continue;
        }
        let header = "light, in parts of its mean there | indirect light on the ground | by equation 23 | by patches | on bodies | by equation 23 | by patches | direct light on the ground | on bodies";
        let rows = rows.iter().map(|r| {
            let [ground, bodies] = r.direct_places;
            let figures = [
                r.ground,
                r.runs_ground,
                r.patches_ground,
                r.bodies,
                r.runs_bodies,
                r.patches_bodies,
                ground,
                bodies,
            ];
            let figures =
                figures.map(|[rms, bias]| format!("{}, bias {:+.1} %", percent(rms), 100.0 * bias));
            format!("{}, {} | {}", r.name, r.spheres, figures.join(" | "))
        });
        parts.push(table(header, rows));
    }
    if !report.steps.is_empty() {
        let header = "body | spheres | paths among the spheres | ours";
        let rows = report.steps.iter().map(|s| {
            let figures = [s.fit, s.whole].map(percent);
            format!("{} | {} | {}", s.name, s.spheres, figures.join(" | "))
        });
        parts.push(format!(
            "Steps from the body to ours, indirect light on the ground\n\n{}",
            table(header, rows)
        ));
    }
    if !report.weights.is_empty() {
        let header = "radius over distance | mean by solid angle | mean by slope";
        let rows = report.weights.iter().map(|w| {
            let figures = [w.solid_angle, w.slope].map(percent);
            format!("{} | {}", w.sine, figures.join(" | "))
        });
        parts.push(format!(
            "The mean radiance of a ball\n\n{}",
            table(header, rows)
        ));
    }
    if !report.rooms.is_empty() {
        let header = "room | functions | order | bounces | direct | of the mean indirect | bias of it | its noise | on bodies | bias | share of indirect light | MB";
        let rows = report.rooms.iter().map(|r| {
            let head = format!("{} | {} | {} | {}", r.name, r.functions, r.order, r.bounces);
            let [rms, bias] = r.patches;
            let [on_bodies, bias_there] = r.pieces;
            format!(
                "{head} | {} | {} | {:+.1} % | {} | {} | {:+.1} % | {} | {:.1}",
                percent(r.direct),
                percent(rms),
                100.0 * bias,
                percent(r.noise),
                percent(on_bodies),
                100.0 * bias_there,
                percent(r.share),
                r.bytes as f64 / 1e6,
            )
        });
        parts.push(format!("Rooms, by patches\n\n{}", table(header, rows)));
    }
    parts.join("\n\n")
}

fn scenes(rows: &[Row]) -> String {
    let header = "scene | spheres | order | truth's light | direct | indirect | of the mean indirect | bias of it | \
                  its noise | by equation 23 | bias of that | by patches | bias of that | share of indirect light";
    let rows = rows.iter().map(|r| {
        let head = format!("{} | {} | {} | {}", r.name, r.spheres, r.order, r.light);
        let figures = [r.direct, r.indirect, r.relative].map(percent).join(" | ");
        format!(
            "{head} | {figures} | {:+.1} % | {} | {} | {:+.1} % | {} | {:+.1} % | {}",
            100.0 * r.relative_bias,
            percent(r.relative_noise),
            percent(r.runs),
            100.0 * r.runs_bias,
            percent(r.patches[0]),
            100.0 * r.patches[1],
            percent(r.share),
        )
    });
    table(header, rows)
}

fn percent(part: f64) -> String {
    let part = 100.0 * part;
    if part < 10.0 {
        format!("{part:.2} %")
    } else {
        format!("{part:.1} %")
    }
}

fn table(header: &str, rows: impl Iterator<Item = String>) -> String {
    let mut text = format!("| {header} |\n|");
    text.push_str(&"---|".repeat(header.split('|').count()));
    for row in rows {
        // Writing to a string cannot fail.
        let _ = write!(text, "\n| {row} |");
    }
    text
}
