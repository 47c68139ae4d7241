//! Calls sh-core where there is no operating system.

#![no_std]

use sh_core::convention::{Axes, unity};
use sh_core::{Sh4, cap, exp, log::Logarithm, project};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// A little of everything that needs elementary functions.
#[unsafe(no_mangle)]
pub extern "C" fn probe(angle: f64) -> f32 {
    let visible = Sh4::zonal(
        cap::visibility::<16>(angle).map(|c| c as f32),
        [0.0, 1.0, 0.0],
    );
    let log = [angle; 16].log()[0];
    let sky = project::equirectangular::<16>(4, 2, |x, y| [(x + y) as f32; 3]);
    let there = unity::shader(&sky.to_f32().to_order(), Axes::UNITY);
    let half = Sh4::from_half(&visible.to_half());
    there[0][0]
        + half[1]
        + exp::ps_star(&visible.0, 2)[0]
        + exp::hyb(&visible.0)[1]
        + log as f32
        + sky.r[0] as f32
}
