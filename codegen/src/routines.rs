//! The table of routines: what each is called, takes, returns and means. Every emitter prints from it.

use crate::basis;
use crate::direct;
use crate::expr::{Graph, Ops, Value};
use crate::fits;
use crate::rings::Rings;
use crate::rotation;
use crate::sampled::{self, Fineness};

/// The orders that routines are generated for.
pub const ORDERS: std::ops::RangeInclusive<usize> = 2..=6;

/// The shape of an argument or a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shape {
    /// One number.
    Scalar,
    /// A unit vector (x, y, z).
    Direction,
    /// A unit quaternion (x, y, z, w).
    Quaternion,
    /// A rotation matrix, row by row.
    Matrix3,
    /// n coefficients, one a band.
    Zonal,
    /// n² coefficients.
    Vector,
    /// Two numbers.
    Pair,
    /// The lower triangle of a symmetric n² × n² matrix, row by row.
    Triangle,
}

impl Shape {
    /// How many numbers.
    pub fn len(self, order: usize) -> usize {
        let c = order * order;
        match self {
            Self::Scalar => 1,
            Self::Pair => 2,
            Self::Direction => 3,
            Self::Quaternion => 4,
            Self::Matrix3 => 9,
            Self::Zonal => order,
            Self::Vector => c,
            Self::Triangle => c * (c + 1) / 2,
        }
    }
}

/// How a routine's graph is made; the arguments' elements come as values.
type Build = fn(&mut Graph, usize, &[Vec<Value>]) -> Vec<Value>;

/// One routine for all orders.
#[derive(Clone, Copy)]
pub struct Routine {
    /// Its name, without the order.
    pub name: &'static str,
    /// One sentence and what else there is to say.
    pub doc: &'static str,
    /// The equation and its source.
    pub source: &'static str,
    /// Rust that shows it at work, after `use sh_core::Routines;`.
    pub example: &'static str,
    /// Names and shapes of the arguments.
    pub arguments: &'static [(&'static str, Shape)],
    /// Shape of the result.
    pub result: Shape,
    build: Build,
}

impl Routine {
    /// The routine's graph for an order, fused and ready to be printed.
    pub fn graph(&self, order: usize) -> Graph {
        let mut g = Graph::default();
        let arguments: Vec<_> = self
            .arguments
            .iter()
            .enumerate()
            .map(|(i, (_, shape))| g.inputs(i, shape.len(order)))
            .collect();
        g.outputs = (self.build)(&mut g, order, &arguments);
        g.fuse();
        g
    }

    /// Operations for an order.
    pub fn ops(&self, order: usize) -> Ops {
        self.graph(order).ops()
    }
}

/// The routine of a name, if there is one.
pub fn find(name: &str) -> Option<&'static Routine> {
    ROUTINES.iter().chain(FORMS).find(|r| r.name == name)
}

/// From this order on the product on rings takes fewer instructions than the one term by term; measured by
/// `cargo bench -p sh-benches --bench forms`.
const RINGS_FROM: usize = 5;

fn product(g: &mut Graph, order: usize, a: &[Value], b: &[Value]) -> Vec<Value> {
    if order >= RINGS_FROM {
        Rings::new(order).product(g, a, b)
    } else {
        direct::product(g, order, a, b)
    }
}

const F: (&str, Shape) = ("f", Shape::Vector);
const G: (&str, Shape) = ("g", Shape::Vector);
const D: (&str, Shape) = ("d", Shape::Direction);
const COS: (&str, Shape) = ("cos", Shape::Scalar);
const SIN: (&str, Shape) = ("sin", Shape::Scalar);

