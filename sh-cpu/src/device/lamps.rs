//! A light's lamps beside its environment.

use super::accumulate::Point;
use super::outline::Outline;
use sh_core::Routines;
use sh_scene::Light;

/// The environment's radiance plus that of the analytic lights.
#[inline(always)]
pub(crate) fn with_emitters<L: Outline<C>, const C: usize>(
    environment: [L; 3],
    transfer: &[L; C],
    lobe: &[L; C],
    point: &Point<L>,
    (light, dark): (&Light, u64),
) -> [L; 3]
where
    [L; C]: Routines<L>,
{
    if light.emitters.is_empty() {
        return environment;
    }
    let [r, g, b] = environment;
    let [red, green, blue] = L::emitted(transfer, lobe, point, &light.emitters, dark);
    [r + red, g + green, b + blue]
}
