//! Expression graphs: what a routine computes, before any language.
//!
//! A graph is built through [`Graph`]'s methods, which share equal subexpressions and fold what is known
//! (0, 1, signs). Signs live on the references to nodes, not in nodes: constants are positive, `c·x` and
//! `−c·x` are one node, and a negation costs nothing until an output needs it.

use std::collections::HashMap;

/// A node's place in its graph.
pub type Id = usize;

/// A reference to a node's value or to its negative.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub struct Value {
    /// The node.
    pub id: Id,
    /// Whether the value is the node's negative.
    pub negative: bool,
}

/// One operation. Operands of `Add` and `Mul` are in ascending order.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum Node {
    /// Element `1` of argument `0`.
    Input(usize, usize),
    /// A constant that is not negative, as bits of an f64.
    Constant(u64),
    /// Sum.
    Add(Id, Id),
    /// Difference.
    Sub(Id, Id),
    /// Product.
    Mul(Id, Id),
    /// `a · b + c`, as one operation where the target has it; `negate` the product, then the term.
    MulAdd(Id, Id, Id, [bool; 2]),
    /// Quotient.
    Div(Id, Id),
    /// Square root.
    Sqrt(Id),
    /// The smaller of both.
    Min(Value, Value),
    /// The larger of both.
    Max(Value, Value),
    /// e to the power of it.
    Exp(Value),
    /// If the first is less than the second then the third, else the fourth.
    Select(Id, Id, Value, Value),
}

/// Counted operations; a fused multiply-add is one of each, a division or a root one multiplication, a
/// minimum or maximum one addition.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Ops {
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
    /// Exponentials of numbers.
    pub exp: usize,
}

/// A directed acyclic graph of operations with its outputs.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// Nodes; operands come before their users.
    pub nodes: Vec<Node>,
    /// What the routine returns, in order.
    pub outputs: Vec<Value>,
    known: HashMap<Node, Id>,
}

impl Graph {
    fn node(&mut self, node: Node) -> Value {
        let nodes = &mut self.nodes;
        let id = *self.known.entry(node).or_insert_with(|| {
            nodes.push(node);
            nodes.len() - 1
        });
        Value {
            id,
            negative: false,
        }
    }

    /// Element `index` of argument `argument`.
    pub fn input(&mut self, argument: usize, index: usize) -> Value {
        self.node(Node::Input(argument, index))
    }

    /// All `count` elements of an argument.
    pub fn inputs(&mut self, argument: usize, count: usize) -> Vec<Value> {
        (0..count).map(|i| self.input(argument, i)).collect()
    }

    /// A constant.
    pub fn constant(&mut self, c: f64) -> Value {
        let value = self.node(Node::Constant(c.abs().to_bits()));
        Value {
            negative: c < 0.0,
            ..value
        }
    }

