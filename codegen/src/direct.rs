//! SH products term by term: the nonzero Gaunt coefficients, factored over pairs.
//!
//! Every unique coefficient Γ_ijk with distinct i, j, k adds six terms to a product. They are cheap to
//! evaluate together for all i that share a pair (j, k) (Snyder 2006, MSR-TR-2006-53):
//!
//! ```text
//! t  = f_j g_k + f_k g_j          h_i += Γ_ijk t               for every i
//! tf = Σ_i Γ_ijk f_i              h_j += tf g_k + tg f_k
//! tg = Σ_i Γ_ijk g_i              h_k += tf g_j + tg f_j
//! ```
//!
//! A pair costs 6 multiplications and a coefficient 3, so the fewer pairs cover all coefficients, the
//! better: they are chosen greedily, the pair that covers most first. Pairs (j, j) cover Γ_ijj. Constants
//! are exact, so that products `Γ f_i` that several pairs need are one.

use crate::exact::gaunt;
use crate::expr::{Graph, Value};
use crate::real::Real;
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// A unique coefficient with its value.
#[derive(Clone, Copy, Debug)]
pub struct Triple {
    /// Ascending indices.
    pub index: [usize; 3],
    /// Γ.
    pub value: f64,
}

/// All nonzero unique coefficients of an order, in ascending order of indices. Computed once: most routines
/// need them, and build scripts run unoptimised.
pub fn triples(order: usize) -> &'static [Triple] {
    static TRIPLES: [OnceLock<Vec<Triple>>; 16] = [const { OnceLock::new() }; 16];
    TRIPLES[order].get_or_init(|| compute(order))
}

fn compute(order: usize) -> Vec<Triple> {
    let c = order * order;
    let root_pi = Real::PI.sqrt();
    let mut out = Vec::new();
    for i in 0..c {
        for j in i..c {
            for k in j..c {
                let root = gaunt(i, j, k);
                if root.sign != 0 {
                    out.push(Triple {
                        index: [i, j, k],
                        value: (root.real() / root_pi).to_f64(),
                    });
                }
            }
        }
    }
    out
}

/// A pair of factors and the third indices it serves.
#[derive(Clone, Debug)]
struct Pair {
    factors: [usize; 2],
    thirds: Vec<(usize, f64)>,
}

/// The ways to read a triple as (pair, third).
fn readings([i, j, k]: [usize; 3]) -> Vec<([usize; 2], usize)> {
    if i == j && j == k {
        vec![([i, i], i)]
    } else if i == j {
        vec![([i, i], k)]
    } else if j == k {
        vec![([j, j], i)]
    } else {
        vec![([i, j], k), ([i, k], j), ([j, k], i)]
    }
}

/// Assigns every coefficient to one pair, few pairs in all.
fn cover(triples: &[Triple]) -> Vec<Pair> {
    let mut left: BTreeSet<usize> = (0..triples.len()).collect();
    let mut pairs = Vec::new();
    while !left.is_empty() {
        let mut counts = std::collections::BTreeMap::<[usize; 2], Vec<usize>>::new();
        for &t in &left {
            for (pair, _) in readings(triples[t].index) {
                counts.entry(pair).or_default().push(t);
            }
        }
        let (factors, served) = counts
            .into_iter()
            .max_by_key(|(pair, served)| {
                (pair[0] == pair[1], served.len(), std::cmp::Reverse(*pair))
            })
            .expect("every coefficient has a reading");
        let third = |t: usize| {
            readings(triples[t].index)
                .into_iter()
                .find(|r| r.0 == factors)
                .expect("counted above")
                .1
        };
        pairs.push(Pair {
            factors,
            thirds: served
                .iter()
                .map(|&t| (third(t), triples[t].value))
                .collect(),
        });
        for t in served {
            left.remove(&t);
        }
    }
    pairs
}

/// Terms that are added up at the end.
struct Sums(Vec<Option<Value>>);

