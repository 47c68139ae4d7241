//! Random arguments that fit a routine's shapes and domains, the same in every run.

use sh_codegen::routines::{Routine, Shape};

/// A generator of numbers with a fixed seed (SplitMix64, Steele et al. 2014).
pub struct Random(u64);

impl Random {
    /// A generator; equal seeds give equal numbers.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Uniform in −1..1, representable in f32.
    pub fn signed(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let bits = (z ^ (z >> 31)) >> 40;
        bits as f64 / f64::from(1 << 23) - 1.0
    }

    /// Uniform in 0..1.
    pub fn unit(&mut self) -> f64 {
        0.5 * (self.signed() + 1.0)
    }

    /// `N` numbers of length 1 together, evenly over the sphere.
    pub fn on_sphere<const N: usize>(&mut self) -> [f64; N] {
        loop {
            let v: [f64; N] = std::array::from_fn(|_| self.signed());
            let square: f64 = v.iter().map(|x| x * x).sum();
            if (0.01..1.0).contains(&square) {
                return v.map(|x| x / square.sqrt());
            }
        }
    }
}

/// A rotation matrix, row by row, from a quaternion (x, y, z, w).
pub fn matrix([x, y, z, w]: [f64; 4]) -> [f64; 9] {
    [
        1.0 - 2.0 * (y * y + z * z),
        2.0 * (x * y - z * w),
        2.0 * (x * z + y * w),
        2.0 * (x * y + z * w),
        1.0 - 2.0 * (x * x + z * z),
        2.0 * (y * z - x * w),
        2.0 * (x * z - y * w),
        2.0 * (y * z + x * w),
        1.0 - 2.0 * (x * x + y * y),
    ]
}

/// The quaternion of case `i`: every third is a small tilt, down to 1e-7, on top of any turn about z; the
/// first is no rotation, the second a half turn about an axis across.
pub fn quaternion(random: &mut Random, i: usize) -> [f64; 4] {
    match i {
        0 => [0.0, 0.0, 0.0, 1.0],
        1 => [0.6, 0.8, 0.0, 0.0],
        _ if i.is_multiple_of(3) => {
            let half = 0.5 * 10.0_f64.powf(-7.0 + 5.0 * random.unit());
            let [x, y] = random.on_sphere::<2>();
            let [z, w] = random.on_sphere::<2>();
            [
                half.sin() * x,
                half.sin() * y,
                half.cos() * z,
                half.cos() * w,
            ]
        }
        _ => random.on_sphere(),
    }
}

/// Arguments for a routine: case `i` of the sequence that `random` stands for.
pub fn arguments(routine: &Routine, order: usize, random: &mut Random, i: usize) -> Vec<Vec<f64>> {
    let angle = match routine.name {
        "cap_visibility" => std::f64::consts::PI * random.unit(),
        _ => std::f64::consts::FRAC_PI_2 * random.unit(),
    };
    routine
        .arguments
        .iter()
        .map(|(name, shape)| match (*name, shape) {
            ("sin", _) => vec![angle.sin()],
            ("cos", _) => vec![angle.cos()],
            // The widest argument of the window's cosine.
            ("h", Shape::Scalar) if i == 1 => vec![1.015625],
            ("h", Shape::Scalar) => vec![0.5 + 12.0 * random.unit()],
            ("norm", _) if routine.name == "optimal_linear_wide" => vec![8.0 * random.unit()],
            ("norm", _) => vec![0.25 * random.unit()],
            // Radii and distance of two discs; the first covers nothing, so that what guards the division acts.
            ("b", Shape::Scalar) if i == 0 => vec![0.0],
            ("a" | "b", Shape::Scalar) => vec![0.01 + 1.5 * random.unit()],
            // A sphere's height over its radius, wholly below to wholly above, and the square of a sine.
            ("height", Shape::Scalar) => vec![1.2 * random.signed()],
            ("square", Shape::Scalar) => vec![random.unit()],
            // All that there are, and a little beyond.
            ("roughness" | "cosine", _) => vec![1.2 * random.unit() - 0.1],
            ("d", Shape::Scalar) => vec![3.0 * random.unit()],
            (_, Shape::Direction) if i < 6 => {
                let mut d = vec![0.0; 3];
                d[i / 2] = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
                d
            }
            (_, Shape::Direction) => random.on_sphere::<3>().to_vec(),
            (_, Shape::Quaternion) => quaternion(random, i).to_vec(),
            (_, Shape::Matrix3) => matrix(quaternion(random, i)).to_vec(),
            (_, shape) => (0..shape.len(order)).map(|_| random.signed()).collect(),
        })
        .collect()
}

/// Whether a shape holds coefficients, which may be of any size, and no angle, direction or factor.
pub fn is_vector(shape: Shape) -> bool {
    matches!(shape, Shape::Vector | Shape::Zonal | Shape::Triangle)
}

/// The product of the norms of all arguments that are SH vectors, zonal vectors or matrices; a square has its
/// argument twice.
pub fn scale(routine: &Routine, arguments: &[Vec<f64>]) -> f64 {
    let norm = |v: &Vec<f64>| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let product: f64 = routine
        .arguments
        .iter()
        .zip(arguments)
        .filter(|((_, shape), _)| is_vector(*shape))
        .map(|(_, v)| norm(v))
        .product();
    if routine.name == "square" {
        product * product
    } else {
        product
    }
}
