// Radiance from analytic lights (Ren et al. 2006, section 7). Twin of sh_cpu's `emitters`.

#import shared/records
#import shared/light
#import library

const ROOT_PI: f32 = 1.7724538509055160;

// Below this distance a receiver is taken to be at a light's centre.
const NEAREST: f32 = 1e-30;

// Whether there may be analytic lights: without them nothing of this is compiled.
override LAMPS: bool = true;

// An analytic light of radiance 1 as an SH vector, seen from a position.
fn emitter_light(at: u32, position: vec3f) -> array<f32, $C> {
    let towards = emitters[at].center - emitters[at].local * position;
    let inverse = 1.0 / max(length(towards), NEAREST);
    let sine = min(emitters[at].radius * inverse, 1.0);
    let cosine = sqrt(max(1.0 - sine * sine, 0.0));
    // What a cap hides of the sky is what it shows of a light: 1 - visibility. The mean of that is
    // sqrt(pi) (1 - cosine), in a form that does not cancel for small lights.
    var zonal = sh$N_cap_visibility(cosine, sine);
    zonal[0] = -sine * sine / (1.0 + cosine) * ROOT_PI;
    for (var l = 0u; l < $Nu; l += 1u) {
        zonal[l] *= -emitters[at].gains[l / 4u][l % 4u];
    }
    return sh$N_zonal(zonal, towards * inverse);
}

// What all lights together give a surface of albedo 1, each held within [0, unshadowed], given the transfer of
// shadowed and of unshadowed light.
fn emitted(transfer: array<f32, $C>, lobe: array<f32, $C>, position: vec3f) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; LAMPS && i < lighting.emitters; i += 1u) {
        let light = emitter_light(i, position);
        let open = sh$N_dot(light, lobe);
        // Nothing comes from below the horizon.
        if (open > 0.0) {
            let lit = bounded(vec3f(sh$N_dot(light, transfer)), vec3f(open));
            sum += lit * emitters[i].radiance;
        }
    }
    return sum;
}
