//! Rust: generic functions over `Lane`, and the trait `Routines` that finds them by vector length.

use super::{Syntax, comment, statements, wrapped};
use crate::constants::{Constant, Value};
use crate::expr::Graph;
use crate::fits;
use crate::routines::{ORDERS, ROUTINES, Routine, Shape};

struct Rust;

impl Syntax for Rust {
    fn input(&self, routine: &Routine, argument: usize, index: usize) -> String {
        let (name, shape) = routine.arguments[argument];
        if shape == Shape::Scalar {
            name.to_string()
        } else {
            format!("{name}[{index}]")
        }
    }
    fn constant(&self, value: f64) -> String {
        format!("k.lift({value:?})")
    }
    fn mul_add(&self, a: &str, b: &str, c: &str) -> String {
        match a.strip_prefix('-') {
            Some(a) if !a.starts_with("k.lift") => format!("(-{a}).mul_add({b}, {c})"),
            _ => format!("{a}.mul_add({b}, {c})"),
        }
    }
    fn call(&self, function: &str, arguments: &[&str]) -> String {
        let (first, rest) = (arguments[0], arguments[1..].join(", "));
        match first.strip_prefix('-') {
            Some(_) => format!("({first}).{function}({rest})"),
            None => format!("{first}.{function}({rest})"),
        }
    }
    fn select(&self, a: &str, b: &str, then: &str, otherwise: &str) -> String {
        format!("L::select({a}.lt({b}), {then}, {otherwise})")
    }
}

fn rust_type(shape: Shape, order: usize) -> String {
    match shape {
        Shape::Scalar => "L".to_string(),
        _ => format!("[L; {}]", shape.len(order)),
    }
}

/// Vectors and matrices come by reference, small things by value.
fn by_reference(shape: Shape) -> bool {
    matches!(shape, Shape::Vector | Shape::Triangle)
}

/// One routine as a Rust function called `{prefix}{order}_{name}`, generic over a `Lane` type `L`.
pub fn function(routine: &Routine, order: usize, prefix: &str) -> String {
    print(routine, order, prefix, &routine.graph(order))
}

fn print(routine: &Routine, order: usize, prefix: &str, graph: &Graph) -> String {
    let ops = graph.ops();
    let (body, outputs) = statements(graph, routine, &Rust);
    let arguments: Vec<_> = routine
        .arguments
        .iter()
        .map(|(name, shape)| {
            let r = if by_reference(*shape) { "&" } else { "" };
            format!("{name}: {r}{}", rust_type(*shape, order))
        })
        .collect();
    let (first, shape) = routine.arguments[0];
    let witness = if shape == Shape::Scalar {
        first.to_string()
    } else {
        format!("{first}[0]")
    };
    let witness = if body.contains("k.lift") || outputs.iter().any(|o| o.contains("k.lift")) {
        format!("    let k = {witness};\n")
    } else {
        String::new()
    };
    let result = match routine.result {
        Shape::Scalar => format!("    {}\n", outputs[0]),
        _ => format!("    [\n{}    ]\n", wrapped(&outputs, "        ")),
    };
    format!(
        "/// `{}` at order {order}: {} multiplications, {} additions.\n#[inline(always)]\npub fn {prefix}{order}_{}<L: Lane>({}) -> {} {{\n{witness}{body}{result}}}\n",
        routine.name,
        ops.mul,
        ops.add,
        routine.name.replace('/', "_"),
        arguments.join(", "),
        rust_type(routine.result, order),
    )
}

fn trait_type(shape: Shape) -> &'static str {
    match shape {
        Shape::Scalar => "L",
        Shape::Pair => "[L; 2]",
        Shape::Direction => "[L; 3]",
        Shape::Quaternion => "[L; 4]",
        Shape::Matrix3 => "[L; 9]",
        Shape::Zonal => "Self::Zonal",
        Shape::Vector => "Self",
        Shape::Triangle => "Self::Triangle",
    }
}

