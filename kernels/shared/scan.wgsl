// Sums over a workgroup, the same in every run.

#import shared/invocation
#import constants

var<workgroup> sums: array<u32, WORKGROUP>;

// The sum of the values of this invocation and all before it. `sums` holds those of all; its last is the total.
fn sum_up_to(lane: u32, value: u32) -> u32 {
    // Those of an earlier call may still be read.
    workgroupBarrier();
    sums[lane] = value;
    workgroupBarrier();
    for (var reach = 1u; reach < WORKGROUP; reach *= 2u) {
        var before = 0u;
        if (lane >= reach) {
            before = sums[lane - reach];
        }
        workgroupBarrier();
        sums[lane] += before;
        workgroupBarrier();
    }
    return sums[lane];
}
