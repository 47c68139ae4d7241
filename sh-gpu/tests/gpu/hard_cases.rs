//! The hard cases of shading, on the GPU.

use crate::gpu::Gpu;
use crate::shading_cases::CASES;
use sh_gpu::{ShadowOptions, ShadowPass};
use sh_scene::{Light, Receiver, Sphere};
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Runs a case by name, at every order.
fn run(gpu: &Gpu, name: &str) {
    let (_, case) = CASES
        .iter()
        .find(|case| case.0 == name)
        .expect("a case of that name");
    // A pipeline for each pair of orders: compiling one takes longer than most cases.
    let passes = RefCell::new(BTreeMap::new());
    let shade = |receivers: &[Receiver], spheres: &[Sphere], light: &Light, accumulation: usize| {
        let mut passes = passes.borrow_mut();
        let pass = passes
            .entry((light.order, accumulation))
            .or_insert_with(|| {
                let options = ShadowOptions {
                    order: light.order,
                    accumulation,
                    ..ShadowOptions::default()
                };
                ShadowPass::with(&gpu.pipelines, options).expect("the device has room")
            });
        lit(gpu, pass, receivers, spheres, light)
    };
    for order in 2..=6 {
        println!("order {order}, GPU:");
        case(&shade, order);
    }
}

/// Radiance of every receiver.
fn lit(
    gpu: &Gpu,
    pass: &ShadowPass,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
) -> Vec<[f32; 3]> {
    let (input, output) = (
        gpu.buffer(receivers),
        gpu.buffer(&vec![[-1.0_f32; 4]; receivers.len()]),
    );
    let (receivers, radiance) = (
        input.as_entire_buffer_binding(),
        output.as_entire_buffer_binding(),
    );
    let bound = pass
        .bind(&gpu.device, receivers, radiance)
        .expect("the buffers fit");
    pass.prepare_spheres(&gpu.queue, spheres, light)
        .expect("blockers and light fit");
    gpu.submit(|encoder| pass.record(encoder, &bound, None));
    let found: Vec<[f32; 4]> = gpu.read(&output);
    found.into_iter().map(|[r, g, b, _]| [r, g, b]).collect()
}

macro_rules! cases {
    ($($test:ident: $name:literal;)*) => {
        $(pub fn $test(gpu: &Gpu) {
            run(gpu, $name);
        })*

        /// Names and what they run, for the list of tests.
        pub const TESTS: &[(&str, fn(&Gpu))] = &[
            $((concat!("hard_cases::", stringify!($test)), $test),)*
            ("hard_cases::every_case_is_run", every_case_is_run),
        ];

        fn every_case_is_run(_: &Gpu) {
            let run = [$($name),*];
            for (name, _) in CASES {
                assert!(run.contains(name), "`{name}` is not run");
            }
        }
    };
}

cases! {
    identical_blockers: "identical blockers";
    spheres_of_one_body: "spheres of one body";
    vanishing_blockers: "vanishing blockers";
    blockers_up_to_the_horizon: "blockers up to the horizon";
    receivers_on_in_and_at_the_centre: "receivers on, in and at the centre";
    spheres_across_the_tangent_plane: "spheres across the tangent plane";
    total_occlusion: "total occlusion";
    a_sun_a_million_times_the_sky: "a sun a million times the sky";
    light_of_any_strength: "light of any strength";
    opposite_normals: "opposite normals";
    scales: "scales";
    light_of_a_lower_order: "light of a lower order";
    what_is_not_a_number: "what is not a number";
}