/// A method's signature, from its name to its result; a leading SH vector becomes `&self`.
fn signature(routine: &Routine) -> String {
    let arguments: Vec<_> = routine
        .arguments
        .iter()
        .enumerate()
        .map(|(i, (name, shape))| match (i, shape) {
            (0, Shape::Vector) => "&self".to_string(),
            _ => {
                let r = if by_reference(*shape) { "&" } else { "" };
                format!("{name}: {r}{}", trait_type(*shape))
            }
        })
        .collect();
    format!(
        "fn {}({}) -> {}",
        routine.name,
        arguments.join(", "),
        trait_type(routine.result)
    )
}

fn doc(routine: &Routine, graphs: &[Graph], indent: &str) -> String {
    let mut text = String::new();
    for line in routine
        .doc
        .lines()
        .chain(["", &format!("Source: {}", routine.source)])
    {
        text += format!("{indent}/// {line}").trim_end();
        text += "\n";
    }
    let counts: Vec<_> = graphs
        .iter()
        .map(|graph| {
            let ops = graph.ops();
            format!("{}/{}", ops.mul, ops.add)
        })
        .collect();
    text += &format!(
        "{indent}///\n{indent}/// Multiplications/additions for orders 2 to 6: {}.\n{indent}///\n",
        counts.join(", ")
    );
    for line in ["```", "use sh_core::Routines;"]
        .into_iter()
        .chain(routine.example.lines())
        .chain(["```"])
    {
        text += &format!("{indent}/// {line}\n");
    }
    text
}

