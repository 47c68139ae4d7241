//! Scene files. Their meshes are missing, so that each ends where the first mesh would be read.

#![no_main]

use gaunt_fuzz::{check_error, file};
use libfuzzer_sys::fuzz_target;
use sh_bake::load_scene;

fuzz_target!(|bytes: &[u8]| {
    if let Err(error) = load_scene(&file("scene.toml", bytes)) {
        check_error(&error);
    }
});