/// All routines that are emitted.
pub const ROUTINES: &[Routine] = &[
    Routine {
        name: "basis",
        doc: "The n² basis functions at the unit vector `d`.\n\n`f(d) = basis(d) · f` evaluates a vector.",
        source: "Ren et al. 2006, eq. 1; real, orthonormal, without Condon–Shortley sign.",
        example: "let y = <[f32; 4]>::basis([0.0, 0.0, 1.0]);\nassert!((y[2] - 0.4886025).abs() < 1e-6);",
        arguments: &[D],
        result: Shape::Vector,
        build: |g, n, a| basis::basis(g, n, &a[0]),
    },
    Routine {
        name: "cosine",
        doc: "The cosine lobe about the unit normal `d`, over π: its dot product with radiance is the radiance that a white diffuse surface reflects.",
        source: "Ren et al. 2006, eq. 9; Ramamoorthi and Hanrahan 2001: A_l/π = 1, 2/3, 1/4, 0, −1/24, 0.",
        example: "// A sky of radiance 1 all around is reflected with radiance 1.\nlet lobe = <[f64; 9]>::cosine([0.0, 1.0, 0.0]);\nassert!((lobe[0] * sh_core::ROOT_FOUR_PI - 1.0).abs() < 1e-12);",
        arguments: &[D],
        result: Shape::Vector,
        build: |g, n, a| basis::cosine(g, n, &a[0]),
    },
    Routine {
        name: "zonal",
        doc: "The zonal vector `z` about +Z, turned to the unit vector `d`.",
        source: "Sloan et al. 2005; Ren et al. 2006, section 6.1: f_lm = √(4π/(2l+1)) z_l y_lm(d).",
        example: "// Band 1 is (y, z, x).\nlet f = <[f64; 4]>::zonal([0.0, 1.0], [1.0, 0.0, 0.0]);\nassert!((f[3] - 1.0).abs() < 1e-12);",
        arguments: &[("z", Shape::Zonal), D],
        result: Shape::Vector,
        build: |g, n, a| basis::zonal(g, n, &a[0], &a[1]),
    },
    Routine {
        name: "product",
        doc: "The product `f * g`, projected back to order n.\n\nCommutative, not associative: what lies above order n is dropped each time.",
        source: "Ren et al. 2006, eq. 3.",
        example: "let one = [sh_core::ROOT_FOUR_PI, 0.0, 0.0, 0.0];\nlet f = [1.0, 2.0, 3.0, 4.0];\nassert!(f.product(&one).iter().zip(f).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, G],
        result: Shape::Vector,
        build: |g, n, a| product(g, n, &a[0], &a[1]),
    },
    Routine {
        name: "square",
        doc: "The product of `f` with itself, at about two thirds of a product's cost.",
        source: "Ren et al. 2006, eq. 3 with g = f.",
        example: "let f = [1.0_f64, 2.0, 3.0, 4.0];\nassert!(f.square().iter().zip(f.product(&f)).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| {
            if n >= RINGS_FROM {
                Rings::new(n).square(g, &a[0])
            } else {
                direct::square(g, n, &a[0])
            }
        },
    },
    Routine {
        name: "product_cosine",
        doc: "The product `f * H(d)` with the cosine lobe about `d`, cheaper than forming and multiplying it: what remains is a dot product with each channel of the light.",
        source: "Ren et al. 2006, eq. 3 and 9.",
        example: "let (f, up) = ([1.0_f64, 2.0, 3.0, 4.0], [0.0, 1.0, 0.0]);\nlet formed = f.product(&<[f64; 4]>::cosine(up));\nassert!(f.product_cosine(up).iter().zip(formed).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, D],
        result: Shape::Vector,
        build: |g, n, a| {
            let lobe = basis::cosine(g, n, &a[1]);
            product(g, n, &a[0], &lobe)
        },
    },
    Routine {
        name: "triple",
        doc: "The integral of the product of three functions over the sphere.",
        source: "Ren et al. 2006, section 3: (a, b, c) = (a * b) · c.",
        example: "let f = [0.5_f64, 0.1, -0.2, 0.3];\nassert!((f.triple(&f, &f) - f.square().dot(&f)).abs() < 1e-12);",
        arguments: &[F, G, ("h", Shape::Vector)],
        result: Shape::Scalar,
        build: |g, n, a| {
            let p = product(g, n, &a[0], &a[1]);
            vec![g.dot(&p, &a[2])]
        },
    },
    Routine {
        name: "dot",
        doc: "The integral of the product of two functions over the sphere.",
        source: "Orthonormality: ∫ f g = Σ f_i g_i.",
        example: "assert_eq!([1.0_f32, 2.0, 3.0, 4.0].dot(&[1.0, 0.0, 0.0, 1.0]), 5.0);",
        arguments: &[F, G],
        result: Shape::Scalar,
        build: |g, _, a| vec![g.dot(&a[0], &a[1])],
    },
    Routine {
        name: "product_matrix",
        doc: "The symmetric matrix of multiplication by `f`: its lower triangle, row by row.",
        source: "Ren et al. 2006, eq. 5.",
        example: "// Row 0, column 0: the integral of f y0 y0.\nlet m = [2.0_f64, 0.0, 0.0, 0.0].product_matrix();\nassert!((m[0] - 2.0 / sh_core::ROOT_FOUR_PI).abs() < 1e-12);",
        arguments: &[F],
        result: Shape::Triangle,
        build: |g, n, a| direct::matrix(g, n, &a[0]),
    },
    Routine {
        name: "matrix_apply",
        doc: "A symmetric matrix, given by its lower triangle, times a vector.",
        source: "With the product matrix of f: M_f g = f * g.",
        example: "let (f, g) = ([1.0_f64, 2.0, 3.0, 4.0], [0.5, 0.0, 1.0, 0.0]);\nlet applied = <[f64; 4]>::matrix_apply(&f.product_matrix(), &g);\nassert!(applied.iter().zip(f.product(&g)).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[("m", Shape::Triangle), G],
        result: Shape::Vector,
        build: |g, n, a| {
            let c = n * n;
            (0..c)
                .map(|i| {
                    let row: Vec<_> = (0..c)
                        .map(|j| {
                            let (r, s) = (i.max(j), i.min(j));
                            a[0][r * (r + 1) / 2 + s]
                        })
                        .collect();
                    g.dot(&row, &a[1])
                })
                .collect()
        },
    },
    Routine {
        name: "rotate",
        doc: "`f` rotated by the unit quaternion `q` = (x, y, z, w): (Rf)(s) = f(R⁻¹s).\n\nAs accurate for tilts of 1e-7 as for any other rotation.",
        source: "R_z(α) R_y(β) R_z(γ) with the angles' cosines and sines from the quaternion; R_y by quarter turns about x.",
        example: "// 90 degrees about z send x to y.\nlet half = std::f64::consts::FRAC_PI_4;\nlet turned = [0.0, 0.0, 0.0, 1.0].rotate([0.0, 0.0, half.sin(), half.cos()]);\nassert!((turned[1] - 1.0).abs() < 1e-12);",
        arguments: &[F, ("q", Shape::Quaternion)],
        result: Shape::Vector,
        build: |g, n, a| rotation::rotate(g, n, &a[0], &a[1]),
    },
    Routine {
        name: "rotate_matrix",
        doc: "`f` rotated by the rotation matrix `m`, given row by row: (Rf)(s) = f(R⁻¹s).",
        source: "Shepperd 1978 to a quaternion, then as `rotate`.",
        example: "// 90 degrees about z send x to y.\nlet about_z = [0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];\nlet turned = [0.0_f64, 0.0, 0.0, 1.0].rotate_matrix(about_z);\nassert!((turned[1] - 1.0).abs() < 1e-12);",
        arguments: &[F, ("m", Shape::Matrix3)],
        result: Shape::Vector,
        build: |g, n, a| {
            let q = rotation::quaternion(g, &a[1]);
            rotation::rotate(g, n, &a[0], &q)
        },
    },
    Routine {
        name: "window",
        doc: "`f` with band l scaled by cos(π/2 · l/h), and by 0 for l ≥ h: against ringing. `h` must be positive; 2n is a mild window.",
        source: "Ren et al. 2006, section 7.",
        example: "let f = [1.0_f64; 9].window(2.0);\nassert!((f[1] - 0.5_f64.sqrt()).abs() < 1e-12);\nassert_eq!(f[4..], [0.0; 5]);",
        arguments: &[F, ("h", Shape::Scalar)],
        result: Shape::Vector,
        build: |g, n, a| basis::window(g, n, &a[0], a[1][0]),
    },
    Routine {
        name: "cap_visibility",
        doc: "Zonal coefficients of the visibility past a circular blocker of angular radius θ about +Z, for any θ in 0..π, from its cosine and sine.",
        source: "Ren et al. 2006, eq. 33, integrated in closed form.",
        example: "// Half of the sky is hidden.\nlet z = <[f64; 4]>::cap_visibility(0.0, 1.0);\nassert!((z[0] - 0.5 * sh_core::ROOT_FOUR_PI).abs() < 1e-12);",
        arguments: &[COS, SIN],
        result: Shape::Zonal,
        build: |g, n, a| basis::cap_visibility(g, n, a[0][0], a[1][0]),
    },
    Routine {
        name: "cap_log",
        doc: "Zonal coefficients of the eigen logarithm of the visibility past a circular blocker of angular radius θ about +Z, for θ in 0..π/2, from its sine and cosine; no table look-up.\n\nAgainst the eigen logarithm, whose values reach 6.5, it errs by at most 0.004, 0.46, 0.41, 0.37 and 0.43 at orders 2 to 6, near the kinks where an eigenvalue is clipped; in the visibility that the exponential makes of it by at most 0.001, 0.060, 0.047, 0.042 and 0.036 of full visibility, as much as the eigen logarithm itself. Beyond π/2 the polynomials mean nothing: hand in π/2.",
        source: "Ren et al. 2006, eq. 30–32, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.",
        example: "assert_eq!(<[f64; 16]>::cap_log(0.0, 1.0), [0.0; 4]);\nassert!(<[f64; 16]>::cap_log(0.6, 0.8)[0] < 0.0);",
        arguments: &[SIN, COS],
        result: Shape::Zonal,
        build: |g, n, a| fits::cap_log(g, "eigen", n, a[0][0], a[1][0]),
    },
    Routine {
        name: "add_cap_log",
        doc: "`f` plus the logarithm of the visibility past a circular blocker about the unit vector `d`: what one blocker costs a receiver. The angular radius θ in 0..π/2 comes as its sine and cosine.",
        source: "Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log`.",
        example: "let (sin, cos, d) = (0.6, 0.8, [0.6, 0.0, 0.8]);\nlet sum = [0.0_f64; 16].add_cap_log(sin, cos, d);\nlet turned = <[f64; 16]>::zonal(<[f64; 16]>::cap_log(sin, cos), d);\nassert!(sum.iter().zip(turned).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, SIN, COS, D],
        result: Shape::Vector,
        build: |g, n, a| fits::add_cap_log(g, "eigen", n, a),
    },
    Routine {
        name: "cap_log_saturating",
        doc: "As `cap_log`, fitted to `exp_saturating` in the place of the eigen logarithm: sums of it over blockers are what that exponential is made for, and no other is. θ in 0..π/2.",
        source: "Ren et al. 2006, eq. 33–34, with the logarithm fitted against true visibilities; `gaunt-lab fit` rewrites the coefficients, `gaunt-lab accuracy` states their error.",
        example: "assert_eq!(<[f64; 16]>::cap_log_saturating(0.0, 1.0), [0.0; 4]);\nassert!(<[f64; 16]>::cap_log_saturating(0.6, 0.8)[0] < 0.0);",
        arguments: &[SIN, COS],
        result: Shape::Zonal,
        build: |g, n, a| fits::cap_log(g, "saturating", n, a[0][0], a[1][0]),
    },
    Routine {
        name: "add_cap_log_saturating",
        doc: "`f` plus the logarithm `cap_log_saturating` of the visibility past a circular blocker about the unit vector `d`: what one blocker costs a receiver of the shadow pass. The angular radius θ in 0..π/2 comes as its sine and cosine.",
        source: "Ren et al. 2006, eq. 34 and 8, with the fitted logarithm of `cap_log_saturating`.",
        example: "let (sin, cos, d) = (0.6, 0.8, [0.6, 0.0, 0.8]);\nlet sum = [0.0_f64; 16].add_cap_log_saturating(sin, cos, d);\nlet turned = <[f64; 16]>::zonal(<[f64; 16]>::cap_log_saturating(sin, cos), d);\nassert!(sum.iter().zip(turned).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, SIN, COS, D],
        result: Shape::Vector,
        build: |g, n, a| fits::add_cap_log(g, "saturating", n, a),
    },
    Routine {
        name: "cap_log_shading",
        doc: "As `cap_log`, fitted to `transfer` in the place of the eigen logarithm. θ in 0..π/2; of a small one band l is that of what the circle hides, so that few small blockers cast the whole of their shadow.",
        source: "Ren et al. 2006, eq. 33–34, with the logarithm fitted against true transfers; `gaunt-lab fit` rewrites the coefficients.",
        example: "assert_eq!(<[f64; 16]>::cap_log_shading(0.0, 1.0), [0.0; 4]);\nassert!(<[f64; 16]>::cap_log_shading(0.6, 0.8)[0] < 0.0);",
        arguments: &[SIN, COS],
        result: Shape::Zonal,
        build: |g, n, a| fits::cap_log(g, "shading", n, a[0][0], a[1][0]),
    },
    Routine {
        name: "accumulate_blocker",
        doc: "A sum of blockers plus one more: what one blocker of a cut costs a receiver of the shadow pass. The logarithm `cap_log_shading` about the unit vector `d`, band l of it times `w[l]`: a blocker's own weight, times the ratio vector of one that stands for several. Coefficients of the sum lack a factor each, which `accumulated_log` puts in at the end; it costs as little for many blockers as for one.",
        source: "Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_shading`.",
        example: "let (sin, cos, d) = (0.6, 0.8, [0.6, 0.0, 0.8]);\nlet half = [0.0_f64; 16].accumulate_blocker(sin, cos, d, [0.5; 4]);\nlet both = half.accumulate_blocker(sin, cos, d, [0.5; 4]).accumulated_log();\nlet one = <[f64; 16]>::zonal(<[f64; 16]>::cap_log_shading(sin, cos), d);\nassert!(one.iter().zip(both).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, SIN, COS, D, ("w", Shape::Zonal)],
        result: Shape::Vector,
        build: |g, n, a| fits::accumulate(g, "shading", n, a),
    },
    Routine {
        name: "accumulate_blocker_saturating",
        doc: "As `accumulate_blocker`, with the logarithm `cap_log_saturating`: for `exp_saturating`, where the visibility itself is asked for.",
        source: "Ren et al. 2006, eq. 38, with the fitted logarithm of `cap_log_saturating`.",
        example: "let (sin, cos, d) = (0.6, 0.8, [0.6, 0.0, 0.8]);\nlet sum = [0.0_f64; 16].accumulate_blocker_saturating(sin, cos, d, [1.0; 4]).accumulated_log();\nlet one = [0.0_f64; 16].add_cap_log_saturating(sin, cos, d);\nassert!(one.iter().zip(sum).all(|(a, b)| (a - b).abs() < 1e-12));",
        arguments: &[F, SIN, COS, D, ("w", Shape::Zonal)],
        result: Shape::Vector,
        build: |g, n, a| fits::accumulate(g, "saturating", n, a),
    },
    Routine {
        name: "accumulated_log",
        doc: "The logarithm of the visibility past all blockers that `accumulate_blocker` has summed up: each coefficient times its factor.",
        source: "The leading coefficients of the basis functions, as polynomials in z, and √(4π/(2l+1)).",
        example: "assert_eq!([0.0_f32; 9].accumulated_log(), [0.0; 9]);",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| {
            let factors = fits::accumulation_factors(n);
            let pairs = a[0].iter().zip(factors);
            pairs.map(|(f, factor)| g.scale(factor, *f)).collect()
        },
    },
    Routine {
        name: "ball_average",
        doc: "The vector whose dot product with what a ball's surface emits, a function of the direction from its centre, is the mean radiance that is seen of it: of all that is in sight, by solid angle. `d` points from the ball to where it is seen from, the angular radius θ in 0..π/2 comes as its sine and cosine.\n\nBand l is y_l(d) times the mean of P_l(cos α) over what is in sight, α the angle from `d`: from far away, weights are the cosines of the surface's slope, near by those of a small cap. That mean is fitted to 3e-6.",
        source: "Guerrero et al. 2008, eq. 16–18, with weights by solid angle, (cos α − s)/(1 − 2 s cos α + s²)^(3/2), s = sin θ, where eq. 17 has the root alone; `gaunt-lab fit` rewrites the coefficients.",
        example: "// Half of a ball is bright.\nlet emission = <[f64; 16]>::basis([0.0, 0.0, 1.0]);\nlet (sin, cos) = (0.6, 0.8);\nlet before = emission.dot(&<[f64; 16]>::ball_average(sin, cos, [0.0, 0.0, 1.0]));\nlet behind = emission.dot(&<[f64; 16]>::ball_average(sin, cos, [0.0, 0.0, -1.0]));\nassert!(before > 0.5 && behind < 0.1);",
        arguments: &[SIN, COS, D],
        result: Shape::Vector,
        build: |g, n, a| fits::ball_average(g, n, a[0][0], a[1][0], &a[2]),
    },
    Routine {
        name: "disc_covered",
        doc: "Which part of a disc in the sky of angular radius `a` another of radius `b` covers whose middle is at the distance `d`; radians, radii up to π/2.\n\nThe share of flat discs, fitted to 0.016, with angles for lengths; of those on a sphere it errs by 0.0165 for radii up to 20°, 0.0205 up to 40°, 0.045 up to 60°, 0.087 up to 80° and 0.12 up to 90°, most where two of one size overlap by half. 0 for discs that do not touch, 1 for one that is covered, and nothing between is below or above.",
        source: "The lens of two circles, fitted in place of its inverse cosines; `gaunt-lab fit` rewrites the coefficients.",
        example: "let covered = |d: f64| <[f64; 4]>::disc_covered(0.2, 0.2, d);\nassert_eq!((covered(0.0), covered(0.4)), (1.0, 0.0));\nassert!((covered(0.2) - 0.391).abs() < 0.02);",
        arguments: &[
            ("a", Shape::Scalar),
            ("b", Shape::Scalar),
            ("d", Shape::Scalar),
        ],
        result: Shape::Scalar,
        build: |g, _, a| vec![fits::disc_covered(g, a[0][0], a[1][0], a[2][0])],
    },
    Routine {
        name: "exp_saturating",
        doc: "The visibility behind all blockers from `f`, the sum of their `cap_log_saturating`: samples of f, held in bounds by a fitted function in the place of e^x, projected back. The exponential of the shadow pass.\n\nWith x = f/√(1 + β‖f̂‖²/4π), f̂ being f without its mean, and t = x(s) held in −1..0.2, a sample becomes h(t) = ((1 + t)(1 − t/4))²: 1 for f = 0, at most 1.2996, and 0 where f says dark. Ripples of many overlapping blockers, which grow with their number, are compressed to the size of one blocker's; no |f| makes it diverge.\n\nPromises for any finite f: every sample lies in 0..=1.2996 before projection; the norm of the result is at most 1.2996 √4π (2 % more at order 6, where a band's gain is 1.02). A number that is not finite makes the result NaN or finite, never infinite. f is told apart up to ‖f̂‖ = 3e18.",
        source: "Sampling rules: Lebedev 1976; β, the gains of the projection's bands and the logarithm fitted against true visibilities by `gaunt-lab fit`.",
        example: "let f = [-1e6_f64; 16];\nassert!(f.exp_saturating().iter().all(|g| g.abs() < 1.3 * sh_core::ROOT_FOUR_PI));\nlet clear = [0.0_f64; 16].exp_saturating();\nassert!((clear[0] - sh_core::ROOT_FOUR_PI).abs() < 1e-14);",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| sampled::saturating(g, n, &a[0]),
    },
    Routine {
        name: "transfer",
        doc: "The transfer from light to what a surface of unit normal `d` reflects behind blockers, from `f`, the sum of their `cap_log_shading`: exp(f) times the cosine lobe over π, projected. Its dot product with a channel of the light is reflected radiance. What the shadow pass takes.\n\nAt samples x = f(s)/√(1 + β‖f̂‖²/4π), f̂ being f without its mean, held in −4..1/2, visibility is (1 + x/4)^4: 1 for f = 0, 0 where f says dark, at most 1.602. It is multiplied with the lobe there, of which all bands up to 2n − 2 are taken: those that couple light of order n with visibility of order n. Light of a lower order takes the first coefficients; that way all bands of the visibility are used.\n\nPromises for any finite f: the norm of the result is at most 1.602 times the lobe's at the samples, 0.82. Without blockers it is `cosine`. f is told apart up to ‖f̂‖ = 3e18.",
        source: "(L, H(N), g) = L · (g * H(N)), Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976); β and the logarithm fitted against true transfers by `gaunt-lab fit`.",
        example: "let up = [0.0, 1.0, 0.0];\nlet clear = [0.0_f64; 16].transfer(up);\nassert!(clear.iter().zip(<[f64; 16]>::cosine(up)).all(|(a, b)| (a - b).abs() < 1e-12));\nassert!([-1e6_f64, 0.0, 0.0, 0.0].transfer(up).iter().all(|t| *t == 0.0));",
        arguments: &[F, D],
        result: Shape::Vector,
        build: |g, n, a| sampled::transfer(g, n, &a[0], &a[1]),
    },
    Routine {
        name: "transfer_lobe",
        doc: "As `transfer`, with another lobe about the unit vector `d` in the place of the cosine's: band l of it is `w[l]`, held in −1..1, times that of a lobe of no width, so that `w[0]` is the share of an even sky that it gives. Without blockers it is y_l(d) times `w[l]`.\n\nPromises for any f: the norm of the result is at most 1.602 times the lobe's at the samples, n²/√4π.",
        source: "As `transfer`; the lobe is of the order of `f`.",
        example: "let d = [0.0, 1.0, 0.0];\nlet clear = [0.0_f64; 9].transfer_lobe(d, [1.0, 0.5, 0.25]);\nlet y = <[f64; 9]>::basis(d);\nassert!((clear[1] - 0.5 * y[1]).abs() < 1e-12 && (clear[6] - 0.25 * y[6]).abs() < 1e-12);",
        arguments: &[F, D, ("w", Shape::Zonal)],
        result: Shape::Vector,
        build: |g, n, a| sampled::transfer_lobe(g, n, &a[0], &a[1], &a[2]),
    },
    Routine {
        name: "gloss_lobe",
        doc: "The lobe in which a surface of this `roughness` (0..1; α of GGX is its square) mirrors light, cosine and shadowing included and its sum 1: the mean of P_l over it about its axis, for `transfer_lobe`. `cosine` is that between the normal and the direction to the viewer. Fitted to 0.01 of the mean of P_1 and to 0.05 of that of P_5, most at grazing angles.",
        source: "GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) about the mean of its directions; `gaunt-lab fit` rewrites the coefficients.",
        example: "let mirror = <[f64; 16]>::gloss_lobe(0.0, 0.8);\nassert!(mirror.iter().all(|g| (g - 1.0).abs() < 0.05));\nlet rough = <[f64; 16]>::gloss_lobe(1.0, 0.8);\nassert!(rough[0] == 1.0 && rough[3] < 0.2);",
        arguments: &[("roughness", Shape::Scalar), ("cosine", Shape::Scalar)],
        result: Shape::Zonal,
        build: |g, n, a| fits::gloss_lobe(g, n, a[0][0], a[1][0]),
    },
    Routine {
        name: "gloss_told",
        doc: "The roughness in whose place light of this order has `roughness`: a smoother lobe, cut off after the order's bands, would be below 0 beside its peak by more than 3 % of that, and show dark rings around a sun. At least 1, 0.88, 0.72, 0.6 and 0.59 for orders 2 to 6.",
        source: "`tests/tests/fitted.rs` holds it to the lobes.",
        example: "assert_eq!(<[f64; 16]>::gloss_told(0.1), 0.72);\nassert_eq!(<[f64; 16]>::gloss_told(0.9), 0.9);",
        arguments: &[("roughness", Shape::Scalar)],
        result: Shape::Scalar,
        build: |g, n, a| vec![fits::gloss_told(g, n, a[0][0])],
    },
    Routine {
        name: "gloss_tilt",
        doc: "How far the lobe of `gloss_lobe` leans: the sine between its axis and the normal, over that of the mirrored direction. 1 for a mirror; rough surfaces send light closer to their normal. Fitted to 0.013.",
        source: "The mean of the directions of GGX's lobe (Walter et al. 2007); `gaunt-lab fit` rewrites the coefficients.",
        example: "assert!(<[f64; 4]>::gloss_tilt(0.0, 0.5) > 0.95 && <[f64; 4]>::gloss_tilt(1.0, 0.5) < 0.3);",
        arguments: &[("roughness", Shape::Scalar), ("cosine", Shape::Scalar)],
        result: Shape::Scalar,
        build: |g, _, a| vec![fits::gloss_tilt(g, a[0][0], a[1][0])],
    },
    Routine {
        name: "gloss_energy",
        doc: "What the lobe of a surface of this `roughness` mirrors of an even sky if it absorbs nothing, light that meets the surface once, E; and the part B of it that Fresnel's reflectance has at grazing angles: of a reflectance F from the front it mirrors F (E − B) + B. Fitted to 0.01 in the mean, and to 0.06 at grazing angles.",
        source: "GGX (Walter et al. 2007) with correlated shadowing (Heitz 2014) and Schlick's Fresnel term (1994), summed as by Karis 2013; `gaunt-lab fit` rewrites the coefficients.",
        example: "let [energy, grazing] = <[f64; 4]>::gloss_energy(0.1, 0.9);\nassert!(energy > 0.97 && grazing < 0.02);",
        arguments: &[("roughness", Shape::Scalar), ("cosine", Shape::Scalar)],
        result: Shape::Pair,
        build: |g, _, a| fits::gloss_energy(g, a[0][0], a[1][0]),
    },
    Routine {
        name: "horizon_radius",
        doc: "Of a sphere that the horizon cuts: the radius of the one that stands for the part above it, over the sphere's own. It touches the horizon from above, below the sphere's centre, and hides the same share of an even sky, weighted by the cosine: a sphere of sine s that touches hides s^3. `height` is that of the sphere's centre over its radius, −1 (wholly below: 0) to 1 (wholly above: 1), `square` the square of the sine of the sphere's angular radius. Fitted: the share to 0.0133 of the sky, and that of a small sphere to 0.125 of what it hides when wholly above.",
        source: "The form factor of a sphere that a horizon cuts (Snyder 1996, \"Area light sources for real-time graphics\"), to the power 1/3; `gaunt-lab fit` rewrites the coefficients.",
        example: "let radius = |height: f64| <[f64; 4]>::horizon_radius(height, 0.04);\nassert_eq!(radius(-1.0), 0.0);\nassert!((radius(1.0) - 1.0).abs() < 1e-6);\n// Half of it, seen from afar.\nassert!((radius(0.0) - 0.6).abs() < 0.1);",
        arguments: &[("height", Shape::Scalar), ("square", Shape::Scalar)],
        result: Shape::Scalar,
        build: |g, _, a| vec![fits::horizon_radius(g, a[0][0], a[1][0])],
    },
    Routine {
        name: "exp_sampled",
        doc: "The exponential of `f` at samples, exp(min(f(s), 0.15)), projected back; on 14, 26, 50, 86 and 86 points for orders 2 to 6. Every sample lies in 0..=1.162.",
        source: "Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.",
        example: "let mut f = [0.0_f64; 16];\nf[0] = -0.5 * sh_core::ROOT_FOUR_PI;\nassert!((f.exp_sampled()[0] - (-0.5_f64).exp() * sh_core::ROOT_FOUR_PI).abs() < 1e-14);",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| sampled::clamped(g, n, Fineness::Medium, &a[0]),
    },
    Routine {
        name: "exp_sampled_coarse",
        doc: "As `exp_sampled`, on 6, 14, 38, 50 and 50 points for orders 2 to 6.",
        source: "Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.",
        example: "assert!([0.1_f32; 16].exp_sampled_coarse()[0] > sh_core::ROOT_FOUR_PI as f32);",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| sampled::clamped(g, n, Fineness::Coarse, &a[0]),
    },
    Routine {
        name: "exp_sampled_fine",
        doc: "As `exp_sampled`, on 26, 38, 86, 110 and 110 points for orders 2 to 6.",
        source: "Ren et al. 2006, eq. 10, by quadrature (Lebedev 1976) and clamped from above.",
        example: "assert!([0.1_f32; 16].exp_sampled_fine()[0] > sh_core::ROOT_FOUR_PI as f32);",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| sampled::clamped(g, n, Fineness::Fine, &a[0]),
    },
    Routine {
        name: "optimal_linear",
        doc: "The factors a and b of the optimal linear exponential a·1 + b·f̂ for a vector without DC, of norm ‖f̂‖ ≤ 1/4.",
        source: "Ren et al. 2006, eq. 23–24, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.",
        example: "assert_eq!(<[f64; 16]>::optimal_linear(0.0), [1.0, 1.0]);",
        arguments: &[("norm", Shape::Scalar)],
        result: Shape::Pair,
        build: |g, n, a| fits::optimal_linear(g, n, a[0][0]),
    },
    Routine {
        name: "optimal_linear_wide",
        doc: "The factors a and b of the optimal linear exponential a·1 + b·f̂ for a vector without DC of any norm ‖f̂‖, as a circle of that norm has them. Beyond the norm of the largest circle they stay as they are there.",
        source: "Ren et al. 2006, eq. 23–24 and Figure 3, fitted; `gaunt-lab fit` rewrites the coefficients and states their error.",
        example: "let [a, b] = <[f64; 16]>::optimal_linear_wide(2.0);\nassert!(a > 1.0 && b > 0.5);",
        arguments: &[("norm", Shape::Scalar)],
        result: Shape::Pair,
        build: |g, n, a| fits::optimal_linear_any(g, n, a[0][0]),
    },
];

/// Other forms of the same routines: counted and measured, not emitted by default.
pub const FORMS: &[Routine] = &[
    Routine {
        name: "product/direct",
        doc: "The product, term by term.",
        source: "Snyder 2006, factored over pairs.",
        example: "",
        arguments: &[F, G],
        result: Shape::Vector,
        build: |g, n, a| direct::product(g, n, &a[0], &a[1]),
    },
    Routine {
        name: "product/rings",
        doc: "The product on circles of latitude.",
        source: "Gauss–Lobatto quadrature in z, exact.",
        example: "",
        arguments: &[F, G],
        result: Shape::Vector,
        build: |g, n, a| Rings::new(n).product(g, &a[0], &a[1]),
    },
    Routine {
        name: "square/direct",
        doc: "The square, term by term.",
        source: "Snyder 2006, factored over pairs.",
        example: "",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| direct::square(g, n, &a[0]),
    },
    Routine {
        name: "square/rings",
        doc: "The square on circles of latitude.",
        source: "Gauss–Lobatto quadrature in z, exact.",
        example: "",
        arguments: &[F],
        result: Shape::Vector,
        build: |g, n, a| Rings::new(n).square(g, &a[0]),
    },
];
