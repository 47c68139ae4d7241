//! The passes as middleware: other people's buffers, and what does not fit.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, ball_and_quad, bouncing, lamps, standing_quad, view};
use crate::shading::shadow;
use sh_gpu::{
    Bands, Bodies, ClusterBinding, Error, IrradiancePass, LightGatherPass, LightUpdatePass,
    Renderer, ResolvePass, ShadowOptions, ShadowPass,
};
use sh_scene::surface::SurfacePoint;
use sh_scene::{
    Blocking, Body, Domain, EnvironmentMap, Forest, Limits, Plan, Receiver, Scene, View,
};
use wgpu::{BufferBinding, BufferSize, BufferUsages};

fn part(buffer: &wgpu::Buffer, offset: u64, size: u64) -> BufferBinding<'_> {
    BufferBinding {
        buffer,
        offset,
        size: BufferSize::new(size),
    }
}

/// A range in the middle of larger buffers is lit, and nothing around it is touched.
pub fn offsets_and_sizes_are_respected(gpu: &Gpu) {
    let mut numbers = Numbers(9);
    let (receivers, spheres, light) = (
        numbers.receivers(100),
        numbers.spheres(70),
        numbers.light(3),
    );
    let whole = shadow(gpu, &receivers, &spheres, &light);
    let (input, output) = (gpu.buffer(&receivers), gpu.buffer(&[[-1.0_f32; 4]; 200]));
    let options = ShadowOptions {
        order: 3,
        accumulation: 3,
        max_blockers: 100,
        max_emitters: 0,
        ..ShadowOptions::default()
    };
    let pass = ShadowPass::new(&gpu.device, options).unwrap();
    // Receivers 8 to 78, radiance from element 48 on.
    let bound = pass
        .bind(
            &gpu.device,
            part(&input, 256, 70 * 32),
            part(&output, 768, 71 * 16),
        )
        .unwrap();
    pass.prepare_spheres(&gpu.queue, &spheres, &light).unwrap();
    gpu.submit(|encoder| pass.record(encoder, &bound, None));
    let found: Vec<[f32; 4]> = gpu.read(&output);
    assert_eq!(found[48..118], whole[8..78]);
    assert!(
        found[..48]
            .iter()
            .chain(&found[118..])
            .all(|value| *value == [-1.0; 4])
    );
}

/// More workgroups than one axis of a dispatch holds.
pub fn large_dispatches_reach_the_last(gpu: &Gpu) {
    let count = 65536 * 64_u64;
    let pass = IrradiancePass::new(&gpu.device, 2, 0).unwrap();
    let (input, output) = (gpu.room(count * 32), gpu.room(count * 16));
    let up = Receiver {
        position: [0.0; 3],
        covered: 1,
        normal: [0.0, 1.0, 0.0],
        object: 0,
    };
    for at in [0, 65535 * 64 - 1, 65535 * 64, count - 1] {
        gpu.queue
            .write_buffer(&input, at * 32, bytemuck::bytes_of(&up));
    }
    let bound = pass
        .bind(
            &gpu.device,
            input.as_entire_buffer_binding(),
            output.as_entire_buffer_binding(),
        )
        .unwrap();
    pass.prepare(&gpu.queue, &Numbers(1).light(2)).unwrap();
    gpu.submit(|encoder| pass.record(encoder, &bound, None));
    let found: Vec<[f32; 4]> = gpu.read(&output);
    let lit: Vec<usize> = (0..found.len()).filter(|&i| found[i][0] > 0.0).collect();
    assert_eq!(lit, [0, 65535 * 64 - 1, 65535 * 64, count as usize - 1]);
}

fn says<T>(result: Result<T, Error>, expected: &str) {
    let error = result.err().expect("this has to be refused").to_string();
    assert!(
        error.contains(expected),
        "`{error}` does not say `{expected}`"
    );
}

