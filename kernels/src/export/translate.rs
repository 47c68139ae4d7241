//! naga: WGSL to the other languages.

use super::source::Source;
use super::{ExportError, Language};
use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{Module, ShaderStage, Type, TypeInner};

/// What is left of a translator's complaint.
fn failed(language: Language, error: impl ToString) -> ExportError {
    ExportError::Translation {
        language: language.name(),
        message: error.to_string(),
    }
}

/// Parses and validates.
pub fn module(language: Language, wgsl: &str) -> Result<(Module, ModuleInfo), ExportError> {
    let module = parse(language, wgsl)?;
    let info = validate(language, &module)?;
    Ok((module, info))
}

fn parse(language: Language, wgsl: &str) -> Result<Module, ExportError> {
    naga::front::wgsl::parse_str(wgsl).map_err(|e| failed(language, e.emit_to_string(wgsl)))
}

fn validate(language: Language, module: &Module) -> Result<ModuleInfo, ExportError> {
    Validator::new(
        ValidationFlags::all(),
        Capabilities::SHADER_FLOAT16_IN_FLOAT32,
    )
    .validate(module)
    .map_err(|e| failed(language, e.as_inner()))
}

/// Arrays get the names of what they hold: a language that has no arrays by value makes structs of them.
fn name_types(module: &mut Module, source: &Source) {
    let (n, prefix) = (source.order as u32, &source.prefix);
    let count = n * n;
    let handles: Vec<_> = module.types.iter().map(|(handle, _)| handle).collect();
    for handle in handles {
        let ty = module.types[handle].clone();
        let TypeInner::Array { base, size, .. } = ty.inner else {
            continue;
        };
        let naga::ArraySize::Constant(length) = size else {
            continue;
        };
        let length = length.get();
        let whole = module.types[base].inner.scalar_kind() == Some(naga::ScalarKind::Uint);
        let name = match length {
            _ if whole => "Halves",
            _ if length == count => "Vector",
            _ if length == n => "Zonal",
            _ if length == count * (count + 1) / 2 => "Triangle",
            9 => "Matrix",
            _ => continue,
        };
        let name = Some(format!("{prefix}{name}"));
        module.types.replace(handle, Type { name, ..ty });
    }
}

/// The source as text of a language that has text.
pub fn text(language: Language, source: &Source) -> Result<String, ExportError> {
    let mut wgsl = source.wgsl();
    if matches!(
        language,
        Language::Glsl450 | Language::Glsl330 | Language::Glsl300Es
    ) {
        // The writer wants an entry point; it is cut off again.
        wgsl += "\n@fragment\nfn entry() {}\n";
    }
    let mut module = parse(language, &wgsl)?;
    name_types(&mut module, source);
    let info = validate(language, &module)?;
    let (module, info) = naga::back::pipeline_constants::process_overrides(
        &module,
        &info,
        None,
        &Default::default(),
    )
    .map_err(|e| failed(language, e))?;
    let (module, info) = (module.as_ref(), info.as_ref());
    match language {
        Language::Glsl450 => glsl(language, module, info, glsl::Version::Desktop(450)),
        Language::Glsl330 => glsl(language, module, info, glsl::Version::Desktop(330)),
        Language::Glsl300Es => glsl(language, module, info, glsl::Version::new_gles(300)),
        Language::Hlsl => {
            let options = hlsl::Options {
                shader_model: hlsl::ShaderModel::V6_0,
                restrict_indexing: false,
                force_loop_bounding: false,
                ..Default::default()
            };
            let mut text = String::new();
            hlsl::Writer::new(&mut text, &options, &Default::default())
                .write(module, info, None)
                .map_err(|e| failed(language, e))?;
            Ok(text)
        }
        _ => {
            let options = msl::Options {
                lang_version: (2, 0),
                force_loop_bounding: false,
                ..Default::default()
            };
            let written = msl::write_string(module, info, &options, &Default::default());
            written
                .map(|(text, _)| text)
                .map_err(|e| failed(language, e))
        }
    }
}

fn glsl(
    language: Language,
    module: &Module,
    info: &ModuleInfo,
    version: glsl::Version,
) -> Result<String, ExportError> {
    let options = glsl::Options {
        version,
        writer_flags: glsl::WriterFlags::empty(),
        ..Default::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: ShaderStage::Fragment,
        entry_point: "entry".into(),
        multiview: None,
    };
    let mut text = String::new();
    glsl::Writer::new(
        &mut text,
        module,
        info,
        &options,
        &pipeline,
        BoundsCheckPolicies::default(),
    )
    .and_then(|mut writer| writer.write())
    .map_err(|e| failed(language, e))?;
    Ok(text)
}

/// WGSL as words of SPIR-V 1.3, with debug names where they are needed to find functions.
pub fn spirv(language: Language, wgsl: &str, names: bool) -> Result<Vec<u32>, ExportError> {
    let (module, info) = module(language, wgsl)?;
    let options = spv::Options {
        lang_version: (1, 3),
        flags: if names {
            spv::WriterFlags::DEBUG
        } else {
            spv::WriterFlags::empty()
        },
        force_loop_bounding: false,
        bounds_check_policies: BoundsCheckPolicies {
            index: BoundsCheckPolicy::Unchecked,
            buffer: BoundsCheckPolicy::Unchecked,
            ..Default::default()
        },
        ..Default::default()
    };
    spv::write_vec(&module, &info, &options, None).map_err(|e| failed(language, e))
}
