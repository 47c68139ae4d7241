//! What was measured, as tables: one for a terminal, shorter ones for a page.

use super::pareto::{self, Method};
use super::{PictureRow, Row};
use std::fmt::Write;

/// The exponentials that others have published; the part before the colon of a name.
const PUBLISHED: [&str; 6] = ["ps", "ps*", "ol", "hyb", "eigen", "product chain"];

/// All methods, order by order, from the fastest on the CPU to the slowest. A star marks those that no other
/// beats in both CPU time and mean error.
pub fn text(rows: &[Row]) -> String {
    let mut text = String::new();
    for order in orders(rows) {
        let methods = pareto::methods(rows, order);
        let best = pareto::best(&methods);
        let names: Vec<String> = methods.iter().map(Method::label).collect();
        let wide = names
            .iter()
            .map(|name| name.chars().count())
            .max()
            .unwrap_or(0);
        let mut sorted: Vec<usize> = (0..methods.len()).collect();
        let time = |i: usize| methods[i].cpu().unwrap_or(f64::INFINITY);
        sorted.sort_by(|&a, &b| time(a).total_cmp(&time(b)));
        let between = if text.is_empty() { "" } else { "\n" };
        let title = format!("order {order}");
        line(&mut text, format_args!("{between}  {title:<wide$}"));
        for head in [
            "mean",
            "p95",
            "max",
            "heavy",
            "stacked",
            "rounding",
            "mul",
            "add",
            "exp",
            "lanes ns",
            "scalar ns",
            "gpu ns",
        ] {
            line(&mut text, format_args!("{head:>10}"));
        }
        text.push('\n');
        for i in sorted {
            let (method, row) = (&methods[i], methods[i].row());
            let star = if best.contains(&i) { '*' } else { ' ' };
            line(&mut text, format_args!("{star} {:<wide$}", names[i]));
            for value in figures(method).into_iter().chain([row.exp]) {
                line(&mut text, format_args!("{:>10}", short(value)));
            }
            for backend in ["lanes", "scalar", "gpu"] {
                let ns = method.ns(backend).map_or("-".into(), short);
                line(&mut text, format_args!("{ns:>10}"));
            }
            text.push('\n');
        }
    }
    if !text.is_empty() {
        text += "\n* no other is both faster and more accurate. Errors are those of the SH vector over |1|;\n  \
                 heavy: the mean over heavily overlapping sets; stacked: the largest over 1 to 4096 identical blockers;\n  \
                 rounding: the largest difference between f32 and f64. Operations and nanoseconds are a receiver's.\n";
    }
    text
}

/// What both tables say of a method: errors, rounding and operations, in the order of their columns.
fn figures(method: &Method<'_>) -> [f64; 8] {
    let row = method.row();
    [
        row.mean,
        row.p95,
        row.max,
        row.heavy,
        row.stacked,
        method.rounding(),
        row.mul,
        row.add,
    ]
}

/// For each order from 3 up: the methods that no other beats, and the published ones, each with the logarithm
/// that gives it the least mean error without accumulation at a higher order. Times are multiples of the default
/// method's on the same backend and at the same order, so that they mean something on another machine.
pub fn markdown(rows: &[Row]) -> String {
    let mut text = String::new();
    for order in orders(rows).into_iter().filter(|order| *order > 2) {
        let methods = pareto::methods(rows, order);
        let best = pareto::best(&methods);
        let mut shown = best.clone();
        let rest = published(&methods);
        shown.extend(rest.into_iter().filter(|i| !best.contains(i)));
        let default = methods.iter().find(|method| method.is_default());
        let timed: Vec<&str> = ["lanes", "scalar", "gpu"]
            .into_iter()
            .filter(|backend| default.and_then(|method| method.ns(backend)).is_some())
            .collect();
        let between = if text.is_empty() { "" } else { "\n" };
        line(
            &mut text,
            format_args!(
                "{between}### Order {order}\n\n| | method | mean | p95 | max | heavy | stacked | rounding | mul | add |"
            ),
        );
        for backend in &timed {
            line(&mut text, format_args!(" time, {backend} |"));
        }
        line(
            &mut text,
            format_args!("\n|---|---|{}\n", "---:|".repeat(8 + timed.len())),
        );
        for i in shown {
            let method = &methods[i];
            let star = if best.contains(&i) { "★" } else { "" };
            // A star of a name would begin emphasis.
            let name = method.label().replace('*', "\\*");
            let name = if method.is_default() {
                format!("**{name}**")
            } else {
                name
            };
            line(&mut text, format_args!("| {star} | {name} |"));
            for value in figures(method) {
                line(&mut text, format_args!(" {} |", short(value)));
            }
            for backend in &timed {
                let of = |method: &Method<'_>| method.ns(backend);
                let ratio = of(method)
                    .zip(default.and_then(of))
                    .map(|(ns, one)| ns / one);
                let ratio = ratio.map_or("–".into(), |ratio| format!("{}×", ratio_short(ratio)));
                line(&mut text, format_args!(" {ratio} |"));
            }
            text.push('\n');
        }
    }
    text
}

