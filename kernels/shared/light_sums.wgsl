// Visibility of lights as what a sphere takes away from what is left to be seen behind all nearer ones (Guerrero et al.
// 2008, equation 23). Spheres in the order of their powers fall into runs; what has been summed up for a run serves all
// that follow, and only within a run pairs are looked at. Twin of sh_cpu's `light_sums`.

#import shared/records
#import shared/scan
#import shared/lit
#import shared/gloss
#import shared/cut
#import shared/blocker
#import shared/light_order
#import shared/light_sent
#import constants
#import library

// What each band of a sphere's log visibility is multiplied with.
var<workgroup> ratios: array<array<f32, $A>, ROOM>;

// The first sphere, in the order of powers, whose place before this one does not hold for all receivers.
var<workgroup> unsettled: array<u32, ROOM>;

// Where a run ends that begins with a sphere.
var<workgroup> runs: array<u32, ROOM>;

// Whether bodies hide each other as a whole instead of sphere by sphere; sh_scene::Blocking.
override BY_BODIES: bool = false;

fn ball(at: u32) -> vec4f {
    return vec4f(nodes[at].center, nodes[at].radius);
}

// Sorts the listed nodes by power, weighs them, and finds where runs begin.
fn order_cut(count: u32, bounds: vec4f, lane: u32) {
    for (var k = lane; k < count; k += WORKGROUP) {
        keep(k, names[k], ball(names[k]), bounds.xyz);
    }
    workgroupBarrier();
    sort_kept(count, bounds.xyz, lane);
    for (var k = lane; k < count; k += WORKGROUP) {
        ratios[k] = weighted(names[k], bounds).weights;
        gains[k] = gain(names[k], nodes[names[k]].radius, bounds.xyz);
    }
    workgroupBarrier();
    for (var k = lane; k < count; k += WORKGROUP) {
        let far = met(k);
        var first = 0u;
        while (first < k && is_behind(far, met(first), bounds)) {
            first += 1u;
        }
        unsettled[k] = first;
    }
    workgroupBarrier();
    for (var k = lane; k < count; k += WORKGROUP) {
        runs[k] = run_end(k, count);
    }
    workgroupBarrier();
}

// Whether all that `near` covers is hidden of `far`, and nothing the other way, from all receivers of the cluster.
fn is_behind(far: Met, near: Met, bounds: vec4f) -> bool {
    if (is_joint(far, near, distance(far.center, near.center))) {
        return false;
    }
    if (BY_BODIES) {
        return body_comes_first(near, far, bounds.xyz);
    }
    return is_settled(near, far, bounds);
}

// How much of what `hider` covers it hides of `hidden` from a place, 0 to 1; `middle` is that of the cluster. What
// intersecting spheres of one body hide of each other is dark in their samples.
fn hides(hidden: Met, hider: Met, place: vec3f, middle: vec3f) -> f32 {
    if (is_joint(hidden, hider, distance(hidden.center, hider.center))) {
        return 0.0;
    }
    if (BY_BODIES) {
        return f32(body_comes_first(hider, hidden, middle));
    }
    return share(hidden, hider, place);
}

// The order of whole bodies; within a body that of its spheres.
fn body_comes_first(a: Met, b: Met, middle: vec3f) -> bool {
    let own = members[a.node];
    let other = members[b.node];
    if (own.x == NO_BODY || other.x == NO_BODY || own.x == other.x) {
        return comes_first(a, b);
    }
    let first = power(middle, nodes[own.y].center, nodes[own.y].radius);
    let second = power(middle, nodes[other.y].center, nodes[other.y].radius);
    return first < second || (first == second && own.x < other.x);
}

// Where the run ends that begins at `start`: before the first sphere that, with all that follow, comes after the whole
// of it for all receivers.
fn run_end(start: u32, count: u32) -> u32 {
    var end = start + 1u;
    for (var k = start + 1u; k < count; k += 1u) {
        if (unsettled[k] < end) {
            end = k + 1u;
        }
    }
    return end;
}

