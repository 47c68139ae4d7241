//! A panel: a frame with two logarithmic axes, points in it, and their names.

use super::axis::Axis;
use super::canvas::{Align, Canvas, Point};
use super::labels::{Anchor, Obstacle, Rect, Shape, place};
use super::mark::{GRID, INK, SOFT, mark};

/// A point of a chart.
#[derive(Clone)]
pub(super) struct Dot {
    /// Cost and error; an error may be infinite.
    pub x: f64,
    pub y: f64,
    /// The upper end of the whisker.
    pub top: f64,
    pub series: usize,
    pub hollow: bool,
    pub front: bool,
    /// What it is called, if it is to be named.
    pub name: Option<String>,
}

/// The inside of a frame.
pub(super) struct Panel {
    area: Rect,
    x: Axis,
    y: Axis,
}

/// Sizes of letters and marks, in pixels.
const TITLE: f64 = 20.0;
const WORDS: f64 = 15.0;
const NAMES: f64 = 15.0;
const FULL: f64 = 6.5;
const SMALL: f64 = 4.5;

/// Divides a rectangle into frames, row by row.
pub(super) fn rows_of_panels(all: Rect, columns: usize, rows: usize) -> Vec<Rect> {
    let [x, y] = all.least;
    let gap = 26.0;
    let share = |length: f64, parts: usize| (length + gap) / parts as f64;
    let (width, height) = (
        share(all.greatest[0] - x, columns),
        share(all.greatest[1] - y, rows),
    );
    let frame = |i: usize| {
        let least = [
            x + width * (i % columns) as f64,
            y + height * (i / columns) as f64,
        ];
        Rect {
            least,
            greatest: [least[0] + width - gap, least[1] + height - gap],
        }
    };
    (0..columns * rows).map(frame).collect()
}

/// A frame without a panel, and why.
pub(super) fn missing(canvas: &mut Canvas, frame: Rect, words: &str) {
    let [x, y] = frame.least;
    canvas.bold(words, [x, y + 18.0], TITLE, SOFT, Align::Left);
}

impl Panel {
    /// A titled panel within a frame, for values in these ranges.
    pub fn new(canvas: &mut Canvas, frame: Rect, title: &str, x: [f64; 2], y: [f64; 2]) -> Self {
        let least = [frame.least[0] + 58.0, frame.least[1] + 38.0];
        let greatest = [frame.greatest[0], frame.greatest[1] - 46.0];
        canvas.bold(
            title,
            [least[0], frame.least[1] + 18.0],
            TITLE,
            INK,
            Align::Left,
        );
        Self {
            area: Rect { least, greatest },
            x: Axis::new(x, [least[0], greatest[0]]),
            y: Axis::new(y, [greatest[1], least[1]]),
        }
    }

    /// Grid, numbers and the names of the axes.
    pub fn axes(&self, canvas: &mut Canvas, across: &str, up: &str) {
        let ([left, top], [right, bottom]) = (self.area.least, self.area.greatest);
        for tick in self.x.ticks(64.0) {
            let x = self.x.at(tick);
            canvas.line(&[[x, top], [x, bottom]], GRID, 1.0);
            canvas.text(
                &tick.to_string(),
                [x, bottom + 15.0],
                WORDS,
                SOFT,
                Align::Center,
            );
        }
        for tick in self.y.ticks(24.0) {
            let y = self.y.at(tick);
            canvas.line(&[[left, y], [right, y]], GRID, 1.0);
            canvas.text(
                &tick.to_string(),
                [left - 8.0, y],
                WORDS,
                SOFT,
                Align::Right,
            );
        }
        canvas.line(&[[left, top], [left, bottom], [right, bottom]], SOFT, 1.2);
        canvas.text(
            across,
            [(left + right) / 2.0, bottom + 36.0],
            WORDS,
            INK,
            Align::Center,
        );
        canvas.upwards(up, [left - 56.0, (top + bottom) / 2.0], WORDS, INK);
    }

    fn at(&self, dot: &Dot) -> Point {
        [self.x.at(dot.x), self.y.at(dot.y)]
    }

    /// The border of what is beaten: from each point of the front right, then down to the next.
    fn steps(&self, dots: &[Dot]) -> Vec<Point> {
        let mut front: Vec<&Dot> = dots.iter().filter(|dot| dot.front).collect();
        front.sort_by(|a, b| a.x.total_cmp(&b.x).then(b.y.total_cmp(&a.y)));
        let mut steps: Vec<Point> = Vec::new();
        for dot in front {
            let [x, y] = self.at(dot);
            if let Some([_, above]) = steps.last().copied() {
                steps.push([x, above]);
            }
            steps.push([x, y]);
        }
        // What is slower than the last is beaten by it.
        if let Some([_, y]) = steps.last().copied() {
            steps.push([self.area.greatest[0], y]);
        }
        steps
    }

    /// Draws that border, and tints what is beaten.
    pub fn front(&self, canvas: &mut Canvas, dots: &[Dot]) {
        let steps = self.steps(dots);
        if let (Some(first), Some(last)) = (steps.first(), steps.last()) {
            let top = self.area.least[1];
            let mut beaten = vec![[first[0], top]];
            beaten.extend(&steps);
            beaten.push([last[0], top]);
            canvas.fill(&beaten, [120, 130, 150], 0.06);
            canvas.line(&steps, INK, 1.6);
        }
    }

