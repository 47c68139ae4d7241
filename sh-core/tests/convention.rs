//! Other engines' conventions: each engine's own published formula, written out here, against light that is known
//! without spherical harmonics.
//!
//! The light is L(d) = a + b (d·u) + c (d·v)²; what a white diffuse surface of normal n reflects of it, irradiance
//! over π, is a + ⅔ b (n·u) + c (¼ + ¼ (n·v)²).

use sh_core::convention::{Axes, Axis, filament, three, unity, unreal};
use sh_core::{Routines, Sh, Sh3, Sh3d, ShRgb};

const PI: f64 = std::f64::consts::PI;

/// Of one channel.
struct Known {
    a: f64,
    b: f64,
    u: [f64; 3],
    c: f64,
    v: [f64; 3],
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Known {
    fn radiance(&self, d: [f64; 3]) -> f64 {
        self.a + self.b * dot(d, self.u) + self.c * dot(d, self.v).powi(2)
    }

    /// Irradiance over π.
    fn reflected(&self, n: [f64; 3]) -> f64 {
        let along = dot(n, self.v);
        self.a + 2.0 / 3.0 * self.b * dot(n, self.u) + self.c * (1.0 + along * along) / 4.0
    }

    /// The zonal vectors of z and z² are (0, √(4π/3), 0) and (√(4π)/3, 0, 4/3 √(π/5)).
    fn sh(&self) -> Sh3 {
        let linear = Sh3d::zonal([0.0, (4.0 * PI / 3.0).sqrt(), 0.0], self.u);
        let square = [(4.0 * PI).sqrt() / 3.0, 0.0, 4.0 / 3.0 * (PI / 5.0).sqrt()];
        let square = Sh3d::zonal(square, self.v);
        let sum = Sh3d::ONE * self.a + linear * self.b + square * self.c;
        Sh(sum.0.map(|x| x as f32))
    }
}

/// Red, green and blue differ, so that mixed channels show.
fn light() -> ([Known; 3], ShRgb<f32, 9>) {
    let known = [
        Known {
            a: 0.9,
            b: 0.5,
            u: [0.36, 0.48, 0.8],
            c: 0.7,
            v: [0.8, -0.6, 0.0],
        },
        Known {
            a: 0.4,
            b: -0.3,
            u: [0.0, 0.6, -0.8],
            c: 0.2,
            v: [0.48, 0.6, 0.64],
        },
        Known {
            a: 1.5,
            b: 0.8,
            u: [-0.6, 0.0, 0.8],
            c: -0.4,
            v: [0.0, 1.0, 0.0],
        },
    ];
    let [r, g, b] = [&known[0], &known[1], &known[2]].map(Known::sh);
    (known, ShRgb { r, g, b })
}

const DIRECTIONS: [[f64; 3]; 8] = [
    [1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.36, 0.48, 0.8],
    [-0.8, 0.6, 0.0],
    [0.0, -0.28, -0.96],
    [0.48, -0.64, -0.6],
    [-0.64, -0.48, 0.6],
];

/// Compares an engine's formula with the known light in all directions. `turn` writes a direction as the engine does;
/// it is written out by each test.
#[track_caller]
fn agrees(
    turn: impl Fn([f64; 3]) -> [f64; 3],
    engine: impl Fn([f64; 3]) -> [f64; 3],
    truth: impl Fn(&Known, [f64; 3]) -> f64,
) {
    let (known, _) = light();
    for d in DIRECTIONS {
        let found = engine(turn(d));
        for (known, found) in known.iter().zip(found) {
            let truth = truth(known, d);
            assert!(
                (found - truth).abs() < 4e-6,
                "at {d:?}: {found} for {truth}"
            );
        }
    }
}

fn unchanged(d: [f64; 3]) -> [f64; 3] {
    d
}

/// The seven vectors that Unity's and Unreal's shaders share: `dot(A, (n, 1)) + dot(B, n.xyzz * n.yzzx) + C (x² − y²)`.
fn seven(rows: &[[f32; 4]; 7], [x, y, z]: [f64; 3]) -> [f64; 3] {
    let four = |row: [f32; 4], by: [f64; 4]| -> f64 {
        row.iter().zip(by).map(|(a, b)| f64::from(*a) * b).sum()
    };
    [0, 1, 2].map(|channel| {
        four(rows[channel], [x, y, z, 1.0])
            + four(rows[channel + 3], [x * y, y * z, z * z, z * x])
            + f64::from(rows[6][channel]) * (x * x - y * y)
    })
}

#[test]
fn unity_shades_as_here() {
    let (_, light) = light();
    let rows = unity::shader(&light, Axes::UNITY);
    assert_eq!(rows[6][3], 1.0);
    agrees(
        |[x, y, z]| [x, y, -z],
        |n| seven(&rows, n),
        Known::reflected,
    );
    let rows = unity::shader(&light, Axes::UNITY_IMPORT);
    agrees(
        |[x, y, z]| [-x, y, z],
        |n| seven(&rows, n),
        Known::reflected,
    );
    for axes in [Axes::UNITY, Axes::UNITY_IMPORT] {
        near(
            &unity::from_shader(&unity::shader(&light, axes), axes),
            &light,
        );
        near(
            &unity::from_probe(&unity::probe(&light, axes), axes),
            &light,
        );
    }
}

/// Scripts take irradiance of a `SphericalHarmonicsL2` out of Unity's factors by multiplying with π and dividing by the
/// basis' constants, and fill a shader's vectors from it.
#[test]
fn unity_probes_hold_what_its_scripts_say() {
    let (known, light) = light();
    let probe = unity::probe(&light, Axes::UNITY);
    let rows = unity::shader(&light, Axes::UNITY);
    for channel in 0..3 {
        let sh = probe[channel];
        assert_eq!(rows[channel], [sh[3], sh[1], sh[2], sh[0] - sh[6]]);
        assert_eq!(rows[channel + 3], [sh[4], sh[5], sh[6] * 3.0, sh[7]]);
        assert_eq!(rows[6][channel], sh[8]);
        // Irradiance averages to π times radiance's average, a + c/3.
        let raw = f64::from(sh[0]) * PI / 0.282_094_791_773_878_14;
        let average = known[channel].a + known[channel].c / 3.0;
        assert!((raw * 0.282_094_791_773_878_14 - PI * average).abs() < 1e-5);
    }
}

#[test]
fn unreal_shades_as_here() {
    let (_, light) = light();
    let rows = unreal::sky(&light, Axes::UNREAL);
    agrees(
        |[x, y, z]| [-z, x, y],
        |n| seven(&rows, n),
        Known::reflected,
    );
    let rows = unreal::sky(&light, Axes::UNREAL_IMPORT);
    agrees(|[x, y, z]| [x, z, y], |n| seven(&rows, n), Known::reflected);
    for axes in [Axes::UNREAL, Axes::UNREAL_IMPORT] {
        near(&unreal::from_sky(&unreal::sky(&light, axes), axes), &light);
        near(
            &unreal::from_vector(&unreal::vector(&light, axes), axes),
            &light,
        );
    }
}

/// The basis of Unreal's vectors and of `D3DXSHEvalDirection`, to six digits as published.
fn d3d_basis([x, y, z]: [f64; 3]) -> [f64; 9] {
    [
        0.282095,
        -0.488603 * y,
        0.488603 * z,
        -0.488603 * x,
        1.092548 * x * y,
        -1.092548 * y * z,
        0.315392 * (3.0 * z * z - 1.0),
        -1.092548 * x * z,
        0.546274 * (x * x - y * y),
    ]
}

#[test]
fn unreal_vectors_hold_radiance() {
    let (_, light) = light();
    let vector = unreal::vector(&light, Axes::UNREAL);
    agrees(
        |[x, y, z]| [-z, x, y],
        |d| {
            [vector.r, vector.g, vector.b].map(|f| {
                let terms = f.0.iter().zip(d3d_basis(d));
                terms.map(|(f, y)| f64::from(*f) * y).sum()
            })
        },
        Known::radiance,
    );
    // Its shader's constants are made of the vector, as Sloan's appendix A10 has them.
    let rows = unreal::sky(&light, Axes::UNREAL);
    let root = PI.sqrt();
    let c = [
        1.0 / (2.0 * root),
        3.0_f64.sqrt() / (3.0 * root),
        15.0_f64.sqrt() / (8.0 * root),
        5.0_f64.sqrt() / (16.0 * root),
    ];
    let v = vector.g.0.map(f64::from);
    let expected = [
        [
            -c[1] * v[3],
            -c[1] * v[1],
            c[1] * v[2],
            c[0] * v[0] - c[3] * v[6],
        ],
        [c[2] * v[4], -c[2] * v[5], 3.0 * c[3] * v[6], -c[2] * v[7]],
    ];
    for (row, expected) in [rows[1], rows[4]].iter().zip(expected) {
        for (a, b) in row.iter().zip(expected) {
            assert!((f64::from(*a) - b).abs() < 1e-6);
        }
    }
}

fn weighted(colours: &[[f32; 3]; 9], factors: [f64; 9]) -> [f64; 3] {
    [0, 1, 2].map(|channel| {
        let terms = colours.iter().zip(factors);
        terms.map(|(c, y)| f64::from(c[channel]) * y).sum()
    })
}

#[test]
fn filament_shades_as_here() {
    let (_, light) = light();
    let sh = filament::irradiance(&light);
    agrees(
        unchanged,
        |[x, y, z]| {
            let quadratic = [y * x, y * z, 3.0 * z * z - 1.0, z * x, x * x - y * y];
            let [a, b, c, d, e] = quadratic;
            weighted(&sh, [1.0, y, z, x, a, b, c, d, e])
        },
        Known::reflected,
    );
    near(&filament::from_irradiance(&sh), &light);
    assert_eq!(filament::from_radiance(&filament::radiance(&light)), light);
}

/// Its reference gives the product of 1/π, A_l^m and Ĉ_l that `radiance` multiplies by to get what `irradiance` takes.
#[test]
fn filament_radiance_becomes_its_irradiance() {
    const TABLE: [f64; 9] = [
        0.282095, -0.325735, 0.325735, -0.325735, 0.273137, -0.273137, 0.078848, -0.273137,
        0.136569,
    ];
    let (_, light) = light();
    let (radiance, irradiance) = (filament::radiance(&light), filament::irradiance(&light));
    for ((l, e), factor) in radiance.iter().zip(irradiance).zip(TABLE) {
        for (l, e) in l.iter().zip(e) {
            assert!((f64::from(*l) * factor - f64::from(e)).abs() < 4e-6);
        }
    }
}

#[test]
fn three_shades_as_here() {
    let (_, light) = light();
    let sh = three::light_probe(&light);
    let quadratic = |[x, y, z]: [f64; 3]| [x * y, y * z, x * z, x * x - y * y];
    // getAt
    agrees(
        unchanged,
        |[x, y, z]| {
            let [xy, yz, xz, xx] = quadratic([x, y, z]);
            let linear = [0.282095, 0.488603 * y, 0.488603 * z, 0.488603 * x];
            let [a, b, c, d] = linear;
            let zz = 0.315392 * (3.0 * z * z - 1.0);
            let rest = [
                1.092548 * xy,
                1.092548 * yz,
                zz,
                1.092548 * xz,
                0.546274 * xx,
            ];
            let [e, f, g, h, i] = rest;
            weighted(&sh, [a, b, c, d, e, f, g, h, i])
        },
        Known::radiance,
    );
    // getIrradianceAt, over π
    agrees(
        unchanged,
        |[x, y, z]| {
            let [xy, yz, xz, xx] = quadratic([x, y, z]);
            let (c1, c2) = (2.0 * 0.511664, 2.0 * 0.429043);
            let zz = 0.743125 * z * z - 0.247708;
            let (first, rest) = (
                [0.886227, c1 * y, c1 * z, c1 * x],
                [c2 * xy, c2 * yz, zz, c2 * xz],
            );
            let ([a, b, c, d], [e, f, g, h]) = (first, rest);
            weighted(&sh, [a, b, c, d, e, f, g, h, 0.429043 * xx]).map(|e| e / PI)
        },
        Known::reflected,
    );
    assert_eq!(three::from_light_probe(&sh), light);
}

#[track_caller]
fn near(a: &ShRgb<f32, 9>, b: &ShRgb<f32, 9>) {
    for (a, b) in [(a.r, b.r), (a.g, b.g), (a.b, b.b)] {
        assert!((a - b).norm() < 2e-6 * b.norm(), "{a:?} for {b:?}");
    }
}

/// All 48 systems at every order: the value at a turned direction stays, and the way back is one.
#[test]
fn vectors_turn_with_directions() {
    fn check<const C: usize>()
    where
        [f64; C]: Routines<f64>,
    {
        let f = Sh::<f64, C>::basis([0.36, 0.48, 0.8]) + Sh::basis([0.0, 0.6, -0.8]) * 0.3;
        let all = [
            Axis::Right,
            Axis::Left,
            Axis::Up,
            Axis::Down,
            Axis::Back,
            Axis::Forward,
        ];
        let mut systems = 0;
        for x in all {
            for y in all {
                for axes in all.iter().filter_map(|z| Axes::new(x, y, *z)) {
                    systems += 1;
                    let turned = axes.sh(&f);
                    for d in DIRECTIONS {
                        let there = turned.evaluate(axes.direction(d));
                        assert!((there - f.evaluate(d)).abs() < 1e-12, "{axes:?}");
                        assert_eq!(axes.inverse().direction(axes.direction(d)), d);
                    }
                    assert!((axes.inverse().sh(&turned) - f).norm() < 1e-12);
                    let [a, b, c] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
                        .map(|d: [f64; 3]| axes.direction(d));
                    let cross = [
                        a[1] * b[2] - a[2] * b[1],
                        a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0],
                    ];
                    assert_eq!(axes.is_right_handed(), dot(cross, c) > 0.0);
                }
            }
        }
        assert_eq!(systems, 48);
    }
    check::<4>();
    check::<9>();
    check::<16>();
    check::<25>();
    check::<36>();
}