// All spheres in workgroup memory, one run after another.
fn sums_in_memory(receiver: Receiver, gloss: Gloss, count: u32, middle: vec3f) -> vec3f {
    let lobe = lobe_of(receiver, gloss);
    var sent = vec3f(0.0);
    // The sum over all runs that are done, and what is left to be seen behind it, where somebody needed that already.
    var nearer = array<f32, $C>();
    var left = lobe[0] * ROOT_FOUR_PI;
    var known = true;
    var start = 0u;
    while (start < count) {
        let end = runs[start];
        let alone = end == start + 1u;
        var together = nearer;
        for (var i = start; i < end; i += 1u) {
            let seen = seen_by(receiver, i);
            if (seen.sine <= 0.0) {
                continue;
            }
            together = with_sphere(together, seen, ratios[i], 1.0);
            if (!shines(names[i])) {
                known = false;
                continue;
            }
            var before = nearer;
            if (!alone) {
                for (var j = start; j < end; j += 1u) {
                    if (j != i) {
                        let part = hides(met(i), met(j), receiver.position, middle);
                        let other = seen_by(receiver, j);
                        before = with_sphere(before, other, ratios[j], part);
                    }
                }
            }
            if (!alone || !known) {
                left = visible(before, lobe);
            }
            let behind = visible(with_sphere(before, seen, ratios[i], 1.0), lobe);
            sent += max(left - behind, 0.0) * gains[i] * mean_sent(names[i], seen);
            left = behind;
            known = alone;
        }
        nearer = together;
        start = end;
    }
    return sent;
}

// Every sphere with all others, a chunk of the tree at a time.
fn sums_of_all(receiver: Receiver, gloss: Gloss, bounds: vec4f, lane: u32) -> vec3f {
    let covered = is_lit(receiver);
    let lobe = lobe_of(receiver, gloss);
    var sent = vec3f(0.0);
    for (var chunk = 0u; chunk < lighting.nodes; chunk += WORKGROUP) {
        let senders = take_spheres(chunk, 0u, bounds, lane);
        for (var i = 0u; i < senders; i += 1u) {
            let node = workgroupUniformLoad(&names[i]);
            if (!shines(node)) {
                continue;
            }
            let seen = seen_by(receiver, i);
            let counts = covered && seen.sine > 0.0;
            var before = array<f32, $C>();
            for (var others = 0u; others < lighting.nodes; others += WORKGROUP) {
                let count = take_spheres(others, HALF, bounds, lane);
                for (var j = HALF; j < HALF + count; j += 1u) {
                    if (counts && names[j] != node) {
                        let part = hides(met(i), met(j), receiver.position, bounds.xyz);
                        let other = seen_by(receiver, j);
                        before = with_sphere(before, other, ratios[j], part);
                    }
                }
            }
            if (counts) {
                let left = visible(before, lobe);
                let behind = visible(with_sphere(before, seen, ratios[i], 1.0), lobe);
                sent += max(left - behind, 0.0) * gains[i] * mean_sent(node, seen);
            }
        }
    }
    return sent;
}

// Puts those of a chunk of nodes that are in the cut into workgroup memory, from `at` on, and tells how many there are.
fn take_spheres(chunk: u32, at: u32, bounds: vec4f, lane: u32) -> u32 {
    let taken = u32(in_cut(chunk + lane, bounds));
    // Waits for those who read what was there before.
    let place = at + sum_up_to(lane, taken) - taken;
    if (taken != 0u) {
        keep(place, chunk + lane, ball(chunk + lane), bounds.xyz);
        ratios[place] = weighted(chunk + lane, bounds).weights;
        if (at == 0u) {
            gains[place] = gain(chunk + lane, balls[place].w, bounds.xyz);
        }
    }
    return workgroupUniformLoad(&sums[WORKGROUP - 1u]);
}

// A sum of log visibilities, and `share` of that of one more sphere.
fn with_sphere(sum: array<f32, $C>, seen: Blocker, weights: array<f32, $N>, share: f32) -> array<f32, $C> {
    if (seen.sine <= 0.0 || share <= 0.0) {
        return sum;
    }
    var counted = weights;
    for (var l = 0u; l < $Nu; l += 1u) {
        counted[l] *= share;
    }
    return add_blocker(sum, seen, counted);
}

// exp(f) . H: what a surface sees of a white sky.
fn visible(sum: array<f32, $C>, lobe: array<f32, $C>) -> f32 {
    return sh$N_dot(sh$N_exp_saturating(sh$N_accumulated_log(sum)), lobe);
}
