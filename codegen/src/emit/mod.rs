//! From graphs to text.

pub mod rust;
pub mod wgsl;

use crate::expr::{Graph, Id, Node, Value};
use crate::routines::Routine;

/// How a language writes what a graph contains.
pub(crate) trait Syntax {
    /// Element `index` of the routine's argument `argument`.
    fn input(&self, routine: &Routine, argument: usize, index: usize) -> String;
    fn constant(&self, value: f64) -> String;
    fn mul_add(&self, a: &str, b: &str, c: &str) -> String;
    /// A function of one or two numbers that both languages know by the same name.
    fn call(&self, function: &str, arguments: &[&str]) -> String;
    fn select(&self, a: &str, b: &str, then: &str, otherwise: &str) -> String;
}

/// The statements `let tN = …;` of a graph and the expressions of its outputs.
pub(crate) fn statements(
    graph: &Graph,
    routine: &Routine,
    syntax: &dyn Syntax,
) -> (String, Vec<String>) {
    let uses = graph.uses();
    let name = |id: Id| match graph.nodes[id] {
        Node::Input(argument, index) => syntax.input(routine, argument, index),
        Node::Constant(bits) => syntax.constant(f64::from_bits(bits)),
        _ => format!("t{id}"),
    };
    let signed = |v: Value| match graph.known(v) {
        Some(c) => syntax.constant(c),
        None if v.negative => format!("-{}", name(v.id)),
        None => name(v.id),
    };
    let negated = |id: Id, negative: bool| signed(Value { id, negative });
    let mut text = String::new();
    for (id, node) in graph.nodes.iter().enumerate() {
        if uses[id] == 0 {
            continue;
        }
        let expression = match *node {
            Node::Input(..) | Node::Constant(_) => continue,
            Node::Add(a, b) => format!("{} + {}", name(a), name(b)),
            Node::Sub(a, b) => format!("{} - {}", name(a), name(b)),
            Node::Mul(a, b) => format!("{} * {}", name(a), name(b)),
            Node::MulAdd(a, b, c, [product, term]) => {
                // The sign goes to a factor that is not a constant's receiver: `-(t1)` binds as written.
                syntax.mul_add(&negated(a, product), &name(b), &negated(c, term))
            }
            Node::Div(a, b) => format!("{} / {}", name(a), name(b)),
            Node::Sqrt(a) => syntax.call("sqrt", &[&name(a)]),
            Node::Min(a, b) => syntax.call("min", &[&signed(a), &signed(b)]),
            Node::Max(a, b) => syntax.call("max", &[&signed(a), &signed(b)]),
            Node::Exp(a) => syntax.call("exp", &[&signed(a)]),
            Node::Select(a, b, c, d) => syntax.select(&name(a), &name(b), &signed(c), &signed(d)),
        };
        text += &format!("    let t{id} = {expression};\n");
    }
    (text, graph.outputs.iter().map(|o| signed(*o)).collect())
}

/// Breaks a comma-separated list over lines of at most 100 columns.
pub(crate) fn wrapped(items: &[String], indent: &str) -> String {
    let mut text = String::new();
    let mut line = String::from(indent);
    for item in items {
        if line.len() + item.len() + 2 > 100 && line.trim() != "" {
            text += line.trim_end();
            text += "\n";
            line = indent.to_string();
        }
        line += item;
        line += ", ";
    }
    text + line.trim_end() + "\n"
}

/// A comment of words, broken over lines of at most 120 columns; `mark` begins each.
pub(crate) fn comment(words: &str, mark: &str) -> String {
    let mut text = String::new();
    let mut columns = 0;
    for word in words.split_whitespace() {
        let length = word.chars().count() + 1;
        if columns == 0 || columns + length > 120 {
            text += if columns == 0 { "" } else { "\n" };
            text += mark;
            columns = mark.len();
        }
        text += " ";
        text += word;
        columns += length;
    }
    text + "\n"
}
