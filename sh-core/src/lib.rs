//! (under construction)
#![cfg_attr(not(feature = "std"), no_std)]
#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("sh-core needs elementary functions: enable the feature `std` (default) or `libm`");
pub mod generated;
mod lane;
mod real;
pub use generated::Routines;
pub use lane::Lane;
