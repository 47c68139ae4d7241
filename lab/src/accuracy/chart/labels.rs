//! Where the names of points go, so that none covers another.

use super::canvas::Point;

/// An upright rectangle: its least and greatest corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rect {
    pub least: Point,
    pub greatest: Point,
}

impl Rect {
    /// Around a middle.
    pub fn around(middle: Point, half: Point) -> Self {
        Self {
            least: [middle[0] - half[0], middle[1] - half[1]],
            greatest: [middle[0] + half[0], middle[1] + half[1]],
        }
    }

    fn meets(&self, other: &Self) -> bool {
        (0..2).all(|i| self.least[i] < other.greatest[i] && other.least[i] < self.greatest[i])
    }

    fn inside(&self, other: &Self) -> bool {
        (0..2).all(|i| self.least[i] >= other.least[i] && self.greatest[i] <= other.greatest[i])
    }

    /// The nearest of its points.
    fn nearest(&self, p: Point) -> Point {
        [0, 1].map(|i| p[i].clamp(self.least[i], self.greatest[i]))
    }

    /// Whether a straight line from `a` to `b` passes through it: the line's part within each pair of sides.
    fn crossed(&self, a: Point, b: Point) -> bool {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for i in 0..2 {
            let step = b[i] - a[i];
            if step == 0.0 {
                if a[i] <= self.least[i] || a[i] >= self.greatest[i] {
                    return false;
                }
                continue;
            }
            let ends = [
                (self.least[i] - a[i]) / step,
                (self.greatest[i] - a[i]) / step,
            ];
            from = from.max(ends[0].min(ends[1]));
            to = to.min(ends[0].max(ends[1]));
        }
        from < to
    }
}

/// What a name had better not cover, and how bad it would be.
pub(super) struct Obstacle {
    pub shape: Shape,
    pub weight: f64,
}

/// Its form.
pub(super) enum Shape {
    /// Neither the name nor its line should be on it.
    Mark(Rect),
    /// The name should not be on it.
    Line(Point, Point),
    /// The same.
    Ground(Rect),
}

/// A point with the size of its name.
pub(super) struct Anchor {
    pub at: Point,
    pub size: Point,
    /// The name stays away where it would do more harm than this.
    pub patience: f64,
}

/// Where a name is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// What it covers.
    pub rect: Rect,
    /// The end of a line to its point, where it is too far away to be told without.
    pub leader: Option<Point>,
    cost: f64,
}

/// Free space around a name.
const MARGIN: f64 = 2.0;

/// From a point to its name, in pixels.
const DISTANCES: [f64; 12] = [
    9.0, 13.0, 18.0, 25.0, 34.0, 45.0, 60.0, 80.0, 105.0, 135.0, 170.0, 210.0,
];

/// Names nearer than this need no line.
const NEAR: f64 = 16.0;

/// How often every name looks again for a better place among the others.
const ROUNDS: usize = 5;

/// How many orders of the names are tried.
const TRIALS: usize = 16;

/// What a name without a place counts.
const ABSENT: f64 = 1000.0;

/// A place within the bounds for each name, or none where there is no free one that is worth it. The result
/// depends on nothing but the arguments.
///
/// One after the other, each name takes the cheapest of the free places around its point; then each looks again.
/// Who comes first matters, so several orders are tried, and the one that ends with the least cost counts.
pub(super) fn place(
    anchors: &[Anchor],
    obstacles: &[Obstacle],
    bounds: Rect,
) -> Vec<Option<Place>> {
    let candidates: Vec<Vec<Place>> = anchors
        .iter()
        .map(|anchor| candidates(anchor, obstacles, bounds))
        .collect();
    let mut best: Option<(f64, Vec<Option<Place>>)> = None;
    for trial in 0..TRIALS {
        let mut order: Vec<usize> = (0..anchors.len()).collect();
        // Forwards, backwards, and then strides through the names.
        match trial {
            0 => {}
            1 => order.reverse(),
            _ => order.sort_by_key(|i| (i * (2 * trial + 1)) % anchors.len()),
        }
        let mut places: Vec<Option<Place>> = vec![None; anchors.len()];
        let mut sum = 0.0;
        for _ in 0..ROUNDS {
            sum = 0.0;
            for &i in &order {
                places[i] = None;
                let free = candidates[i]
                    .iter()
                    .filter_map(|c| Some((disturbance(anchors, &places, i, c)?, c)));
                let cheapest = free.min_by(|a, b| a.0.total_cmp(&b.0));
                places[i] = cheapest.map(|(_, candidate)| *candidate);
                sum += cheapest.map_or(ABSENT, |(cost, _)| cost);
            }
        }
        if best.as_ref().is_none_or(|(least, _)| sum < *least) {
            best = Some((sum, places));
        }
    }
    best.map(|(_, places)| places).unwrap_or_default()
}

/// The cost of a place among the other names; none if it covers one.
fn disturbance(
    anchors: &[Anchor],
    places: &[Option<Place>],
    own: usize,
    candidate: &Place,
) -> Option<f64> {
    let mut cost = candidate.cost;
    for (i, other) in places.iter().enumerate() {
        let Some(other) = other.filter(|_| i != own) else {
            continue;
        };
        if candidate.rect.meets(&other.rect) {
            return None;
        }
        if candidate
            .leader
            .is_some_and(|end| other.rect.crossed(anchors[own].at, end))
        {
            cost += 300.0;
        }
        if let Some(end) = other.leader {
            if candidate.rect.crossed(anchors[i].at, end) {
                cost += 300.0;
            }
            if candidate
                .leader
                .is_some_and(|own_end| cross(anchors[own].at, own_end, anchors[i].at, end))
            {
                cost += 150.0;
            }
        }
    }
    Some(cost)
}

