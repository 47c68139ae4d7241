#import shared/records
#import library

// The environment's radiance that a surface of albedo 1 reflects, given the transfer from the environment
// to it: H(N) for an unshadowed surface, H(N) times visibility for a shadowed one.
fn reflected(transfer: array<f32, $C>) -> vec3f {
    var sum = vec3f(0.0);
    for (var i = 0u; i < $Cu; i += 1u) {
        sum += transfer[i] * lighting.coefficients[i].rgb;
    }
    return sum;
}

// Shadowed radiance held within [0, unshadowed]. What is not a number (a series that ran over its range)
// fails the comparison and becomes 0.
fn bounded(shadowed: vec3f, unshadowed: vec3f) -> vec3f {
    let most = max(unshadowed, vec3f(0.0));
    return select(vec3f(0.0), min(shadowed, most), shadowed > vec3f(0.0));
}
