//! Plans on the GPU: a scene compiles the shaders and holds the memory that its plan calls for, and a frame uploads
//! and records what has changed.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, bouncing, lamps, standing_quad, view};
use sh_gpu::{Bands, Pipelines, Renderer};
use sh_scene::passes::LIGHT_UPDATE;
use sh_scene::{Buffer, Indirect, Plan, Scene, Shader};
use std::collections::HashSet;

/// What is made for a scene: modules, pipelines, memory.
#[derive(Debug, PartialEq)]
struct Made {
    modules: usize,
    shaders: Vec<Shader>,
    memory: Vec<Buffer>,
}

fn renderer(gpu: &Gpu, pipelines: &Pipelines, scene: &Scene) -> Renderer {
    let (plan, view) = (Plan::new(scene), view(scene, 40, 30));
    let most = Bands::MAX_SAMPLES;
    Renderer::with_pipelines(pipelines, &gpu.queue, scene, &plan, &view, most).unwrap()
}

/// Makes a scene's renderer and compares it with the plan, and with what the device says it was asked for.
fn made(gpu: &Gpu, scene: &Scene) -> Made {
    let held = || {
        let wait = wgpu::PollType::wait_indefinitely();
        gpu.device.poll(wait).unwrap();
        let hub = gpu.instance.generate_report().unwrap().hub;
        let pipelines = hub.compute_pipelines.num_allocated + hub.render_pipelines.num_allocated;
        (hub.shader_modules.num_allocated, pipelines)
    };
    let before = held();
    let pipelines = Pipelines::new(&gpu.device);
    let renderer = renderer(gpu, &pipelines, scene);
    let after = held();
    let plan = Plan::new(scene);
    let modules: HashSet<_> = plan.shaders.iter().map(Shader::module).collect();
    assert_eq!(pipelines.shader_modules(), modules.len());
    assert_eq!(pipelines.count(), plan.shaders.len(), "{:?}", plan.shaders);
    assert_eq!(after.0 - before.0, modules.len());
    assert_eq!(after.1 - before.1, plan.shaders.len());
    let memory = renderer.buffers();
    let bytes: u64 = renderer.bytes().iter().map(|(_, bytes)| bytes).sum();
    assert_eq!(memory.iter().map(|b| b.bytes).sum::<u64>(), bytes);
    Made {
        modules: modules.len(),
        shaders: plan.shaders,
        memory,
    }
}