    /// The constant a value stands for, if it is one.
    pub fn known(&self, a: Value) -> Option<f64> {
        match self.nodes[a.id] {
            Node::Constant(bits) if a.negative => Some(-f64::from_bits(bits)),
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// `−a`.
    pub fn neg(&mut self, a: Value) -> Value {
        Value {
            negative: !a.negative,
            ..a
        }
    }

    /// `a + b`.
    pub fn add(&mut self, a: Value, b: Value) -> Value {
        match (self.known(a), self.known(b)) {
            (Some(x), Some(y)) => return self.constant(x + y),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            _ => {}
        }
        let (low, high) = (a.id.min(b.id), a.id.max(b.id));
        match (a.negative, b.negative) {
            (false, false) => self.node(Node::Add(low, high)),
            (true, true) => Value {
                negative: true,
                ..self.node(Node::Add(low, high))
            },
            (false, true) => self.difference(a.id, b.id),
            (true, false) => self.difference(b.id, a.id),
        }
    }

    /// One node serves `a − b` and `b − a`.
    fn difference(&mut self, a: Id, b: Id) -> Value {
        if let Some(&id) = self.known.get(&Node::Sub(b, a)) {
            return Value { id, negative: true };
        }
        self.node(Node::Sub(a, b))
    }

    /// `a − b`.
    pub fn sub(&mut self, a: Value, b: Value) -> Value {
        let b = self.neg(b);
        self.add(a, b)
    }

    /// `a · b`.
    pub fn mul(&mut self, a: Value, b: Value) -> Value {
        let negative = a.negative != b.negative;
        match (self.known(a), self.known(b)) {
            (Some(x), Some(y)) => return self.constant(x * y),
            (Some(0.0), _) | (_, Some(0.0)) => return self.constant(0.0),
            (Some(x), _) if x.abs() == 1.0 => return Value { id: b.id, negative },
            (_, Some(y)) if y.abs() == 1.0 => return Value { id: a.id, negative },
            _ => {}
        }
        let value = self.node(Node::Mul(a.id.min(b.id), a.id.max(b.id)));
        Value { negative, ..value }
    }

    /// `c · a`.
    pub fn scale(&mut self, c: f64, a: Value) -> Value {
        let c = self.constant(c);
        self.mul(c, a)
    }

    /// `a · b + c`, never sharing the product with another operation: one instruction where the target
    /// fuses.
    pub fn mul_add(&mut self, a: Value, b: Value, c: Value) -> Value {
        let known = |g: &Self, v| g.known(v).is_some_and(|x| x == 0.0 || x.abs() == 1.0);
        if known(self, a) || known(self, b) || self.known(c) == Some(0.0) {
            let product = self.mul(a, b);
            return self.add(product, c);
        }
        let (low, high) = (a.id.min(b.id), a.id.max(b.id));
        let negate = a.negative != b.negative;
        if negate && c.negative {
            let value = self.node(Node::MulAdd(low, high, c.id, [false, false]));
            return Value {
                negative: true,
                ..value
            };
        }
        self.node(Node::MulAdd(low, high, c.id, [negate, c.negative]))
    }

    /// `a / b`.
    pub fn div(&mut self, a: Value, b: Value) -> Value {
        let value = self.node(Node::Div(a.id, b.id));
        Value {
            negative: a.negative != b.negative,
            ..value
        }
    }

    /// `√a`, for a value that carries no sign.
    pub fn sqrt(&mut self, a: Value) -> Value {
        assert!(!a.negative, "the root of a negated node");
        self.node(Node::Sqrt(a.id))
    }

    /// The smaller of `a` and `b`.
    pub fn min(&mut self, a: Value, b: Value) -> Value {
        self.node(Node::Min(a, b))
    }

    /// The larger of `a` and `b`.
    pub fn max(&mut self, a: Value, b: Value) -> Value {
        self.node(Node::Max(a, b))
    }

    /// `e^a`.
    pub fn exp(&mut self, a: Value) -> Value {
        self.node(Node::Exp(a))
    }

    /// `then` where `a < b`, `otherwise` elsewhere; `a` and `b` must carry no sign.
    pub fn select(&mut self, a: Value, b: Value, then: Value, otherwise: Value) -> Value {
        assert!(!a.negative && !b.negative, "a comparison of negated nodes");
        self.node(Node::Select(a.id, b.id, then, otherwise))
    }

    /// The sum of all; 0 for none.
    pub fn sum(&mut self, terms: &[Value]) -> Value {
        let mut total = self.constant(0.0);
        for term in terms {
            total = self.add(total, *term);
        }
        total
    }

    /// `Σ aᵢ bᵢ` as a chain of fused operations.
    pub fn dot(&mut self, a: &[Value], b: &[Value]) -> Value {
        let mut total = self.constant(0.0);
        for (a, b) in a.iter().zip(b) {
            total = self.mul_add(*a, *b, total);
        }
        total
    }

    /// A polynomial, lowest power first, by Horner's rule.
    pub fn horner(&mut self, coefficients: &[f64], x: Value) -> Value {
        let mut value = self.constant(0.0);
        for c in coefficients.iter().rev() {
            let c = self.constant(*c);
            value = self.mul_add(value, x, c);
        }
        value
    }

    /// The nodes an operation reads.
    pub fn operands(node: &Node) -> Vec<Id> {
        match *node {
            Node::Input(..) | Node::Constant(_) => vec![],
            Node::Add(a, b) | Node::Sub(a, b) | Node::Mul(a, b) | Node::Div(a, b) => vec![a, b],
            Node::MulAdd(a, b, c, _) => vec![a, b, c],
            Node::Sqrt(a) => vec![a],
            Node::Min(a, b) | Node::Max(a, b) => vec![a.id, b.id],
            Node::Exp(a) => vec![a.id],
            Node::Select(a, b, c, d) => vec![a, b, c.id, d.id],
        }
    }

    /// How often each node is read by operations and outputs that are needed; 0 for what is not needed.
    pub fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.nodes.len()];
        for output in &self.outputs {
            uses[output.id] += 1;
        }
        for id in (0..self.nodes.len()).rev() {
            if uses[id] > 0 {
                for operand in Self::operands(&self.nodes[id]) {
                    uses[operand] += 1;
                }
            }
        }
        uses
    }

