//! The program's parts, as a library so that tests can call them. Whoever wants the passes in a program of their own
//! takes `sh-cpu` or `sh-gpu`.
//!
//! A picture goes: arguments → a scene, loaded by `sh-bake` → a plan → the passes of a backend, frame by frame → a file
//! and a report.
//!
//! ```
//! // `gaunt eval`: one request, one answer.
//! use gaunt::eval::{Backend, answer};
//! let request = br#"{"op":"dot","order":2,"f":[1,0,0,0],"g":[1,2,3,4]}"#;
//! let refused = answer(&mut Backend::F64, request);
//! assert!(refused.starts_with(r#"{"error":"#));
//! let request = br#"{"op":"basis","order":2,"dir":[0,0,1]}"#;
//! assert!(answer(&mut Backend::F64, request).starts_with(r#"{"ok":[0.2820947917738781"#));
//! ```
//!
//! | command | module |
//! |---|---|
//! | `gaunt`, `gaunt render` | [`render`], with [`image`] for tone and files, [`report`], [`gpu`] |
//! | `gaunt eval` | [`eval`] |
//! | `gaunt project` | [`project`] |
//! | `gaunt plan` | [`plan`] |
//! | `gaunt ops` | [`ops`] |
//! | `gaunt export` | [`export`], with files of [`image::Output`] |
//! | `gaunt compare` | [`compare`], on the path tracer over pictures in [`truth`] |
//! | `gaunt view` | `view`, with the feature of that name |
//!
//! [`program`], [`progress`], [`image`], [`words`] and [`exponential`] serve `gaunt-lab` as well, which measures.

pub mod compare;
mod error;
pub mod eval;
pub mod exponential;
pub mod export;
pub mod gpu;
pub mod image;
pub mod ops;
pub mod plan;
pub mod program;
pub mod progress;
pub mod project;
pub mod render;
pub mod report;
pub mod truth;
#[cfg(feature = "view")]
pub mod view;
pub mod words;

pub use error::Error;
