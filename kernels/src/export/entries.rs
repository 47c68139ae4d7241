//! SPIR-V with a compute entry point for each routine.

use super::source::Source;
use super::{ExportError, Language, translate};
use naga::{ArraySize, Module, Scalar, ScalarKind, Type, TypeInner};
use std::collections::BTreeMap;

/// One argument or result: what WGSL calls its type, and how many numbers of 32 bits it has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Value {
    /// The argument's name; `result` for the result.
    pub name: String,
    /// The type in WGSL.
    pub wgsl: String,
    /// How many numbers.
    pub count: usize,
    /// Whether they are unsigned integers, and no floats.
    pub whole: bool,
}

/// What a routine takes and gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Arguments in their order.
    pub arguments: Vec<Value>,
    /// The result.
    pub result: Value,
}

impl Signature {
    /// Numbers that all arguments have together.
    pub fn taken(&self) -> usize {
        self.arguments.iter().map(|a| a.count).sum()
    }
}

/// The signatures of all routines, by their names without prefix.
pub fn signatures(source: &Source) -> Result<BTreeMap<String, Signature>, ExportError> {
    let (module, _) = translate::module(Language::Spirv, &source.wgsl())?;
    let mut all = BTreeMap::new();
    for (_, function) in module.functions.iter() {
        let name = function.name.as_deref().unwrap_or_default();
        let routine = source.declarations.iter().find(|d| d.name == name);
        let Some(routine) = routine.and_then(|d| d.routine.clone()) else {
            continue;
        };
        let value = |name: &str, ty| value(&module, name, &module.types[ty]);
        let arguments = function.arguments.iter();
        let arguments = arguments
            .map(|a| value(a.name.as_deref().unwrap_or_default(), a.ty))
            .collect::<Option<Vec<_>>>();
        let result = function.result.as_ref().and_then(|r| value("result", r.ty));
        if let (Some(arguments), Some(result)) = (arguments, result) {
            all.insert(routine, Signature { arguments, result });
        }
    }
    Ok(all)
}

fn value(module: &Module, name: &str, ty: &Type) -> Option<Value> {
    let kind = |scalar: Scalar| {
        (
            scalar.kind == ScalarKind::Uint,
            if scalar.kind == ScalarKind::Uint {
                "u32"
            } else {
                "f32"
            },
        )
    };
    let (count, whole, wgsl) = match ty.inner {
        TypeInner::Scalar(scalar) => {
            let (whole, word) = kind(scalar);
            (1, whole, word.to_string())
        }
        TypeInner::Vector { size, scalar } => {
            let (whole, word) = kind(scalar);
            (
                size as usize,
                whole,
                format!("vec{}<{word}>", size as usize),
            )
        }
        TypeInner::Array {
            base,
            size: ArraySize::Constant(count),
            ..
        } => {
            let (whole, word) = kind(module.types[base].inner.scalar()?);
            (
                count.get() as usize,
                whole,
                format!("array<{word}, {count}>"),
            )
        }
        _ => return None,
    };
    Some(Value {
        name: name.to_string(),
        wgsl,
        count,
        whole,
    })
}

/// The library and an entry point for each routine, as SPIR-V.
pub fn module(source: &Source) -> Result<Vec<u32>, ExportError> {
    let mut wgsl = source.wgsl();
    // The entry points have the routines' names, and the routines other ones.
    wgsl = super::source::words(&wgsl, |word| {
        let routine = source
            .declarations
            .iter()
            .any(|d| d.routine.is_some() && d.name == word);
        routine.then(|| format!("function_{word}"))
    });
    wgsl += "\n@group(0) @binding(0) var<storage, read> arguments: array<u32>;\n\
             @group(0) @binding(1) var<storage, read_write> results: array<u32>;\n";
    for (routine, signature) in signatures(source)? {
        wgsl += &entry(&format!("{}{routine}", source.prefix), &signature);
    }
    translate::spirv(Language::Spirv, &wgsl, false)
}

/// One entry point. Every number goes through its bits.
fn entry(name: &str, signature: &Signature) -> String {
    let mut reads = String::new();
    let mut first = 0;
    let bits = |whole: bool, word: String| {
        if whole {
            word
        } else {
            format!("bitcast<f32>({word})")
        }
    };
    for (i, argument) in signature.arguments.iter().enumerate() {
        let at = |k: usize| bits(argument.whole, format!("arguments[first + {}u]", first + k));
        if argument.wgsl.starts_with("array") {
            let one = bits(argument.whole, format!("arguments[first + {first}u + i]"));
            reads += &format!(
                "    var argument{i}_: {};\n    for (var i = 0u; i < {}u; i += 1u) {{\n        argument{i}_[i] = {one};\n    }}\n",
                argument.wgsl, argument.count
            );
        } else {
            let numbers: Vec<_> = (0..argument.count).map(at).collect();
            let numbers = numbers.join(", ");
            reads += &format!("    let argument{i}_ = {}({numbers});\n", argument.wgsl);
        }
        first += argument.count;
    }
    let names: Vec<_> = (0..signature.arguments.len())
        .map(|i| format!("argument{i}_"))
        .collect();
    let result = &signature.result;
    let count = result.count;
    let word = |value: &str| {
        if result.whole {
            value.to_string()
        } else {
            format!("bitcast<u32>({value})")
        }
    };
    let write = match count {
        1 => format!("    results[id.x] = {};\n", word("result")),
        _ => format!(
            "    for (var i = 0u; i < {count}u; i += 1u) {{\n        results[id.x * {count}u + i] = {};\n    }}\n",
            word("result[i]")
        ),
    };
    format!(
        "\n@compute @workgroup_size(64)\nfn {name}(@builtin(global_invocation_id) id: vec3<u32>) {{\n    \
         if ((id.x + 1u) * {count}u > arrayLength(&results)) {{\n        return;\n    }}\n    \
         let first = id.x * {}u;\n{reads}    var result = function_{name}({});\n{write}}}\n",
        signature.taken(),
        names.join(", ")
    )
}

/// What each entry point takes and gives.
pub fn note(source: &Source) -> Result<String, ExportError> {
    let mut text = String::new();
    let signatures = signatures(source)?;
    for declaration in &source.declarations {
        let Some(signature) = declaration
            .routine
            .as_ref()
            .and_then(|name| signatures.get(name))
        else {
            continue;
        };
        let arguments: Vec<_> = signature
            .arguments
            .iter()
            .map(|a| format!("{}: {}", a.name, a.wgsl))
            .collect();
        text += &format!(
            "\n{}({}) -> {}\n    takes {} numbers, gives {}\n",
            declaration.name,
            arguments.join(", "),
            signature.result.wgsl,
            signature.taken(),
            signature.result.count
        );
        for line in &declaration.doc {
            text += format!("    {line}").trim_end();
            text.push('\n');
        }
    }
    Ok(text)
}
