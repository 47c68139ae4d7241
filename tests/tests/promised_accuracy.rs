//! What the default exponential promises over the standard random sets of blockers, and that from order 3 on no published
//! method has both less error and fewer operations.

use gaunt_lab::accuracy::Row;
use std::sync::LazyLock;

static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| gaunt_lab::accuracy::rows(&|_| {}));

/// Rows whose logarithms are summed in the order of the result.
fn of(order: usize) -> impl Iterator<Item = &'static Row> {
    ROWS.iter()
        .filter(move |row| row.order == order && row.accumulation_order == order)
        .filter(|row| row.backend == "scalar")
}

fn default(order: usize) -> &'static Row {
    of(order)
        .find(|row| row.exponential == "saturating")
        .expect("the default is among them")
}

#[test]
fn errors_are_those_promised() {
    // Mean, 95th percentile and maximum of |g - V| / |1|; the largest over 1 to 4,096 identical blockers.
    for (order, mean, p95, max, stacked) in [
        (2, 0.047, 0.108, 0.20, 0.31),
        (3, 0.053, 0.112, 0.16, 0.20),
        (4, 0.045, 0.085, 0.125, 0.13),
        (5, 0.038, 0.070, 0.104, 0.11),
        (6, 0.033, 0.060, 0.080, 0.12),
    ] {
        let row = default(order);
        println!(
            "order {order}: {:.4} {:.4} {:.4}, stacked {:.4}",
            row.mean, row.p95, row.max, row.stacked
        );
        assert!(
            row.mean <= mean && row.p95 <= p95 && row.max <= max,
            "{row:?}"
        );
        assert!(row.stacked <= stacked, "{row:?}");
        assert!(row.rounding < 1e-6, "{row:?}");
    }
}

/// Published methods that are cheaper and more accurate in the mean than the default.
fn better(order: usize) -> Vec<&'static Row> {
    let operations = |row: &Row| row.mul + row.add + row.exp;
    let ours = default(order);
    let published = of(order)
        .filter(|row| row.exponential != "saturating" && !row.exponential.starts_with("sampled"));
    let is_better = |row: &&Row| row.mean < ours.mean && operations(row) < operations(ours);
    published.filter(is_better).collect()
}

#[test]
fn no_published_method_is_cheaper_and_more_accurate_from_order_3_on() {
    for order in 3..=6 {
        let better = better(order);
        assert!(
            better.is_empty(),
            "{better:?}\nare cheaper and more accurate than\n{:?}",
            default(order)
        );
    }
}

/// At order 2 most are: cheaper, and by up to a thirtieth more accurate in the mean, because its default is fitted to what many
/// blockers do as well. In heavy sets each of them errs by twice as much, and where blockers lie on each other by three times as
/// much or without bound.
#[test]
fn at_order_2_published_methods_are_better_but_for_many_blockers() {
    let ours = default(2);
    let better = better(2);
    assert!(!better.is_empty(), "order 2 is as the others are");
    for row in better {
        assert!(row.mean > 0.96 * ours.mean, "{row:?}\n{ours:?}");
        assert!(row.heavy > 1.9 * ours.heavy, "{row:?}\n{ours:?}");
        assert!(row.stacked > 3.0 * ours.stacked, "{row:?}\n{ours:?}");
    }
}

#[test]
fn a_higher_order_of_accumulation_is_more_accurate() {
    for order in 2..=5 {
        let mut means: Vec<(usize, f64)> = ROWS
            .iter()
            .filter(|row| row.order == order && row.backend == "scalar")
            .filter(|row| row.exponential == "saturating")
            .map(|row| (row.accumulation_order, row.mean))
            .collect();
        means.sort_by_key(|(accumulation, _)| *accumulation);
        assert_eq!(means.len(), 7 - order);
        let (first, last) = (means[0].1, means[means.len() - 1].1);
        assert!(last < 0.85 * first, "order {order}: {means:?}");
    }
}
