//! Light that spheres send on, against the CPU.

use crate::gpu::Gpu;
use crate::parity::{clustered, compare};
use crate::scenes::{Numbers, standing_quad, surface};
use glam::{Affine3A, Quat, Vec3};
use sh_cpu::{
    CutOptions, LightCutOptions, LightCuts, LightGather, LightUpdate, Path, SphericalLights,
};
use sh_gpu::{ClusterBinding, LightGatherPass, LightUpdatePass, ShadowOptions, ShadowPass};
use sh_scene::{
    Blocking, Body, Forest, Indirect, Light, Limits, Object, Receiver, Scene, Sphere,
    SurfaceSamples,
};
use std::ops::Range;

/// A heap of intersecting spheres with a surface.
fn heap(numbers: &mut Numbers, count: usize, spread: f32) -> Object {
    let spheres: Vec<_> = (0..count)
        .map(|_| Sphere {
            center: (numbers.vector() * spread).into(),
            radius: 0.1 + 0.3 * numbers.next(),
        })
        .collect();
    Object {
        surface: surface(numbers, &spheres),
        spheres,
        transform: Affine3A::from_scale_rotation_translation(
            Vec3::splat(0.7 + 0.6 * numbers.next()),
            Quat::from_scaled_axis(numbers.vector() * 3.0),
            numbers.vector() * 2.0,
        ),
        ..standing_quad().objects.remove(0)
    }
}

/// Heaps that interlock and some far off, one without a surface, one whose points are black or no number, one that has
/// no extent.
fn heaps(numbers: &mut Numbers) -> Scene {
    let mut scene = standing_quad();
    scene.objects.clear();
    for (count, spread) in [(9, 0.5), (1, 0.1), (14, 0.7), (6, 0.4), (5, 0.4), (2, 0.3)] {
        scene.objects.push(heap(numbers, count, spread));
    }
    let far = heap(numbers, 24, 0.6);
    let away = Affine3A::from_translation(Vec3::new(9.0, 1.0, -4.0));
    scene.objects.push(Object {
        transform: away * far.transform,
        ..far
    });
    scene.objects[3].surface = SurfaceSamples::default();
    for (i, point) in scene.objects[4].surface.points.iter_mut().enumerate() {
        point.albedo = [0.0, f32::NAN, [0.0, f32::NAN][i % 2]];
    }
    for sphere in &mut scene.objects[5].spheres {
        sphere.radius = 0.0;
    }
    scene
}

/// What one backend finds: the emission of all nodes, and the radiance of all receivers.
struct Sent {
    emission: Vec<[f32; 3]>,
    brightest: [f32; 3],
    radiance: Vec<[f32; 3]>,
}

/// What is asked of both.
struct Case<'a> {
    objects: &'a [Object],
    forest: &'a Forest,
    light: &'a Light,
    limits: Limits,
    indirect: Indirect,
    receivers: &'a [Receiver],
    clusters: &'a [Range<usize>],
}

