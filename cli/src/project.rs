//! `gaunt project`: the SH coefficients of an environment map.

use crate::Error;
use sh_core::{OrderError, Routines, for_order, project};
use sh_scene::EnvironmentMap;
use std::fmt::Write;

/// The coefficients of a map, red, green and blue each, neither windowed nor cut at a ground; in double
/// precision, from exact solid angles.
///
/// ```
/// let map = sh_scene::EnvironmentMap::constant([1.0, 0.5, 0.0]);
/// let coefficients = gaunt::project::coefficients(&map, 3).unwrap();
/// assert_eq!(coefficients.len(), 9);
/// assert!((coefficients[0][1] - 0.5 * sh_core::ROOT_FOUR_PI).abs() < 1e-12);
/// ```
pub fn coefficients(map: &EnvironmentMap, order: usize) -> Result<Vec<[f64; 3]>, Error> {
    for_order!(
        order, C => Ok(of_order::<C>(map)),
        else => Err(Error::Usage(OrderError(order).to_string()))
    )
}

fn of_order<const C: usize>(map: &EnvironmentMap) -> Vec<[f64; 3]>
where
    [f64; C]: Routines<f64>,
{
    let (width, height) = (map.width as usize, map.height as usize);
    let sh = project::equirectangular::<C>(width, height, |x, y| map.pixels[x + y * width]);
    (0..C).map(|i| [sh.r[i], sh.g[i], sh.b[i]]).collect()
}

/// The coefficients as a table, a row each.
pub fn table(coefficients: &[[f64; 3]]) -> String {
    let mut text = format!(
        "{:>2} {:>3} {:>13} {:>13} {:>13}",
        "l", "m", "red", "green", "blue"
    );
    for (i, [r, g, b]) in coefficients.iter().enumerate() {
        let l = i.isqrt();
        let m = i as isize - (l * l + l) as isize;
        write!(text, "\n{l:>2} {m:>3} {r:>13.6} {g:>13.6} {b:>13.6}").expect("writing to a string");
    }
    text
}
