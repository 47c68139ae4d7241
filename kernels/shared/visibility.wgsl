// Log visibilities summed over a cluster's cut, in the order of accumulation (Ren et al. 2006, section 8). Twin of sh_cpu's
// `cut` and `shadow`. Which logarithm says the pass, by importing shared/log_shading or shared/log_saturating.

#import shared/records
#import shared/invocation
#import shared/lit
#import shared/scan
#import shared/cut
#import shared/blocker
#import shared/emitted
#import shared/behind
#import constants
#import library

// Nodes that an invocation looks at between two barriers.
const EACH: u32 = 4u;

const CHUNK: u32 = EACH * WORKGROUP;

// Those of a chunk of nodes that are in the cut.
var<workgroup> cut: array<Weighted, CHUNK>;

// A receiver's log visibilities.
struct LogVisibility {
    sum: array<f32, $B>,
    // Bit i: lamp i may have a blocker behind it, and needs a sum of its own. The same for all of the workgroup.
    lamps: u32,
}

// The sum of a receiver's log visibilities, as the sky has it or a lamp. All invocations of the workgroup have to call this,
// with the same bounds and lamp.
fn log_visibility(receiver: Receiver, bounds: vec4f, lane: u32, lamp: u32) -> LogVisibility {
    let covered = is_lit(receiver);
    let of_lamp = LAMPS && lamp != NO_LAMP;
    var sum = array<f32, $B>();
    var behind = 0u;
    for (var chunk = 0u; chunk < lighting.nodes; chunk += CHUNK) {
        let own = chunk + lane * EACH;
        var taken = 0u;
        for (var i = 0u; i < EACH; i += 1u) {
            var counts = false;
            if (of_lamp) {
                counts = counts_for_lamp(lamp, own + i, bounds);
            } else {
                counts = in_cut(own + i, bounds) && !is_negligible(own + i, bounds);
                if (LAMPS && counts) {
                    behind |= lamps_behind(own + i, bounds);
                }
            }
            taken |= u32(counts) << i;
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
            let towards = cut[i].center - receiver.position;
            let own = is_own(receiver, cut[i].object);
            let blocker = above(towards, receiver.normal, cut[i].radius, own);
            if (covered && blocker.sine > 0.0) {
                var weights = cut[i].weights;
                if (of_lamp) {
                    let part = lamp_part(lamp, cut[i].center, cut[i].radius, blocker, receiver.position);
                    for (var l = 0u; l < $Au; l += 1u) {
                        weights[l] *= part;
                    }
                }
                sum = add_blocker(sum, blocker, weights);
            }
        }
        workgroupBarrier();
    }
    var lamps = 0u;
    if (LAMPS && !of_lamp) {
        lamps = gather_lamps(behind, lane);
    }
    return LogVisibility(sum, lamps);
}
