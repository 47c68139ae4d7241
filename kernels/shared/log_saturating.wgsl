// How blockers are summed up where their visibility itself is asked for: by the logarithm that goes with
// sh$A_exp_saturating, each sphere as it is.

#import shared/records
#import library

fn log_of_cap(sine: f32, cosine: f32) -> array<f32, $A> {
    return sh$A_cap_log_saturating(sine, cosine);
}

fn add_blocker(sum: array<f32, $B>, seen: Blocker, weights: array<f32, $A>) -> array<f32, $B> {
    return sh$A_accumulate_blocker_saturating(sum, seen.sine, seen.cosine, seen.direction, weights);
}

fn weight_of(node: Node) -> f32 {
    return 1.0;
}
