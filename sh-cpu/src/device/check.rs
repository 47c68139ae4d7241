//! Whether a pass can work with what a caller hands in.

use crate::error::{Error, MAX_SIDE};
use sh_core::{ORDERS, OrderError};
use sh_scene::{EnvironmentMap, Light, View};
use std::ops::Range;

/// Whether a buffer has one entry a sample.
pub(crate) fn check_length(
    buffer: &'static str,
    expected: usize,
    found: usize,
) -> Result<(), Error> {
    if expected == found {
        Ok(())
    } else {
        Err(Error::Length {
            buffer,
            expected,
            found,
        })
    }
}

/// Whether clusters follow each other and hold all receivers.
pub(crate) fn check_clusters(clusters: &[Range<usize>], receivers: usize) -> Result<(), Error> {
    let mut next = 0;
    for (index, range) in clusters.iter().enumerate() {
        if range.start != next || range.end < next {
            return Err(Error::Clusters {
                index,
                range: range.clone(),
                next,
            });
        }
        next = range.end;
    }
    check_length("clusters", receivers, next)
}

/// Whether a light is of an order that there is, and whole.
pub(crate) fn check_light(light: &Light) -> Result<(), Error> {
    let (order, found) = (light.order, light.coefficients.len());
    if !ORDERS.contains(&order) {
        return Err(OrderError(order).into());
    }
    if found != order * order {
        return Err(Error::Coefficients { order, found });
    }
    Ok(())
}

/// Whether a map has as many pixels as it says, and any.
pub(crate) fn check_environment(map: &EnvironmentMap) -> Result<(), Error> {
    let texels = map.width as usize * map.height as usize;
    if texels == 0 || texels != map.pixels.len() {
        return Err(Error::Environment {
            width: map.width,
            height: map.height,
            found: map.pixels.len(),
        });
    }
    Ok(())
}

/// Whether rays through the view are directions.
pub(crate) fn check_view(view: &View) -> Result<(), Error> {
    let side = 1..=MAX_SIDE;
    if !side.contains(&view.width) || !side.contains(&view.height) {
        return Err(Error::Size {
            width: view.width,
            height: view.height,
        });
    }
    let camera = &view.camera;
    let problem = if !camera.eye.is_finite() || !camera.target.is_finite() {
        "eye and target must be finite".into()
    } else if (camera.target - camera.eye).try_normalize().is_none() {
        format!("eye and target are the same point {}", camera.eye)
    } else if !(camera.fov > 0.0 && camera.fov < std::f32::consts::PI) {
        format!(
            "its field of view is {} radians, it must lie between 0 and π",
            camera.fov
        )
    } else {
        return Ok(());
    };
    Err(Error::Camera { problem })
}
