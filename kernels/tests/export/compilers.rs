//! Every file inside a small shader, by the compilers that shader authors use.

use crate::files::whole;
use crate::samples::sample;
use libtest_mimic::Failed;
use sh_kernels::export::Language;
use sh_kernels::{MAX_ORDER, MIN_ORDER};
use std::path::{Path, PathBuf};
use std::process::Command;

const TOOLS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/compilers");

/// Where `tests/compilers/install` has put what is no package of the system.
fn installed() -> PathBuf {
    let ours = || PathBuf::from(TOOLS).join("../../target/compilers");
    std::env::var_os("GAUNT_COMPILERS").map_or_else(ours, PathBuf::from)
}

/// A folder of its own for a test's files.
pub fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("export")
        .join(name);
    std::fs::create_dir_all(&folder).expect("a folder for temporary files");
    folder
}

/// What of the compilers of a language is not there, as a sentence.
pub fn missing(language: Language) -> Option<String> {
    let (programs, file): (&[&str], _) = match language {
        Language::Wgsl => (&["node"], Some("node_modules/webgpu")),
        Language::Glsl450 | Language::Glsl330 | Language::Glsl300Es => {
            (&["glslangValidator"], None)
        }
        Language::Hlsl => (&["python3"], Some("libdxcompiler.so")),
        Language::Msl => (&["g++"], None),
        Language::Spirv => (&["spirv-val"], None),
        Language::SpirvLibrary => (&["spirv-as", "spirv-link", "spirv-val"], None),
    };
    let absent = |name: &str| {
        let path = std::env::var_os("PATH").unwrap_or_default();
        !std::env::split_paths(&path).any(|folder| folder.join(name).is_file())
    };
    let missing = programs
        .iter()
        .find(|name| absent(name))
        .map(|name| name.to_string());
    let missing = missing.or_else(|| {
        let path = installed().join(file?);
        (!path.exists()).then(|| path.display().to_string())
    });
    missing.map(|what| format!("there is no {what}: run tests/compilers/install"))
}

/// Runs a program in a folder; what it says if it fails.
pub fn run(folder: &Path, program: &str, arguments: &[&str]) -> Result<(), Failed> {
    let output = Command::new(program)
        .args(arguments)
        .current_dir(folder)
        .output()
        .map_err(|error| format!("cannot run {program}: {error}"))?;
    match output.status.success() {
        true => Ok(()),
        false => {
            let text = [output.stdout, output.stderr].concat();
            let text: String = String::from_utf8_lossy(&text).chars().take(4000).collect();
            Err(format!("{program} {}: {text}", arguments.join(" ")).into())
        }
    }
}

/// All orders, as they are; and that the compiler refuses a shader that calls what does not exist.
pub fn check(language: Language) -> Result<(), Failed> {
    for order in MIN_ORDER..=MAX_ORDER {
        compile(language, order, |text| text)?;
    }
    let wrong = |text: String| text.replace("sh2_cosine", "sh2_cosinus");
    match compile(language, 2, wrong) {
        Err(_) => Ok(()),
        Ok(()) if language == Language::Spirv => Ok(()),
        Ok(()) => Err("the compiler takes a function that does not exist".into()),
    }
}

/// The page's sample with the exported file; `change` may spoil it.
fn compile(
    language: Language,
    order: usize,
    change: impl Fn(String) -> String,
) -> Result<(), Failed> {
    let file = whole(language, order);
    let folder = folder(&file.name);
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.join(name), bytes);
    write(&file.name, &file.bytes)?;
    let shader = |kind, index| change(sample(kind, index, order));
    match language {
        Language::Wgsl => {
            let text = String::from_utf8(file.bytes.clone())? + &shader("wgsl", 0);
            write("sample.wgsl", text.as_bytes())?;
            let installed = installed().canonicalize()?;
            let script = format!("{TOOLS}/tint.mjs");
            run(
                &folder,
                "node",
                &[&script, &installed.to_string_lossy(), "sample.wgsl"],
            )
        }
        Language::Glsl450 => {
            write("sample.frag", shader("glsl", 0).as_bytes())?;
            let arguments = [
                "-V",
                "--target-env",
                "vulkan1.1",
                "-I.",
                "sample.frag",
                "-o",
                "sample.spv",
            ];
            run(&folder, "glslangValidator", &arguments)?;
            run(
                &folder,
                "spirv-val",
                &["--target-env", "vulkan1.1", "sample.spv"],
            )
        }
        Language::Glsl330 | Language::Glsl300Es => {
            let include = format!("#include \"sh{order}_300es.glsl\"\n");
            let text = shader("glsl", 1).replace(&include, std::str::from_utf8(&file.bytes)?);
            let text = match language {
                Language::Glsl330 => text.replace("#version 300 es", "#version 330"),
                _ => text,
            };
            write("sample.frag", text.as_bytes())?;
            run(&folder, "glslangValidator", &["sample.frag"])
        }
        Language::Hlsl => {
            write("sample.hlsl", shader("hlsl", 0).as_bytes())?;
            let script = format!("{TOOLS}/dxc.py");
            let library = installed().join("libdxcompiler.so").canonicalize()?;
            let library = library.to_string_lossy();
            run(
                &folder,
                "python3",
                &[&script, &library, "sample.hlsl", "ps_6_0", "main"],
            )
        }
        Language::Msl => {
            write("sample.metal", shader("metal", 0).as_bytes())?;
            let shim = format!("-I{TOOLS}/metal");
            let arguments = [
                "-std=c++14",
                "-fsyntax-only",
                "-Wno-attributes",
                "-I.",
                &shim,
                "-x",
                "c++",
                "sample.metal",
            ];
            run(&folder, "g++", &arguments)
        }
        Language::Spirv => run(
            &folder,
            "spirv-val",
            &["--target-env", "vulkan1.1", &file.name],
        ),
        Language::SpirvLibrary => {
            run(
                &folder,
                "spirv-val",
                &["--target-env", "spv1.3", &file.name],
            )?;
            write("mine.spvasm", shader("spirv", 0).as_bytes())?;
            let arguments = ["--target-env", "spv1.3", "mine.spvasm", "-o", "mine.spv"];
            run(&folder, "spirv-as", &arguments)?;
            run(
                &folder,
                "spirv-link",
                &["mine.spv", &file.name, "-o", "whole.spv"],
            )?;
            run(
                &folder,
                "spirv-val",
                &["--target-env", "vulkan1.1", "whole.spv"],
            )
        }
    }
}
