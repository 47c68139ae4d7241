//! One panel that compares series of points.

use super::canvas::Canvas;
use super::labels::Rect;
use super::panel::{Dot, Panel};
use super::{axis, head, pareto, series};
use gaunt::Error;
use std::path::Path;

/// A series: its name, and its points: time, error, name.
pub type Series<'a> = (&'a str, Vec<(f64, f64, String)>);

/// Draws series of named points, errors against times, both logarithmic, with the border of what is beaten. `lines`
/// explain the chart, `axes` name what goes right and what goes up.
///
/// # Errors
/// A file whose name ends in neither `.svg` nor `.png` or that cannot be written; no point with a time and an error.
pub fn series_of_points(
    title: &str,
    lines: [&str; 2],
    axes: [&str; 2],
    all: &[Series],
    file: &Path,
) -> Result<(), Error> {
    let points: Vec<(usize, &(f64, f64, String))> = all
        .iter()
        .enumerate()
        .flat_map(|(i, (_, points))| points.iter().map(move |point| (i, point)))
        .collect();
    let best = pareto::front(
        &points
            .iter()
            .map(|(_, (x, y, _))| (*x, *y))
            .collect::<Vec<_>>(),
    );
    let dot = |(i, (series, (x, y, name))): (usize, &(usize, &(f64, f64, String)))| Dot {
        x: *x,
        y: *y,
        top: *y,
        series: *series,
        hollow: false,
        front: best.contains(&i),
        name: Some(name.clone()),
    };
    let dots: Vec<Dot> = points.iter().enumerate().map(dot).collect();
    let range = |values: fn(&Dot) -> f64| {
        axis::range(dots.iter().map(values), 1.45, 1.25).ok_or_else(|| {
            Error::Usage("cannot draw a chart: no point has a time and an error".into())
        })
    };
    let (x, y) = (range(|dot| dot.x)?, range(|dot| dot.y)?);
    let mut canvas = Canvas::new([1600, 900])?;
    head(&mut canvas, title, lines);
    let frame = Rect {
        least: [60.0, 118.0],
        greatest: [1576.0, 848.0],
    };
    let panel = Panel::new(&mut canvas, frame, "", x, y);
    panel.axes(&mut canvas, axes[0], axes[1]);
    panel.front(&mut canvas, &dots);
    panel.dots(&mut canvas, &dots);
    series(
        &mut canvas,
        874.0,
        all.iter().map(|(name, _)| *name).enumerate(),
    );
    canvas.write(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_to_draw_is_told_and_points_are_drawn() {
        let file = std::env::temp_dir().join(format!("gaunt-compare-{}.svg", std::process::id()));
        let draw = |points| series_of_points("T", ["", ""], ["x", "y"], &[("a", points)], &file);
        let error = draw(vec![(f64::NAN, 1.0, String::new())]).map_err(|e| e.to_string());
        assert!(error.is_err_and(|e| e.contains("no point")) && !file.exists());
        let points = vec![
            (1.0, 0.1, "first".to_owned()),
            (10.0, 0.01, "second".to_owned()),
        ];
        assert!(draw(points).is_ok());
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        assert!(text.contains("first") && text.contains("second"));
        let _ = std::fs::remove_file(&file);
    }
}
