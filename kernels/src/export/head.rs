//! The first lines of every file: what it is, its conventions, how to make it again, its licence.

use super::ascii::wrapped;
use super::source::{Source, comment};
use super::{Language, Request};

/// The head as comment. Everything an includer has to know stands here or at a routine.
pub fn text(request: &Request<'_>, source: &Source) -> String {
    comment(&lines(request, source))
}

/// The head line by line.
pub fn lines(request: &Request<'_>, source: &Source) -> Vec<String> {
    let (order, count) = (request.order, request.order * request.order);
    let mut command = format!(
        "gaunt export --lang {} --order {order}",
        request.language.option()
    );
    if !request.routines.is_empty() {
        command += &format!(" --routines {}", request.routines.join(","));
    }
    if let Some(prefix) = request.prefix {
        command += &format!(" --prefix {prefix}");
    }
    let mut paragraphs = vec![
        format!(
            "Spherical harmonics of order {order} in {}. Gaunt {}.",
            request.language.name(),
            env!("CARGO_PKG_VERSION")
        ),
        format!("Made by `{command}`; do not change it here. MIT or Apache-2.0, at your choice."),
        String::new(),
    ];
    paragraphs.push(usage(request.language, source));
    paragraphs.extend([
        String::new(),
        format!(
            "A vector has {count} coefficients; that of band l and index m, -l to l, stands at l*l + l + m. The basis is \
             real and orthonormal, with the signs usual in graphics (no Condon-Shortley): band 1 is sqrt(3/(4 pi)) (y, z, \
             x), and the function 1 is (sqrt(4 pi), 0, ...). A zonal vector has the {order} coefficients of m = 0, one a \
             band, of a function that is round about +Z. A symmetric matrix is its lower triangle, row by row. Axes are \
             right-handed, angles radians; directions and quaternions (x, y, z, w) have length 1, and rotations are \
             active: (Rf)(s) = f(R^-1 s)."
        ),
        String::new(),
        format!("Routines, each with the prefix {}: {}.", source.prefix, source.functions().join(", ")),
    ]);
    paragraphs.iter().flat_map(|p| wrapped(p, 115)).collect()
}

/// How a file of the language is used.
fn usage(language: Language, source: &Source) -> String {
    let prefix = &source.prefix;
    match language {
        Language::Wgsl => {
            "Put it before or after your own text: it declares functions, constants and at most one \
             struct, all of which start with the prefix. No extension is needed.".into()
        }
        Language::Glsl450 => {
            "#include it, or put it after `#version 450` or later. It declares neither inputs nor \
             outputs.".into()
        }
        Language::Glsl330 => {
            "Put it after `#version 330` or later. It declares neither inputs nor outputs. Without the \
             packing of halves, which GLSL has from 4.2 on.".into()
        }
        Language::Glsl300Es => {
            "Put it after `#version 300 es`, for WebGL 2 and OpenGL ES 3.0. It declares neither inputs nor \
             outputs, and sets `precision highp float; precision highp int;`.".into()
        }
        Language::Hlsl => {
            "#include it in a shader of model 6.0 or later, compiled by DXC. It declares no \
             resources.".into()
        }
        Language::Msl => {
            format!("#include it in a Metal shader, version 2.0 or later. Arrays are structs with one \
             member, as in `{prefix}Vector f; f.inner[0] = 1.0;`.")
        }
        Language::Spirv => {
            "A compute entry point for each routine, with the routine's name, for Vulkan 1.1 and later. \
             Invocation i takes its arguments from the storage buffer at set 0, binding 0 and puts its \
             result into that at binding 1; both are arrays of numbers of 32 bits, those of one invocation \
             after those of the one before. Workgroups have 64 invocations along x; those beyond the end \
             of the results do nothing.".into()
        }
        Language::SpirvLibrary => {
            format!("Every routine is a function with the linkage attribute `{prefix}... Export`. Declare \
             it in your module with `Import` and link: `spirv-link yours.spv {}_library.spv -o whole.spv`. \
             Types have to be the same: a vector is OpTypeArray of 32-bit floats with ArrayStride 4.",
             prefix.trim_end_matches('_'))
        }
    }
}
