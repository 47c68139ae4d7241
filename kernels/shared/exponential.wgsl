// The SH exponentials that are made of SH products (Ren et al. 2006, section 4). Twin of sh_core::exp. For the
// bounded exponential of the shadow pass see sh$N_exp_saturating in the library.
//
// All but the plain series isolate DC (equation 20). PS* and HYB halve p times, approximate, square p times
// (equation 21); p is the smallest with |f^| / 2^p < 1/4, without limit: 132 halvings bring any finite number
// there, and no more than that ever happen.
//
// The DC factor exp(f0 / sqrt(4 pi)) is spread over the squarings, its 2^p-th root before the first. Applied
// afterwards, exp(f^) of many blockers would overflow before that small factor could bring it back.

#import constants
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
    result.root = exp(f[0] * scale / ROOT_FOUR_PI);
    return result;
}

fn squared(g: array<f32, $C>, times: u32) -> array<f32, $C> {
    var result = g;
    for (var i = 0u; i < times; i += 1u) {
        result = sh$N_square(result);
    }
    return result;
}

// sum + weight * term.
fn plus(sum: array<f32, $C>, weight: f32, term: array<f32, $C>) -> array<f32, $C> {
    var result = sum;
    for (var i = 0u; i < $Cu; i += 1u) {
        result[i] += weight * term[i];
    }
    return result;
}

// PS-p: the plain product series up to `degree` (equation 17).
fn sh$N_exp_product_series(f: array<f32, $C>, degree: u32) -> array<f32, $C> {
    var sum = array<f32, $C>();
    sum[0] = ROOT_FOUR_PI;
    var term = sum;
    var factorial = 1.0;
    for (var k = 1u; k <= degree; k += 1u) {
        term = sh$N_product(term, f);
        factorial /= f32(k);
        sum = plus(sum, factorial, term);
    }
    return sum;
}

// PS*-p: the product series up to `degree`, even and odd powers apart (equation 22), scaled and squared.
fn sh$N_exp_ps_star(f: array<f32, $C>, degree: u32) -> array<f32, $C> {
    let parts = halved(f);
    let square = sh$N_square(parts.rest);
    var power = array<f32, $C>();
    power[0] = ROOT_FOUR_PI;
    var even = power;
    var odd = array<f32, $C>();
    var factorial = 1.0;
    for (var k = 0u; k <= degree; k += 2u) {
        if (k > 0u) {
            power = sh$N_product(power, square);
            factorial /= f32(k * (k - 1u));
            even = plus(even, factorial, power);
        }
        if (k < degree) {
            odd = plus(odd, factorial / f32(k + 1u), power);
        }
    }
    var sum = plus(even, 1.0, sh$N_product(parts.rest, odd));
    for (var i = 0u; i < $Cu; i += 1u) {
        sum[i] *= parts.root;
    }
    return squared(sum, parts.halvings);
}

// HYB: the optimal linear a 1 + b f, with a and b fitted as functions of the norm (equations 23 and 24), scaled
// and squared.
fn sh$N_exp_hyb(f: array<f32, $C>) -> array<f32, $C> {
    let parts = halved(f);
    let factors = parts.root * sh$N_optimal_linear(parts.norm);
    var sum = array<f32, $C>();
    sum[0] = factors.x * ROOT_FOUR_PI;
    return squared(plus(sum, factors.y, parts.rest), parts.halvings);
}

// OL: the optimal linear a 1 + b f for any norm, neither scaled nor squared.
fn sh$N_exp_optimal_linear(f: array<f32, $C>) -> array<f32, $C> {
    var rest = f;
    rest[0] = 0.0;
    let factors = exp(f[0] / ROOT_FOUR_PI) * sh$N_optimal_linear_wide(sqrt(sh$N_dot(rest, rest)));
    var sum = array<f32, $C>();
    sum[0] = factors.x * ROOT_FOUR_PI;
    return plus(sum, factors.y, rest);
}