    /// Draws points and names: those off the front first.
    pub fn dots(&self, canvas: &mut Canvas, dots: &[Dot]) {
        let top = self.area.least[1];
        for dot in dots.iter().filter(|dot| !dot.front) {
            let [x, y] = self.at(dot);
            let color = mark(dot.series).color;
            // Beyond an edge: an arrow there.
            if !self.y.holds(dot.y) {
                canvas.fill(
                    &[[x - 5.0, top + 9.0], [x, top + 1.0], [x + 5.0, top + 9.0]],
                    color,
                    0.6,
                );
            } else if !self.x.holds(dot.x) {
                canvas.fill(
                    &[[x - 9.0, y - 5.0], [x - 1.0, y], [x - 9.0, y + 5.0]],
                    color,
                    0.6,
                );
            } else {
                mark(dot.series).draw_pale(canvas, [x, y], SMALL, dot.hollow);
            }
        }
        for dot in dots.iter().filter(|dot| dot.front) {
            let [x, y] = self.at(dot);
            let color = mark(dot.series).pale();
            if dot.top > dot.y {
                let end = self.y.at(dot.top);
                canvas.line(&[[x, y], [x, end]], color, 1.4);
                canvas.line(&[[x - 4.0, end], [x + 4.0, end]], color, 1.4);
            }
        }
        for dot in dots.iter().filter(|dot| dot.front) {
            mark(dot.series).draw(canvas, self.at(dot), FULL, dot.hollow);
        }
        self.names(canvas, dots);
    }

    fn names(&self, canvas: &mut Canvas, dots: &[Dot]) {
        // Those of the front have the first choice.
        let mut named: Vec<(&Dot, &str)> = dots
            .iter()
            .filter_map(|dot| Some((dot, dot.name.as_deref()?)))
            .collect();
        named.sort_by_key(|(dot, _)| !dot.front);
        let size = |dot: &Dot| if dot.front { NAMES } else { NAMES - 2.0 };
        let anchors: Vec<Anchor> = named
            .iter()
            .map(|(dot, name)| Anchor {
                at: self.at(dot),
                // Viewers of SVG files may have a wider font.
                size: [1.06 * canvas.width(name, size(dot)), size(dot)],
                // The front is named in any case; a lesser name may not cover anything.
                patience: if dot.front { f64::INFINITY } else { 24.0 },
            })
            .collect();
        let places = place(&anchors, &self.obstacles(dots), self.inner());
        for (((dot, name), anchor), place) in named.iter().zip(&anchors).zip(places) {
            let Some(place) = place else { continue };
            let (rect, color) = (place.rect, if dot.front { INK } else { SOFT });
            if let Some(end) = place.leader {
                canvas.line(&[anchor.at, end], SOFT, 0.8);
            }
            let middle = (rect.least[1] + rect.greatest[1]) / 2.0;
            // Whatever the font's width, the end next to the point stays where it is.
            let (x, align) = if rect.greatest[0] <= anchor.at[0] {
                (rect.greatest[0] - 2.0, Align::Right)
            } else if rect.least[0] >= anchor.at[0] {
                (rect.least[0] + 2.0, Align::Left)
            } else {
                ((rect.least[0] + rect.greatest[0]) / 2.0, Align::Center)
            };
            // Lines behind the words, if it cannot be helped, are dimmed.
            let ([left, top], [right, bottom]) = (rect.least, rect.greatest);
            let [top, bottom] = [top + 2.0, bottom - 2.0];
            canvas.fill(
                &[[left, top], [right, top], [right, bottom], [left, bottom]],
                [247, 248, 250],
                0.6,
            );
            canvas.text(name, [x, middle], size(dot), color, align);
        }
    }

    /// The area without a rim.
    fn inner(&self) -> Rect {
        Rect {
            least: self.area.least.map(|side| side + 3.0),
            greatest: self.area.greatest.map(|side| side - 3.0),
        }
    }

    fn obstacles(&self, dots: &[Dot]) -> Vec<Obstacle> {
        let mut obstacles = Vec::new();
        for dot in dots {
            let [x, y] = self.at(dot);
            let (radius, weight) = if dot.front {
                (FULL + 1.5, 120.0)
            } else {
                (SMALL + 0.5, 25.0)
            };
            let shape = Shape::Mark(Rect::around([x, y], [radius; 2]));
            obstacles.push(Obstacle { shape, weight });
            if dot.front && dot.top > dot.y {
                let shape = Shape::Line([x, y - radius], [x, self.y.at(dot.top)]);
                obstacles.push(Obstacle {
                    shape,
                    weight: 25.0,
                });
            }
        }
        for pair in self.steps(dots).windows(2) {
            let shape = Shape::Line(pair[0], pair[1]);
            obstacles.push(Obstacle {
                shape,
                weight: 30.0,
            });
            // Below the front nothing can be in the way.
            let above = [pair[0][0], self.area.least[1]];
            let beaten = Shape::Ground(Rect {
                least: above,
                greatest: pair[1],
            });
            obstacles.push(Obstacle {
                shape: beaten,
                weight: 6.0,
            });
        }
        obstacles
    }
}
