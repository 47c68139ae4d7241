// Polished receivers: the lobe in which they mirror light towards the eye. Twin of sh_cpu's `gloss`, where the formulae and their
// reasons stand.

#import shared/records
#import shared/lit
#import constants
#import library

// How a receiver mirrors light.
struct Gloss {
    // The unit vector to the eye.
    view: vec3f,
    // The roughness of the lobe that the order of the light can tell.
    told: f32,
    // The middle of the lobe.
    axis: vec3f,
    // The cosine of normal and view.
    facing: f32,
    // The square of GGX's alpha.
    square: f32,
    // One over what it mirrors of an even sky.
    whole: f32,
}

fn roughness_of(receiver: Receiver) -> f32 {
    return (f32(receiver.covered >> ROUGHNESS_SHIFT & MATT) - 1.0) / ROUGHNESS_STEPS;
}

// The cosine of normal and view, which is never 0.
fn facing_of(along: f32) -> f32 {
    return clamp(along, FACING, 1.0);
}

// That of a receiver that is lit; nothing where light is reflected diffusely.
fn gloss_of(receiver: Receiver, eye: vec3f) -> Gloss {
    if (!GLOSS) {
        return Gloss();
    }
    let away = eye - receiver.position;
    let view = away * (1.0 / max(length(away), NEAREST));
    let along = dot(view, receiver.normal);
    let facing = facing_of(along);
    let roughness = roughness_of(receiver);
    let told = sh$N_gloss_told(roughness);
    // Away from the eye in the plane of the surface, as long as the sine.
    let aside = (along * receiver.normal - view) * sh$N_gloss_tilt(told, facing);
    let up = sqrt(max(1.0 - dot(aside, aside), 0.0));
    let alpha = max(roughness * roughness, SMOOTHEST);
    let energy = sh$N_gloss_energy(roughness, facing).x;
    return Gloss(view, told, up * receiver.normal + aside, facing, alpha * alpha, 1.0 / energy);
}

// The lobe in which a receiver reflects light, as an SH vector.
fn lobe_of(receiver: Receiver, gloss: Gloss) -> array<f32, $C> {
    if (!GLOSS) {
        return sh$N_cosine(receiver.normal);
    }
    var lobe = sh$N_basis(gloss.axis);
    let bands = sh$N_gloss_lobe(gloss.told, gloss.facing);
    for (var l = 0u; l < $Nu; l += 1u) {
        for (var i = l * l; i < (l + 1u) * (l + 1u); i += 1u) {
            lobe[i] *= bands[l];
        }
    }
    return lobe;
}

// What a receiver reflects of a light of which it would reflect `open` diffusely at albedo 1, by the cosines of the light's
// direction with the normal and with the view, and what its size adds to the square of alpha, over h . v.
fn reflects(open: f32, gloss: Gloss, towards: f32, along: f32, size: f32) -> f32 {
    if (!GLOSS) {
        return open;
    }
    let height = max(towards, 0.0);
    // (n . h)^2, of h = l + v, whose length squared is 2 + 2 l . v.
    let both = height + gloss.facing;
    let two = max(2.0 + 2.0 * along, NEAREST);
    let half = min(both * both / two, 1.0);
    // h . v is half of that length.
    let wide = min(size * 2.0 / sqrt(two) + gloss.square, 1.0);
    let fall = half * (wide - 1.0) + 1.0;
    let rest = 1.0 - gloss.square;
    let before = sqrt(rest * gloss.facing * gloss.facing + gloss.square);
    let after = sqrt(rest * height * height + gloss.square);
    let shade = 2.0 * (height * before + gloss.facing * after);
    return open * wide * gloss.whole / (fall * fall * max(shade, NEAREST));
}
