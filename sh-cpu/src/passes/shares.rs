//! The shares pass: what blockers leave of light.

use crate::device::check::check_length;
use crate::error::Error;

/// Radiance to the share that it is of that without blockers; 1 where there is no light.
///
/// # Errors
/// Where there is not one of each for a receiver.
pub(crate) fn shares(radiance: &mut [[f32; 3]], open: &[[f32; 3]]) -> Result<(), Error> {
    check_length("open", radiance.len(), open.len())?;
    for (radiance, open) in radiance.iter_mut().zip(open) {
        for (radiance, &open) in radiance.iter_mut().zip(open) {
            *radiance = if open > 0.0 { *radiance / open } else { 1.0 };
        }
    }
    Ok(())
}