    /// Counts the operations that are needed.
    pub fn ops(&self) -> Ops {
        let mut ops = Ops::default();
        for (node, uses) in self.nodes.iter().zip(self.uses()) {
            if uses == 0 {
                continue;
            }
            match node {
                Node::Add(..) | Node::Sub(..) | Node::Min(..) | Node::Max(..) => ops.add += 1,
                Node::Exp(_) => ops.exp += 1,
                Node::Mul(..) | Node::Div(..) | Node::Sqrt(_) => ops.mul += 1,
                Node::MulAdd(..) => {
                    ops.mul += 1;
                    ops.add += 1;
                }
                Node::Input(..) | Node::Constant(_) | Node::Select(..) => {}
            }
        }
        ops
    }

    /// Fuses every product that only one sum reads into that sum. Counts stay as they are.
    pub fn fuse(&mut self) {
        let mut uses = self.uses();
        for id in 0..self.nodes.len() {
            let single = |id: Id| match self.nodes[id] {
                Node::Mul(a, b) if uses[id] == 1 => Some((a, b)),
                _ => None,
            };
            let fused = match self.nodes[id] {
                Node::Add(a, b) => single(b)
                    .map(|(x, y)| (b, Node::MulAdd(x, y, a, [false, false])))
                    .or(single(a).map(|(x, y)| (a, Node::MulAdd(x, y, b, [false, false])))),
                Node::Sub(a, b) => single(b)
                    .map(|(x, y)| (b, Node::MulAdd(x, y, a, [true, false])))
                    .or(single(a).map(|(x, y)| (a, Node::MulAdd(x, y, b, [false, true])))),
                _ => None,
            };
            if let (Some((product, node)), true) = (fused, uses[id] > 0) {
                self.nodes[id] = node;
                uses[product] = 0;
            }
        }
        self.known.clear();
    }

    /// The outputs for given inputs, in f64.
    pub fn evaluate(&self, arguments: &[&[f64]]) -> Vec<f64> {
        let mut v: Vec<f64> = Vec::with_capacity(self.nodes.len());
        let signed = |v: &[f64], x: Value| if x.negative { -v[x.id] } else { v[x.id] };
        let flip = |x: f64, negative: bool| if negative { -x } else { x };
        for node in &self.nodes {
            let value = match *node {
                Node::Input(a, i) => arguments[a][i],
                Node::Constant(bits) => f64::from_bits(bits),
                Node::Add(a, b) => v[a] + v[b],
                Node::Sub(a, b) => v[a] - v[b],
                Node::Mul(a, b) => v[a] * v[b],
                Node::MulAdd(a, b, c, [p, t]) => flip(v[a] * v[b], p) + flip(v[c], t),
                Node::Div(a, b) => v[a] / v[b],
                Node::Sqrt(a) => v[a].sqrt(),
                Node::Min(a, b) => signed(&v, a).min(signed(&v, b)),
                Node::Max(a, b) => signed(&v, a).max(signed(&v, b)),
                Node::Exp(a) => signed(&v, a).exp(),
                Node::Select(a, b, c, d) => signed(&v, if v[a] < v[b] { c } else { d }),
            };
            v.push(value);
        }
        self.outputs.iter().map(|o| signed(&v, *o)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_across_signs() {
        let mut g = Graph::default();
        let (x, y) = (g.input(0, 0), g.input(0, 1));
        let a = g.scale(3.0, x);
        let b = g.scale(-3.0, x);
        assert_eq!((a.id, b.negative), (b.id, true));
        let (d, e) = (g.sub(x, y), g.sub(y, x));
        assert_eq!((d.id, e.negative), (e.id, true));
    }

    #[test]
    fn fusing_keeps_values_and_counts() {
        let mut g = Graph::default();
        let (x, y, z) = (g.input(0, 0), g.input(0, 1), g.input(0, 2));
        let xy = g.mul(x, y);
        let a = g.sub(z, xy);
        let xz = g.mul(x, z);
        let b = g.sub(xz, y);
        g.outputs = vec![a, b];
        let (before, ops) = (g.evaluate(&[&[2.0, 3.0, 5.0]]), g.ops());
        g.fuse();
        assert_eq!((g.evaluate(&[&[2.0, 3.0, 5.0]]), g.ops()), (before, ops));
        assert_eq!(
            ops,
            Ops {
                mul: 2,
                add: 2,
                exp: 0
            }
        );
        assert!(
            g.nodes
                .iter()
                .filter(|n| matches!(n, Node::MulAdd(..)))
                .count()
                == 2
        );
    }
}
