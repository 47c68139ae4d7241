//! Error against time as charts, in SVG and PNG files that are the same to the last bit for the same rows.

mod axis;
mod canvas;
mod compare;
mod labels;
mod mark;
mod panel;

use super::pareto::{self, Method};
use super::{PictureRow, Row};
use canvas::{Align, Canvas};
pub use compare::{Series, series_of_points};
use gaunt::Error;
use labels::Rect;
use mark::{INK, SOFT, mark};
use panel::{Dot, Panel, rows_of_panels};
use std::path::Path;

/// The kinds of exponentials with the words of the legend; the part before the colon of a name.
const FAMILIES: [(&str, &str); 8] = [
    ("saturating", "saturating (ours)"),
    ("ps*", "PS*"),
    ("hyb", "HYB"),
    ("ps", "PS"),
    ("sampled", "sampled (ours)"),
    ("ol", "OL"),
    ("eigen", "eigen"),
    ("product chain", "product chain, no logarithm"),
];

/// The family's number; unknown ones share the last.
fn family(exponential: &str) -> usize {
    let name = exponential.split(':').next().unwrap_or_default();
    let known = FAMILIES.iter().position(|(family, _)| *family == name);
    known.unwrap_or(FAMILIES.len() - 1)
}

/// Whether a chart can be written to a file of this name: before the work, not after it.
///
/// # Errors
/// A name that ends in neither `.svg` nor `.png`.
pub fn check(file: &Path) -> Result<(), Error> {
    canvas::check(file)
}

/// Draws the error of every method against its time on the CPU: a panel for each order from 3 to 6, the methods
/// that no other beats named and joined. Vector lanes where a method has them; scalar times are hollow marks.
///
/// # Errors
/// A file whose name ends in neither `.svg` nor `.png` or that cannot be written; rows without any time.
pub fn methods(rows: &[Row], file: &Path) -> Result<(), Error> {
    let mut canvas = Canvas::new([1600, 1240])?;
    let title = "What accuracy costs: error of a receiver’s visibility against time";
    let lines = [
        "Up: |g − truth| / |1| of the SH vector over random sets of 1 to 12 circular blockers, radii 3° to 45°, in the upper half: mean, and a whisker to the 95th percentile.",
        "Right: nanoseconds a receiver on the CPU, with vector lanes where the method has them. Both scales are logarithmic; less is better in both.",
    ];
    head(&mut canvas, title, lines);
    let orders = [3, 4, 5, 6];
    let methods = orders.map(|order| pareto::methods(rows, order));
    let dots = methods.each_ref().map(|methods| dots(methods));
    let all = || dots.iter().flatten();
    let nothing = || {
        Error::Usage(
            "cannot draw a chart of methods: no row of orders 3 to 6 has a time and an error"
                .into(),
        )
    };
    let least = axis::range(all().map(|d| d.y), 1.35, 1.0).ok_or_else(nothing)?[0];
    // What is many times worse than the best stands at the upper edge, with an arrow.
    let most = axis::range(
        all()
            .flat_map(|d| [d.y, d.top])
            .filter(|y| *y < 12.0 * least),
        1.0,
        1.1,
    )
    .ok_or_else(nothing)?[1];
    let frames = rows_of_panels(
        Rect {
            least: [60.0, 118.0],
            greatest: [1576.0, 1160.0],
        },
        2,
        2,
    );
    for ((order, dots), frame) in orders.into_iter().zip(&dots).zip(frames) {
        // So does what is many times slower than all that is worth its time.
        let slowest = dots
            .iter()
            .filter(|d| d.front)
            .map(|d| d.x)
            .fold(0.0, f64::max);
        let shown = dots.iter().map(|d| d.x).filter(|x| *x < 20.0 * slowest);
        let Some(x) = axis::range(shown, 1.6, 1.25) else {
            panel::missing(&mut canvas, frame, &format!("Order {order}: not measured"));
            continue;
        };
        let title = format!("Order {order}, {} coefficients", order * order);
        let panel = Panel::new(&mut canvas, frame, &title, x, [least, most]);
        panel.axes(&mut canvas, "ns a receiver", "error");
        panel.front(&mut canvas, dots);
        panel.dots(&mut canvas, dots);
    }
    legend(&mut canvas, &dots.concat());
    canvas.write(file)
}

/// What the chart shows, and how to read it.
fn head(canvas: &mut Canvas, title: &str, lines: [&str; 2]) {
    canvas.bold(title, [60.0, 40.0], 27.0, INK, Align::Left);
    for (line, y) in lines.iter().zip([74.0, 97.0]) {
        canvas.text(line, [60.0, y], 17.0, SOFT, Align::Left);
    }
}

