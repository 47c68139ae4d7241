// Coefficients as half-precision floats, two a word.

#import constants

// `f` as half-precision floats, two in each word, the one of lower index in the lower half: in memory they lie as an
// array of $C f16 does. An odd one at the end is followed by 0. What is beyond 65504 is brought there.
//
// Rounding errs by at most 2^-11 of a coefficient, and by 2^-25 below 2^-14.
fn sh$N_pack_half(f: array<f32, $C>) -> array<u32, ($C + 1) / 2> {
    var words = array<u32, ($C + 1) / 2>();
    for (var i = 0u; i < $Cu; i += 2u) {
        let second = select(0.0, f[min(i + 1u, $Cu - 1u)], i + 1u < $Cu);
        words[i >> 1u] = pack2x16float(clamp(vec2<f32>(f[i], second), vec2<f32>(-HALF_MAX), vec2<f32>(HALF_MAX)));
    }
    return words;
}

// The vector that `pack_half` has packed.
fn sh$N_unpack_half(words: array<u32, ($C + 1) / 2>) -> array<f32, $C> {
    var f = array<f32, $C>();
    for (var i = 0u; i < $Cu; i += 1u) {
        let pair = unpack2x16float(words[i >> 1u]);
        f[i] = select(pair.x, pair.y, (i & 1u) == 1u);
    }
    return f;
}
