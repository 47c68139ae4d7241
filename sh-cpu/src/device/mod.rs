//! What passes share: twins of `kernels/shared`, and running a kernel over receivers.

pub(crate) mod accumulate;
pub(crate) mod behind;
pub(crate) mod check;
pub(crate) mod cut;
pub(crate) mod drive;
pub(crate) mod emission;
pub(crate) mod emitters;
pub(crate) mod geometry;
pub(crate) mod horizon;
pub(crate) mod lamps;
pub(crate) mod light;
pub(crate) mod light_cut;
pub(crate) mod light_cuts;
pub(crate) mod light_discs;
pub(crate) mod light_order;
pub(crate) mod light_sent;
pub(crate) mod light_sums;
pub(crate) mod logs;
mod order;
pub(crate) mod outline;
pub(crate) mod patch_cut;
pub(crate) mod patch_hiding;
pub(crate) mod patch_lights;
pub(crate) mod patches;
pub(crate) mod ratio;
pub(crate) mod rays;
pub(crate) mod spherical_lights;
