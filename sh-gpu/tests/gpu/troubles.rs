//! What the device complains of reaches the caller as an error.

use crate::gpu::Gpu;
use crate::scenes::Numbers;
use sh_gpu::{Error, IrradiancePass, ShadowOptions, ShadowPass, Watch};

fn small() -> ShadowOptions {
    ShadowOptions {
        order: 2,
        accumulation: 2,
        max_blockers: 10,
        ..ShadowOptions::default()
    }
}

/// A device that is gone: whatever is made from then on, and what was submitted before.
pub fn lost_devices_are_errors(_: &Gpu) {
    let gpu = Gpu::with(wgpu::Limits::default()).unwrap();
    let watch = Watch::new(&gpu.device);
    let pass = ShadowPass::new(&gpu.device, small()).unwrap();
    let (input, output) = (gpu.room(3200), gpu.room(1600));
    let [input, output] = [&input, &output].map(|buffer| buffer.as_entire_buffer_binding());
    let bound = pass
        .bind(&gpu.device, input.clone(), output.clone())
        .unwrap();
    assert_eq!(watch.check(), Ok(()));
    gpu.device.destroy();
    let lost =
        |error: Option<Error>| assert!(matches!(error, Some(Error::DeviceLost(_))), "{error:?}");
    lost(ShadowPass::new(&gpu.device, small()).err());
    lost(IrradiancePass::new(&gpu.device, 2, 0).err());
    lost(pass.bind(&gpu.device, input, output).err());
    // A frame goes on without a panic, and the watch tells.
    pass.prepare_spheres(&gpu.queue, &[], &Numbers(1).light(2))
        .unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    pass.record(&mut encoder, &bound, None);
    gpu.queue.submit([encoder.finish()]);
    // The host's poll brings its callbacks.
    let _ = gpu.device.poll(wgpu::PollType::Poll);
    lost(watch.check().err());
}

/// Memory that is not there: this process gets no more than it has.
#[cfg(target_os = "linux")]
pub fn exhausted_memory_is_an_error(gpu: &Gpu) {
    let limit = |soft: &str| {
        let process = std::process::id().to_string();
        let set = std::process::Command::new("prlimit")
            .args(["--pid", &process, &format!("--as={soft}:")])
            .status();
        assert!(set.expect("util-linux has prlimit").success());
    };
    let status = std::fs::read_to_string("/proc/self/statm").unwrap();
    let pages: u64 = status.split(' ').next().unwrap().parse().unwrap();
    let large = ShadowOptions {
        max_blockers: 1_300_000,
        ..small()
    };
    limit(&(pages * 4096 + (48 << 20)).to_string());
    let result = ShadowPass::new(&gpu.device, large);
    limit("unlimited");
    let error = result.err();
    assert_eq!(error, Some(Error::OutOfMemory));
    // The device lives on.
    ShadowPass::new(&gpu.device, small()).unwrap();
    ShadowPass::new(&gpu.device, large).unwrap();
}

/// Buffers that were destroyed, or that lack a usage; and what nobody was there to return.
pub fn refusals_are_errors(gpu: &Gpu) {
    let pass = ShadowPass::new(&gpu.device, small()).unwrap();
    let (input, output) = (gpu.room(3200), gpu.room(1600));
    let other = gpu.sibling().unwrap();
    let foreign = other.room(1600);
    let bind = |radiance: &wgpu::Buffer| {
        let (receivers, radiance) = (
            input.as_entire_buffer_binding(),
            radiance.as_entire_buffer_binding(),
        );
        pass.bind(&gpu.device, receivers, radiance)
    };
    let error = bind(&foreign).unwrap_err();
    assert!(matches!(error, Error::Validation(_)), "{error}");
    let vertices = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 1600,
        usage: wgpu::BufferUsages::VERTEX,
        mapped_at_creation: false,
    });
    let error = bind(&vertices).unwrap_err();
    assert!(
        matches!(
            error,
            Error::Binding {
                binding: "radiance",
                ..
            }
        ),
        "{error}"
    );
    gpu.errors().unwrap();

    let watch = Watch::new(&other.device);
    let pass = ShadowPass::new(&other.device, small()).unwrap();
    let receivers = other.room(3200);
    let bound = pass
        .bind(
            &other.device,
            receivers.as_entire_buffer_binding(),
            foreign.as_entire_buffer_binding(),
        )
        .unwrap();
    foreign.destroy();
    let mut encoder = other.device.create_command_encoder(&Default::default());
    pass.record(&mut encoder, &bound, None);
    other.queue.submit([encoder.finish()]);
    let error = watch.check().unwrap_err();
    assert!(
        matches!(&error, Error::Validation(text) if text.contains("destroyed")),
        "{error}"
    );
    assert_eq!(watch.check(), Ok(()), "it was told once");
    drop(output);
}
