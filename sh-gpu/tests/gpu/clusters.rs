//! Clusters and trees at their edges: empty ones, far too many, records that lead nowhere, numbers that are none.

use crate::gpu::Gpu;
use crate::scenes::{Numbers, lamps};
use sh_gpu::{ClusterBinding, ShadowOptions, ShadowPass};
use sh_scene::{Forest, Light, Limits, Receiver, Sphere};

/// The pass with receivers and clusters, ready for trees.
struct Lit<'a> {
    gpu: &'a Gpu,
    pass: ShadowPass,
    bound: sh_gpu::Bound,
    output: wgpu::Buffer,
    count: usize,
}

impl<'a> Lit<'a> {
    fn new(gpu: &'a Gpu, receivers: &[Receiver], clusters: &[[u32; 2]], largest: u32) -> Self {
        let pass = ShadowPass::with(&gpu.pipelines, ShadowOptions::default()).unwrap();
        let (input, records) = (gpu.buffer(receivers), gpu.buffer(clusters));
        let output = gpu.room(receivers.len() as u64 * 16);
        let clusters = ClusterBinding {
            clusters: records.as_entire_buffer_binding(),
            largest,
        };
        let bound = pass
            .bind_clusters(
                &gpu.device,
                input.as_entire_buffer_binding(),
                clusters,
                output.as_entire_buffer_binding(),
            )
            .unwrap();
        Self {
            gpu,
            pass,
            bound,
            output,
            count: receivers.len(),
        }
    }

    /// What receivers show that nothing was written to hold -1.
    fn shade(&self, forest: &Forest, limits: Limits, light: &Light) -> Vec<[f32; 4]> {
        let nothing = vec![[-1.0_f32; 4]; self.count];
        let queue = &self.gpu.queue;
        queue.write_buffer(&self.output, 0, bytemuck::cast_slice(&nothing));
        self.pass.prepare(queue, forest, limits, light).unwrap();
        self.gpu
            .submit(|encoder| self.pass.record(encoder, &self.bound, None));
        self.gpu.read(&self.output)
    }
}

/// Blockers without size in one place, on top of each other or at the end of the world, in one tree.
pub fn trees_of_any_kind_stay_bounded(gpu: &Gpu) {
    let mut numbers = Numbers(6);
    let mut receivers = numbers.receivers(512);
    receivers[100].position = [1e18, 0.0, 0.0];
    receivers[300].position = [f32::NAN, 0.0, 0.0];
    let lit = Lit::new(gpu, &receivers, &[[0, 256], [256, 256]], 256);
    let light = numbers.light(4).with_lights(&lamps()).unwrap();
    let limits = Limits::default();
    let open = lit.shade(&Forest::new(&[], &[]), limits, &light);
    let ball = |center, radius| Sphere { center, radius };
    let points = vec![ball([9.0; 3], 0.0); 40];
    assert_eq!(
        lit.shade(&Forest::new(&points, &[40]), limits, &light),
        open
    );
    let mut mixed = numbers.spheres(60);
    mixed.extend(vec![ball([20.0, 0.0, 0.0], 0.5); 30]);
    mixed.extend([
        ball([1e18; 3], 1.0),
        ball([0.0; 3], 1e18),
        ball([-1e18, 0.0, 0.0], 1e17),
        ball([30.0; 3], 1e-20),
    ]);
    let forest = Forest::new(&mixed, &[60, 34]);
    for limits in [limits, Limits::LEAVES, Limits::new(0.5, 0.5)] {
        let shadowed = lit.shade(&forest, limits, &light);
        for (i, (open, shadowed)) in open.iter().zip(&shadowed).enumerate() {
            for c in 0..3 {
                let within = (0.0..=open[c]).contains(&shadowed[c]);
                assert!(within, "receiver {i}: {shadowed:?} of {open:?}");
            }
        }
    }
}

/// Records that lead beyond the receivers light those that there are and touch nothing else; what no cluster holds is
/// left alone.
pub fn clusters_that_lead_nowhere_do_no_harm(gpu: &Gpu) {
    let mut numbers = Numbers(7);
    let receivers = numbers.receivers(200);
    let (spheres, light) = (numbers.spheres(50), numbers.light(4));
    let forest = Forest::new(&spheres, &[50]);
    let whole = Lit::new(gpu, &receivers, &[[0, 100], [100, 40]], 100);
    let whole = whole.shade(&forest, Limits::LEAVES, &light);
    let records = [
        [100, 40],
        [0, 100],
        [0, 0],
        [200, 50],
        [u32::MAX, 3],
        [7000, u32::MAX],
    ];
    let odd = Lit::new(gpu, &receivers, &records, 128);
    let found = odd.shade(&forest, Limits::LEAVES, &light);
    assert_eq!(found[..140], whole[..140]);
    assert!(found[140..].iter().all(|value| *value == [-1.0; 4]));
    // Reaching beyond the end means to the end.
    let last = Lit::new(gpu, &receivers, &[[0, 140], [140, u32::MAX - 3]], 140);
    let found = last.shade(&forest, Limits::LEAVES, &light);
    assert!(found.iter().all(|value| value[0] >= 0.0));
}

/// More clusters than one axis of a dispatch holds.
pub fn clusters_beyond_one_axis_are_lit(gpu: &Gpu) {
    const COUNT: u32 = 66_000;
    let receivers: Vec<Receiver> = (0..COUNT)
        .map(|i| Receiver {
            position: [0.0; 3],
            covered: u32::from(i % 16_384 == 463),
            normal: [0.0, 1.0, 0.0],
            object: 0,
        })
        .collect();
    let clusters: Vec<[u32; 2]> = (0..COUNT).map(|i| [i, 1]).collect();
    let lit = Lit::new(gpu, &receivers, &clusters, 1);
    let found = lit.shade(
        &Forest::new(&[], &[]),
        Limits::default(),
        &Numbers(1).light(4),
    );
    for (receiver, found) in receivers.iter().zip(&found) {
        assert_eq!(found[0] > 0.0, receiver.covered == 1);
        assert_eq!(found[3], 0.0);
    }
}
