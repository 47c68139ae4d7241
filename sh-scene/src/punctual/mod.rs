//! Lights that are small enough for shadows with edges: spots, points and suns.

mod light;
mod record;
mod view;

pub use light::{PunctualLight, PunctualShape};
pub use record::{PunctualRecord, Seen, above};
pub use view::{LightView, LightViews};
