//! glTF, as JSON or GLB. An input that begins like JSON and has a zero byte in it is the JSON and the binary
//! of a GLB, apart there: so that a mutation of either leaves the lengths right.

#![no_main]

use gaunt_fuzz::{file, glb, mesh};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let zero = bytes.iter().position(|b| *b == 0);
    match zero {
        Some(zero) if bytes.starts_with(b"{") => {
            mesh(&file("mesh.glb", &glb(&bytes[..zero], &bytes[zero + 1..])));
        }
        _ => mesh(&file("mesh.gltf", bytes)),
    }
});
