//! Whole frames.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, ball_and_quad, bouncing, shining, standing_quad, view};
use sh_gpu::{Bands, Renderer};
use sh_scene::{Light, Plan, Scene, View};

/// The picture of a scene under some light.
pub fn picture_of(gpu: &Gpu, scene: &Scene, view: &View, light: &Light) -> Vec<[f32; 4]> {
    let (plan, most) = (Plan::new(scene), Bands::MAX_SAMPLES);
    let renderer =
        Renderer::with_pipelines(&gpu.pipelines, &gpu.queue, scene, &plan, view, most).unwrap();
    renderer
        .prepare(&gpu.queue, scene, &scene.forest(), light, view)
        .unwrap();
    gpu.submit(|encoder| renderer.record(encoder, None));
    gpu.read(renderer.picture())
}

/// The picture of a scene under the light of a counter.
pub fn render(gpu: &Gpu, scene: &Scene, view: &View, max_samples: u32) -> Vec<[f32; 4]> {
    let plan = Plan::new(scene);
    let renderer =
        Renderer::with_pipelines(&gpu.pipelines, &gpu.queue, scene, &plan, view, max_samples)
            .unwrap();
    let light = Numbers(4).light(scene.settings.order);
    renderer
        .prepare(&gpu.queue, scene, &scene.forest(), &light, view)
        .unwrap();
    gpu.submit(|encoder| renderer.record(encoder, None));
    gpu.read(renderer.picture())
}

pub fn the_sky_is_the_environment_map(gpu: &Gpu) {
    let mut scene = standing_quad();
    (scene.ground, scene.objects) = (None, Vec::new());
    scene.camera.fov = 2.6;
    for target in [
        glam::Vec3::ZERO,
        glam::Vec3::new(1.1, 9.0, 5.2),
        glam::Vec3::new(0.9, 1.4, 9.0),
    ] {
        scene.camera.target = target;
        let view = view(&scene, 80, 60);
        let picture = render(gpu, &scene, &view, 1 << 20);
        for (i, found) in picture.iter().enumerate() {
            let (x, y) = (i as u32 % 80 * 2, i as u32 / 80 * 2);
            let mut sum = [0.0; 3];
            for (x, y) in [(x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1)] {
                let sample = scene.environment.sample(view.ray(view.samples(), x, y));
                sum = std::array::from_fn(|c| sum[c] + sample[c] / 4.0);
            }
            for c in 0..3 {
                assert!(
                    (found[c] - sum[c]).abs() < 2e-5,
                    "pixel {i}: {found:?}, not {sum:?}"
                );
            }
            assert_eq!(found[3], 0.0);
        }
    }
}

/// A picture whose height no band divides is the same in one band and in many, at full and at half resolution.
pub fn bands_leave_no_seam(gpu: &Gpu) {
    let mut full = bouncing();
    full.settings.half_resolution = false;
    for scene in [
        standing_quad(),
        ball_and_quad(),
        bouncing(),
        full,
        shining(),
    ] {
        let view = view(&scene, 65, 151);
        let (one, many) = (
            render(gpu, &scene, &view, 1 << 20),
            render(gpu, &scene, &view, 1),
        );
        assert_eq!(one.len(), 65 * 151);
        let differ = one.iter().zip(&many).filter(|(a, b)| {
            // Samples at an edge may fall to either side.
            a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 2e-5)
        });
        let count = differ.count();
        assert!(count <= 8, "{count} pixels differ");
        // The last row is a picture too, with ground in it.
        assert!(
            one[150 * 65..]
                .iter()
                .all(|pixel| pixel[3] == 1.0 && pixel[0] > 0.0)
        );
        assert_eq!(
            many,
            render(gpu, &scene, &view, 1),
            "the same bits from run to run"
        );
    }
}

/// Numbers of everything a device holds, after a frame and after ten more.
pub fn a_steady_frame_creates_nothing(gpu: &Gpu) {
    let scene = bouncing();
    let view = view(&scene, 40, 85);
    let plan = Plan::new(&scene);
    let renderer =
        Renderer::with_pipelines(&gpu.pipelines, &gpu.queue, &scene, &plan, &view, 1).unwrap();
    let light = Numbers(4).light(4);
    let forest = scene.forest();
    let frame = || {
        let queue = &gpu.queue;
        renderer.update_meshes(queue, &scene).unwrap();
        let environment = &scene.environment;
        renderer.update_environment(queue, environment).unwrap();
        renderer
            .prepare(queue, &scene, &forest, &light, &view)
            .unwrap();
        gpu.submit(|encoder| renderer.record(encoder, None));
    };
    let held = || {
        let hub = gpu.instance.generate_report().unwrap().hub;
        [
            ("bind group layouts", hub.bind_group_layouts.num_allocated),
            ("bind groups", hub.bind_groups.num_allocated),
            ("render pipelines", hub.render_pipelines.num_allocated),
            ("compute pipelines", hub.compute_pipelines.num_allocated),
            ("buffers", hub.buffers.num_allocated),
            ("textures", hub.textures.num_allocated),
            ("texture views", hub.texture_views.num_allocated),
        ]
    };
    frame();
    let before = held();
    assert!(before.iter().all(|(_, count)| *count > 0), "{before:?}");
    for _ in 0..10 {
        frame();
    }
    assert_eq!(held(), before);
}

