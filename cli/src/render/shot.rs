//! What a backend is told of a picture.

use sh_scene::{Plan, View};

/// Everything that is the same for all frames but the scene's state.
pub(crate) struct Shot<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) view: &'a View,
    /// What of the scene changes from frame to frame.
    pub(crate) changes: Changes,
}

/// What has to be uploaded anew for a frame, besides what always is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Changes {
    pub(crate) meshes: bool,
    pub(crate) environment: bool,
}