impl Sums {
    fn add(&mut self, g: &mut Graph, i: usize, v: Value) {
        self.0[i] = Some(self.0[i].map_or(v, |s| g.add(s, v)));
    }
    fn finish(self, g: &mut Graph) -> Vec<Value> {
        self.0
            .into_iter()
            .map(|s| s.unwrap_or_else(|| g.constant(0.0)))
            .collect()
    }
}

/// `h = f * g`. Inputs that are the constant 0 drop out.
pub fn product(g: &mut Graph, order: usize, a: &[Value], b: &[Value]) -> Vec<Value> {
    let mut out = Sums(vec![None; order * order]);
    for Pair {
        factors: [j, k],
        thirds,
    } in cover(triples(order))
    {
        let weighted = |g: &mut Graph, x: &[Value]| {
            let terms: Vec<_> = thirds.iter().filter(|t| j != k || t.0 != j).collect();
            let products: Vec<_> = terms.iter().map(|t| g.scale(t.1, x[t.0])).collect();
            g.sum(&products)
        };
        let (wa, wb) = (weighted(g, a), weighted(g, b));
        let both = |g: &mut Graph, x: usize, y: usize| {
            let (p, q) = (g.mul(a[x], b[y]), g.mul(a[y], b[x]));
            if x == y { p } else { g.add(p, q) }
        };
        let cross = |g: &mut Graph, y: usize| {
            let (p, q) = (g.mul(wa, b[y]), g.mul(wb, a[y]));
            g.add(p, q)
        };
        let t = both(g, j, k);
        for (i, value) in &thirds {
            let term = g.scale(*value, t);
            out.add(g, *i, term);
        }
        if thirds.iter().any(|t| j != k || t.0 != j) {
            let term = cross(g, k);
            out.add(g, j, term);
            if j != k {
                let term = cross(g, j);
                out.add(g, k, term);
            }
        }
    }
    out.finish(g)
}

/// `h = f * f`: the product with both factors alike, its doublings folded into shared sums.
pub fn square(g: &mut Graph, order: usize, a: &[Value]) -> Vec<Value> {
    let mut out = Sums(vec![None; order * order]);
    for Pair {
        factors: [j, k],
        thirds,
    } in cover(triples(order))
    {
        // tf is needed doubled only (h_j += 2 tf f_k), t as 2 f_j f_k: double the constants instead.
        let terms: Vec<_> = thirds.iter().filter(|t| j != k || t.0 != j).collect();
        let products: Vec<_> = terms.iter().map(|t| g.scale(2.0 * t.1, a[t.0])).collect();
        let weighted = g.sum(&products);
        let t = g.mul(a[j], a[k]);
        for (i, value) in &thirds {
            let term = g.scale(if j == k { *value } else { 2.0 * value }, t);
            out.add(g, *i, term);
        }
        if !terms.is_empty() {
            let term = g.mul(weighted, a[k]);
            out.add(g, j, term);
            if j != k {
                let term = g.mul(weighted, a[j]);
                out.add(g, k, term);
            }
        }
    }
    out.finish(g)
}

/// The symmetric product matrix M_f, (M_f)_ij = Σ_k Γ_ijk f_k (Ren et al. 2006, eq. 5): its lower
/// triangle, row by row.
pub fn matrix(g: &mut Graph, order: usize, a: &[Value]) -> Vec<Value> {
    let c = order * order;
    let mut out = Sums(vec![None; c * (c + 1) / 2]);
    for &Triple {
        index: [i, j, k],
        value,
    } in triples(order)
    {
        let mut entries = BTreeSet::new();
        for (row, column, with) in [(k, j, i), (k, i, j), (j, i, k)] {
            entries.insert((row * (row + 1) / 2 + column, with));
        }
        for (entry, with) in entries {
            let term = g.scale(value, a[with]);
            out.add(g, entry, term);
        }
    }
    out.finish(g)
}
