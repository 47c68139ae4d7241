//! The passes, a file each, named as their declarations in `sh_scene::passes`.

pub(crate) mod basis_gather;
pub(crate) mod basis_update;
pub(crate) mod gbuffer;
pub(crate) mod invalid;
pub(crate) mod irradiance;
pub(crate) mod light_gather;
pub(crate) mod light_update;
pub(crate) mod light_view;
pub(crate) mod points;
pub(crate) mod punctual;
pub(crate) mod resolve;
pub(crate) mod scatter;
pub(crate) mod shadow;
pub(crate) mod shares;
pub(crate) mod upsample;
