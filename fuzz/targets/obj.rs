//! Wavefront OBJ.

#![no_main]

use gaunt_fuzz::{file, mesh};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| mesh(&file("mesh.obj", bytes)));
