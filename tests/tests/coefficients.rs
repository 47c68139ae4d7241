//! Every generated constant matters: with its sign flipped, a routine no longer gives the truth.

use sh_codegen::expr::Node;
use sh_codegen::routines::{FORMS, ORDERS, ROUTINES, Routine};
use sh_tests::{case, truth::truth};

/// `product/rings` has the truth of `product`.
fn wanted(routine: &Routine, order: usize, arguments: &[Vec<f64>]) -> Vec<f64> {
    let name = routine
        .name
        .split('/')
        .next()
        .expect("a split has a first part");
    truth(name, order, arguments).expect("every routine has a truth")
}

fn evaluate(graph: &sh_codegen::expr::Graph, arguments: &[Vec<f64>]) -> Vec<f64> {
    let slices: Vec<&[f64]> = arguments.iter().map(Vec::as_slice).collect();
    graph.evaluate(&slices)
}

fn differs(got: &[f64], want: &[f64]) -> bool {
    got.iter()
        .zip(want)
        .any(|(g, w)| (g - w).abs() > 1e-12 || !g.is_finite())
}

/// Up to `most` places of constants in use, evenly spread. The last terms of the window's cosine, below 1e-15,
/// are beyond what the f64 truth can see.
fn constants(graph: &sh_codegen::expr::Graph, most: usize) -> Vec<usize> {
    let uses = graph.uses();
    let all: Vec<usize> = (0..graph.nodes.len())
        .filter(|id| {
            uses[*id] > 0
                && matches!(graph.nodes[*id], Node::Constant(bits) if visible(f64::from_bits(bits)))
        })
        .collect();
    let step = all.len().div_ceil(most).max(1);
    all.into_iter().step_by(step).collect()
}

fn visible(constant: f64) -> bool {
    // 1e-36 is a threshold, not a term. 1e-12 guards a division whose outcome is multiplied with 0: what is not a number
    // there is dropped by the next bound on a processor, though not on every GPU.
    (constant > 1e-15 && constant != 1e-12) || constant == 1e-36
}

#[test]
fn a_flipped_constant_is_seen() {
    for routine in ROUTINES.iter().chain(FORMS) {
        for order in ORDERS {
            let graph = routine.graph(order);
            let mut random = case::Random::new(77);
            // Case 0 holds the identity rotation, where thresholds act.
            let cases: Vec<_> = [0, 1, 7, 8]
                .into_iter()
                .map(|i| case::arguments(routine, order, &mut random, i))
                .map(|a| (wanted(routine, order, &a), a))
                .collect();
            for (want, a) in &cases {
                assert!(
                    !differs(&evaluate(&graph, a), want),
                    "{} at order {order}",
                    routine.name
                );
            }
            for id in constants(&graph, 40) {
                let seen = |change: fn(f64) -> f64| {
                    let mut mutant = graph.clone();
                    if let Node::Constant(bits) = &mut mutant.nodes[id] {
                        *bits = change(f64::from_bits(*bits)).to_bits();
                    }
                    cases
                        .iter()
                        .any(|(want, a)| differs(&evaluate(&mutant, a), want))
                };
                // A sign that cannot matter: under a square, or where a rotation leaves a direction open.
                assert!(
                    seen(|c| -c) || seen(|c| 1.5 * c),
                    "{} at order {order}: flipping {:?} went unseen",
                    routine.name,
                    graph.nodes[id]
                );
            }
        }
    }
}

/// Rounding a constant to f64 and then to f32 gives what rounding it once gives: no f64 constant lies
/// half-way between two f32 numbers unless it is one of the few that are short in binary.
#[test]
fn constants_round_once() {
    for routine in ROUTINES.iter().chain(FORMS) {
        for order in ORDERS {
            for node in routine.graph(order).nodes {
                let Node::Constant(bits) = node else { continue };
                let value = f64::from_bits(bits);
                let single = value as f32;
                let rest = value - f64::from(single);
                let next = if rest > 0.0 {
                    single.next_up()
                } else {
                    single.next_down()
                };
                assert!(
                    rest == 0.0 || 2.0 * rest.abs() < (f64::from(next) - f64::from(single)).abs(),
                    "{}: {value} lies half-way between two f32",
                    routine.name
                );
            }
        }
    }
}

/// The bounds that a good published generator reaches, and ours below them at orders 5 and 6.
#[test]
fn operation_counts() {
    let count = |name: &str, order: usize| {
        sh_codegen::routines::find(name)
            .expect("it exists")
            .ops(order)
    };
    let product = [(16, 6), (96, 74), (329, 274), (937, 860), (2051, 1995)];
    let square = [(14, 3), (77, 43), (246, 157), (699, 507), (1556, 1189)];
    for (name, bounds) in [("product", product), ("square", square)] {
        for (order, (mul, add)) in ORDERS.zip(bounds) {
            let ops = count(name, order);
            assert!(
                ops.mul <= mul && ops.add <= add,
                "{name} of order {order}: {ops:?}"
            );
        }
    }
    let total = |order| count("product", order).mul + count("product", order).add;
    assert!(total(5) * 100 <= 88 * 1995, "order 5: {}", total(5));
    assert!(total(6) * 100 <= 70 * 4522, "order 6: {}", total(6));
}