type Effect = (&'static str, fn(&mut Scene));

/// Everything that can be switched on, one after the other, and off again in the same order reversed: what is made is
/// what was made before.
pub fn effects_come_and_go_without_a_trace(gpu: &Gpu) {
    let effects: [Effect; 6] = [
        ("ground", |s| s.ground = standing_quad().ground),
        ("shadows", |s| s.settings.shadows = true),
        ("lamps", |s| s.lights = lamps()),
        ("half resolution", |s| s.settings.half_resolution = true),
        ("indirect light", |s| {
            s.settings.indirect = Some(Indirect::default())
        }),
        ("accumulation", |s| s.settings.accumulation = 3),
    ];
    let mut scene = bouncing();
    (scene.ground, scene.lights) = (None, Vec::new());
    // The lowest orders compile soonest.
    scene.settings = scene.settings.with_order(2);
    let settings = &mut scene.settings;
    (
        settings.shadows,
        settings.half_resolution,
        settings.indirect,
    ) = (false, false, None);
    let mut scenes = vec![scene];
    for (_, switch_on) in &effects {
        let mut next = scenes[scenes.len() - 1].clone();
        switch_on(&mut next);
        scenes.push(next);
    }
    let first: Vec<Made> = scenes.iter().map(|scene| made(gpu, scene)).collect();
    for ((name, _), pair) in effects.iter().zip(first.windows(2)) {
        let [without, with] = [&pair[0], &pair[1]];
        assert_ne!(with, without, "{name}");
        let bytes = |made: &Made| made.memory.iter().map(|b| b.bytes).sum::<u64>();
        println!(
            "{name}: {} modules, {} pipelines, {} bytes",
            with.modules,
            with.shaders.len(),
            bytes(with)
        );
    }
    for (scene, before) in scenes.iter().zip(&first).rev() {
        assert_eq!(made(gpu, scene), *before);
    }
    // With pipelines that are kept, nothing is compiled twice.
    let kept = Pipelines::new(&gpu.device);
    let count = |scene: &Scene| {
        renderer(gpu, &kept, scene);
        (kept.shader_modules(), kept.count())
    };
    let all = scenes.iter().map(count).collect::<Vec<_>>().pop();
    let again = scenes.iter().rev().map(count).collect::<Vec<_>>().pop();
    assert_eq!(all, again);
}

/// What a frame uploads: nothing where nothing has changed, and what belongs to one body where that has moved. Pictures
/// are those of a renderer that uploads everything.
pub fn a_frame_uploads_what_has_changed(gpu: &Gpu) {
    let mut scene = bouncing();
    let view = view(&scene, 40, 30);
    let plan = Plan::new(&scene);
    let kept = Renderer::new(&gpu.device, &gpu.queue, &scene, &plan, &view).unwrap();
    let update = plan.passes.iter().position(|pass| pass.is(&LIGHT_UPDATE));
    let update = update.expect("bodies light each other");
    let mut forest = scene.forest();
    let mut light = Numbers(4).light(4).with_lights(&scene.lights).unwrap();
    let mut frame = |scene: &Scene, light: &sh_scene::Light, what: &str| {
        forest.update(&scene.world_spheres());
        let before = kept.uploaded();
        kept.prepare(&gpu.queue, scene, &forest, light, &view)
            .unwrap();
        let (bytes, dispatches) = (kept.uploaded() - before, kept.dispatches()[update]);
        gpu.submit(|encoder| kept.record(encoder, None));
        kept.submitted();
        let picture = gpu.read::<[f32; 4]>(kept.picture());
        let most = Bands::MAX_SAMPLES;
        let fresh = kept.pipelines();
        let fresh = Renderer::with_pipelines(fresh, &gpu.queue, scene, &plan, &view, most).unwrap();
        fresh
            .prepare(&gpu.queue, scene, &forest, light, &view)
            .unwrap();
        gpu.submit(|encoder| fresh.record(encoder, None));
        assert_eq!(picture, gpu.read::<[f32; 4]>(fresh.picture()), "{what}");
        println!("{what}: {bytes} bytes uploaded, {dispatches} dispatches that find what is sent");
        (bytes, dispatches)
    };
    let (all, dispatches) = frame(&scene, &light, "the first frame");
    assert!(all > 5_000 && dispatches > 0);
    assert_eq!(frame(&scene, &light, "a steady frame"), (0, 0));
    // The quad has two of 42 spheres.
    scene.objects[0].transform.translation.y += 0.1;
    let (moved, again) = frame(&scene, &light, "a small body has moved");
    assert!(
        moved > 0 && moved * 4 < all && again == dispatches,
        "{moved} of {all}"
    );
    light.coefficients[2][1] += 0.1;
    let (lit, again) = frame(&scene, &light, "the sky has changed");
    assert!(lit > 0 && lit < 1024 && again == dispatches, "{lit}");
    scene.objects[1].material.albedo[0] *= 0.5;
    let (painted, none) = frame(&scene, &light, "a body was painted");
    assert_eq!((painted, none), (256, 0));
    assert_eq!(frame(&scene, &light, "nothing again"), (0, 0));
    // Surface points that change, and a host that writes what the renderer has.
    for point in &mut scene.objects[1].surface.points {
        point.albedo = [0.1, 0.9, 0.1];
    }
    kept.update_meshes(&gpu.queue, &scene).unwrap();
    assert_eq!(frame(&scene, &light, "surfaces have changed").1, dispatches);
}

/// A frame that was recorded and never submitted has done nothing: the next one records all that it needs. Without word of
/// what was submitted every frame does, and gives the same picture.
pub fn a_dropped_frame_is_recorded_again(gpu: &Gpu) {
    let mut scene = bouncing();
    let view = view(&scene, 40, 30);
    let plan = Plan::new(&scene);
    let renderer = || Renderer::new(&gpu.device, &gpu.queue, &scene, &plan, &view).unwrap();
    let (kept, fresh) = (renderer(), renderer());
    let update = |renderer: &Renderer| -> usize {
        let passes = plan.passes.iter().zip(renderer.dispatches());
        let updates = passes.filter(|(pass, _)| pass.is(&LIGHT_UPDATE));
        updates.map(|(_, dispatches)| dispatches).sum()
    };
    let light = Numbers(4).light(4).with_lights(&scene.lights).unwrap();
    let mut forest = scene.forest();
    let drop_one = |renderer: &Renderer| {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        renderer.record(&mut encoder, None);
    };
    let picture = |renderer: &Renderer| {
        gpu.submit(|encoder| renderer.record(encoder, None));
        gpu.read::<[f32; 4]>(renderer.picture())
    };
    for moved in [0.0, 0.2] {
        scene.objects[0].transform.translation.y += moved;
        forest.update(&scene.world_spheres());
        for renderer in [&kept, &fresh] {
            renderer
                .prepare(&gpu.queue, &scene, &forest, &light, &view)
                .unwrap();
        }
        let all = update(&fresh);
        drop_one(&kept);
        assert_eq!(update(&kept), all, "what was dropped is still to be done");
        let (after_drop, usual) = (picture(&kept), picture(&fresh));
        assert!(usual.iter().any(|pixel| pixel[0] > 0.1), "not all is dark");
        assert_eq!(after_drop, usual);
        kept.submitted();
        assert_eq!((update(&kept), update(&fresh)), (0, all));
        // As it was: one leaves out what the other finds again.
        drop_one(&kept);
        kept.submitted();
        assert_eq!((picture(&kept), picture(&fresh)), (usual.clone(), usual));
    }
}

/// The parts of a frame one by one are the frame.
pub fn parts_are_the_frame(gpu: &Gpu) {
    let scene = bouncing();
    let view = view(&scene, 40, 70);
    let plan = Plan::new(&scene);
    let light = Numbers(4).light(4);
    let picture = |in_parts: bool| {
        let renderer =
            Renderer::with_bands(&gpu.device, &gpu.queue, &scene, &plan, &view, 1).unwrap();
        renderer
            .prepare(&gpu.queue, &scene, &scene.forest(), &light, &view)
            .unwrap();
        if in_parts {
            let mut seen = HashSet::new();
            for part in 0..renderer.parts() {
                gpu.submit(|encoder| seen.extend(renderer.record_part(encoder, part)));
            }
            assert_eq!(seen.len(), plan.passes.len());
            gpu.submit(|encoder| assert_eq!(renderer.record_part(encoder, renderer.parts()), None));
        } else {
            gpu.submit(|encoder| renderer.record(encoder, None));
        }
        gpu.read::<[f32; 4]>(renderer.picture())
    };
    assert_eq!(picture(true), picture(false));
}
