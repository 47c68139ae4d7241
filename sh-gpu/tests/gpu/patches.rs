//! Light by way of patches: the GPU's pictures are the CPU's.

use crate::frame::picture_of;
use crate::gpu::Gpu;
use crate::scenes::{shining, view};
use sh_scene::{Plan, Scene};

/// How far apart both are: of nearly all pixels, and in the mean, over the mean of the picture.
pub fn apart(gpu: &Gpu, scene: &Scene, what: &str) -> [f32; 2] {
    let view = view(scene, 96, 64);
    let ours = picture_of(gpu, scene, &view, &scene.light().unwrap());
    let plan = Plan::new(scene);
    let theirs = sh_cpu::render(scene, &plan, (view.width, view.height), &|_| {}).unwrap();
    let mean = theirs.pixels.as_flattened().iter().sum::<f32>() / (3 * theirs.pixels.len()) as f32;
    let mut apart: Vec<f32> = ours
        .iter()
        .zip(&theirs.pixels)
        .map(|(a, b)| (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max) / mean)
        .collect();
    let whole = apart.iter().sum::<f32>() / apart.len() as f32;
    apart.sort_by(f32::total_cmp);
    let nearly_all = apart[apart.len() * 98 / 100];
    println!("{what}: {nearly_all:e}, {whole:e} in the mean");
    [nearly_all, whole]
}

/// At every order, at full and at half resolution, beside spheres that send and without them, in one bounce and in three.
pub fn patches_give_what_they_do_on_the_cpu(gpu: &Gpu) {
    for (order, half, bounces, mixed) in [
        (2, false, 1, false),
        (3, true, 3, false),
        (4, false, 3, true),
        (4, true, 1, true),
        (6, false, 2, false),
    ] {
        let mut scene = shining();
        scene.settings = scene.settings.with_order(order);
        scene.settings.half_resolution = half;
        if let Some(indirect) = &mut scene.settings.indirect {
            indirect.bounces = bounces;
        }
        if !mixed {
            scene.objects[0].surface = Default::default();
        }
        let what = format!("order {order}, half {half}, {bounces} bounces, mixed {mixed}");
        let [nearly_all, mean] = apart(gpu, &scene, &what);
        assert!(
            nearly_all < 2e-4 && mean < 1e-4,
            "{what}: {nearly_all} {mean}"
        );
        // What is compared is there.
        let view = view(&scene, 96, 64);
        let light = scene.light().unwrap();
        let with = picture_of(gpu, &scene, &view, &light);
        scene.settings.indirect = None;
        let without = picture_of(gpu, &scene, &view, &light);
        let sum = |all: &[[f32; 4]]| all.iter().map(|p| p[0] + p[1] + p[2]).sum::<f32>();
        let share = sum(&with) / sum(&without) - 1.0;
        println!("{share} of all light");
        assert!(share > 20.0 * mean, "{what}: {share} {mean}");
    }
}