/// The methods that have a time and an error.
fn dots(methods: &[Method<'_>]) -> Vec<Dot> {
    let best = pareto::best(methods);
    let dot = |(i, method): (usize, &Method<'_>)| {
        let row = method.row();
        let front = best.iter().position(|&b| b == i);
        Some(Dot {
            x: method.cpu().filter(|x| x.is_normal() && *x > 0.0)?,
            y: Some(row.mean).filter(|y| !y.is_nan())?,
            top: row.p95,
            series: family(&row.exponential),
            hollow: method.ns("lanes").is_none(),
            front: front.is_some(),
            name: front.map(|_| method.label()),
        })
    };
    methods.iter().enumerate().filter_map(dot).collect()
}

/// How much wider than here a viewer of SVG files may set text.
const WIDER: f64 = 1.17;

/// What marks and lines mean, in two lines at the bottom.
fn legend(canvas: &mut Canvas, dots: &[Dot]) {
    let known = FAMILIES.iter().enumerate();
    let present = known.filter(|(series, _)| dots.iter().any(|dot| dot.series == *series));
    series(
        canvas,
        1188.0,
        present.map(|(series, (_, words))| (series, *words)),
    );
    let (mut x, y) = (60.0, 1216.0);
    let word = |canvas: &mut Canvas, x: &mut f64, words: &str| {
        canvas.text(words, [*x, y], 16.0, INK, Align::Left);
        *x += WIDER * canvas.width(words, 16.0) + 30.0;
    };
    canvas.line(&[[x, y], [x + 26.0, y]], INK, 1.6);
    x += 34.0;
    word(
        canvas,
        &mut x,
        "Pareto front, its methods named: nothing measured is both faster and more accurate",
    );
    mark(0).draw_pale(canvas, [x + 8.0, y], 4.5, false);
    x += 20.0;
    word(canvas, &mut x, "off the front");
    if dots.iter().any(|dot| dot.hollow) {
        mark(0).draw(canvas, [x + 8.0, y], 6.5, true);
        x += 22.0;
        word(canvas, &mut x, "hollow: scalar only");
    }
    canvas.fill(&[[x, y - 4.0], [x + 8.0, y], [x, y + 4.0]], SOFT, 1.0);
    x += 16.0;
    word(canvas, &mut x, "beyond the edge");
}

/// A line with the marks of series and what they mean.
fn series<'a>(canvas: &mut Canvas, y: f64, entries: impl Iterator<Item = (usize, &'a str)>) {
    let mut x = 60.0;
    for (series, words) in entries {
        mark(series).draw(canvas, [x + 8.0, y], 6.5, false);
        canvas.text(words, [x + 22.0, y], 16.0, INK, Align::Left);
        x += 22.0 + WIDER * canvas.width(words, 16.0) + 24.0;
    }
}

