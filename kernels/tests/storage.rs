//! sh-core's storage types have the size and the strides that shaders give them: std140's rules are those of WGSL's
//! uniform buffers, std430's those of its storage buffers.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use sh_core::storage::{HalfRgb2, HalfRgb3, Rgb2, Rgb3};

/// The size of a WGSL type in a buffer of an address space, or `None` where its layout is not permitted there.
fn size(space: &str, ty: &str) -> Option<usize> {
    let text = format!("@group(0) @binding(0) var<{space}> packed: {ty};");
    let module = naga::front::wgsl::parse_str(&text).expect("a declaration");
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    validator.validate(&module).ok()?;
    let mut layouter = naga::proc::Layouter::default();
    layouter.update(module.to_ctx()).ok()?;
    let (_, variable) = module.global_variables.iter().next()?;
    Some(layouter[variable.ty].size as usize)
}

#[test]
fn types_have_the_layout_that_they_state() {
    for space in ["uniform", "storage"] {
        assert_eq!(size(space, "array<vec4<f32>, 3>"), Some(size_of::<Rgb2>()));
        assert_eq!(size(space, "array<vec4<f32>, 7>"), Some(size_of::<Rgb3>()));
        assert_eq!(
            size(space, "array<vec4<u32>, 4>"),
            Some(size_of::<HalfRgb3>())
        );
        let padded = size_of_val(&HalfRgb2::default().std140());
        assert_eq!(size(space, "array<vec4<u32>, 2>"), Some(padded));
    }
    assert_eq!(
        size("storage", "array<vec2<u32>, 3>"),
        Some(size_of::<HalfRgb2>())
    );
    assert_eq!(
        size("uniform", "array<vec2<u32>, 3>"),
        None,
        "std140 would pad it"
    );
}