pub fn what_does_not_fit_is_an_error(gpu: &Gpu) {
    let device = &gpu.device;
    for order in [0, 1, 7] {
        says(IrradiancePass::new(device, order, 0), "orders 2 to 6");
    }
    let huge = ShadowOptions {
        max_blockers: u32::MAX,
        ..ShadowOptions::default()
    };
    says(
        ShadowPass::new(device, huge),
        "max_storage_buffer_binding_size",
    );

    for accumulation in [0, 3, 7] {
        let options = ShadowOptions {
            order: 4,
            accumulation,
            max_blockers: 3,
            max_emitters: 1,
            ..ShadowOptions::default()
        };
        let sentence =
            format!("order 4 cannot be accumulated at order {accumulation}: orders 4 to 6 can");
        says(ShadowPass::new(device, options), &sentence);
    }
    let beyond = ShadowOptions {
        order: 7,
        accumulation: 7,
        max_blockers: 3,
        max_emitters: 1,
        ..ShadowOptions::default()
    };
    says(ShadowPass::new(device, beyond), "orders 2 to 6");

    let mut numbers = Numbers(2);
    let few = ShadowOptions {
        order: 4,
        accumulation: 4,
        max_blockers: 3,
        max_emitters: 1,
        ..ShadowOptions::default()
    };
    let pass = ShadowPass::new(device, few).unwrap();
    says(
        pass.prepare_spheres(&gpu.queue, &numbers.spheres(4), &numbers.light(4)),
        "4 blocker spheres do not fit the 3",
    );
    says(
        pass.prepare_spheres(&gpu.queue, &[], &numbers.light(3)),
        "the light has order 3",
    );
    let mut short = numbers.light(4);
    short.coefficients.pop();
    says(
        pass.prepare_spheres(&gpu.queue, &[], &short),
        "15 coefficients",
    );

    let lamps = numbers.light(4).with_lights(&lamps()).unwrap();
    says(
        pass.prepare_spheres(&gpu.queue, &[], &lamps),
        "2 analytic lights do not fit the 1",
    );
    let forest = Forest::new(&numbers.spheres(4), &[4]);
    says(
        pass.prepare(&gpu.queue, &forest, Limits::default(), &numbers.light(4)),
        "4 blocker spheres do not fit the 3",
    );
    says(
        pass.prepare_light(&gpu.queue, 7, Limits::default(), &numbers.light(4)),
        "do not fit the 3",
    );

    let (input, output) = (gpu.room(3200), gpu.room(1600));
    let clusters = |binding| ClusterBinding {
        clusters: binding,
        largest: 100,
    };
    let bind = |records| {
        let (receivers, radiance) = (part(&input, 0, 3200), part(&output, 0, 1600));
        pass.bind_clusters(device, receivers, clusters(records), radiance)
    };
    says(bind(part(&input, 0, 12)), "`clusters` has 12 bytes");
    says(
        pass.bind(device, part(&input, 0, 3200), part(&output, 0, 1584)),
        "`radiance` holds 99",
    );
    says(
        pass.bind(device, part(&input, 0, 3201), part(&output, 0, 1600)),
        "only 3200",
    );
    says(
        pass.bind(device, part(&input, 0, 100), part(&output, 0, 1600)),
        "multiple of 32",
    );
    says(
        pass.bind(device, part(&input, 32, 320), part(&output, 0, 1600)),
        "multiple of 256",
    );
    let uniform = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 1600,
        usage: BufferUsages::UNIFORM,
        mapped_at_creation: false,
    });
    says(
        pass.bind(device, part(&input, 0, 320), part(&uniform, 0, 160)),
        "BufferUsages::STORAGE",
    );

    let mut scene = standing_quad();
    let bands = |width, height| {
        let view = view(&scene, width, height);
        Bands::new(device, &view, view.samples(), 1000)
    };
    says(bands(0, 10), "is empty");
    says(bands(5000, 10), "max_texture_dimension_2d");
    says(bands(4000, 40000), "max_buffer_size");
    let bands = bands(16, 16).unwrap();

    let small = view(&scene, 16, 16);
    let renderer = Renderer::new(device, &gpu.queue, &scene, &Plan::new(&scene), &small).unwrap();
    let light = numbers.light(4);
    let forest = scene.forest();
    let prepare =
        |scene: &Scene, view: &View| renderer.prepare(&gpu.queue, scene, &forest, &light, view);
    says(prepare(&scene, &view(&scene, 16, 17)), "another size");
    scene.camera.target = scene.camera.eye;
    says(prepare(&scene, &view(&scene, 16, 16)), "no direction");
    scene.camera.target.x += 1.0;
    scene.objects.push(scene.objects[0].clone());
    says(prepare(&scene, &view(&scene, 16, 16)), "2 objects");
    scene.objects[1].mesh.triangles[0][1] = 4;
    says(
        Bodies::new(device, &gpu.queue, &scene),
        "object 1 (`quad`) has a triangle with vertex 4",
    );
    scene.objects[1].mesh.normals.pop();
    says(
        Bodies::new(device, &gpu.queue, &scene),
        "3 normals for 4 vertices",
    );

    let map = EnvironmentMap {
        width: 2,
        height: 2,
        pixels: vec![[0.0; 3]; 3],
    };
    says(
        ResolvePass::new(device, &gpu.queue, &bands, &map),
        "2 by 2 texels brings 3",
    );
    let mut plan = Plan::new(&ball_and_quad());
    plan.passes.retain(|pass| pass.at != Domain::Halves);
    says(
        Renderer::new(device, &gpu.queue, &ball_and_quad(), &plan, &small),
        "the plan has no gbuffer pass, which would give upsample its receivers",
    );
    let map = EnvironmentMap {
        width: 9000,
        height: 1,
        pixels: vec![[0.0; 3]; 9000],
    };
    says(ResolvePass::new(device, &gpu.queue, &bands, &map), "9000");
}

