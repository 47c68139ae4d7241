// Visibility of lights as discs in the sky. Twin of sh_cpu's `light_discs`.

#import shared/records
#import shared/scan
#import shared/lit
#import shared/gloss
#import shared/blocker
#import shared/light_order
#import shared/light_sent
#import constants
#import library

// Words of a mask with a bit for each sphere.
const WORDS: u32 = ROOM / 32u;

// Which spheres may cover a part of each sphere's disc somewhere in the cluster.
var<workgroup> hiders: array<array<u32, WORDS>, ROOM>;

// A node as it counts: one that stands for several is as large as they are together.
fn disc_ball(at: u32) -> vec4f {
    let node = nodes[at];
    return vec4f(node.center, min(node.radius, sqrt(node.area)));
}

// Whether `other` may cover a part of `own`'s disc for a receiver of the cluster: with radii larger by that of the
// cluster, seen from its middle, their discs meet, and it is not behind for all.
fn may_hide(own: Met, other: Met, bounds: vec4f) -> bool {
    let to = own.center - bounds.xyz;
    let towards = other.center - bounds.xyz;
    let away = length(to);
    let distance = length(towards);
    let sine = (own.radius + bounds.w) / away;
    let s = (other.radius + bounds.w) / distance;
    // A cluster that reaches into a sphere may see it anywhere.
    if (sine < 1.0 && s < 1.0) {
        let both = sqrt(max(1.0 - sine * sine, 0.0)) * sqrt(max(1.0 - s * s, 0.0)) - sine * s;
        if (dot(to / away, towards / distance) < both) {
            return false;
        }
    }
    // A sphere without samples lies inside of its body, and is not seen.
    if (!shines(other.node) && is_joint(own, other, length(own.center - other.center))) {
        return false;
    }
    return !(comes_first(own, other) && is_settled(own, other, bounds));
}

// Puts the listed nodes into workgroup memory, sorted by power, and finds what may hide each.
fn find_hiders(count: u32, bounds: vec4f, lane: u32) {
    for (var k = lane; k < count; k += WORKGROUP) {
        keep(k, names[k], disc_ball(names[k]), bounds.xyz);
    }
    workgroupBarrier();
    sort_kept(count, bounds.xyz, lane);
    for (var k = lane; k < count; k += WORKGROUP) {
        gains[k] = gain(names[k], balls[k].w, bounds.xyz);
    }
    for (var k = lane; k < count * WORDS; k += WORKGROUP) {
        let own = k / WORDS;
        let word = k % WORDS;
        var mask = 0u;
        for (var bit = 0u; bit < min(count - min(word * 32u, count), 32u); bit += 1u) {
            let other = word * 32u + bit;
            mask |= u32(other != own && may_hide(met(own), met(other), bounds)) << bit;
        }
        hiders[own][word] = mask;
    }
    workgroupBarrier();
}

// All spheres in workgroup memory, from the nearest on.
fn discs_in_memory(receiver: Receiver, gloss: Gloss, count: u32) -> vec3f {
    var sent = vec3f(0.0);
    // What nearer ones leave of each.
    var left: array<f32, ROOM>;
    for (var i = 0u; i < count; i += 1u) {
        left[i] = 1.0;
        let seen = seen_by(receiver, i);
        let open = open_disc(seen, receiver.normal, gloss);
        if (open <= 0.0) {
            continue;
        }
        var rest = 1.0;
        for (var word = 0u; word < WORDS; word += 1u) {
            var mask = hiders[i][word];
            while (mask != 0u) {
                let j = word * 32u + countTrailingZeros(mask);
                mask &= mask - 1u;
                var part = 1.0;
                if (j < i) {
                    part = left[j];
                }
                rest -= hidden_by(receiver, i, seen, j, part);
            }
        }
        left[i] = max(rest, 0.0);
        if (shines(names[i])) {
            sent += open * left[i] * gains[i] * mean_sent(names[i], seen);
        }
    }
    return sent;
}

