//! What is found once kept on disk: sphere sets, their weights and surface samples.
//!
//! A set is found by what it was made from: its file is named after a SHA-256 hash of all that decides it, with the version
//! of what makes it. So nothing is ever out of date, and the folder can be emptied at any moment. A file ends in a hash
//! of all before it; one that is cut off or changed is as good as none, and is replaced. Files are written under another
//! name first, so that several programs can share the folder. Where it cannot be written, nothing is kept, and that is
//! no error.

mod baked;
mod folder;

pub(crate) use baked::{Baked, Ingredients, Key, fours};
pub use folder::Cache;
