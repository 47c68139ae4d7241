//! The program's parts, as a library so that tests can call them.
//!
//! | command | module |
//! |---|---|
//! | `gaunt`, `gaunt render` | [`render`], with [`image`] for tone and files, [`report`], [`gpu`] |
//! | `gaunt eval` | [`eval`] |
//! | `gaunt project` | [`project`] |
//! | `gaunt ops` | [`ops`] |
//! | `gaunt fit` | [`fit`] |
//! | `gaunt bench` | [`bench`] |
//! | `gaunt spheres` | [`spheres`] |
//! | `gaunt compare` | [`compare`], on the path tracer over pictures in [`truth`] |
//! | `gaunt validate` | [`validate`], on [`compare`] |
//! | `gaunt accuracy` | [`accuracy`], on the exponentials of [`exponential`] |

pub mod accuracy;
pub mod bench;
pub mod compare;
mod error;
pub mod eval;
pub mod exponential;
pub mod fit;
pub mod gpu;
pub mod image;
pub mod ops;
pub mod progress;
pub mod project;
pub mod render;
pub mod report;
pub mod spheres;
pub mod truth;
pub mod validate;
mod words;

pub use error::Error;
