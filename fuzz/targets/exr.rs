//! Environment maps, OpenEXR.

#![no_main]

use gaunt_fuzz::{environment, file};
use libfuzzer_sys::fuzz_target;

// libFuzzer's own hook ends the process at a panic, also at one that the loader catches. One that nobody catches
// still ends it.
fuzz_target!(init: std::panic::set_hook(Box::new(|_| ())), |bytes: &[u8]| environment(&file("map.exr", bytes)));
