// The blockers that a cluster of receivers needs (Ren et al. 2006, section 6.3). Twin of sh_cpu's `cut`. Which logarithm is
// summed says the pass, by importing shared/log_shading or shared/log_saturating.

#import shared/records
#import shared/blocker
#import constants
#import library

// A blocker of a cut, and what each band of its log visibility is multiplied with (equation 37).
struct Weighted {
    center: vec3f,
    radius: f32,
    weights: array<f32, $A>,
    // Its body; 0: none or several.
    object: u32,
}

// Whether a node is small enough, seen from every receiver of the cluster, to stand for its leaves (equation 36).
fn is_small(node: Node, bounds: vec4f) -> bool {
    return node.radius < lighting.sin_max * (distance(node.center, bounds.xyz) - bounds.w);
}

// Whether the tree's cut holds a node. Whatever is below a small node is small as well, so that nobody has to walk
// down from the root: the node above must not be small.
fn in_cut(at: u32, bounds: vec4f) -> bool {
    if (at >= lighting.nodes) {
        return false;
    }
    let node = nodes[at];
    if (node.skip > at + 1u && !is_small(node, bounds)) {
        return false;
    }
    return node.parent == at || !is_small(nodes[node.parent], bounds);
}

// Whether a node of a cut is too small to matter to any receiver of the cluster: sh_scene::Forest::is_negligible. Where
// only leaves count none is, because sin_max is 0.
fn is_negligible(at: u32, bounds: vec4f) -> bool {
    let node = nodes[at];
    let distance = distance(node.center, bounds.xyz) - bounds.w;
    let share = f32(node.skip - at) * NEGLIGIBLE * sign(lighting.sin_max);
    return distance > node.radius && node.area * f32(lighting.nodes) <= share * distance * distance;
}

// A node of the cut as the receivers add it up. A leaf stands for itself.
fn weighted(at: u32, bounds: vec4f) -> Weighted {
    let node = nodes[at];
    var result = Weighted(node.center, node.radius, array<f32, $A>(), node.object);
    if (node.skip > at + 1u) {
        result.weights = ratio(at, bounds.xyz);
    } else {
        for (var l = 0u; l < $Au; l += 1u) {
            result.weights[l] = weight_of(node);
        }
    }
    return result;
}

// The ratio vector of a node, seen from a point. Both log visibilities are sums of zonal functions about directions,
// whose dot product over a band is P_l of the cosine between these. A group of leaves that is small enough counts as
// one cap of their joint cross-section.
fn ratio(at: u32, place: vec3f) -> array<f32, $A> {
    let whole = nodes[at];
    let middle = seen(whole.center - place, whole.radius);
    var sum = array<f32, $A>();
    var below = at + 1u;
    while (below < whole.skip) {
        let node = nodes[below];
        let towards = node.center - place;
        let nearest = lighting.sin_min * lighting.sin_min * dot(towards, towards);
        if (node.skip <= below + 1u || node.radius * node.radius < nearest) {
            let cap = seen(towards, min(sqrt(node.area), node.radius));
            let log = log_of_cap(cap.sine, cap.cosine);
            let weight = weight_of(node);
            let x = clamp(dot(cap.direction, middle.direction), -1.0, 1.0);
            var before = 0.0;
            var now = 1.0;
            for (var l = 0u; l < $Au; l += 1u) {
                sum[l] += weight * log[l] * now;
                let next = (f32(2u * l + 1u) * x * now - f32(l) * before) / f32(l + 1u);
                before = now;
                now = next;
            }
            below = max(node.skip, below + 1u);
        } else {
            below += 1u;
        }
    }
    let log = log_of_cap(middle.sine, middle.cosine);
    for (var l = 0u; l < $Au; l += 1u) {
        sum[l] /= log[l];
    }
    return sum;
}
