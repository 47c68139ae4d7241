//! Which methods are worth their time: those that no other beats in both time and error.

use super::Row;

/// The points that no other beats, as indices sorted by cost: from the cheapest to the most accurate.
///
/// A point `(cost, error)` beats another if it is no worse in both and better in one. So equal points stay
/// together, on the front or off it. What is not finite is never on the front and beats nobody.
///
/// ```
/// use gaunt_lab::accuracy::pareto::front;
/// // The second is slower than the first and no more accurate.
/// assert_eq!(front(&[(1.0, 0.2), (2.0, 0.2), (4.0, 0.1), (f64::NAN, 0.0)]), [0, 2]);
/// ```
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let finite = |&i: &usize| points[i].0.is_finite() && points[i].1.is_finite();
    let mut order: Vec<usize> = (0..points.len()).filter(finite).collect();
    // Stable, so that equal points keep their order. Finite numbers always compare.
    order.sort_by(|&a, &b| {
        let by_cost = points[a].partial_cmp(&points[b]);
        by_cost.unwrap_or(std::cmp::Ordering::Equal)
    });
    let mut last: Option<(f64, f64)> = None;
    order.retain(|&i| {
        let stays = last.is_none_or(|best| points[i].1 < best.1 || points[i] == best);
        if stays {
            last = Some(points[i]);
        }
        stays
    });
    order
}

/// The same method on all backends that were measured.
#[derive(Clone, Debug)]
pub struct Method<'a> {
    rows: Vec<&'a Row>,
}

impl<'a> Method<'a> {
    /// The row that stands for the method: vector lanes if they were timed, else scalar, else any.
    pub fn row(&self) -> &'a Row {
        let timed = |backend| {
            let mut rows = self.rows.iter();
            rows.find(|row| row.backend == backend && row.ns.is_some())
        };
        timed("lanes").or(timed("scalar")).unwrap_or(&self.rows[0])
    }

    /// Nanoseconds a receiver on one backend: `scalar`, `lanes` or `gpu`.
    pub fn ns(&self, backend: &str) -> Option<f64> {
        let mut rows = self.rows.iter().filter(|row| row.backend == backend);
        rows.find_map(|row| row.ns)
    }

    /// Nanoseconds a receiver on the CPU: with vector lanes, or scalar where lanes do not have the method.
    pub fn cpu(&self) -> Option<f64> {
        self.ns("lanes").or(self.ns("scalar"))
    }

    /// The largest rounding error of all backends.
    pub fn rounding(&self) -> f64 {
        self.rows
            .iter()
            .fold(0.0, |worst, row| row.rounding.max(worst))
    }

    /// Whether this is what the shadow pass does where nobody asks for anything else.
    pub fn is_default(&self) -> bool {
        let row = self.rows[0];
        row.exponential == "saturating"
            && row.logarithm == "fitted"
            && row.accumulation_order == row.order
    }

    /// What sets it apart: `saturating`, `saturating, accumulated at 6`, `ps*:2, eigen log`.
    pub fn label(&self) -> String {
        let row = self.rows[0];
        let mut label = row.exponential.clone();
        let plain = row.logarithm == "none"
            || (row.exponential == "saturating" && row.logarithm == "fitted");
        if !plain {
            label += &format!(", {} log", row.logarithm);
        }
        if row.accumulation_order != row.order {
            label += &format!(", accumulated at {}", row.accumulation_order);
        }
        label
    }
}

/// The methods of one order, in the order of their first rows.
pub fn methods(rows: &[Row], order: usize) -> Vec<Method<'_>> {
    let mut methods: Vec<Method<'_>> = Vec::new();
    for row in rows.iter().filter(|row| row.order == order) {
        let same = |method: &&mut Method<'_>| {
            let known = method.rows[0];
            (
                &known.exponential,
                &known.logarithm,
                known.accumulation_order,
            ) == (&row.exponential, &row.logarithm, row.accumulation_order)
        };
        match methods.iter_mut().find(same) {
            Some(method) => method.rows.push(row),
            None => methods.push(Method { rows: vec![row] }),
        }
    }
    methods
}

