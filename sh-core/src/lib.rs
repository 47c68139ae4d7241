//! (under construction)
#![cfg_attr(not(feature = "std"), no_std)]
#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("sh-core needs elementary functions: enable the feature `std` (default) or `libm`");
mod lane;
mod real;
pub use lane::Lane;
