//! The constants that kernels in WGSL have as well, printed from one table (`codegen/src/constants.rs`).
//!
//! They are here because every crate that needs them builds on this one, and hidden from its documentation because
//! nearly all belong to passes, of which this crate knows nothing. What others may rely on is shown where it means
//! something:
//!
//! ```
//! assert_eq!(sh_core::ROOT_FOUR_PI, sh_core::constants::ROOT_FOUR_PI);
//! assert_eq!(sh_core::seen::OWN, sh_core::constants::OWN);
//! ```

include!(concat!(env!("OUT_DIR"), "/constants.rs"));