/// Whether two straight lines cross.
fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let side = |p: Point, q: Point, r: Point| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// All places within the bounds, with what each costs by itself.
fn candidates(anchor: &Anchor, obstacles: &[Obstacle], bounds: Rect) -> Vec<Place> {
    let half = anchor.size.map(|side| side / 2.0 + MARGIN);
    let mut places = Vec::new();
    for distance in DISTANCES {
        for step in 0..24 {
            let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 24.0).sin_cos();
            // The side or corner that faces the point is at the distance.
            let lean = (2.0 * cos).clamp(-1.0, 1.0);
            let middle = [
                anchor.at[0] + cos * distance + lean * half[0],
                anchor.at[1] + sin * distance + (3.0 * sin).clamp(-1.0, 1.0) * half[1],
            ];
            let rect = Rect::around(middle, half);
            if !rect.inside(&bounds) {
                continue;
            }
            let end = rect.nearest(anchor.at);
            let gap = (end[0] - anchor.at[0]).hypot(end[1] - anchor.at[1]);
            let leader = (gap > NEAR).then_some(end);
            // Beside is read more easily than above or below.
            let mut cost = 0.5 * gap + 3.0 * sin.abs();
            for obstacle in obstacles {
                let hit = match &obstacle.shape {
                    Shape::Mark(mark) => {
                        let own = mark.nearest(anchor.at) == anchor.at;
                        rect.meets(mark)
                            || (!own && leader.is_some_and(|end| mark.crossed(anchor.at, end)))
                    }
                    Shape::Line(a, b) => rect.crossed(*a, *b),
                    Shape::Ground(ground) => rect.meets(ground),
                };
                if hit {
                    cost += obstacle.weight;
                }
            }
            if cost <= anchor.patience {
                places.push(Place { rect, leader, cost });
            }
        }
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crowded_names_find_places_that_do_not_meet() {
        let bounds = Rect {
            least: [0.0; 2],
            greatest: [700.0, 400.0],
        };
        let anchors: Vec<Anchor> = (0..14)
            .map(|i| Anchor {
                at: [300.0 + 7.0 * f64::from(i), 250.0 + 3.0 * f64::from(i % 5)],
                size: [120.0, 14.0],
                patience: f64::INFINITY,
            })
            .collect();
        let places: Vec<Place> = place(&anchors, &[], bounds).into_iter().flatten().collect();
        assert_eq!(places.len(), anchors.len());
        for (i, a) in places.iter().enumerate() {
            assert!(a.rect.inside(&bounds));
            assert!(places[..i].iter().all(|b| !a.rect.meets(&b.rect)));
        }
    }

    #[test]
    fn names_keep_off_marks_and_lines() {
        let bounds = Rect {
            least: [0.0; 2],
            greatest: [400.0, 400.0],
        };
        let anchor = Anchor {
            at: [200.0, 200.0],
            size: [80.0, 14.0],
            patience: f64::INFINITY,
        };
        let wall = Obstacle {
            shape: Shape::Line([0.0, 190.0], [400.0, 190.0]),
            weight: 50.0,
        };
        let mark = Rect::around([250.0, 200.0], [20.0, 5.0]);
        let mark = Obstacle {
            shape: Shape::Mark(mark),
            weight: 50.0,
        };
        let placed = place(&[anchor], &[wall, mark], bounds)[0].expect("there is room");
        assert!(placed.rect.least[1] > 190.0);
        assert!(placed.rect.greatest[0] < 230.0 || placed.rect.least[1] > 205.0);
    }

    #[test]
    fn a_name_without_room_has_no_place() {
        let bounds = Rect {
            least: [0.0; 2],
            greatest: [50.0, 50.0],
        };
        let anchor = Anchor {
            at: [25.0, 25.0],
            size: [80.0, 14.0],
            patience: f64::INFINITY,
        };
        assert!(place(&[anchor], &[], bounds)[0].is_none());
    }

    #[test]
    fn a_name_stays_away_where_it_would_do_harm() {
        let bounds = Rect {
            least: [0.0; 2],
            greatest: [400.0, 400.0],
        };
        let harm = |patience| {
            let anchor = Anchor {
                at: [200.0, 200.0],
                size: [80.0, 14.0],
                patience,
            };
            let all = Obstacle {
                shape: Shape::Ground(bounds),
                weight: 150.0,
            };
            place(&[anchor], &[all], bounds)[0]
        };
        assert!(harm(100.0).is_none());
        assert!(harm(200.0).is_some());
    }

    #[test]
    fn a_line_crosses_a_rectangle_only_where_it_does() {
        let rect = Rect::around([0.0, 0.0], [2.0, 1.0]);
        assert!(rect.crossed([-5.0, 0.0], [5.0, 0.5]));
        assert!(rect.crossed([0.0, 0.0], [9.0, 9.0]));
        assert!(!rect.crossed([-5.0, 2.0], [5.0, 2.0]));
        assert!(!rect.crossed([3.0, -5.0], [3.0, 5.0]));
        assert!(!rect.crossed([-5.0, 0.0], [-3.0, 0.0]));
    }
}
