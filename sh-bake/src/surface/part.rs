//! A part of a body.

use sh_scene::{Material, Mesh};

/// A mesh and how it reflects.
pub(crate) type Part<'a> = (&'a Mesh, &'a Material);
