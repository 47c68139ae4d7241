//! Benchmarks: how long the routines take, and how many instructions, one result at a time and in lanes.
//!
//! ```text
//! cargo bench -p sh-benches --bench batch          nanoseconds a result: scalar, 8 lanes, 16 lanes
//! cargo bench -p sh-benches --bench forms          which form of product and square is the faster
//! cargo bench -p sh-benches --bench instructions   instructions a result (needs valgrind)
//! ```
//!
//! [`cases::all`] is the table of what is measured. Time on a machine that does other work says little, so
//! what is compared runs in turns ([`timing::in_turns`]) and is judged by its fastest round and by the
//! median of the rounds' ratios. Instruction counts do not depend on the load at all.

pub mod batch;
pub mod cases;
pub mod forms;
pub mod fused;
pub mod timing;
