//! Writes `call`, which finds a generated routine by name and order and calls it on flat slices.

use sh_codegen::routines::{ORDERS, ROUTINES, Shape};
use std::fmt::Write;

fn main() -> std::io::Result<()> {
    let (mut arms, mut bodies) = (String::new(), String::new());
    for routine in ROUTINES {
        for order in ORDERS {
            let arguments: Vec<String> = routine
                .arguments
                .iter()
                .enumerate()
                .map(|(i, (_, shape))| match shape {
                    Shape::Scalar => format!("a[{i}][0]"),
                    Shape::Vector | Shape::Triangle => format!("&array(&a[{i}])"),
                    _ => format!("array(&a[{i}])"),
                })
                .collect();
            let name = format!("sh{order}_{}", routine.name);
            let call = format!(
                "<[L; {}] as Routines<L>>::{}({})",
                order * order,
                routine.name,
                arguments.join(", ")
            );
            let result = match routine.result {
                Shape::Scalar => format!("vec![{call}]"),
                _ => format!("{call}.to_vec()"),
            };
            writeln!(arms, "        ({:?}, {order}) => {name}(a),", routine.name)
                .expect("to a string");
            // One body each: all of them inlined into one function would take minutes to compile.
            writeln!(
                bodies,
                "#[inline(never)]\nfn {name}<L: sh_core::Lane>(a: &[Vec<L>]) -> Vec<L> {{\n    {result}\n}}\n"
            )
            .expect("to a string");
        }
    }
    let text = format!(
        "/// The routine of a name at an order, on flat arguments.\n\
         pub fn call<L: sh_core::Lane>(routine: &str, order: usize, a: &[Vec<L>]) -> Vec<L> {{\n\
         \x20   match (routine, order) {{\n{arms}        _ => panic!(\"no routine {{routine}} of order {{order}}\"),\n    }}\n}}\n\n{bodies}"
    );
    let out = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts");
    println!("cargo::rerun-if-changed=build.rs");
    std::fs::write(std::path::Path::new(&out).join("call.rs"), text)
}
