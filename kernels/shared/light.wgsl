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
// becomes 0; it is told by its bits, because a shader's compiler may assume that comparisons never meet one.
fn bounded(shadowed: vec3f, unshadowed: vec3f) -> vec3f {
    let is_number = (bitcast<vec3u>(shadowed) & vec3u(0x7fffffffu)) <= vec3u(0x7f800000u);
    let most = max(unshadowed, vec3f(0.0));
    return select(vec3f(0.0), clamp(shadowed, vec3f(0.0), most), is_number);
}
