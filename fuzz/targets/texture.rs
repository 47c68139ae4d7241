//! Base colour textures, PNG and JPEG: the input is the image of a triangle that is right in all else.

#![no_main]

use gaunt_fuzz::{file, glb, mesh};
use libfuzzer_sys::fuzz_target;

/// Positions (0 0 0), (1 0 0), (0 1 0); the same bytes, read two by two, serve as texture coordinates.
const CORNERS: [f32; 9] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];

fuzz_target!(|bytes: &[u8]| {
    let kind = if bytes.first() == Some(&0x89) {
        "png"
    } else {
        "jpeg"
    };
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],
"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"material":0}}]}}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}},
{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"}}],
"bufferViews":[{{"buffer":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":{}}}],
"buffers":[{{"byteLength":{}}}],"images":[{{"bufferView":1,"mimeType":"image/{kind}"}}],
"textures":[{{"source":0}}],
"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}}}}}}]}}"#,
        bytes.len(),
        36 + bytes.len(),
    );
    let corners = CORNERS.iter().flat_map(|c| c.to_le_bytes());
    let binary: Vec<u8> = corners.chain(bytes.iter().copied()).collect();
    mesh(&file("mesh.glb", &glb(json.as_bytes(), &binary)));
});
