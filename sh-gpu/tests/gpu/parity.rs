//! The passes against those of the CPU, on the same input: what differs is rounding, and where rounding decides (a
//! node at the very threshold of a cut, a sample at that of the upsampling) a little more, here and there.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, ball_and_quad, bouncing, lamps, view};
use sh_cpu::{CutOptions, Cuts, Failed, Gbuffer, Geometry, Halves, Path, Shadow};
use sh_gpu::{
    Bands, ClusterBinding, HalfBinding, IrradiancePass, Renderer, ShadowOptions, ShadowPass,
    UpsamplePass,
};
use sh_scene::{Clusters, Forest, Light, Limits, Plan, Receiver, Scene, Sphere, View};
use std::ops::Range;

/// How many differ by more than rounding, and the largest difference.
pub fn compare<'a>(
    found: impl IntoIterator<Item = &'a [f32; 4]>,
    expected: impl IntoIterator<Item = &'a [f32; 3]>,
) -> (usize, f32) {
    let (mut count, mut most) = (0, 0.0_f32);
    for (found, expected) in found.into_iter().zip(expected) {
        let off = (0..3).map(|c| (found[c] - expected[c]).abs());
        let off = off.fold(0.0, f32::max);
        assert!(off.is_finite(), "{found:?} {expected:?}");
        count += usize::from(off > 5e-5);
        most = most.max(off);
    }
    (count, most)
}

/// Lights and crowds of spheres in heaps, so that some are far off and some near.
fn heaps(numbers: &mut Numbers) -> (Vec<Sphere>, Vec<usize>) {
    let counts = vec![120, 1, 60, 40];
    let mut spheres = Vec::new();
    for &count in &counts {
        let middle = numbers.vector() * 9.0;
        spheres.extend((0..count).map(|_| Sphere {
            center: (middle + numbers.vector()).into(),
            radius: 0.05 + 0.2 * numbers.next(),
        }));
    }
    (spheres, counts)
}

/// Receivers in clusters of any size, and one of which nothing is covered.
pub fn clustered(numbers: &mut Numbers, count: usize) -> (Vec<Receiver>, Vec<Range<usize>>) {
    let receivers = numbers.receivers(count);
    let clusters = Clusters::new(&receivers, 14);
    let mut sorted = clusters.sorted(&receivers);
    for receiver in &mut sorted[clusters.ranges[5].clone()] {
        receiver.covered = 0;
    }
    (sorted, clusters.ranges)
}

fn shadowed_on_cpu(
    receivers: &[Receiver],
    clusters: &[Range<usize>],
    forest: &Forest,
    light: &Light,
    accumulation: usize,
) -> (Vec<[f32; 3]>, usize) {
    let mut cuts = Cuts::default();
    let options = CutOptions {
        limits: Limits::default(),
        ratios: true,
        accumulation,
    };
    cuts.bound(receivers, clusters, 0..clusters.len());
    cuts.find(Path::best(), forest, light, options);
    let shadow = Shadow {
        clusters,
        cuts: &cuts,
        light,
        accumulation,
        baked: None,
        eye: None,
    };
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    sh_cpu::shadow_clusters(Path::best(), receivers, &shadow, &mut radiance).unwrap();
    (radiance, cuts.pairs())
}

pub fn cuts_are_those_of_the_cpu(gpu: &Gpu) {
    for (order, accumulation) in [(2, 2), (3, 5), (4, 4), (4, 6)] {
        let mut numbers = Numbers(order as u64);
        let (spheres, counts) = heaps(&mut numbers);
        let forest = Forest::new(&spheres, &counts);
        let (receivers, clusters) = clustered(&mut numbers, 1500);
        let light = numbers.light(order).with_lights(&lamps()).unwrap();
        let (expected, pairs) =
            shadowed_on_cpu(&receivers, &clusters, &forest, &light, accumulation);
        assert!(pairs < receivers.len() * spheres.len() / 2, "{pairs} pairs");

        let options = ShadowOptions {
            order,
            accumulation,
            max_blockers: spheres.len() as u32,
            max_emitters: 2,
            ..ShadowOptions::default()
        };
        let pass = ShadowPass::with(&gpu.pipelines, options).unwrap();
        let input = gpu.buffer(&receivers);
        let output = gpu.buffer(&vec![[-1.0_f32; 4]; receivers.len()]);
        let records: Vec<[u32; 2]> = clusters
            .iter()
            .map(|range| [range.start as u32, range.len() as u32])
            .collect();
        let records = gpu.buffer(&records);
        let largest = clusters.iter().map(|range| range.len() as u32).max();
        let clusters = ClusterBinding {
            clusters: records.as_entire_buffer_binding(),
            largest: largest.unwrap(),
        };
        let bound = pass
            .bind_clusters(
                &gpu.device,
                input.as_entire_buffer_binding(),
                clusters,
                output.as_entire_buffer_binding(),
            )
            .unwrap();
        pass.prepare(&gpu.queue, &forest, Limits::default(), &light)
            .unwrap();
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        let found: Vec<[f32; 4]> = gpu.read(&output);
        let (count, most) = compare(&found, &expected);
        println!("order {order} of {accumulation}: {count} differ, {most:e} at most");
        assert!(count <= 3 && most < 0.01, "{count} differ, {most} at most");
        let light_without = pass.prepare_light(&gpu.queue, 0, Limits::default(), &light);
        light_without.unwrap();
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        let open: Vec<[f32; 4]> = gpu.read(&output);
        let darker = open.iter().zip(&found).filter(|(o, f)| f[0] < 0.99 * o[0]);
        assert!(darker.count() > 100, "blockers make a difference");
    }
}

