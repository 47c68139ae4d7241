//! Environment maps, Radiance HDR.

#![no_main]

use gaunt_fuzz::{environment, file};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| environment(&file("map.hdr", bytes)));