/// The trait up to its first routine.
const HEAD: &str = "\
/// What is generated for every order, found by the length of a coefficient array.
///
/// Implemented for `[L; 4]`, `[L; 9]`, `[L; 16]`, `[L; 25]` and `[L; 36]`: orders 2 to 6.
///
/// ```
/// use sh_core::{Lane, Routines};
/// /// For any order, in scalar numbers and in vector lanes.
/// fn reflected<L: Lane, const C: usize>(light: &[L; C], normal: [L; 3]) -> L
/// where
///     [L; C]: Routines<L>,
/// {
///     light.dot(&<[L; C]>::cosine(normal))
/// }
/// let sky = [sh_core::ROOT_FOUR_PI, 0.0, 0.0, 0.0];
/// assert!((reflected(&sky, [0.0, 1.0, 0.0]) - 1.0).abs() < 1e-12);
/// ```
pub trait Routines<L: Lane>: Copy + AsRef<[L]> + AsMut<[L]> {
    /// The order n.
    ///
    /// ```
    /// use sh_core::Routines;
    /// assert_eq!(<[f32; 16]>::ORDER, 4);
    /// ```
    const ORDER: usize;
    /// n coefficients, one a band.
    ///
    /// ```
    /// use sh_core::Routines;
    /// let z: <[f32; 16] as Routines<f32>>::Zonal = [1.0, 0.5, 0.25, 0.0];
    /// assert!((<[f32; 16]>::zonal(z, [0.0, 0.0, 1.0])[6] - 0.25).abs() < 1e-6);
    /// ```
    type Zonal: Copy + AsRef<[L]> + AsMut<[L]>;
    /// The lower triangle of a symmetric n² × n² matrix.
    ///
    /// ```
    /// use sh_core::Routines;
    /// let triangle: <[f32; 4] as Routines<f32>>::Triangle = [1.0, 0.0, 0.0, 0.0].product_matrix();
    /// assert_eq!(triangle.len(), 10);
    /// ```
    type Triangle: Copy + AsRef<[L]> + AsMut<[L]>;
    /// `value` in every coefficient.
    ///
    /// ```
    /// use sh_core::Routines;
    /// assert_eq!(<[f32; 4]>::filled(2.0), [2.0; 4]);
    /// ```
    fn filled(value: L) -> Self;
    /// A zonal vector; `value` tells its coefficient of each band.
    ///
    /// ```
    /// use sh_core::Routines;
    /// assert_eq!(<[f32; 9]>::zonal_from(|l| l as f32), [0.0, 1.0, 2.0]);
    /// ```
    fn zonal_from(value: impl Fn(usize) -> L) -> Self::Zonal;
";

/// Everything that sh-core includes: the trait, its implementations, the functions, the table of logs.
pub fn library() -> String {
    let graphs: Vec<Vec<Graph>> = ROUTINES
        .iter()
        .map(|r| ORDERS.map(|order| r.graph(order)).collect())
        .collect();
    let mut text = String::from(
        "// @generated by sh-codegen from codegen/src/routines.rs; rebuilt with this crate.\n\n",
    );
    text += HEAD;
    for (routine, graphs) in ROUTINES.iter().zip(&graphs) {
        text += &format!(
            "{}    {};\n",
            doc(routine, graphs, "    "),
            signature(routine)
        );
    }
    text += "}\n\n";
    for order in ORDERS {
        let c = order * order;
        text += &format!(
            "impl<L: Lane> Routines<L> for [L; {c}] {{\n    const ORDER: usize = {order};\n    type Zonal = [L; {order}];\n    type Triangle = [L; {}];\n    #[inline(always)]\n    fn filled(value: L) -> Self {{\n        [value; {c}]\n    }}\n    #[inline(always)]\n    fn zonal_from(value: impl Fn(usize) -> L) -> Self::Zonal {{\n        [{}]\n    }}\n",
            c * (c + 1) / 2,
            (0..order)
                .map(|l| format!("value({l})"))
                .collect::<Vec<_>>()
                .join(", ")
        );
        for routine in ROUTINES {
            let names: Vec<_> = routine
                .arguments
                .iter()
                .enumerate()
                .map(|(i, (name, shape))| {
                    if i == 0 && *shape == Shape::Vector {
                        "self"
                    } else {
                        name
                    }
                })
                .collect();
            text += &format!(
                "    #[inline(always)]\n    {} {{\n        sh{order}_{}({})\n    }}\n",
                signature(routine),
                routine.name,
                names.join(", ")
            );
        }
        text += "}\n\n";
        for (routine, graphs) in ROUTINES.iter().zip(&graphs) {
            text += &print(routine, order, "sh", &graphs[order - ORDERS.start()]);
            text += "\n";
        }
        let table = fits::cap_log_table(order);
        text += &format!(
            "/// The eigen logarithm of a cap's visibility at every whole degree 0..=179, order {order}.\npub static CAP_LOG_TABLE_{order}: [[f64; {order}]; {}] = [\n",
            table.len()
        );
        for row in table {
            text += &format!("    {row:?},\n");
        }
        text += "];\n\n";
        text += &format!(
            "/// The fitted logarithms of a cap's visibility by what they are fitted to, order {order}: for each band, powers of 2 cos θ − 1.\npub static CAP_LOG_FITS_{order}: [(&str, [&[f64]; {order}]); {}] = [\n",
            fits::CAP_LOGS.len()
        );
        for name in fits::CAP_LOGS {
            let bands: Vec<_> = fits::cap_log_coefficients(name, order)
                .iter()
                .map(|band| format!("&{band:?}"))
                .collect();
            text += &format!("    ({name:?}, [{}]),\n", bands.join(", "));
        }
        text += "];\n\n";
    }
    text
}

/// A shared constant as a documented `pub const`.
pub fn constant(constant: &Constant) -> String {
    let (kind, value) = match constant.value {
        Value::Double(value) => ("f64", format!("{value:?}")),
        Value::Single(value) => ("f32", format!("{value:?}")),
        Value::Count(value) => ("usize", value.to_string()),
        Value::Word(value) => ("u32", value.to_string()),
        Value::Byte(value) => ("u8", value.to_string()),
    };
    let doc = comment(constant.doc, "///");
    format!("{doc}pub const {}: {kind} = {value};\n", constant.name)
}

/// All constants that kernels share.
pub fn constants() -> String {
    super::constants(constant)
}
