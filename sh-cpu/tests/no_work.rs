//! What does not matter or has not changed is no work, and its absence is not seen.

mod common;

use common::{object, scene, sphere_mesh};
use glam::{Affine3A, Vec3, vec3};
use sh_cpu::{CutOptions, Cuts, Frames, Path, Shadow, shadow_clusters};
use sh_scene::passes::{GBUFFER, LIGHT_UPDATE};
use sh_scene::surface::SurfacePoint;
use sh_scene::{
    AreaLight, Forest, Ground, Indirect, Light, Limits, NEGLIGIBLE, Plan, Receiver, Scene, Sphere,
};
use std::ops::Range;

/// Numbers in -1..1, the same in every run.
fn noise(i: usize) -> f32 {
    (i as f32 * 12.9898 + 4.1).sin() * 43_758.547 % 1.0
}

fn vector(i: usize) -> Vec3 {
    Vec3::new(noise(3 * i), noise(3 * i + 1), noise(3 * i + 2))
}

fn receiver(position: Vec3, normal: Vec3) -> Receiver {
    Receiver {
        position: position.into(),
        covered: 1,
        normal: normal.normalize().into(),
        object: 0,
    }
}

/// Groups of receivers side by side.
fn clusters(count: usize, each: usize) -> Vec<Range<usize>> {
    (0..count).map(|i| i * each..(i + 1) * each).collect()
}

fn options(order: usize) -> CutOptions {
    CutOptions {
        limits: Limits::default(),
        ratios: true,
        accumulation: order,
    }
}

fn shaded(
    receivers: &[Receiver],
    clusters: &[Range<usize>],
    cuts: &Cuts,
    light: &Light,
) -> Vec<[f32; 3]> {
    let mut radiance = vec![[0.0; 3]; receivers.len()];
    let shadow = Shadow {
        clusters,
        cuts,
        light,
        accumulation: light.order,
        baked: None,
        eye: None,
    };
    shadow_clusters(Path::best(), receivers, &shadow, &mut radiance).unwrap();
    radiance
}

fn dark(order: usize) -> Light {
    Light {
        order,
        coefficients: vec![[0.0; 3]; order * order],
        emitters: Vec::new(),
    }
}

/// Lamps near and far, small and large, before clusters that face anywhere: the bits are the same whether those below the
/// horizon are skipped or not, and many are.
#[test]
fn lamps_below_the_horizon_of_a_cluster_are_skipped_to_the_bit() {
    const EACH: usize = 24;
    const COUNT: usize = 600;
    let mut receivers = Vec::new();
    for cluster in 0..COUNT {
        let (axis, middle) = (vector(cluster).normalize(), vector(cluster + 7000) * 2.0);
        let size = 0.02 + 0.5 * noise(cluster).abs();
        receivers.extend((0..EACH).map(|i| {
            let i = cluster * EACH + i + 20_000;
            receiver(
                middle + vector(i) * size,
                axis + vector(i + 900_000) * size * 0.5,
            )
        }));
    }
    let clusters = clusters(COUNT, EACH);
    let lamps = [
        (0.02, 4.0, true),
        (0.4, 4.0, true),
        (1.5, 5.0, true),
        (0.005, 1.0, false),
        (0.5, 1.0, false),
    ];
    let lamps: Vec<AreaLight> = lamps
        .iter()
        .enumerate()
        .map(|(i, &(size, distance, local))| {
            let (towards, radiance) = (vector(i + 31), [3.0, 2.0, 1.0]);
            match local {
                true => AreaLight::local(towards.normalize() * distance, size, radiance),
                false => AreaLight::distant(towards, size, radiance),
            }
        })
        .collect();
    let spheres: Vec<Sphere> = (0..20)
        .map(|i| Sphere {
            center: (vector(i + 50) * 3.0).into(),
            radius: 0.2,
        })
        .collect();
    let forest = Forest::new(&spheres, &[20]);
    for order in 2..=6 {
        let light = dark(order).with_lights(&lamps).unwrap();
        let mut cuts = Cuts::default();
        cuts.bound(&receivers, &clusters, 0..COUNT);
        cuts.find(Path::best(), &forest, &light, options(order));
        let all = shaded(&receivers, &clusters, &cuts, &light);
        assert_eq!(cuts.lamps_below(), 0);
        cuts.dim(&light);
        cuts.find(Path::best(), &forest, &light, options(order));
        let below = cuts.lamps_below();
        assert_eq!(shaded(&receivers, &clusters, &cuts, &light), all);
        let share = below as f32 / (COUNT * lamps.len()) as f32;
        println!("order {order}: {share:.3} of all pairs of a cluster and a lamp are skipped");
        // Half of all directions is below a horizon, and most of those wholly, at every order.
        assert!(share > 0.3, "{order}: {share}");
    }
}

