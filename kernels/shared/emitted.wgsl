// Radiance from analytic lights (Ren et al. 2006, section 7; Guerrero et al. 2008, section 7.3). Twin of sh_cpu's
// `emitters`.

#import shared/records
#import shared/light
#import shared/gloss
#import constants
#import library

const ROOT_PI: f32 = 0.5 * ROOT_FOUR_PI;

// Whether there may be analytic lights: without them nothing of this is compiled.
override LAMPS: bool = true;

// Whether some may be brighter on one side than on another.
override DISTRIBUTIONS: bool = true;

// An analytic light as a position sees it.
struct Shown {
    sine: f32,
    cosine: f32,
    direction: vec3f,
}

fn shown(at: u32, position: vec3f) -> Shown {
    let towards = emitters[at].center - emitters[at].local * position;
    let inverse = 1.0 / max(length(towards), NEAREST);
    let sine = min(emitters[at].radius * inverse, 1.0);
    return Shown(sine, sqrt(max(1.0 - sine * sine, 0.0)), towards * inverse);
}

// An analytic light of radiance 1 as an SH vector.
fn emitter_light(at: u32, seen: Shown) -> array<f32, $C> {
    // What a cap hides of the sky is what it shows of a light: 1 - visibility. The mean of that is
    // sqrt(pi) (1 - cosine), in a form that does not cancel for small lights.
    var zonal = sh$N_cap_visibility(seen.cosine, seen.sine);
    zonal[0] = -seen.sine * seen.sine / (1.0 + seen.cosine) * ROOT_PI;
    for (var l = 0u; l < $Nu; l += 1u) {
        zonal[l] *= -emitters[at].gains[l];
    }
    return sh$N_zonal(zonal, seen.direction);
}

// The mean radiance of what is seen of it.
fn emitter_radiance(at: u32, seen: Shown) -> vec3f {
    var result = emitters[at].radiance;
    if (DISTRIBUTIONS && emitters[at].order > 0u) {
        let weights = sh$N_ball_average(seen.sine, seen.cosine, -seen.direction);
        var mean = vec3f(0.0);
        for (var i = 0u; i < $Cu; i += 1u) {
            mean += weights[i] * emitters[at].distribution[i].rgb;
        }
        result *= max(mean, vec3f(0.0));
    }
    return result;
}

// Which share a light of radiance 1 is of an even sky's, weighted by the cosine: what of its cap is above the horizon
// (sh_core::seen).
fn share_above(seen: Shown, normal: vec3f) -> f32 {
    let facing = dot(normal, seen.direction);
    if (facing > seen.sine) {
        return seen.sine * seen.sine * facing;
    }
    // A sphere of this sine at the distance 1, and the one that touches the horizon in its place.
    let over = facing / max(seen.sine, NEAREST);
    let counted = seen.sine * sh$N_horizon_radius(over, seen.sine * seen.sine);
    let along = max(1.0 - facing * facing, 0.0);
    let part = counted / max(sqrt(along + counted * counted), NEAREST);
    return part * part * part;
}

// What lights give a surface of albedo 1: what each gives in the open, times the share that blockers leave of it, which the
// transfers of shadowed and of unshadowed light tell. Those from `first` to before `end`, without those whose bit is set.
fn emitted(
    transfer: array<f32, $C>,
    lobe: array<f32, $C>,
    receiver: Receiver,
    gloss: Gloss,
    first: u32,
    end: u32,
    without: u32,
) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = first; LAMPS && i < end; i += 1u) {
        if (i < MOST_LAMPS && (without >> i & 1u) != 0u) {
            continue;
        }
        let seen = shown(i, receiver.position);
        let share = share_above(seen, receiver.normal);
        // Nothing comes from below the horizon.
        if (share > 0.0) {
            let light = emitter_light(i, seen);
            let open = sh$N_dot(light, lobe);
            if (open > 0.0) {
                let lit = bounded(vec3f(sh$N_dot(light, transfer)), vec3f(open));
                let size = 0.25 * seen.sine * seen.sine;
                let along = dot(seen.direction, gloss.view);
                let towards = dot(seen.direction, receiver.normal);
                let counted = reflects(share, gloss, towards, along, size);
                sum += counted * (lit / open) * emitter_radiance(i, seen);
            }
        }
    }
    return sum;
}

// The same without blockers.
fn unshadowed_lamps(lobe: array<f32, $C>, receiver: Receiver, gloss: Gloss) -> vec3f {
    return emitted(lobe, lobe, receiver, gloss, 0u, lighting.emitters, 0u);
}