pub fn analytic_lights_are_those_of_the_cpu(gpu: &Gpu) {
    for order in 2..=6 {
        let mut numbers = Numbers(order as u64);
        let receivers = numbers.receivers(300);
        let dark = Light {
            order,
            coefficients: vec![[0.0; 3]; order * order],
            emitters: Vec::new(),
        };
        let light = dark.with_lights(&lamps()).unwrap();
        let mut expected = vec![[0.0; 3]; 300];
        sh_cpu::irradiance(&receivers, &light, &mut expected).unwrap();
        assert!(expected.iter().filter(|r| r[2] > 0.01).count() > 100);
        let pass = IrradiancePass::with(&gpu.pipelines, order, 2, true).unwrap();
        let (input, output) = (gpu.buffer(&receivers), gpu.room(300 * 16));
        let bound = pass
            .bind(
                &gpu.device,
                input.as_entire_buffer_binding(),
                output.as_entire_buffer_binding(),
            )
            .unwrap();
        pass.prepare(&gpu.queue, &light).unwrap();
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        let (count, most) = compare(&gpu.read::<[f32; 4]>(&output), &expected);
        assert_eq!(count, 0, "order {order}: {most} at most");
    }
}

/// What the CPU's rays see of a grid.
fn seen(scene: &Scene, view: &View, grid: sh_scene::Grid) -> Gbuffer {
    let geometry = Geometry::new(scene).unwrap();
    let mut seen = Gbuffer::default();
    let rows = 0..grid.tiles().rows;
    sh_cpu::gbuffer(&geometry, view, grid, rows, &mut seen).unwrap();
    seen
}

