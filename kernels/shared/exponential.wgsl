// The SH exponential of a log visibility (Ren et al. 2006, section 4): isolate DC (equation 20), halve p
// times, approximate, square p times (equation 21). p is the smallest with |f^| / 2^p < 1/4, without limit:
// 132 halvings bring any finite number there, and no more than that ever happen. Twin of sh_core::exp.
//
// The DC factor exp(f0 / sqrt(4 pi)) is spread over the squarings, its 2^p-th root before the first. Applied
// afterwards, exp(f^) of many blockers would overflow before that small factor could bring it back.

#import library

// f without DC and over 2^p, the norm of that, p, and the root of the DC factor.
struct Halved {
    rest: array<f32, $C>,
    norm: f32,
    halvings: u32,
    root: f32,
}

fn halved(f: array<f32, $C>) -> Halved {
    var result = Halved(f, 0.0, 0u, 1.0);
    result.rest[0] = 0.0;
    result.norm = sqrt(sh$N_dot(result.rest, result.rest));
    var scale = 1.0;
    while (result.norm >= 0.25 && result.halvings < 132u) {
        result.norm *= 0.5;
        scale *= 0.5;
        result.halvings += 1u;
    }
    for (var i = 1u; i < $Cu; i += 1u) {
        result.rest[i] *= scale;
    }
    result.root = exp(f[0] * scale * 0.28209479177387814);
    return result;
}

fn squared(g: array<f32, $C>, times: u32) -> array<f32, $C> {
    var result = g;
    for (var i = 0u; i < times; i += 1u) {
        result = sh$N_square(result);
    }
    return result;
}

// PS*-2: the factored product series of degree 2, 1 + f + f*f / 2.
fn sh$N_exponential_ps_star(f: array<f32, $C>) -> array<f32, $C> {
    let parts = halved(f);
    var g = sh$N_square(parts.rest);
    for (var i = 0u; i < $Cu; i += 1u) {
        g[i] = parts.root * (parts.rest[i] + 0.5 * g[i]);
    }
    g[0] += parts.root * 3.5449077018110318;
    return squared(g, parts.halvings);
}

// HYB: the optimal linear a 1 + b f, with a and b fitted as functions of the norm (equations 23 and 24).
fn sh$N_exponential_hyb(f: array<f32, $C>) -> array<f32, $C> {
    let parts = halved(f);
    let factors = parts.root * sh$N_optimal_linear(parts.norm);
    var g = parts.rest;
    for (var i = 0u; i < $Cu; i += 1u) {
        g[i] *= factors.y;
    }
    g[0] = factors.x * 3.5449077018110318;
    return squared(g, parts.halvings);
}
