//! What needs a GPU. Without an adapter every test shows as ignored, never as passed; with
//! `GAUNT_REQUIRE_GPU=1` a missing adapter is a failure.

mod clusters;
mod frame;
mod gbuffer;
mod gloss;
mod gpu;
mod hard_cases;
mod hard_scenes;
mod host;
mod invalid;
mod lights;
mod middleware;
mod parity;
mod patches;
mod plans;
mod punctual;
mod scenes;
mod shading;
#[path = "../../../tests/shared/shading_cases/mod.rs"]
mod shading_cases;
mod troubles;
mod truth;

use gpu::Gpu;
use libtest_mimic::{Arguments, Failed, Trial};
use std::sync::Arc;

/// A name and what it runs.
type Test = (&'static str, fn(&Gpu));

const TESTS: &[Test] = &[
    (
        "shading::shadow_is_that_of_f64",
        shading::shadow_is_that_of_f64,
    ),
    (
        "shading::irradiance_is_that_of_f64",
        shading::irradiance_is_that_of_f64,
    ),
    (
        "shading::crowds_of_blockers_stay_bounded",
        shading::crowds_of_blockers_stay_bounded,
    ),
    (
        "shading::walking_across_a_blocker_never_jumps",
        shading::walking_across_a_blocker_never_jumps,
    ),
    (
        "host::offsets_and_sizes_are_respected",
        host::offsets_and_sizes_are_respected,
    ),
    (
        "host::large_dispatches_reach_the_last",
        host::large_dispatches_reach_the_last,
    ),
    (
        "host::what_does_not_fit_is_an_error",
        host::what_does_not_fit_is_an_error,
    ),
    (
        "gbuffer::samples_are_where_rays_meet_surfaces",
        gbuffer::samples_are_where_rays_meet_surfaces,
    ),
    (
        "gbuffer::normals_turn_to_the_viewer",
        gbuffer::normals_turn_to_the_viewer,
    ),
    (
        "gbuffer::textures_are_bilinear_and_repeat",
        gbuffer::textures_are_bilinear_and_repeat,
    ),
    (
        "frame::the_sky_is_the_environment_map",
        frame::the_sky_is_the_environment_map,
    ),
    (
        "host::lights_that_do_not_fit_are_an_error",
        host::lights_that_do_not_fit_are_an_error,
    ),
    (
        "invalid::counts_are_those_of_the_cpu",
        invalid::counts_are_those_of_the_cpu,
    ),
    (
        "invalid::a_frame_counts_where_somebody_asks",
        invalid::a_frame_counts_where_somebody_asks,
    ),
    ("frame::bands_leave_no_seam", frame::bands_leave_no_seam),
    (
        "frame::a_steady_frame_creates_nothing",
        frame::a_steady_frame_creates_nothing,
    ),
    (
        "frame::a_scene_that_bends_is_uploaded_anew",
        frame::a_scene_that_bends_is_uploaded_anew,
    ),
    (
        "hard_scenes::triangles_without_area_change_no_pixel",
        hard_scenes::triangles_without_area_change_no_pixel,
    ),
    (
        "hard_scenes::normals_without_length_give_a_picture",
        hard_scenes::normals_without_length_give_a_picture,
    ),
    (
        "hard_scenes::scenes_of_any_size_look_the_same",
        hard_scenes::scenes_of_any_size_look_the_same,
    ),
    (
        "clusters::trees_of_any_kind_stay_bounded",
        clusters::trees_of_any_kind_stay_bounded,
    ),
    (
        "clusters::clusters_that_lead_nowhere_do_no_harm",
        clusters::clusters_that_lead_nowhere_do_no_harm,
    ),
    (
        "clusters::clusters_beyond_one_axis_are_lit",
        clusters::clusters_beyond_one_axis_are_lit,
    ),
    (
        "parity::cuts_are_those_of_the_cpu",
        parity::cuts_are_those_of_the_cpu,
    ),
    (
        "parity::analytic_lights_are_those_of_the_cpu",
        parity::analytic_lights_are_those_of_the_cpu,
    ),
    (
        "parity::upsampled_light_is_that_of_the_cpu",
        parity::upsampled_light_is_that_of_the_cpu,
    ),
    (
        "parity::pictures_are_those_of_the_cpu",
        parity::pictures_are_those_of_the_cpu,
    ),
    (
        "punctual::lights_are_those_of_the_cpu",
        punctual::lights_are_those_of_the_cpu,
    ),
    (
        "punctual::views_are_taken_once",
        punctual::views_are_taken_once,
    ),
    (
        "lights::spheres_send_what_they_do_on_the_cpu",
        lights::spheres_send_what_they_do_on_the_cpu,
    ),
    (
        "lights::long_cuts_are_those_of_the_cpu",
        lights::long_cuts_are_those_of_the_cpu,
    ),
    (
        "lights::what_is_sent_stays_bounded",
        lights::what_is_sent_stays_bounded,
    ),
    (
        "plans::effects_come_and_go_without_a_trace",
        plans::effects_come_and_go_without_a_trace,
    ),
    (
        "plans::a_frame_uploads_what_has_changed",
        plans::a_frame_uploads_what_has_changed,
    ),
    (
        "plans::a_dropped_frame_is_recorded_again",
        plans::a_dropped_frame_is_recorded_again,
    ),
    ("plans::parts_are_the_frame", plans::parts_are_the_frame),
    (
        "middleware::shadowed_light_is_what_the_lobe_meets",
        middleware::shadowed_light_is_what_the_lobe_meets,
    ),
    (
        "middleware::vertices_are_receivers",
        middleware::vertices_are_receivers,
    ),
    (
        "middleware::screens_are_lit_in_parts",
        middleware::screens_are_lit_in_parts,
    ),
    (
        "middleware::depth_leads_back_to_the_world",
        middleware::depth_leads_back_to_the_world,
    ),
    (
        "middleware::parts_leave_no_seam",
        middleware::parts_leave_no_seam,
    ),
    (
        "middleware::small_devices_are_told",
        middleware::small_devices_are_told,
    ),
    (
        "middleware::pipelines_are_shared",
        middleware::pipelines_are_shared,
    ),
    (
        "troubles::lost_devices_are_errors",
        troubles::lost_devices_are_errors,
    ),
    #[cfg(target_os = "linux")]
    (
        "troubles::exhausted_memory_is_an_error",
        troubles::exhausted_memory_is_an_error,
    ),
    (
        "troubles::refusals_are_errors",
        troubles::refusals_are_errors,
    ),
    (
        "patches::patches_give_what_they_do_on_the_cpu",
        patches::patches_give_what_they_do_on_the_cpu,
    ),
    (
        "gloss::what_is_mirrored_is_what_it_is_on_the_cpu",
        gloss::what_is_mirrored_is_what_it_is_on_the_cpu,
    ),
    (
        "gloss::nothing_is_made_for_what_is_matt",
        gloss::nothing_is_made_for_what_is_matt,
    ),
    (
        "frame::timestamps_tell_every_pass",
        frame::timestamps_tell_every_pass,
    ),
];

/// All tests, the hard cases after the others.
fn tests() -> impl Iterator<Item = &'static Test> {
    TESTS.iter().chain(hard_cases::TESTS)
}

fn main() {
    // One at a time: what the device holds and complains of is counted for each test.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    let trials = match Gpu::new() {
        Ok(gpu) => {
            let gpu = Arc::new(gpu);
            let trial = |&(name, test): &Test| {
                let gpu = gpu.clone();
                Trial::test(name, move || {
                    test(&gpu);
                    gpu.errors()
                })
            };
            tests().map(trial).collect()
        }
        Err(reason) => {
            let trial = |&(name, _): &Test| {
                let reason = reason.clone();
                Trial::test(name, move || Err(Failed::from(reason)))
                    .with_kind("no GPU")
                    .with_ignored_flag(!required)
            };
            if !required {
                eprintln!("ignoring all GPU tests: {reason}");
            }
            tests().map(trial).collect()
        }
    };
    libtest_mimic::run(&arguments, trials).exit();
}