/// The pictures that no other of the same scene beats in both time and RMS error. Times are multiples of the
/// fastest in the table's scene.
pub fn pictures_markdown(rows: &[PictureRow]) -> String {
    let mut scenes: Vec<&str> = Vec::new();
    for row in rows {
        if !scenes.contains(&row.scene.as_str()) {
            scenes.push(&row.scene);
        }
    }
    if scenes.is_empty() {
        return String::new();
    }
    let mut text = String::from(
        "| scene | spheres | order | accumulated at | RMS | bias | time |\n|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for scene in scenes {
        let rows: Vec<&PictureRow> = rows.iter().filter(|row| row.scene == scene).collect();
        let best = pareto::front(&rows.iter().map(|row| (row.ms, row.rms)).collect::<Vec<_>>());
        let fastest = best.first().map_or(f64::NAN, |&i| rows[i].ms);
        for row in best.into_iter().map(|i| rows[i]) {
            line(
                &mut text,
                format_args!(
                    "| {scene} | {} | {} | {} | {} | {} | {}× |\n",
                    row.spheres,
                    row.order,
                    row.accumulation_order,
                    short(row.rms),
                    short(row.bias),
                    ratio_short(row.ms / fastest),
                ),
            );
        }
    }
    text
}

/// The best of each published exponential.
fn published(methods: &[Method<'_>]) -> Vec<usize> {
    let mut found: Vec<usize> = Vec::new();
    for (i, method) in methods.iter().enumerate() {
        let row = method.row();
        let family = row.exponential.split(':').next().unwrap_or_default();
        if !PUBLISHED.contains(&family) || row.accumulation_order != row.order {
            continue;
        }
        let same = |&&mut known: &&mut usize| methods[known].row().exponential == row.exponential;
        match found.iter_mut().find(same) {
            // What is not a number is worse than any.
            Some(known) if methods[*known].row().mean <= row.mean || row.mean.is_nan() => {}
            Some(known) => *known = i,
            None => found.push(i),
        }
    }
    found.sort_by(|&a, &b| methods[a].row().mean.total_cmp(&methods[b].row().mean));
    found
}

fn orders(rows: &[Row]) -> Vec<usize> {
    let mut orders: Vec<usize> = rows.iter().map(|row| row.order).collect();
    orders.sort_unstable();
    orders.dedup();
    orders
}

fn line(text: &mut String, arguments: std::fmt::Arguments<'_>) {
    text.write_fmt(arguments).expect("writing to a string");
}

/// Three significant digits: `0.0436`, `4.65`, `545`, and beyond a thousand or below a thousandth `2.4e3`.
///
/// ```
/// use gaunt_lab::accuracy::table::short;
/// assert_eq!([0.04358, 4.65, 50.0, 999.9, 5000.0, 2.5e-7].map(short), ["0.0436", "4.65", "50", "1e3", "5e3", "2.5e-7"]);
/// ```
pub fn short(value: f64) -> String {
    if !value.is_finite() || value == 0.0 {
        return value.abs().to_string().replacen(
            "inf",
            if value < 0.0 { "-inf" } else { "inf" },
            1,
        );
    }
    let scientific = format!("{value:.2e}");
    let Some((mantissa, power)) = scientific.split_once('e') else {
        return scientific;
    };
    let power: i32 = power.parse().unwrap_or(0);
    if !(-3..3).contains(&power) {
        let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
        return format!("{mantissa}e{power}");
    }
    if value.fract() == 0.0 {
        return value.to_string();
    }
    format!("{value:.*}", (2 - power).max(0) as usize)
}

/// Two significant digits are all that a time is worth.
fn ratio_short(ratio: f64) -> String {
    match ratio {
        r if r < 0.095 => format!("{r:.3}"),
        r if r < 0.95 => format!("{r:.2}"),
        r if r < 9.5 => format!("{r:.1}"),
        r if r < 1000.0 => format!("{r:.0}"),
        r => short(r),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::pareto::samples::row;

    fn rows() -> Vec<Row> {
        vec![
            row(4, "ps*:2", "eigen", "lanes", 0.07, Some(30.0)),
            row(4, "ps*:2", "fitted", "lanes", 0.06, Some(30.0)),
            row(4, "ps*:2", "samples", "lanes", f64::NAN, Some(30.0)),
            row(4, "saturating", "fitted", "scalar", 0.05, Some(40.0)),
            row(4, "saturating", "fitted", "lanes", 0.05, Some(10.0)),
            row(4, "sampled:50", "fitted", "lanes", 0.055, Some(12.0)),
            row(4, "eigen", "eigen", "scalar", 0.06, Some(9000.0)),
        ]
    }

    #[test]
    fn the_text_goes_from_fast_to_slow_with_a_star_on_the_front() {
        let text = text(&rows());
        let lines: Vec<&str> = text.lines().skip(1).take(6).collect();
        let starts = [
            "* saturating",
            "  sampled:50, fitted log",
            "  ps*:2, eigen log",
        ];
        for (line, start) in lines.iter().zip(starts) {
            assert!(line.starts_with(start), "{text}");
        }
        let widths: Vec<usize> = text
            .lines()
            .take(7)
            .map(|line| line.chars().count())
            .collect();
        assert!(widths.iter().all(|width| *width == widths[0]), "{widths:?}");
        let fields: Vec<&str> = lines[0].split_whitespace().collect();
        let expected = "* saturating 0.0500 0.100 0.150 0.125 1e15 2e-7 100 2e3 50 10 40 -";
        assert_eq!(fields.join(" "), expected);
    }

    #[test]
    fn a_page_has_the_front_and_each_published_method_once_and_no_time_of_its_own() {
        let page = markdown(&rows());
        let lines: Vec<&str> = page.lines().skip(4).collect();
        assert_eq!(lines.len(), 3, "{page}");
        assert!(
            lines[0].starts_with("| ★ | **saturating** | 0.0500 |"),
            "{page}"
        );
        assert!(lines[0].ends_with(" 1.0× | 1.0× |"), "{page}");
        assert!(
            lines[1].starts_with("|  | ps\\*:2, fitted log |") && lines[1].ends_with(" 3.0× | – |"),
            "{page}"
        );
        assert!(
            lines[2].contains("eigen log") && lines[2].ends_with(" – | 225× |"),
            "{page}"
        );
        assert_eq!(markdown(&[]), "");
    }

    #[test]
    fn pictures_are_those_of_the_front() {
        let picture = |spheres, rms, ms| PictureRow {
            scene: "hall".into(),
            order: 4,
            accumulation_order: 6,
            spheres,
            factor: 1.0,
            rms,
            bias: -0.0123,
            ms,
        };
        let page = pictures_markdown(&[
            picture(8, 0.1, 5.0),
            picture(16, 0.2, 6.0),
            picture(32, 0.05, 20.0),
        ]);
        let lines: Vec<&str> = page.lines().skip(2).collect();
        let expected = [
            "| hall | 8 | 4 | 6 | 0.100 | -0.0123 | 1.0× |",
            "| hall | 32 | 4 | 6 | 0.0500 | -0.0123 | 4.0× |",
        ];
        assert_eq!(lines, expected);
    }

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::NAN, "NaN"),
            (3e15, "3e15"),
            (5123.0, "5.12e3"),
            (545.4, "545"),
            (999.96, "1e3"),
            (-0.04567, "-0.0457"),
            (0.000_999_9, "0.00100"),
            (0.000_12, "1.2e-4"),
        ] {
            assert_eq!(short(value), text);
        }
    }
}
