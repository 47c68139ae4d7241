//! How points of a series look: a colour and a form each, so that either tells them apart.

use super::canvas::{Canvas, Color, Point};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Lines and letters.
pub(super) const INK: Color = [34, 36, 42];
/// Letters that matter less.
pub(super) const SOFT: Color = [96, 100, 110];
/// Lines behind everything.
pub(super) const GRID: Color = [229, 231, 235];

/// A colour and a form.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mark {
    pub color: Color,
    form: Form,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Form {
    /// A regular polygon: corners, and the direction of the first in turns, clockwise from the right.
    Regular(u32, f64),
    /// A cross of four arms, turned so far.
    Cross(f64),
}

/// The colours are those of Okabe & Ito (2008), which people with any vision of colours tell apart, without
/// their yellow, which white swallows.
const MARKS: [Mark; 8] = [
    Mark {
        color: [213, 94, 0],
        form: Form::Regular(24, 0.0),
    },
    Mark {
        color: [0, 114, 178],
        form: Form::Regular(3, -0.25),
    },
    Mark {
        color: [0, 158, 115],
        form: Form::Regular(4, 0.0),
    },
    Mark {
        color: [204, 121, 167],
        form: Form::Regular(3, 0.25),
    },
    Mark {
        color: [230, 159, 0],
        form: Form::Regular(4, 0.125),
    },
    Mark {
        color: [86, 180, 233],
        form: Form::Regular(5, -0.25),
    },
    Mark {
        color: [34, 36, 42],
        form: Form::Cross(0.125),
    },
    Mark {
        color: [120, 124, 132],
        form: Form::Cross(0.0),
    },
];

/// The mark of a series, by its number.
pub(super) fn mark(series: usize) -> Mark {
    MARKS[series % MARKS.len()]
}

impl Mark {
    /// In full: over a white rim that parts it from its neighbours. A hollow one is white within.
    pub fn draw(&self, canvas: &mut Canvas, at: Point, radius: f64, hollow: bool) {
        canvas.fill(&self.outline(at, radius + 2.0), [255; 3], 1.0);
        canvas.fill(&self.outline(at, radius), self.color, 1.0);
        if hollow {
            canvas.fill(&self.outline(at, radius - 2.2), [255; 3], 1.0);
        }
    }

    /// Small and pale.
    pub fn draw_pale(&self, canvas: &mut Canvas, at: Point, radius: f64, hollow: bool) {
        canvas.fill(&self.outline(at, radius), self.pale(), 1.0);
        if hollow {
            canvas.fill(&self.outline(at, radius - 1.7), [255; 3], 1.0);
        }
    }

    /// More than halfway to a light grey, and opaque: where several meet they must not look like one in full.
    pub fn pale(&self) -> Color {
        self.color.map(|c| ((u16::from(c) * 2 + 205 * 3) / 5) as u8)
    }

    /// Corners. Radii are those of the circle of about the same area.
    fn outline(&self, [x, y]: Point, radius: f64) -> Vec<Point> {
        match self.form {
            Form::Regular(corners, turn) => {
                let sides = f64::from(corners);
                let radius = radius * ((TAU / 2.0) / (sides / 2.0 * (TAU / sides).sin())).sqrt();
                let corner = |i| {
                    let (sin, cos) = ((f64::from(i) / sides + turn) * TAU).sin_cos();
                    [x + radius * cos, y + radius * sin]
                };
                (0..corners).map(corner).collect()
            }
            Form::Cross(turn) => {
                let (long, thick) = (1.25 * radius, 0.45 * radius);
                let arm = |i| {
                    let (sin, cos) = (f64::from(i) * FRAC_PI_2 + turn * TAU).sin_cos();
                    [[thick, -thick], [long, -thick], [long, thick]]
                        .map(|[a, b]| [x + a * cos - b * sin, y + a * sin + b * cos])
                };
                (0..4).flat_map(arm).collect()
            }
        }
    }
}
