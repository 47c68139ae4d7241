//! The table of what is measured: every hot routine of every order, on every path.

use crate::batch::{Group, sweep};
use crate::forms;
use crate::fused::Fused;
use fearless_simd::{Level, Simd};
use sh_core::Routines;
use sh_cpu::lanes::{Lanes8, Lanes16};

/// How results are computed.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Path {
    /// One at a time, for the build's baseline processor.
    Scalar,
    /// One at a time, with fused operations.
    Fused,
    /// 8 side by side.
    Eight,
    /// 16 side by side.
    Sixteen,
}

impl Path {
    /// All.
    pub const ALL: [Self; 4] = [Self::Scalar, Self::Fused, Self::Eight, Self::Sixteen];

    /// As printed, and as taken on a command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scalar => "scalar",
            Self::Fused => "fused",
            Self::Eight => "8",
            Self::Sixteen => "16",
        }
    }

    /// Results side by side.
    pub const fn lanes(self) -> usize {
        match self {
            Self::Scalar | Self::Fused => 1,
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

/// Whether this processor has the instructions that are measured: AVX2 on x86, anything elsewhere.
///
/// One instruction set is enough to compare paths and forms, and every further one would be compiled for
/// each of a hundred and sixty batches. With the feature `avx512` a processor that has it uses it.
pub fn is_here() -> bool {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    return Level::new().as_avx2().is_some();
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    return true;
}

/// Enters the instruction set that is measured.
macro_rules! enter {
    ($simd:pat => $body:expr) => {{
        #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
        {
            let level = Level::new();
            #[cfg(feature = "avx512")]
            if let Some($simd) = level.as_avx512() {
                return level.as_avx512().expect("seen above").vectorize(
                    #[inline(always)]
                    || $body,
                );
            }
            if let Some($simd) = level.as_avx2() {
                level.as_avx2().expect("seen above").vectorize(
                    #[inline(always)]
                    || $body,
                );
            }
        }
        #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
        fearless_simd::dispatch!(Level::new(), $simd => $body)
    }};
}

/// Computes a batch (see [`crate::batch`]) from its inputs.
pub type Sweep = fn(&[f32], &mut [f32]);

/// One routine of one order.
pub struct Case {
    /// The routine's name, `routine/form` for a form of it.
    pub name: &'static str,
    /// The order n.
    pub order: usize,
    /// Numbers a result is computed from.
    pub inputs: usize,
    /// Numbers a result has.
    pub outputs: usize,
    /// The batch functions of the paths that are measured.
    pub sweeps: Vec<(Path, Sweep)>,
}

impl Case {
    /// The batch function of a path, if that is measured.
    pub fn sweep(&self, path: Path) -> Option<Sweep> {
        let found = self.sweeps.iter().find(|(p, _)| *p == path);
        found.map(|(_, sweep)| *sweep)
    }
}

macro_rules! case {
    ($name:literal, $order:literal, $inputs:expr => $outputs:expr, |$x:ident| $body:expr
        $(, and $more:ident)?) => {{
        #[inline(always)]
        fn run<G: Group>(token: G::Token, input: &[f32], output: &mut [f32]) {
            sweep::<G, { $inputs }, { $outputs }>(
                token,
                input,
                output,
                #[inline(always)]
                |$x| $body,
            );
        }
        Case {
            name: $name,
            order: $order,
            inputs: $inputs,
            outputs: $outputs,
            sweeps: vec![
                (Path::Scalar, |i, o| run::<f32>((), i, o)),
                (Path::Eight, |i, o| enter!(simd => run::<Lanes8<_>>(simd, i, o))),
                (Path::Sixteen, |i, o| enter!(simd => run::<Lanes16<_>>(simd, i, o))),
                $((Path::$more, |i, o| enter!(_ => run::<$more>((), i, o))),)?
            ],
        }
    }};
}

/// The two vectors that lie one behind the other.
#[inline(always)]
fn pair<T, const C: usize>(x: &[T]) -> (&[T; C], &[T; C]) {
    let (f, g) = x.split_first_chunk().expect("two vectors");
    (f, g.first_chunk().expect("two vectors"))
}

macro_rules! order {
    ($n:literal, $c:literal, $pd:ident, $pr:ident, $sd:ident, $sr:ident) => {
        [
            case!("product", $n, 2 * $c => $c, |x| {
                let (f, g) = pair::<_, $c>(x);
                f.product(g)
            }, and Fused),
            case!("square", $n, $c => $c, |x| x.square(), and Fused),
            case!("basis", $n, 3 => $c, |x| Routines::basis(*x), and Fused),
            case!("add_cap_log", $n, $c + 5 => $c, |x| {
                let f: &[_; $c] = x.first_chunk().expect("a vector");
                let [sin, cos, d @ ..] = x.last_chunk::<5>().expect("a vector and five numbers");
                f.add_cap_log(*sin, *cos, *d)
            }, and Fused),
            case!("product/direct", $n, 2 * $c => $c, |x| {
                let (f, g) = pair(x);
                forms::$pd(f, g)
            }),
            case!("product/rings", $n, 2 * $c => $c, |x| {
                let (f, g) = pair(x);
                forms::$pr(f, g)
            }),
            case!("square/direct", $n, $c => $c, |x| forms::$sd(x)),
            case!("square/rings", $n, $c => $c, |x| forms::$sr(x)),
        ]
    };
}

/// Everything that is measured, by order. A build with debug assertions is one for tests, and stops at order 3:
/// compiling the rest takes minutes.
#[rustfmt::skip]
pub fn all() -> Vec<Case> {
    let mut cases = Vec::new();
    cases.extend(order!(2, 4, sh2_product_direct, sh2_product_rings, sh2_square_direct, sh2_square_rings));
    cases.extend(order!(3, 9, sh3_product_direct, sh3_product_rings, sh3_square_direct, sh3_square_rings));
    #[cfg(not(debug_assertions))]
    cases.extend(order!(4, 16, sh4_product_direct, sh4_product_rings, sh4_square_direct, sh4_square_rings));
    #[cfg(not(debug_assertions))]
    cases.extend(order!(5, 25, sh5_product_direct, sh5_product_rings, sh5_square_direct, sh5_square_rings));
    #[cfg(not(debug_assertions))]
    cases.extend(order!(6, 36, sh6_product_direct, sh6_product_rings, sh6_square_direct, sh6_square_rings));
    cases
}

/// The case of a routine and an order.
pub fn find(name: &str, order: usize) -> Option<Case> {
    all()
        .into_iter()
        .find(|case| case.name == name && case.order == order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::batch::numbers;

    /// Every path of a case and every form of a routine computes the same; 32 vectors, told apart by layout.
    #[test]
    fn what_is_compared_computes_the_same() {
        const VECTORS: usize = 32;
        if !is_here() {
            return;
        }
        for case in all() {
            let base = find(case.name.split('/').next().unwrap_or_default(), case.order)
                .expect("every form has its routine");
            let input = numbers(case.inputs * VECTORS);
            let mut expected = vec![0.0; case.outputs * VECTORS];
            base.sweep(Path::Scalar).expect("always measured")(&input, &mut expected);
            for (path, sweep) in &case.sweeps {
                let lanes = path.lanes();
                let mut output = vec![f32::NAN; case.outputs * VECTORS];
                sweep(&grouped(&input, case.inputs, lanes), &mut output);
                let expected = grouped(&expected, case.outputs, lanes);
                for (i, (a, b)) in output.iter().zip(&expected).enumerate() {
                    let near = (a - b).abs() <= 2e-5 * (1.0 + b.abs());
                    assert!(near, "{} {} {path:?} [{i}]: {a} {b}", case.name, case.order);
                }
            }
        }
    }

    /// An array of vectors of `size` numbers, in groups of `lanes`.
    fn grouped(vectors: &[f32], size: usize, lanes: usize) -> Vec<f32> {
        let group = |group: &[f32]| -> Vec<f32> {
            (0..size * lanes)
                .map(|k| group[k % lanes * size + k / lanes])
                .collect()
        };
        vectors.chunks_exact(size * lanes).flat_map(group).collect()
    }
}
