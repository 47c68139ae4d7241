//! The scatter pass: the light of samples that half resolution does not do for, back to where they are.

/// Puts each of `light` where `indices` say.
pub(crate) fn scatter(indices: &[u32], light: &[[f32; 3]], radiance: &mut [[f32; 3]]) {
    for (&index, light) in indices.iter().zip(light) {
        radiance[index as usize] = *light;
    }
}