/// The pass by itself, on receivers and radiance of the CPU.
pub fn upsampled_light_is_that_of_the_cpu(gpu: &Gpu) {
    let scene = ball_and_quad();
    let view = view(&scene, 121, 83);
    let (samples, halves) = (
        seen(&scene, &view, view.samples()),
        seen(&scene, &view, view.halves()),
    );
    let (forest, light) = (scene.forest(), scene.light().unwrap());
    let accumulation = scene.settings.accumulation;
    let shade = |receivers: &[Receiver], clusters: &[Range<usize>]| {
        shadowed_on_cpu(receivers, clusters, &forest, &light, accumulation).0
    };
    let coarse = shade(&halves.receivers, &view.halves().tiles().clusters());

    let mut open = vec![[0.0; 3]; halves.receivers.len()];
    sh_cpu::irradiance(&halves.receivers, &light, &mut open).unwrap();
    let known = Halves::new(halves.receivers.clone(), &coarse, &open).unwrap();
    let mut expected = vec![[0.0; 3]; samples.receivers.len()];
    sh_cpu::irradiance(&samples.receivers, &light, &mut expected).unwrap();
    let (rows, mut failed) = (0..view.samples().tiles().rows, Failed::default());
    sh_cpu::upsample(&view, &known, rows, &samples, &mut expected, &mut failed).unwrap();
    let covered = samples.receivers.iter().filter(|r| r.covered != 0).count();
    let share = failed.indices.len() as f32 / covered as f32;
    println!("{share} of the samples are shaded by themselves");
    assert!((0.02..0.5).contains(&share), "{share}");
    let anew = shade(&failed.receivers, &failed.clusters);
    for (&at, anew) in failed.indices.iter().zip(anew) {
        expected[at as usize] = anew;
    }

    let bands = Bands::new(&gpu.device, &view, view.samples(), 1 << 20).unwrap();
    assert_eq!(bands.count(), 1);
    assert_eq!(bands.half_tile_rows(0), 0..view.halves().tiles().rows);
    let options = ShadowOptions {
        order: light.order,
        accumulation,
        max_blockers: forest.spheres() as u32,
        max_emitters: 2,
        ..ShadowOptions::default()
    };
    let shadow = ShadowPass::with(&gpu.pipelines, options).unwrap();
    let pass = UpsamplePass::new(&gpu.device, &gpu.queue, &bands, &shadow, false).unwrap();
    let wide = |light: &[[f32; 3]]| -> Vec<[f32; 4]> {
        light.iter().map(|&[r, g, b]| [r, g, b, 0.0]).collect()
    };
    let (half, shares) = (gpu.buffer(&halves.receivers), gpu.buffer(&wide(&coarse)));
    let binding = || HalfBinding {
        receivers: half.as_entire_buffer_binding(),
        shares: shares.as_entire_buffer_binding(),
        sent: None,
    };
    let input = gpu.buffer(&samples.receivers);
    let output = gpu.buffer(&vec![[-1.0_f32; 4]; samples.receivers.len()]);
    let to_shares = pass.bind_shares(&gpu.device, binding()).unwrap();
    let bound = pass
        .bind(
            &gpu.device,
            binding(),
            input.as_entire_buffer_binding(),
            output.as_entire_buffer_binding(),
        )
        .unwrap();
    let rest = pass.rest(&bands, 0);
    let again = shadow
        .bind_clusters(&gpu.device, rest.receivers, rest.clusters, rest.radiance)
        .unwrap();
    bands.prepare(&gpu.queue, &view, scene.ground).unwrap();
    let limits = scene.settings.limits;
    shadow.prepare(&gpu.queue, &forest, limits, &light).unwrap();
    gpu.submit(|encoder| {
        pass.record_shares(encoder, &to_shares, None);
        pass.record(encoder, &bands, 0, &bound, None);
        shadow.record(encoder, &again, None);
        pass.record_scatter(encoder, &bands, 0, &bound, None);
    });
    let found: Vec<[f32; 4]> = gpu.read(&output);
    let (count, most) = compare(&found, &expected);
    println!("{count} samples differ, {most:e} at most");
    // What rounding sends the other way is still near.
    assert!(count <= 5 && most < 0.1, "{count} differ, {most} at most");
}

/// Whole pictures with odd sides, at full and at half resolution, without and with light that spheres send on. A sample
/// at an edge may fall to either side.
pub fn pictures_are_those_of_the_cpu(gpu: &Gpu) {
    let (mut pictures, sizes) = (Vec::new(), (77, 55));
    for mut scene in [ball_and_quad(), bouncing()] {
        for half in [false, true] {
            scene.settings.half_resolution = half;
            let view = view(&scene, 77, 55);
            let plan = Plan::new(&scene);
            let expected = sh_cpu::render(&scene, &plan, sizes, &|_| {}).unwrap();
            let renderer = Renderer::with_pipelines(
                &gpu.pipelines,
                &gpu.queue,
                &scene,
                &plan,
                &view,
                Bands::MAX_SAMPLES,
            )
            .unwrap();
            let light = scene.light().unwrap();
            let forest = scene.forest();
            renderer
                .prepare(&gpu.queue, &scene, &forest, &light, &view)
                .unwrap();
            gpu.submit(|encoder| renderer.record(encoder, None));
            let found: Vec<[f32; 4]> = gpu.read(renderer.picture());
            let far = |(a, b): &(&[f32; 4], &[f32; 3])| (0..3).any(|c| (a[c] - b[c]).abs() > 1e-3);
            let count = found.iter().zip(&expected.pixels).filter(far).count();
            println!("half resolution {half}: {count} of {} differ", found.len());
            assert!(count <= 4, "half resolution {half}: {count} differ");
            pictures.push(found);
        }
    }
    let [dark, dark_half, bright, bright_half] = &pictures[..] else {
        panic!("four pictures");
    };
    for (dark, bright) in [(dark, bright), (dark_half, bright_half)] {
        let brighter = |(a, b): &(&[f32; 4], &[f32; 4])| (0..3).any(|c| b[c] > a[c] + 2e-3);
        let count = dark.iter().zip(bright).filter(brighter).count();
        println!("light that is sent on makes {count} pixels brighter");
        assert!(count > 300, "{count} are brighter");
    }
}