/// Dust and crumbs around and far from receivers: what all that are too small take away is less than was promised.
#[test]
fn spheres_too_small_to_matter_do_not() {
    const EACH: usize = 64;
    const COUNT: usize = 24;
    let mut worst = [0.0_f32; 7];
    let mut skipped = 0;
    for (set, (count, size, reach)) in [
        (3000, 0.002, 1.0),
        (400, 0.01, 4.0),
        (2000, 0.02, 40.0),
        (60, 0.3, 60.0),
    ]
    .into_iter()
    .enumerate()
    {
        let spheres: Vec<Sphere> = (0..count)
            .map(|i| Sphere {
                center: (vector(i + 1000 * set) * reach + Vec3::Y * reach * 0.6).into(),
                radius: size * (0.1 + noise(i).abs()),
            })
            .collect();
        let forest = Forest::new(&spheres, &[count / 2, count - count / 2]);
        let receivers: Vec<Receiver> = (0..COUNT * EACH)
            .map(|i| {
                let middle = vector(i / EACH + 77) * 2.0;
                receiver(middle + vector(i) * 0.1, Vec3::Y + vector(i / EACH) * 0.6)
            })
            .collect();
        let clusters = clusters(COUNT, EACH);
        for (order, worst) in worst.iter_mut().enumerate().skip(2) {
            let mut even = dark(order);
            even.coefficients[0] = [sh_core::ROOT_FOUR_PI as f32; 3];
            let mut cuts = Cuts::default();
            cuts.bound(&receivers, &clusters, 0..COUNT);
            cuts.find_all(Path::best(), &forest, options(order));
            assert_eq!(cuts.too_small(), 0);
            let all = shaded(&receivers, &clusters, &cuts, &even);
            cuts.find(Path::best(), &forest, &even, options(order));
            skipped += cuts.too_small();
            let rest = shaded(&receivers, &clusters, &cuts, &even);
            for (a, b) in all.iter().zip(&rest) {
                *worst = worst.max((a[0] - b[0]).abs());
            }
        }
    }
    println!(
        "{skipped} nodes skipped; largest error over the bound {NEGLIGIBLE}, by order: {worst:?}"
    );
    assert!(skipped > 10_000, "{skipped}");
    // The sky is 1 everywhere, and so is a white receiver in the open.
    for (order, worst) in worst.iter().enumerate().skip(2) {
        assert!(
            *worst > 0.0 && *worst <= NEGLIGIBLE,
            "order {order}: {worst}"
        );
    }
}

/// Two balls on the ground that light each other.
fn two_balls() -> Scene {
    let ball = |x: f32| {
        let mut body = object(
            sphere_mesh(0.5, 12),
            Affine3A::from_translation(vec3(x, 0.5, 0.0)),
        );
        for sphere in &body.spheres {
            let up = Vec3::from(sphere.center) + Vec3::Y * sphere.radius;
            body.surface.push([SurfacePoint {
                position: up.into(),
                normal: [0.0, 1.0, 0.0],
                albedo: [0.8; 3],
                ..Default::default()
            }]);
        }
        body
    };
    let mut scene = scene(vec![ball(-0.8), ball(0.8)]);
    scene.ground = Some(Ground {
        height: 0.0,
        albedo: [0.5; 3],
    });
    scene.camera.eye = vec3(0.0, 3.0, 6.0);
    scene.settings.indirect = Some(Indirect::default());
    scene
}

