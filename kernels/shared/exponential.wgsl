#import library

// The SH exponential of a log visibility, by PS*-2 (Ren et al. 2006, equations 20 to 22): isolate the
// constant band, halve p times, take the factored series of degree 2, square p times. p is the smallest
// with |f^| / 2^p < 1/4; 132 halvings bring any finite number there, and more never happen.
//
// The constant band's factor exp(f0 / sqrt(4 pi)) is spread over the squarings, 2^-p of it before the
// first: applied afterwards, large f^ would overflow before a small factor could bring it back.
fn exponential(f: array<f32, $C>) -> array<f32, $C> {
    var rest = f;
    rest[0] = 0.0;
    var norm = sqrt(sh$N_dot(rest, rest));
    var scale = 1.0;
    var halvings = 0u;
    while (norm >= 0.25 && halvings < 132u) {
        norm *= 0.5;
        scale *= 0.5;
        halvings += 1u;
    }
    for (var i = 1u; i < $Cu; i += 1u) {
        rest[i] *= scale;
    }
    let constant = exp(f[0] * scale * 0.28209479177387814);
    let squared = sh$N_square(rest);
    var g: array<f32, $C>;
    for (var i = 0u; i < $Cu; i += 1u) {
        g[i] = constant * (rest[i] + 0.5 * squared[i]);
    }
    g[0] += constant * 3.5449077018110318;
    for (var i = 0u; i < halvings; i += 1u) {
        g = sh$N_square(g);
    }
    return g;
}
