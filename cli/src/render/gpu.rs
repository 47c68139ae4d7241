//! A picture on the GPU: the passes record, this submits and reads back.

use super::shot::Shot;
use crate::Error;
use crate::gpu::{Gpu, Stamps};
use crate::report::Times;
use sh_gpu::Renderer;
use sh_scene::resource::Given;
use sh_scene::{Resource, Scene, Tracker};
use std::time::Instant;
use wgpu::Buffer;

/// What is made for the first picture and used for all.
pub struct Painter {
    renderer: Renderer,
    stamps: Option<Stamps>,
    /// Where the picture is read back from.
    staging: Buffer,
    /// The same for each thing that the plan gives besides.
    besides: Vec<(Resource, Buffer)>,
}

/// A picture, and what else the plan gives of its pixels.
pub(crate) struct Painted {
    /// Linear radiance, row by row from the top.
    pub(crate) pixels: Vec<[f32; 3]>,
    pub(crate) given: Given,
}

impl Painter {
    fn new(gpu: &Gpu, scene: &Scene, shot: &Shot) -> Result<Self, Error> {
        let renderer = Renderer::new(&gpu.device, &gpu.queue, scene, shot.plan, shot.view)?;
        Ok(Self {
            stamps: Stamps::new(gpu, renderer.timestamps()),
            staging: gpu.staging(renderer.picture().size()),
            besides: shot
                .plan
                .besides()
                .filter_map(|given| Some((given, renderer.given(given)?.size())))
                .map(|(given, size)| (given, gpu.staging(size)))
                .collect(),
            renderer,
        })
    }
}

/// Runs the plan, with the light that the tracker has.
pub fn picture(
    gpu: &Gpu,
    painter: &mut Option<Painter>,
    (scene, tracker): (&Scene, &mut Tracker),
    shot: &Shot,
    times: &mut Times,
) -> Result<Painted, Error> {
    let painter = times.measure("upload", || -> Result<&mut Painter, Error> {
        let painter = match painter {
            Some(painter) => {
                if shot.changes.meshes {
                    painter.renderer.update_meshes(&gpu.queue, scene)?;
                }
                if shot.changes.environment {
                    let environment = &scene.environment;
                    painter
                        .renderer
                        .update_environment(&gpu.queue, environment)?;
                }
                painter
            }
            none => none.insert(Painter::new(gpu, scene, shot)?),
        };
        if shot.plan.is_blocked() {
            tracker.place(scene);
        }
        if let Some(light) = tracker.light() {
            let blockers = tracker.forest();
            let renderer = &painter.renderer;
            renderer.prepare(&gpu.queue, scene, blockers, light, shot.view)?;
        }
        gpu.submit(|_| {})?;
        Ok(painter)
    })?;
    let Painter {
        renderer,
        stamps,
        staging,
        besides,
    } = painter;
    let picture = renderer.picture();
    let start = Instant::now();
    gpu.submit(|encoder| {
        renderer.record(encoder, stamps.as_ref().map(Stamps::queries));
        if let Some(stamps) = stamps {
            stamps.resolve(encoder);
        }
    })?;
    renderer.submitted();
    let mut rest = start.elapsed().as_secs_f64();
    if let Some(stamps) = stamps {
        let stamps = stamps.read(gpu)?;
        for (pass, nanoseconds) in renderer.times(&stamps, gpu.queue.get_timestamp_period()) {
            times.add(pass, nanoseconds * 1e-9);
            rest -= nanoseconds * 1e-9;
        }
    }
    // All passes, or what recording, submitting and waiting took besides them.
    times.add("frame", rest.max(0.0));
    times.measure("read back", || {
        gpu.submit(|encoder| {
            encoder.copy_buffer_to_buffer(picture, 0, staging, 0, picture.size());
            for (resource, staging) in besides.iter() {
                if let Some(given) = renderer.given(*resource) {
                    encoder.copy_buffer_to_buffer(given, 0, staging, 0, given.size());
                }
            }
        })?;
        let given = besides.iter().map(|(resource, staging)| {
            let read = |bytes: &[u8]| bytemuck::cast_slice(bytes).to_vec();
            Ok::<_, Error>((*resource, gpu.read(staging, read)?))
        });
        Ok(Painted {
            pixels: gpu.read(staging, |bytes| {
                let pixels: &[[f32; 4]] = bytemuck::cast_slice(bytes);
                pixels.iter().map(|[r, g, b, _]| [*r, *g, *b]).collect()
            })?,
            given: given.collect::<Result<_, _>>()?,
        })
    })
}