/// A second frame of a still scene does what depends on the camera, and nothing else; it is the first to the bit.
#[test]
fn frames_do_again_what_has_changed_and_nothing_else() {
    let mut scene = two_balls();
    let plan = Plan::new(&scene);
    let update = plan.passes.iter().position(|pass| pass.is(&LIGHT_UPDATE));
    let update = update.expect("the balls see each other");
    let mut frames = Frames::default();
    let mut picture = |scene: &Scene| frames.render(scene, &plan, (32, 24), &|_| {}).unwrap();
    let first = picture(&scene);
    assert!(first.changes.rebuilt && first.changes.projections == 1);
    assert!(first.work[update].tasks > 0);
    let second = picture(&scene);
    assert!(second.changes.none(), "{:?}", second.changes);
    assert_eq!((second.changes.spheres, second.changes.lamps), (0, 0));
    assert_eq!(second.work[update].tasks, 0);
    assert_eq!(second.pixels, first.pixels);

    // One of the balls moves: its spheres are placed, all of them are lit anew, and light is not projected.
    let rest = scene.objects[1].transform;
    scene.objects[1].transform.translation.x += 0.3;
    let moved = picture(&scene);
    let own = scene.objects[1].spheres.len();
    assert_eq!((moved.changes.objects, moved.changes.spheres), (1, own));
    assert!(moved.changes.nodes > 0 && moved.changes.projections == 0);
    assert!(moved.work[update].tasks > 0);
    assert_ne!(moved.pixels, first.pixels);
    scene.objects[1].transform = rest;
    assert_eq!(picture(&scene).pixels, first.pixels);

    // The sky turns.
    scene.environment = sh_scene::Sky::default().map(16, 8);
    let lit = picture(&scene);
    assert_eq!((lit.changes.projections, lit.changes.nodes), (1, 0));
    assert!(lit.work[update].tasks > 0);
    assert_eq!(
        lit.pixels,
        sh_cpu::render(&scene, &plan, (32, 24), &|_| {})
            .unwrap()
            .pixels
    );
    // A point of a surface that turns dark.
    scene.objects[0].surface.points[0].albedo = [0.0; 3];
    let darker = picture(&scene);
    assert!(darker.changes.none() && darker.work[update].tasks > 0);
}

/// What a pass is counted with: every pass of a plan has tasks, and those with memory say so.
#[test]
fn every_pass_tells_its_work() {
    let scene = two_balls();
    for half in [false, true] {
        let mut scene = scene.clone();
        scene.settings.half_resolution = half;
        let plan = Plan::new(&scene);
        let frame = sh_cpu::render(&scene, &plan, (64, 48), &|_| {}).unwrap();
        assert_eq!(frame.work.len(), plan.passes.len());
        for (pass, work) in plan.passes.iter().zip(&frame.work) {
            assert!(
                work.tasks > 0 && work.bytes > 0,
                "{}: {work:?}",
                pass.name()
            );
        }
        let bytes: u64 = frame.buffers.iter().map(|buffer| buffer.bytes).sum();
        assert_eq!(bytes, frame.work.iter().map(|work| work.bytes).sum());
        let picture = frame.buffers.iter().find(|buffer| buffer.name == "picture");
        assert_eq!(picture.map(|buffer| buffer.bytes), Some(64 * 48 * 12));
        // 8 tiles across and 6 down, twice where half resolution comes first.
        let gbuffer: u64 = plan
            .passes
            .iter()
            .zip(&frame.work)
            .filter(|(pass, _)| pass.is(&GBUFFER))
            .map(|(_, work)| work.tasks)
            .sum();
        assert_eq!(gbuffer, if half { 48 + 4 } else { 48 });
    }
}