/// The methods that no other beats in both CPU time and mean error, as indices from the fastest to the most
/// accurate.
pub fn best(methods: &[Method<'_>]) -> Vec<usize> {
    let point = |method: &Method<'_>| (method.cpu().unwrap_or(f64::NAN), method.row().mean);
    front(&methods.iter().map(point).collect::<Vec<_>>())
}

/// Rows for tests.
#[cfg(test)]
pub(super) mod samples {
    use crate::accuracy::Row;

    pub fn row(
        order: usize,
        exponential: &str,
        logarithm: &str,
        backend: &str,
        mean: f64,
        ns: Option<f64>,
    ) -> Row {
        Row {
            order,
            exponential: exponential.into(),
            logarithm: logarithm.into(),
            accumulation_order: order,
            backend: backend.into(),
            mean,
            p95: 2.0 * mean,
            max: 3.0 * mean,
            rounding: if backend == "lanes" { 2e-7 } else { 1e-7 },
            mul: 100.0,
            add: 2000.0,
            exp: 50.0,
            ns,
            heavy: 2.5 * mean,
            stacked: 1e15,
            from_exact: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::samples::row;
    use super::{best, front, methods};
    use proptest::prelude::*;

    fn beats(a: (f64, f64), b: (f64, f64)) -> bool {
        a.0 <= b.0 && a.1 <= b.1 && a != b
    }

    /// Few different values, so that ties are common.
    fn value() -> impl Strategy<Value = f64> {
        prop_oneof![
            8 => (-2..6_i32).prop_map(f64::from),
            4 => 0.0..4.0,
            1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 5e-324]),
        ]
    }

    proptest! {
        #[test]
        fn on_the_front_is_exactly_who_is_not_beaten(
            points in prop::collection::vec((value(), value()), 0..40),
        ) {
            let front = front(&points);
            let finite = |p: &(f64, f64)| p.0.is_finite() && p.1.is_finite();
            for (i, &point) in points.iter().enumerate() {
                let beaten = points.iter().any(|&other| finite(&other) && beats(other, point));
                let expected = finite(&point) && !beaten;
                prop_assert_eq!(front.contains(&i), expected, "{} {:?}", i, point);
            }
        }

        #[test]
        fn the_front_falls_from_cheap_to_accurate(
            points in prop::collection::vec((value(), value()), 0..40),
        ) {
            for pair in front(&points).windows(2) {
                let (a, b) = (points[pair[0]], points[pair[1]]);
                prop_assert!(a == b || (a.0 < b.0 && a.1 > b.1), "{:?} {:?}", a, b);
            }
        }
    }

    #[test]
    fn equal_points_share_the_front_and_nothing_makes_none() {
        assert_eq!(front(&[(1.0, 1.0), (0.0, 2.0), (1.0, 1.0)]), [1, 0, 2]);
        assert_eq!(front(&[(0.0, 1.0), (-0.0, 1.0)]), [0, 1]);
        assert!(front(&[]).is_empty());
        assert!(front(&[(f64::INFINITY, 0.0), (0.0, f64::NAN)]).is_empty());
    }

    #[test]
    fn backends_of_a_method_are_one() {
        let mut higher = row(4, "saturating", "fitted", "lanes", 0.04, Some(20.0));
        higher.accumulation_order = 6;
        let rows = [
            row(4, "saturating", "fitted", "scalar", 0.05, Some(60.0)),
            row(4, "saturating", "fitted", "lanes", 0.05, Some(10.0)),
            row(4, "eigen", "eigen", "lanes", 0.06, None),
            row(4, "eigen", "eigen", "scalar", 0.06, Some(900.0)),
            row(5, "ol", "eigen", "scalar", 0.01, Some(1.0)),
            row(4, "product chain", "none", "gpu", 0.01, Some(1.0)),
            higher,
        ];
        let methods = methods(&rows, 4);
        let labels: Vec<String> = methods.iter().map(|m| m.label()).collect();
        let expected = [
            "saturating",
            "eigen, eigen log",
            "product chain",
            "saturating, accumulated at 6",
        ];
        assert_eq!(labels, expected);
        assert_eq!(methods[0].cpu(), Some(10.0));
        assert_eq!(methods[0].rounding(), 2e-7);
        assert_eq!(
            (methods[1].cpu(), methods[1].row().backend.as_str()),
            (Some(900.0), "scalar")
        );
        // What only a GPU has timed is no rival on the CPU.
        assert_eq!(best(&methods), [0, 3]);
        assert!(methods[0].is_default() && !methods[3].is_default());
    }
}
