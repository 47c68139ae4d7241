//! The shadow and irradiance kernels against f64.

use crate::gpu::Gpu;
use crate::scenes::Numbers;
use crate::truth;
use sh_core::for_order;
use sh_gpu::{IrradiancePass, ShadowOptions, ShadowPass};
use sh_scene::{Light, Receiver, Sphere};

/// Largest distance from the truth that rounding may make, of a radiance of about 1.
const ROUNDING: f64 = 2e-5;

/// The shadow pass, accumulating in the light's own order.
pub fn shadow(
    gpu: &Gpu,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
) -> Vec<[f32; 4]> {
    accumulated(gpu, receivers, spheres, light, light.order)
}

fn accumulated(
    gpu: &Gpu,
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
) -> Vec<[f32; 4]> {
    let options = ShadowOptions {
        order: light.order,
        accumulation,
        max_blockers: spheres.len() as u32,
        max_emitters: light.emitters.len() as u32,
        ..ShadowOptions::default()
    };
    let pass = ShadowPass::with(&gpu.pipelines, options).unwrap();
    let (input, output) = (
        gpu.buffer(receivers),
        gpu.buffer(&vec![[-1.0_f32; 4]; receivers.len()]),
    );
    let bound = pass
        .bind(
            &gpu.device,
            input.as_entire_buffer_binding(),
            output.as_entire_buffer_binding(),
        )
        .unwrap();
    pass.prepare_spheres(&gpu.queue, spheres, light).unwrap();
    gpu.submit(|encoder| pass.record(encoder, &bound, None));
    gpu.read(&output)
}

fn compare(what: &str, found: &[[f32; 4]], expected: impl Fn(usize) -> [f64; 3]) {
    for (i, found) in found.iter().enumerate() {
        let expected = expected(i);
        for c in 0..3 {
            let off = (f64::from(found[c]) - expected[c]).abs();
            assert!(
                off < ROUNDING,
                "{what}, receiver {i}: {found:?}, but f64 says {expected:?}"
            );
        }
        assert_eq!(found[3], 0.0);
    }
}

/// The truth at an order and an order of accumulation.
type Truth = fn(&Receiver, &[Sphere], &Light) -> [f64; 3];

pub fn shadow_is_that_of_f64(gpu: &Gpu) {
    let orders: [(usize, usize, Truth); 7] = [
        (2, 2, truth::shadow::<4, 4>),
        (3, 3, truth::shadow::<9, 9>),
        (4, 4, truth::shadow::<16, 16>),
        (5, 5, truth::shadow::<25, 25>),
        (6, 6, truth::shadow::<36, 36>),
        (3, 5, truth::shadow::<9, 25>),
        (4, 6, truth::shadow::<16, 36>),
    ];
    for (order, accumulation, truth) in orders {
        // No blocker, part of a tile, whole tiles, one more.
        for count in [0, 7, 128, 193] {
            let mut numbers = Numbers(order as u64 * 1000 + count as u64);
            let receivers = numbers.receivers(300);
            let (spheres, light) = (numbers.spheres(count), numbers.light(order));
            let found = accumulated(gpu, &receivers, &spheres, &light, accumulation);
            let open = accumulated(gpu, &receivers, &[], &light, accumulation);
            let darkened = found
                .iter()
                .zip(&open)
                .filter(|(f, o)| f[0] < 0.99 * o[0])
                .count();
            assert!(
                count == 0 || darkened > 50,
                "{darkened} of 300 receivers are in shadow"
            );
            let what = format!("order {order} of {accumulation}, {count} blockers");
            compare(&what, &found, |i| match receivers[i].covered {
                0 => [0.0; 3],
                _ => truth(&receivers[i], &spheres, &light),
            });
        }
    }
}

pub fn irradiance_is_that_of_f64(gpu: &Gpu) {
    for order in 2..=6 {
        let mut numbers = Numbers(order as u64);
        let (receivers, light) = (numbers.receivers(300), numbers.light(order));
        let pass = IrradiancePass::with(&gpu.pipelines, order, 1, true).unwrap();
        let (input, output) = (
            gpu.buffer(&receivers),
            gpu.buffer(&vec![[-1.0_f32; 4]; 300]),
        );
        let bound = pass
            .bind(
                &gpu.device,
                input.as_entire_buffer_binding(),
                output.as_entire_buffer_binding(),
            )
            .unwrap();
        pass.prepare(&gpu.queue, &light).unwrap();
        gpu.submit(|encoder| pass.record(encoder, &bound, None));
        let found = gpu.read(&output);
        compare(&format!("order {order}, irradiance"), &found, |i| {
            let receiver = &receivers[i];
            match receiver.covered {
                0 => [0.0; 3],
                _ => for_order!(order, C => truth::irradiance::<C>(receiver, &light)),
            }
        });
    }
}

/// A crowd of overlapping blockers, receivers at their centres,
/// blockers without size, receivers and blockers as far away as floats reach.
pub fn crowds_of_blockers_stay_bounded(gpu: &Gpu) {
    for order in [2, 4, 6] {
        let mut numbers = Numbers(77);
        let mut receivers = numbers.receivers(200);
        let mut spheres = numbers.spheres(500);
        for (i, sphere) in spheres.iter_mut().enumerate() {
            sphere.radius *= [10.0, 0.0, 1.0, 1e-20, 100.0][i % 5];
        }
        spheres.push(Sphere {
            center: [1e18; 3],
            radius: 1.0,
        });
        spheres.push(Sphere {
            center: [0.0; 3],
            radius: 1e18,
        });
        for (receiver, sphere) in receivers.iter_mut().zip(&spheres).take(60) {
            receiver.position = sphere.center;
        }
        receivers[61].position = [1e18, 0.0, 0.0];
        receivers[62].position = [0.0, -1e18, 0.0];
        let light = numbers.light(order);
        let open = shadow(gpu, &receivers, &[], &light);
        let shadowed = shadow(gpu, &receivers, &spheres, &light);
        for (i, (open, shadowed)) in open.iter().zip(&shadowed).enumerate() {
            for c in 0..3 {
                let within = (0.0..=open[c].max(0.0)).contains(&shadowed[c]);
                assert!(
                    within,
                    "order {order}, receiver {i}: {shadowed:?} of {open:?}"
                );
            }
        }
    }
}

/// A receiver slides along a plane that cuts a blocker: out of its inside, past it, far away. The largest
/// step between neighbours has to shrink with the distance between them.
pub fn walking_across_a_blocker_never_jumps(gpu: &Gpu) {
    let light = Numbers(3).light(4);
    let largest_step = |height: f32, steps: usize| {
        let sphere = Sphere {
            center: [0.0, height, 0.0],
            radius: 1.0,
        };
        let receivers: Vec<Receiver> = (0..=steps)
            .map(|i| Receiver {
                position: [0.05 + 4.0 * i as f32 / steps as f32, 0.0, 0.3],
                covered: 1,
                normal: [0.0, 1.0, 0.0],
                object: 0,
            })
            .collect();
        let radiance = shadow(gpu, &receivers, &[sphere], &light);
        radiance
            .windows(2)
            .map(|w| (w[1][0] - w[0][0]).abs())
            .fold(0.0, f32::max)
    };
    for height in [-0.95, -0.5, -0.01, 0.01, 0.5, 0.95, 0.999, 1.0, 1.001] {
        let (coarse, fine) = (largest_step(height, 500), largest_step(height, 5000));
        assert!(
            fine < 0.25 * coarse + 1e-5,
            "height {height}: steps of {coarse} became {fine}, ten times as many"
        );
    }
}
