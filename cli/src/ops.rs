//! `gaunt ops`: how many operations each generated routine takes.

use serde::Serialize;
use sh_codegen::routines::{FORMS, ORDERS, ROUTINES};
use std::fmt::Write;

/// The operations of a routine at an order. A fused multiply-add counts as one of each.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Count {
    /// The routine's name; other forms than the one emitted have the form's name behind a slash.
    pub routine: &'static str,
    /// SH order.
    pub order: usize,
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
}

/// All routines, each for all orders; at the end the forms that are not emitted.
///
/// ```
/// let square = gaunt::ops::counts().into_iter().find(|c| c.routine == "square" && c.order == 2);
/// assert_eq!(square.map(|c| c.mul <= 14 && c.add <= 3), Some(true));
/// ```
pub fn counts() -> Vec<Count> {
    let routines = ROUTINES.iter().chain(FORMS);
    routines
        .flat_map(|routine| {
            ORDERS.map(|order| {
                let ops = routine.ops(order);
                Count {
                    routine: routine.name,
                    order,
                    mul: ops.mul,
                    add: ops.add,
                }
            })
        })
        .collect()
}

/// The counts as JSON, an object a line.
///
/// # Errors
/// Never, as long as a count has only names and numbers.
pub fn json(counts: &[Count]) -> Result<String, serde_json::Error> {
    let lines: Result<Vec<_>, _> = counts.iter().map(serde_json::to_string).collect();
    Ok(format!("[{}]", lines?.join(",\n")))
}

/// The counts as a table: a row a routine, a column an order.
pub fn table(counts: &[Count]) -> String {
    let mut text = format!("{:<18}", "mul + add");
    for order in ORDERS {
        write!(text, "{:>15}", format!("order {order}")).expect("writing to a string");
    }
    for row in counts.chunks(ORDERS.count()) {
        write!(text, "\n{:<18}", row[0].routine).expect("writing to a string");
        for count in row {
            write!(text, "{:>15}", format!("{} + {}", count.mul, count.add))
                .expect("writing to a string");
        }
    }
    text
}
