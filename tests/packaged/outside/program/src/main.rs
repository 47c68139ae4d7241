//! Computes something with each crate that it depends on.

use sh_core::convention::{Axes, unity};
use sh_core::{Routines, Sh4, ShRgb, cap};

fn main() {
    // Half of an even sky is hidden: half of it is reflected.
    let up = [0.0, 1.0, 0.0];
    let hidden = cap::visibility::<16>(std::f64::consts::FRAC_PI_2).map(|c| c as f32);
    let visible = Sh4::zonal(hidden, [1.0, 0.0, 0.0]);
    let reflected = Sh4::ONE.triple(&visible, &Sh4::cosine(up));
    assert!((reflected - 0.5).abs() < 1e-5, "{reflected}");
    let clear = [0.0_f32; 16].exp_saturating()[0] / Sh4::ONE[0];
    assert!((clear - 1.0).abs() < 1e-5, "{clear}");
    let probe = unity::probe(&ShRgb::gray(Sh4::ONE).to_order(), Axes::UNITY);
    assert!((probe[0][0] - 1.0).abs() < 1e-6);

    let sky = sh_scene::Sky::default().map(16, 8);
    let light = sh_scene::Light::project(&sky, None, 4, 8.0).expect("order 4 exists");
    assert!(light.irradiance(up).iter().all(|c| *c > 0.0));

    let shader = sh_kernels::source(sh_kernels::Pass::Shadow, 4).expect("order 4 exists");
    assert!(shader.contains("fn shadow("));
    println!("the packages compute: {reflected} of the sky, a shader of {} lines", shader.lines().count());
}
