//! Writes the generated routines to where `src/generated.rs` includes them from.

fn main() -> std::io::Result<()> {
    let out = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts");
    println!("cargo::rerun-if-changed=build.rs");
    std::fs::write(
        std::path::Path::new(&out).join("routines.rs"),
        sh_codegen::emit::rust::library(),
    )
}