/// Draws the error of whole pictures against the time of their shadow pass: a panel for each scene, a series for
/// each number of spheres, points named by order and accumulation.
///
/// # Errors
/// A file whose name ends in neither `.svg` nor `.png` or that cannot be written; rows without times and errors.
pub fn pictures(rows: &[PictureRow], file: &Path) -> Result<(), Error> {
    let usable: Vec<&PictureRow> = rows
        .iter()
        .filter(|row| [row.rms, row.ms].iter().all(|v| v.is_normal() && *v > 0.0))
        .collect();
    let mut scenes: Vec<&str> = usable.iter().map(|row| row.scene.as_str()).collect();
    let mut seen = std::collections::BTreeSet::new();
    scenes.retain(|scene| seen.insert(*scene));
    let mut spheres: Vec<usize> = usable.iter().map(|row| row.spheres).collect();
    spheres.sort_unstable();
    spheres.dedup();
    let range = |value: fn(&PictureRow) -> f64| {
        let values = usable.iter().map(|row| value(row));
        axis::range(values, 1.45, 1.25).ok_or_else(|| {
            Error::Usage("cannot draw a chart of pictures: no row has a time and an error".into())
        })
    };
    let (x, y) = (range(|row| row.ms)?, range(|row| row.rms)?);
    let columns = scenes.len().min(3);
    let count = scenes.len().div_ceil(columns);
    let height = 220 + 480 * count as u32;
    let mut canvas = Canvas::new([1600, height])?;
    let title = "What accuracy costs: error of whole pictures against time";
    let lines = [
        "Up: root mean square of the difference to a ray-cast truth, over the mean radiance. Right: milliseconds of the shadow pass for a million samples. Both scales are logarithmic.",
        "A number is the SH order; 4 (6) is order 4 with blockers accumulated at order 6. The line is the Pareto front: nothing measured is both faster and more accurate.",
    ];
    head(&mut canvas, title, lines);
    let bottom = f64::from(height);
    let frames = rows_of_panels(
        Rect {
            least: [60.0, 118.0],
            greatest: [1576.0, bottom - 52.0],
        },
        columns,
        count,
    );
    for (scene, frame) in scenes.iter().zip(frames) {
        let rows: Vec<&PictureRow> = usable
            .iter()
            .copied()
            .filter(|row| row.scene == *scene)
            .collect();
        let best = pareto::front(&rows.iter().map(|row| (row.ms, row.rms)).collect::<Vec<_>>());
        let dot = |(i, row): (usize, &&PictureRow)| Dot {
            x: row.ms,
            y: row.rms,
            top: row.rms,
            series: spheres.binary_search(&row.spheres).unwrap_or_default(),
            hollow: false,
            front: best.contains(&i),
            name: Some(if row.accumulation_order == row.order {
                row.order.to_string()
            } else {
                format!("{} ({})", row.order, row.accumulation_order)
            }),
        };
        let dots: Vec<Dot> = rows.iter().enumerate().map(dot).collect();
        let panel = Panel::new(&mut canvas, frame, scene, x, y);
        panel.axes(&mut canvas, "ms a million samples", "RMS error");
        panel.front(&mut canvas, &dots);
        panel.dots(&mut canvas, &dots);
    }
    let words: Vec<String> = spheres
        .iter()
        .map(|count| format!("{count} spheres"))
        .collect();
    let entries = words.iter().map(String::as_str).enumerate();
    series(&mut canvas, bottom - 26.0, entries);
    canvas.write(file)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accuracy::pareto::samples::row;

    fn some_rows() -> Vec<Row> {
        let orders = 3..=6;
        orders
            .flat_map(|order| {
                let slow = 3_f64.powi(order as i32);
                [
                    row(order, "saturating", "fitted", "lanes", 0.05, Some(slow)),
                    row(order, "ps*:2", "eigen", "lanes", 0.07, Some(3.0 * slow)),
                    row(
                        order,
                        "ps:2",
                        "eigen",
                        "scalar",
                        f64::INFINITY,
                        Some(2.0 * slow),
                    ),
                    row(order, "eigen", "eigen", "scalar", 0.06, Some(900.0 * slow)),
                    row(order, "hyb", "eigen", "scalar", f64::NAN, Some(slow)),
                    row(order, "ol", "eigen", "scalar", 0.0, Some(0.0)),
                    row(order, "something new", "none", "gpu", 0.03, None),
                ]
            })
            .collect()
    }

    fn picture(scene: &str, spheres: usize, rms: f64) -> PictureRow {
        PictureRow {
            scene: scene.into(),
            order: 4,
            accumulation_order: 6,
            spheres,
            factor: 1.0,
            rms,
            bias: 0.0,
            ms: 10.0 * spheres as f64,
        }
    }

    /// A folder of its own for a test, gone afterwards.
    fn within(name: &str, test: impl FnOnce(&Path)) {
        let folder = std::env::temp_dir().join(format!("gaunt-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        test(&folder);
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn charts_are_the_same_bytes_every_time() {
        within("charts", |folder| {
            let pictures_rows = [
                picture("one", 8, 0.1),
                picture("two", 16, 0.05),
                picture("two", 32, f64::NAN),
            ];
            let draw = |name: &str| {
                let file = folder.join(name);
                methods(&some_rows(), &file).unwrap();
                let first = std::fs::read(&file).unwrap();
                pictures(&pictures_rows, &file).unwrap();
                [first, std::fs::read(&file).unwrap()]
            };
            let svg = draw("a.svg");
            assert_eq!(svg, draw("b.SVG"));
            assert_eq!(draw("a.png"), draw("b.png"));
            let text = String::from_utf8(svg[0].clone()).unwrap();
            assert!(text.starts_with("<svg width=\"1600\" height=\"1240\""));
            assert!(text.contains("saturating") && text.contains("Order 6"));
            let size = image::image_dimensions(folder.join("a.png")).unwrap();
            assert_eq!(size, (1600, 700));
        });
    }

    #[test]
    fn what_cannot_be_drawn_leaves_no_file() {
        within("no-charts", |folder| {
            let ending = methods(&some_rows(), &folder.join("chart.pdf"))
                .unwrap_err()
                .to_string();
            assert!(ending.contains(".svg or .png"), "{ending}");
            let empty = methods(&[], &folder.join("chart.svg"))
                .unwrap_err()
                .to_string();
            assert!(empty.contains("no row"), "{empty}");
            assert!(pictures(&[picture("one", 8, 0.0)], &folder.join("chart.png")).is_err());
            assert_eq!(std::fs::read_dir(folder).unwrap().count(), 0);
        });
    }
}
