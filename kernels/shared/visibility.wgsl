// What blockers leave visible of the sky: log visibilities summed over a cluster's cut, in the order of accumulation,
// and exponentiated once (Ren et al. 2006, section 8). Twin of sh_cpu's `cut` and `shadow`.

#import shared/records
#import shared/invocation
#import shared/scan
#import shared/cut
#import shared/blocker
#import library

// Nodes that an invocation looks at between two barriers.
const EACH: u32 = 4u;

const CHUNK: u32 = 256u;

// Those of a chunk of nodes that are in the cut.
var<workgroup> cut: array<Weighted, CHUNK>;

// The sum of a receiver's log visibilities. All invocations of the workgroup have to call this, with the same bounds.
fn log_visibility(receiver: Receiver, bounds: vec4f, lane: u32) -> array<f32, $B> {
    let covered = receiver.covered != 0u;
    var sum = array<f32, $B>();
    for (var chunk = 0u; chunk < lighting.nodes; chunk += CHUNK) {
        let own = chunk + lane * EACH;
        var taken = 0u;
        for (var i = 0u; i < EACH; i += 1u) {
            taken |= u32(in_cut(own + i, bounds) && !is_negligible(own + i, bounds)) << i;
        }
        var place = sum_up_to(lane, countOneBits(taken)) - countOneBits(taken);
        let found = workgroupUniformLoad(&sums[WORKGROUP - 1u]);
        for (var i = 0u; i < EACH; i += 1u) {
            if ((taken >> i & 1u) != 0u) {
                cut[place] = weighted(own + i, bounds);
                place += 1u;
            }
        }
        workgroupBarrier();
        for (var i = 0u; i < found; i += 1u) {
            let blocker = replace(cut[i].center - receiver.position, receiver.normal, cut[i].radius);
            if (covered && blocker.sine > 0.0) {
                sum = sh$A_accumulate_blocker(
                    sum, blocker.sine, blocker.cosine, blocker.direction, cut[i].weights);
            }
        }
        workgroupBarrier();
    }
    return sum;
}

// Visibility, of which the light's order has the lower bands.
fn visibility_of(sum: array<f32, $B>) -> array<f32, $C> {
    let accumulated = sh$A_exp_saturating(sh$A_accumulated_log(sum));
    var visibility = array<f32, $C>();
    for (var i = 0u; i < $Cu; i += 1u) {
        visibility[i] = accumulated[i];
    }
    return visibility;
}
