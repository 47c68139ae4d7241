//! The orders that there are, and what is done by an order that is known at run time.

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

/// An expression for an order that is known at run time: `C` in it is the number of coefficients, order². After `else` comes
/// what there is instead for an order without routines; without it that panics with the sentence of [`OrderError`].
///
/// ```
/// use sh_core::{OrderError, Routines, for_order};
/// fn upwards<const C: usize>() -> f32
/// where
///     [f32; C]: Routines<f32>,
/// {
///     <[f32; C]>::cosine([0.0, 1.0, 0.0])[1]
/// }
/// fn of_order(order: usize) -> Result<f32, OrderError> {
///     for_order!(order, C => Ok(upwards::<C>()), else => Err(OrderError(order)))
/// }
/// assert_eq!(of_order(3), Ok(upwards::<9>()));
/// assert_eq!(of_order(7), Err(OrderError(7)));
/// assert_eq!(for_order!(6, C => [0.0; C].len()), 36);
/// ```
#[macro_export]
macro_rules! for_order {
    ($order:expr, $c:ident => $of:expr $(, else => $other:expr)?) => {
        match $order {
            2 => { const $c: usize = 4; $of }
            3 => { const $c: usize = 9; $of }
            4 => { const $c: usize = 16; $of }
            5 => { const $c: usize = 25; $of }
            6 => { const $c: usize = 36; $of }
            $(_ => $other,)?
            #[allow(unreachable_patterns, reason = "none is left after `else`")]
            order => panic!("{}", $crate::OrderError(order)),
        }
    };
}