impl Case<'_> {
    fn on_cpu(&self) -> Sent {
        let &Self {
            objects,
            forest,
            light,
            limits,
            indirect,
            receivers,
            clusters,
        } = self;
        let mut lights = SphericalLights::default();
        let update = LightUpdate {
            indirect,
            limits,
            accumulation: light.order,
        };
        let bodies = objects.iter().map(Body::from);
        let path = Path::best();
        lights.update(path, bodies, forest, light, update).unwrap();
        let mut cuts = LightCuts::default();
        let options = LightCutOptions {
            cut: CutOptions {
                limits,
                ratios: true,
                accumulation: light.order,
            },
            blocking: indirect.blocking,
        };
        cuts.find(path, receivers, clusters, forest, &lights, options);
        let gather = LightGather {
            clusters,
            cuts: &cuts,
            lights: &lights,
            eye: None,
        };
        let mut radiance = vec![[0.0; 3]; receivers.len()];
        sh_cpu::light_gather(path, receivers, &gather, &mut radiance).unwrap();
        let nodes = 0..forest.nodes().len() as u32;
        Sent {
            emission: nodes
                .flat_map(|node| lights.emission(node).to_vec())
                .collect(),
            brightest: lights.brightest(),
            radiance,
        }
    }

    fn on_gpu(&self, gpu: &Gpu) -> Sent {
        let options = ShadowOptions {
            order: self.light.order,
            accumulation: self.light.order,
            max_blockers: self.forest.spheres() as u32,
            max_emitters: 2,
            ..ShadowOptions::default()
        };
        let (device, queue) = (&gpu.device, &gpu.queue);
        let shadow = ShadowPass::with(&gpu.pipelines, options).unwrap();
        let gather = LightGatherPass::new(device, &shadow, self.indirect.blocking).unwrap();
        let bodies = || self.objects.iter().map(Body::from);
        let bounces = self.indirect.bounces;
        let update =
            LightUpdatePass::new(device, queue, &shadow, &gather, bodies(), bounces).unwrap();
        let input = gpu.buffer(self.receivers);
        // It adds to what is there.
        let output = gpu.buffer(&vec![[0.25_f32; 4]; self.receivers.len()]);
        let records: Vec<[u32; 2]> = self
            .clusters
            .iter()
            .map(|range| [range.start as u32, range.len() as u32])
            .collect();
        let records = gpu.buffer(&records);
        let largest = self.clusters.iter().map(|range| range.len() as u32).max();
        let clusters = ClusterBinding {
            clusters: records.as_entire_buffer_binding(),
            largest: largest.unwrap(),
        };
        let bound = gather
            .bind_clusters(
                device,
                input.as_entire_buffer_binding(),
                clusters,
                output.as_entire_buffer_binding(),
            )
            .unwrap();
        shadow
            .prepare(queue, self.forest, self.limits, self.light)
            .unwrap();
        let spheres = self.objects.iter().map(|object| object.spheres.len());
        gather.prepare(queue, self.forest, spheres).unwrap();
        update.prepare(queue, bodies(), self.forest).unwrap();
        gpu.submit(|encoder| {
            update.record(encoder, &shadow, &gather, None);
            gather.record(encoder, &bound, None);
        });
        let emission: Vec<[f32; 4]> = gpu.read(gather.emission());
        let count = self.light.order * self.light.order;
        let [r, g, b, _] = emission[count];
        let emission = emission.chunks(count + 1).take(self.forest.nodes().len());
        let radiance: Vec<[f32; 4]> = gpu.read(&output);
        for (receiver, radiance) in self.receivers.iter().zip(&radiance) {
            assert!(receiver.covered != 0 || radiance[..3] == [0.25; 3]);
        }
        Sent {
            emission: emission
                .flat_map(|node| node[..count].iter().map(|&[r, g, b, _]| [r, g, b]))
                .collect(),
            brightest: [r, g, b],
            radiance: radiance
                .iter()
                .map(|&[r, g, b, _]| [r - 0.25, g - 0.25, b - 0.25])
                .collect(),
        }
    }
}

/// How many receivers differ by more than rounding, and the largest difference.
fn differ(case: &Case, gpu: &Gpu, what: &str) -> (usize, f32) {
    let (found, expected) = (case.on_gpu(gpu), case.on_cpu());
    let bright = expected
        .emission
        .iter()
        .flatten()
        .fold(0.0_f32, |most, &c| most.max(c.abs()));
    let lit = expected.radiance.iter().filter(|r| r[0] > 0.005).count();
    assert!(bright > 0.5 && lit > 50, "{bright} {lit}");
    assert_eq!(found.emission.len(), expected.emission.len());
    let off = found.emission.iter().flatten();
    let off = off.zip(expected.emission.iter().flatten());
    let off = off.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    let [found_most, most] = [&found, &expected].map(|sent| sent.brightest);
    let near = |(a, b): (&f32, &f32)| (a - b).abs() < 1e-5;
    assert!(
        found_most.iter().zip(&most).all(near),
        "{found_most:?} {most:?}"
    );
    let wide: Vec<_> = found
        .radiance
        .iter()
        .map(|&[r, g, b]| [r, g, b, 0.0])
        .collect();
    let (count, most) = compare(&wide, &expected.radiance);
    println!("{what}: emission {off:e} of {bright}, {count} differ, {most:e} at most");
    assert!(off < 5e-5 * bright, "{what}: {off} of {bright}");
    (count, most)
}