pub fn lights_that_do_not_fit_are_an_error(gpu: &Gpu) {
    let (device, queue) = (&gpu.device, &gpu.queue);
    let scene = bouncing();
    let forest = scene.forest();
    let many = ShadowOptions {
        max_blockers: 500_000,
        ..ShadowOptions::default()
    };
    let many = ShadowPass::new(device, many).unwrap();
    says(
        LightGatherPass::new(device, &many, Blocking::Discs),
        "room for what spheres send on needs 272000000, but the device's limit `max_storage_buffer_binding_size`",
    );
    drop(many);
    let pass = |max_blockers| {
        let options = ShadowOptions {
            max_blockers,
            ..ShadowOptions::default()
        };
        let shadow = ShadowPass::new(device, options).unwrap();
        let gather = LightGatherPass::new(device, &shadow, Blocking::Discs).unwrap();
        (shadow, gather)
    };
    let (shadow, gather) = pass(42);
    gather.prepare(queue, &forest, [2, 40]).unwrap();
    says(
        gather.prepare(queue, &forest, [2, 39]),
        "the bodies have 41 spheres, but the tree of blockers has 42",
    );
    let (_, few) = pass(41);
    says(
        few.prepare(queue, &forest, [2, 40]),
        "42 blocker spheres do not fit the 41",
    );
    let (input, output) = (gpu.room(3200), gpu.room(1600));
    says(
        gather.bind(device, part(&input, 0, 3200), part(&output, 0, 1584)),
        "`radiance` holds 99",
    );

    let mut objects = scene.objects.clone();
    let all = objects.iter().map(Body::from);
    let update = LightUpdatePass::new(device, queue, &shadow, &gather, all.clone(), 1).unwrap();
    update.prepare(queue, all.clone(), &forest).unwrap();
    says(
        update.prepare(
            queue,
            all,
            &Forest::new(&scene.world_spheres()[..41], &[41]),
        ),
        "the bodies have 42 spheres, but the tree of blockers has 41",
    );
    let known = objects[0].surface.points.len() + objects[1].surface.points.len();
    objects[0].surface.push([SurfacePoint::default()]);
    let again = objects[0].spheres[0];
    objects[0].spheres.push(again);
    let sentence = format!(
        "the bodies have 43 spheres with {} surface points, but the pass was made for 42 with {known}",
        known + 1
    );
    let more = objects.iter().map(Body::from);
    says(update.prepare(queue, more.clone(), &forest), &sentence);
    says(update.update_surfaces(queue, more), &sentence);
}
