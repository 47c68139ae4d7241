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

// What is not a number (a series that ran over its range) becomes 0; it is told by its bits, because a shader's
// compiler may assume that comparisons never meet one.
fn number(value: vec3f) -> vec3f {
    return select(vec3f(0.0), value, is_number(value));
}

fn is_number(value: vec3f) -> vec3<bool> {
    return (bitcast<vec3u>(value) & vec3u(0x7fffffffu)) <= vec3u(0x7f800000u);
}

// Shadowed radiance held within [0, unshadowed], 0 for what is not a number.
fn bounded(shadowed: vec3f, unshadowed: vec3f) -> vec3f {
    let most = max(unshadowed, vec3f(0.0));
    return select(vec3f(0.0), clamp(shadowed, vec3f(0.0), most), is_number(shadowed));
}