/// What every node emits and every receiver gets, at every order, with every rule of blocking.
pub fn spheres_send_what_they_do_on_the_cpu(gpu: &Gpu) {
    for order in 2..=6 {
        let mut numbers = Numbers(40 + order as u64);
        let scene = heaps(&mut numbers);
        let forest = scene.forest();
        let light = numbers.light(order);
        let (mut receivers, clusters) = clustered(&mut numbers, 400);
        // Some within spheres.
        let spheres = forest.leaves().step_by(9);
        for (receiver, sphere) in receivers.iter_mut().step_by(31).zip(spheres) {
            let away = Vec3::from(receiver.normal) * sphere.radius * 0.4;
            receiver.position = (Vec3::from(sphere.center) + away).into();
        }
        for (blocking, bounces) in Blocking::ALL.into_iter().zip([2, 3, 1, 2]) {
            let case = Case {
                objects: &scene.objects,
                forest: &forest,
                light: &light,
                limits: Limits::default(),
                indirect: Indirect {
                    bounces,
                    blocking,
                    ..Indirect::default()
                },
                receivers: &receivers,
                clusters: &clusters,
            };
            let what = format!("order {order}, {blocking:?}, {bounces} bounces");
            let (count, most) = differ(&case, gpu, &what);
            assert!(
                count <= 3 && most < 0.01,
                "{what}: {count} differ, {most} at most"
            );
        }
    }
}

/// Cuts that workgroup memory does not hold.
pub fn long_cuts_are_those_of_the_cpu(gpu: &Gpu) {
    for (order, blocking) in [
        (3, Blocking::Runs),
        (4, Blocking::Object),
        (4, Blocking::Discs),
    ] {
        let mut numbers = Numbers(90 + order as u64);
        let mut scene = standing_quad();
        scene.objects = [90, 70, 50]
            .map(|count| heap(&mut numbers, count, 1.0))
            .to_vec();
        let forest = scene.forest();
        let light = numbers.light(order);
        let (receivers, clusters) = clustered(&mut numbers, 200);
        let case = Case {
            objects: &scene.objects,
            forest: &forest,
            light: &light,
            limits: Limits::LEAVES,
            indirect: Indirect {
                bounces: 1,
                blocking,
                ..Indirect::default()
            },
            receivers: &receivers,
            clusters: &clusters,
        };
        let what = format!("order {order}, {blocking:?}, 210 spheres");
        let (count, most) = differ(&case, gpu, &what);
        assert!(
            count <= 3 && most < 0.01,
            "{what}: {count} differ, {most} at most"
        );
    }
}

/// Spheres and receivers at the edges of what there is: inside each other, at centres, without extent, as far off as
/// floats reach. What is sent lies between 0 and the brightest of all.
pub fn what_is_sent_stays_bounded(gpu: &Gpu) {
    for order in [2, 4, 6] {
        let mut numbers = Numbers(60 + order as u64);
        let mut scene = heaps(&mut numbers);
        for (i, sphere) in scene.objects[2].spheres.iter_mut().enumerate() {
            sphere.radius *= [10.0, 0.0, 1.0, 1e-20, 100.0][i % 5];
            sphere.center = [[0.0; 3], sphere.center][i % 2];
        }
        scene.objects[6].spheres[0].center = [1e18; 3];
        scene.objects[6].spheres[1].radius = 1e18;
        scene.objects[6].transform.matrix3 *= 0.0;
        // One and the same sphere of two bodies.
        scene.objects[1].transform = scene.objects[0].transform;
        scene.objects[1].spheres[0] = scene.objects[0].spheres[0];
        let forest = scene.forest();
        let light = numbers.light(order);
        let (mut receivers, clusters) = clustered(&mut numbers, 300);
        let leaves = forest.leaves();
        for (receiver, sphere) in receivers.iter_mut().step_by(5).zip(leaves) {
            receiver.position = sphere.center;
        }
        receivers[61].position = [1e18, 0.0, 0.0];
        receivers[62].position = [0.0, -1e18, 0.0];
        for blocking in Blocking::ALL {
            let case = Case {
                objects: &scene.objects,
                forest: &forest,
                light: &light,
                limits: Limits::default(),
                indirect: Indirect {
                    bounces: 3,
                    blocking,
                    ..Indirect::default()
                },
                receivers: &receivers,
                clusters: &clusters,
            };
            let sent = case.on_gpu(gpu);
            let brightest = sent.brightest;
            assert!(brightest.iter().all(|c| (0.1..50.0).contains(c)));
            let lit = sent.radiance.iter().filter(|r| r[0] > 0.001).count();
            assert!(lit > 20, "order {order}, {blocking:?}: {lit} are lit");
            for (i, radiance) in sent.radiance.iter().enumerate() {
                for (c, most) in radiance.iter().zip(brightest) {
                    let within = (-1e-6..=most + 1e-6).contains(c);
                    assert!(
                        within,
                        "order {order}, receiver {i}: {radiance:?} of {brightest:?}"
                    );
                }
            }
            let numbers = sent.emission.iter().flatten();
            assert!(numbers.copied().all(f32::is_finite), "order {order}");
        }
    }
}
