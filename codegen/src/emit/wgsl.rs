//! WGSL: plain functions on arrays by value, one flat text an order.
//!
//! Public names end in a letter (`sh4_product`), because translators rename what ends in a digit.

use super::{Syntax, comment, statements, wrapped};
use crate::constants::{Constant, Value};
use crate::fits;
use crate::routines::{ROUTINES, Routine, Shape};

struct Wgsl;

impl Syntax for Wgsl {
    fn input(&self, routine: &Routine, argument: usize, index: usize) -> String {
        let (name, shape) = routine.arguments[argument];
        match shape {
            Shape::Scalar => parameter(name).to_string(),
            Shape::Direction | Shape::Quaternion => {
                format!("{}.{}", parameter(name), ["x", "y", "z", "w"][index])
            }
            _ => format!("{}[{index}]", parameter(name)),
        }
    }
    fn constant(&self, value: f64) -> String {
        let value = value as f32;
        if value < 0.0 {
            format!("({value:?})")
        } else {
            format!("{value:?}")
        }
    }
    fn mul_add(&self, a: &str, b: &str, c: &str) -> String {
        format!("fma({a}, {b}, {c})")
    }
    fn call(&self, function: &str, arguments: &[&str]) -> String {
        format!("{function}({})", arguments.join(", "))
    }
    fn select(&self, a: &str, b: &str, then: &str, otherwise: &str) -> String {
        format!("select({otherwise}, {then}, {a} < {b})")
    }
}

/// `cos` and `sin` are built-in functions in WGSL.
fn parameter(name: &str) -> &str {
    match name {
        "cos" => "cosine",
        "sin" => "sine",
        other => other,
    }
}

fn wgsl_type(shape: Shape, order: usize) -> String {
    match shape {
        Shape::Scalar => "f32".to_string(),
        Shape::Pair => "vec2<f32>".to_string(),
        Shape::Direction => "vec3<f32>".to_string(),
        Shape::Quaternion => "vec4<f32>".to_string(),
        _ => format!("array<f32, {}>", shape.len(order)),
    }
}

/// One routine as a WGSL function called `sh{order}_{name}`.
pub fn function(routine: &Routine, order: usize) -> String {
    let graph = routine.graph(order);
    let ops = graph.ops();
    let (body, outputs) = statements(&graph, routine, &Wgsl);
    let arguments: Vec<_> = routine
        .arguments
        .iter()
        .map(|(name, shape)| format!("{}: {}", parameter(name), wgsl_type(*shape, order)))
        .collect();
    let result = wgsl_type(routine.result, order);
    let value = match routine.result {
        Shape::Scalar => format!("    return {};\n", outputs[0]),
        _ => format!(
            "    return {result}(\n{}    );\n",
            wrapped(&outputs, "        ")
        ),
    };
    let mut doc = String::new();
    for line in routine
        .doc
        .lines()
        .chain([format!("Source: {}", routine.source).as_str()])
    {
        doc += format!("// {line}").trim_end();
        doc += "\n";
    }
    format!(
        "{doc}// {} multiplications, {} additions.\nfn sh{order}_{}({}) -> {result} {{\n{body}{value}}}\n",
        ops.mul,
        ops.add,
        routine.name,
        arguments.join(", ")
    )
}

/// The table of the eigen logarithm, as a function of the row that halves the table until one row is left. A constant
/// array would do, but translators copy it whole, number by number, each time it is indexed; and of a switch with so
/// many cases a software driver makes nested branches, deeper than it can.
fn cap_log_row(order: usize) -> String {
    let result = format!("array<f32, {order}>");
    let table = fits::cap_log_table(order);
    let last = table.len() - 1;
    let mut body = String::new();
    halve(&table, 0, 1, &result, &mut body);
    format!(
        "// Zonal coefficients of the eigen logarithm of the visibility past a circular blocker about +Z whose angular radius\n\
         // is a whole number of degrees, 0..={last}; beyond that as at {last}. The rows of the table behind `cap_log_table`.\n\
         // Source: Ren et al. 2006, eq. 30-32, clipped at 0.02; `gaunt-lab fit` computes it.\n\
         fn sh{order}_cap_log_row(row: u32) -> {result} {{\n    var z = {result}();\n{body}    return z;\n}}\n"
    )
}

/// Statements that set `z` to one of some rows, of which the first has the number `first`.
fn halve(rows: &[Vec<f64>], first: usize, depth: usize, array: &str, text: &mut String) {
    let indent = "    ".repeat(depth);
    if let [row] = rows {
        let numbers: Vec<_> = row.iter().map(|x| format!("{:?}", *x as f32)).collect();
        *text += &format!("{indent}z = {array}({});\n", numbers.join(", "));
        return;
    }
    let (low, high) = rows.split_at(rows.len() / 2);
    let middle = first + low.len();
    *text += &format!("{indent}if (row < {middle}u) {{\n");
    halve(low, first, depth + 1, array, text);
    *text += &format!("{indent}}} else {{\n");
    halve(high, middle, depth + 1, array, text);
    *text += &format!("{indent}}}\n");
}

/// All routines of an order, and the table of logarithms.
pub fn library(order: usize) -> String {
    let mut functions: Vec<_> = ROUTINES.iter().map(|r| function(r, order)).collect();
    functions.push(cap_log_row(order));
    format!(
        "// @generated by sh-codegen from codegen/src/routines.rs: spherical harmonics of order {order}.\n\
         // Index l*l + l + m, real orthonormal basis without Condon-Shortley sign, y1 = sqrt(3/4pi) (y, z, x).\n\n{}",
        functions.join("\n")
    )
}

/// A shared constant as a `const` with a comment.
pub fn constant(constant: &Constant) -> String {
    let single = |value: f32| ("f32", format!("{value:?}"));
    let count = |value: usize| ("u32", format!("{value}u"));
    let (kind, value) = match constant.value {
        Value::Double(value) => single(value as f32),
        Value::Single(value) => single(value),
        Value::Count(value) => count(value),
        Value::Word(value) => count(value as usize),
        Value::Byte(value) => count(value.into()),
    };
    let doc = comment(constant.doc, "//");
    format!("{doc}const {}: {kind} = {value};\n", constant.name)
}

/// All constants that Rust shares.
pub fn constants() -> String {
    super::constants(constant)
}
