//! The orders that there are.

use crate::constants::MAX_ORDER;
use core::fmt;
use core::ops::RangeInclusive;

/// The SH orders that there are routines for.
///
/// ```
/// assert!(sh_core::ORDERS.contains(&4) && !sh_core::ORDERS.contains(&7));
/// ```
pub const ORDERS: RangeInclusive<usize> = 2..=MAX_ORDER;

/// An SH order that there are no routines for.
///
/// ```
/// let error = sh_core::OrderError(7);
/// assert_eq!(error.to_string(), "SH order 7 is not available: orders 2 to 6 are");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OrderError(pub usize);

impl fmt::Display for OrderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(order) = self;
        let (first, last) = (ORDERS.start(), ORDERS.end());
        write!(
            f,
            "SH order {order} is not available: orders {first} to {last} are"
        )
    }
}

impl core::error::Error for OrderError {}