// Every sphere with all others, a chunk of the tree at a time.
fn discs_of_all(receiver: Receiver, gloss: Gloss, bounds: vec4f, lane: u32) -> vec3f {
    let covered = is_lit(receiver);
    var sent = vec3f(0.0);
    for (var chunk = 0u; chunk < lighting.nodes; chunk += WORKGROUP) {
        let senders = take_discs(chunk, 0u, bounds, lane);
        for (var i = 0u; i < senders; i += 1u) {
            let node = workgroupUniformLoad(&names[i]);
            if (!shines(node)) {
                continue;
            }
            let seen = seen_by(receiver, i);
            var visible = select(0.0, open_disc(seen, receiver.normal, gloss), covered);
            for (var others = 0u; others < lighting.nodes; others += WORKGROUP) {
                let count = take_discs(others, HALF, bounds, lane);
                for (var j = HALF; j < HALF + count; j += 1u) {
                    if (visible > 0.0 && names[j] != node && may_hide(met(i), met(j), bounds)) {
                        visible -= visible * hidden_by(receiver, i, seen, j, 1.0);
                    }
                }
            }
            if (visible > 0.0) {
                sent += visible * gains[i] * mean_sent(node, seen);
            }
        }
    }
    return sent;
}

// Puts those of a chunk of nodes that are in the cut into workgroup memory, from `at` on, and tells how many there are.
fn take_discs(chunk: u32, at: u32, bounds: vec4f, lane: u32) -> u32 {
    let taken = u32(in_cut(chunk + lane, bounds));
    // Waits for those who read what was there before.
    let place = at + sum_up_to(lane, taken) - taken;
    if (taken != 0u) {
        keep(place, chunk + lane, disc_ball(chunk + lane), bounds.xyz);
        if (at == 0u) {
            gains[place] = gain(chunk + lane, balls[place].w, bounds.xyz);
        }
    }
    return workgroupUniformLoad(&sums[WORKGROUP - 1u]);
}

// The cosine over a disc, of that over the sky; or the lobe in which light is mirrored.
fn open_disc(seen: Blocker, normal: vec3f, gloss: Gloss) -> f32 {
    let square = seen.sine * seen.sine;
    let towards = dot(seen.direction, normal);
    return reflects(square * max(towards, 0.0), gloss, towards, dot(seen.direction, gloss.view), 0.25 * square);
}

// The part of sphere i's disc that sphere j hides, of which so much is seen, if it comes first.
fn hidden_by(receiver: Receiver, i: u32, own: Blocker, j: u32, left: f32) -> f32 {
    let other = seen_by(receiver, j);
    let a = counted_cosine(own);
    let b = counted_cosine(other);
    let towards = dot(own.direction, other.direction);
    // cos (a + b) of both radii: beyond it the discs are apart.
    let reach = a * b - sqrt(max(1.0 - a * a, 0.0)) * sqrt(max(1.0 - b * b, 0.0));
    if (towards <= reach - ANGLES_ERR) {
        return 0.0;
    }
    let covered = sh$N_disc_covered(angle(a), angle(b), angle(towards));
    let part = share(met(i), met(j), receiver.position);
    let ahead = max(2.0 * part - 1.0, 0.0);
    return covered * part * (1.0 + (left - 1.0) * ahead);
}

// What does not count has a sine of 0, and any cosine.
fn counted_cosine(seen: Blocker) -> f32 {
    return select(1.0, seen.cosine, seen.sine > 0.0);
}

// The angle of a cosine, 0 to pi, by Abramowitz and Stegun 1964, 4.4.45: it errs by at most 6.8e-5.
fn angle(cosine: f32) -> f32 {
    let x = min(abs(cosine), 1.0);
    let p = ((x * ANGLE_CUBIC + ANGLE_SQUARE) * x + ANGLE_LINEAR) * x + ANGLE_CONSTANT;
    let acute = sqrt(1.0 - x) * p;
    return select(acute, 3.14159265 - acute, cosine < 0.0);
}
