//! Every flat text is WGSL that naga accepts, and holds no more than its pass needs.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga::{Expression, Literal};
use sh_codegen::constants::{self, Value};
use sh_kernels::{MAX_ORDER, MIN_ORDER, Pass, library, shadow, source};

fn module(label: &str, text: &str) -> naga::Module {
    let module = naga::front::wgsl::parse_str(text)
        .unwrap_or_else(|error| panic!("{label}: {}", error.emit_to_string(text)));
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("{label}: {}", error.emit_to_string(text)));
    module
}

#[test]
fn every_pass_of_every_order_is_valid() {
    for order in MIN_ORDER..=MAX_ORDER {
        for pass in Pass::ALL {
            let label = format!("{} {order}", pass.name());
            let module = module(&label, source(pass, order).unwrap());
            assert!(
                !module.entry_points.is_empty(),
                "{label} has no entry point"
            );
        }
        module(&format!("library {order}"), library(order).unwrap());
        for accumulation in order..=MAX_ORDER {
            let name = format!("shadow of order {order} on {accumulation}");
            module(&name, shadow(order, accumulation).unwrap());
        }
    }
}

#[test]
fn only_shading_passes_carry_the_library() {
    for order in MIN_ORDER..=MAX_ORDER {
        assert!(
            !source(Pass::Gbuffer, order)
                .unwrap()
                .contains(&format!("sh{order}_"))
        );
        // What is mirrored needs the energy of its lobe, and nothing else.
        let resolve = source(Pass::Resolve, order).unwrap();
        assert!(resolve.contains(&format!("fn sh{order}_gloss_energy(")));
        let irradiance = source(Pass::Irradiance, order).unwrap();
        assert!(irradiance.contains(&format!("fn sh{order}_cosine(")));
        assert!(!irradiance.contains(&format!("fn sh{order}_transfer(")));
        let shadow = source(Pass::Shadow, order).unwrap();
        assert!(shadow.contains(&format!("fn sh{order}_transfer(")));
        assert!(!shadow.contains(&format!("fn sh{order}_rotate(")));
    }
}

#[test]
fn no_function_name_ends_in_a_digit() {
    for order in MIN_ORDER..=MAX_ORDER {
        let passes = Pass::ALL.map(|pass| source(pass, order).unwrap());
        for text in passes.into_iter().chain(library(order)) {
            for (_, function) in module("", text).functions.iter() {
                let name = function.name.clone().unwrap();
                assert!(!name.ends_with(|c: char| c.is_ascii_digit()), "{name}");
            }
        }
    }
}

/// Text without its comments.
fn code(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap());
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn of_shared_constants_a_pass_has_those_that_it_uses() {
    let mut used = 0;
    for order in MIN_ORDER..=MAX_ORDER {
        let passes = Pass::ALL.map(|pass| source(pass, order).unwrap());
        for text in passes.into_iter().chain(library(order)) {
            let code = code(text);
            let words: Vec<&str> = code
                .split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
                .collect();
            for constant in constants::all() {
                let count = words.iter().filter(|word| **word == constant.name).count();
                let declared = code.matches(&format!("const {}:", constant.name)).count();
                used += declared;
                assert!(
                    declared == usize::from(count > 0) && count != 1,
                    "{}: {declared} of {count}\n{text}",
                    constant.name
                );
            }
        }
    }
    assert!(used > 0);
}

#[test]
fn shared_constants_are_read_as_they_are() {
    let module = module("constants", &sh_codegen::wgsl::constants());
    for constant in constants::all() {
        let (_, read) = module
            .constants
            .iter()
            .find(|(_, read)| read.name.as_deref() == Some(constant.name))
            .unwrap();
        let expected = match constant.value {
            Value::Double(value) => Literal::F32(value as f32),
            Value::Single(value) => Literal::F32(value),
            Value::Count(value) => Literal::U32(value as u32),
            Value::Word(value) => Literal::U32(value),
            Value::Byte(value) => Literal::U32(value.into()),
        };
        let found = &module.global_expressions[read.init];
        assert!(
            matches!(found, Expression::Literal(literal) if *literal == expected),
            "{}: {found:?}, not {expected:?}",
            constant.name
        );
    }
}

#[test]
fn orders_outside_the_range_are_absent() {
    for order in [0, 1, 7, usize::MAX] {
        assert!(source(Pass::Shadow, order).is_none());
        assert!(library(order).is_none());
    }
}
