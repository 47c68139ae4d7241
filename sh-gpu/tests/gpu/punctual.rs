//! Lights with sharp shadows: the GPU's pictures are the CPU's.

use crate::frame::picture_of;
use crate::gpu::Gpu;
use crate::patches::apart;
use crate::scenes::{shining, standing_quad, view};
use glam::{Affine3A, Vec3};
use sh_gpu::Renderer;
use sh_scene::{Domain, Finish, Plan, PunctualLight, PunctualShape, Scene};

fn spot(angle: f32, radius: f32) -> PunctualLight {
    let shape = PunctualShape::Spot {
        position: Vec3::new(1.5, 3.0, 2.0),
        towards: Vec3::new(-1.5, -2.5, -2.0),
        angle: angle.to_radians(),
        blend: 0.3,
        radius,
    };
    PunctualLight::new(shape, [60.0, 40.0, 20.0])
}

fn point(radius: f32) -> PunctualLight {
    let position = Vec3::new(-0.3, 2.6, -0.8);
    PunctualLight::new(
        PunctualShape::Point { position, radius },
        [90.0, 60.0, 30.0],
    )
}

fn sun(angle: f32) -> PunctualLight {
    let direction = Vec3::new(1.0, 1.2, -0.8);
    PunctualLight::new(PunctualShape::Sun { direction, angle }, [4.0, 3.0, 2.0])
}

/// Every kind, with a size and without, in one view and in several, at full and at half resolution, on polished surfaces and on what
/// bodies send; and what hides it, hides it.
pub fn lights_are_those_of_the_cpu(gpu: &Gpu) {
    let lit = |mut scene: Scene, lights: Vec<PunctualLight>| {
        scene.punctual = lights;
        scene
    };
    let mut polished = lit(standing_quad(), vec![spot(50.0, 0.1), sun(0.05)]);
    polished.objects[0].material.finish = Finish {
        roughness: 0.4,
        metallic: 0.5,
    };
    let mut bound = lit(standing_quad(), vec![point(0.2)]);
    bound.objects[0].transform = Affine3A::from_rotation_y(0.4);
    bound.punctual[0].object = Some(0);
    let all = [
        ("spot", lit(standing_quad(), vec![spot(50.0, 0.0)]), false),
        (
            "soft spot",
            lit(standing_quad(), vec![spot(50.0, 0.3)]),
            true,
        ),
        (
            "wide spot",
            lit(standing_quad(), vec![spot(150.0, 0.2)]),
            false,
        ),
        ("point", lit(standing_quad(), vec![point(0.15)]), false),
        ("sun", lit(standing_quad(), vec![sun(0.1)]), false),
        (
            "all",
            lit(standing_quad(), vec![spot(70.0, 0.1), point(0.0), sun(0.0)]),
            true,
        ),
        ("polished", polished, false),
        ("bound", bound, false),
        (
            "sent",
            lit(shining(), vec![spot(90.0, 0.2), sun(0.02)]),
            true,
        ),
    ];
    for (what, scene, half) in all {
        let mut scene = scene;
        scene.settings.half_resolution = half;
        let [nearly_all, mean] = apart(gpu, &scene, what);
        assert!(
            nearly_all < 2e-4 && mean < 1e-4,
            "{what}: {nearly_all} {mean}"
        );
        if scene.settings.indirect.is_some() {
            // What bodies send differs as well.
            continue;
        }
        let view = view(&scene, 96, 64);
        let light = scene.light().unwrap();
        let given = |shadows: bool| {
            let mut with = scene.clone();
            with.settings.shadows = shadows;
            let mut without = with.clone();
            without.punctual.clear();
            let [with, without] =
                [with, without].map(|scene| picture_of(gpu, &scene, &view, &light));
            let given = with.iter().zip(&without).map(|(a, b)| a[0] - b[0]);
            given.collect::<Vec<_>>()
        };
        let (open, seen) = (given(false), given(true));
        let lit = open.iter().filter(|open| **open > 0.02).count();
        let hidden = |(open, seen): &(&f32, &f32)| **open > 0.02 && **seen < 0.5 * **open;
        let hidden = open.iter().zip(&seen).filter(hidden).count();
        assert!(
            lit > 600 && hidden > 20,
            "{what}: {lit} pixels lit, {hidden} of them hidden"
        );
    }
}

/// A scene without such a light has no pass, memory or pipeline for it; one whose lights stand still looks from them once.
pub fn views_are_taken_once(gpu: &Gpu) {
    assert!(!Plan::new(&standing_quad()).runs_over(Domain::Views));
    let mut scene = standing_quad();
    scene.punctual = vec![sun(0.01)];
    let plan = Plan::new(&scene);
    assert!(plan.runs_over(Domain::Views));
    let view = view(&scene, 64, 48);
    let renderer = Renderer::new(&gpu.device, &gpu.queue, &scene, &plan, &view).unwrap();
    let at = plan.passes.iter().position(|p| p.at == Domain::Views);
    let draws = |scene: &Scene| {
        let (forest, light) = (scene.forest(), scene.light().unwrap());
        renderer
            .prepare(&gpu.queue, scene, &forest, &light, &view)
            .unwrap();
        let draws = renderer.dispatches()[at.unwrap()];
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        renderer.record(&mut encoder, None);
        gpu.queue.submit([encoder.finish()]);
        renderer.submitted();
        draws
    };
    assert!(draws(&scene) > 0);
    assert_eq!(draws(&scene), 0);
    scene.objects[0].transform.translation.x += 0.1;
    assert!(draws(&scene) > 0, "a body has moved");
    scene.punctual[0].intensity = [1.0; 3];
    assert!(draws(&scene) > 0, "the light is another");
    assert_eq!(draws(&scene), 0);
    // Others than it was made for are refused.
    scene.punctual.push(point(0.0));
    let (forest, light) = (scene.forest(), scene.light().unwrap());
    let refused = renderer.prepare(&gpu.queue, &scene, &forest, &light, &view);
    let message = refused.unwrap_err().to_string();
    assert!(
        message.starts_with("2 spots, points and suns have 7 views"),
        "{message}"
    );
}