/// A renderer that is told of another shape and another sky shows what one made for them shows.
pub fn a_scene_that_bends_is_uploaded_anew(gpu: &Gpu) {
    for scene in [standing_quad(), bouncing()] {
        let mut bent = scene.clone();
        for (i, p) in bent.objects[0].mesh.positions.iter_mut().enumerate() {
            p[i % 3] += 0.3;
        }
        for point in &mut bent.objects[0].surface.points {
            point.albedo = [0.9, 0.1, 0.1];
            point.normal = [0.0, 1.0, 0.0];
        }
        bent.environment = bent.environment.rotated(1.0);
        bends(gpu, &scene, &bent);
    }
}

fn bends(gpu: &Gpu, scene: &Scene, bent: &Scene) {
    let view = view(scene, 40, 30);
    let (queue, light) = (&gpu.queue, Numbers(4).light(4));
    let plan = Plan::new(scene);
    let renderer = Renderer::with_pipelines(
        &gpu.pipelines,
        queue,
        scene,
        &plan,
        &view,
        Bands::MAX_SAMPLES,
    )
    .unwrap();
    let frame = |scene: &Scene| {
        let forest = scene.forest();
        renderer
            .prepare(queue, scene, &forest, &light, &view)
            .unwrap();
        gpu.submit(|encoder| renderer.record(encoder, None));
        gpu.read::<[f32; 4]>(renderer.picture())
    };
    let before = frame(scene);
    renderer.update_meshes(queue, bent).unwrap();
    let environment = &bent.environment;
    renderer.update_environment(queue, environment).unwrap();
    let after = frame(bent);
    assert_eq!(after, render(gpu, bent, &view, 1 << 20));
    assert_ne!(after, before);

    let mut other = scene.clone();
    other.objects[0].mesh.positions.pop();
    let sentence = renderer.update_meshes(queue, &other).unwrap_err();
    assert!(sentence.to_string().contains("were uploaded"), "{sentence}");
    other.objects.clear();
    assert!(renderer.update_meshes(queue, &other).is_err());
    let small = sh_scene::EnvironmentMap::constant([1.0; 3]);
    let sentence = renderer.update_environment(queue, &small).unwrap_err();
    assert!(sentence.to_string().contains("2 by 1 texels"), "{sentence}");
}

pub fn timestamps_tell_every_pass(gpu: &Gpu) {
    if !gpu.timestamps {
        println!("this adapter has no timestamps");
        return;
    }
    let scene = bouncing();
    let view = view(&scene, 40, 85);
    let plan = Plan::new(&scene);
    let renderer =
        Renderer::with_pipelines(&gpu.pipelines, &gpu.queue, &scene, &plan, &view, 1).unwrap();
    let queries = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
        label: None,
        ty: wgpu::QueryType::Timestamp,
        count: renderer.timestamps(),
    });
    let resolved = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: u64::from(renderer.timestamps()) * 8,
        usage: wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC,
        mapped_at_creation: false,
    });
    renderer
        .prepare(
            &gpu.queue,
            &scene,
            &scene.forest(),
            &Numbers(4).light(4),
            &view,
        )
        .unwrap();
    gpu.submit(|encoder| {
        renderer.record(encoder, Some(&queries));
        encoder.resolve_query_set(&queries, 0..renderer.timestamps(), &resolved, 0);
    });
    let times = renderer.times(&gpu.read(&resolved), gpu.queue.get_timestamp_period());
    let kinds: Vec<_> = times.iter().map(|(pass, _)| *pass).collect();
    assert_eq!(
        kinds,
        plan.passes
            .iter()
            .map(|pass| pass.name())
            .collect::<Vec<_>>()
    );
    assert!(
        times.iter().all(|(_, time)| *time > 0.0 && *time < 1e10),
        "{times:?}"
    );
}
