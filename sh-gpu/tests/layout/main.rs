//! What kernels declare and what Rust does: records, and what passes are bound to.

mod records;
mod slots;
