//! What half resolution gives away: the picture with upsampling beside the one whose samples are all shaded.

use super::measure::{Figures, scale};
use super::view::Seen;
use crate::Error;
use sh_scene::{Domain, Plan, Scene};

/// The difference that it makes, over the mean of the whole picture's lit pixels; none where the scene's plan has no half
/// resolution.
///
/// # Errors
/// Where the scene is none that can be rendered.
pub(super) fn half(scene: &Scene, seen: &Seen) -> Result<Option<Figures>, Error> {
    let plan = Plan::new(scene);
    if !plan.runs_over(Domain::Halves) {
        return Ok(None);
    }
    let lit = seen.picture(|_, receiver| [f32::from(u8::from(receiver.is_some())); 3]);
    let pixels = |scene: &Scene, plan: &Plan| {
        let picture = sh_cpu::render(scene, plan, (seen.width, seen.height), &|_| {})?.pixels;
        let lit = picture.iter().zip(&lit).filter(|(_, lit)| lit[0] > 0.0);
        Ok::<_, Error>(lit.map(|(pixel, _)| *pixel).collect::<Vec<_>>())
    };
    let ours = pixels(scene, &plan)?;
    let mut whole = scene.clone();
    whole.settings.half_resolution = false;
    let truth = pixels(&whole, &Plan::new(&whole))?;
    let none = vec![[0.0; 3]; truth.len()];
    Ok(Some(Figures::new(&ours, &truth, &none, scale(&truth))))
}
