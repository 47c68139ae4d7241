//! Writes the generated routines and constants to where `src/generated.rs` and `src/constants.rs` include them from.

fn main() -> std::io::Result<()> {
    let out = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts");
    println!("cargo::rerun-if-changed=build.rs");
    let out = std::path::Path::new(&out);
    std::fs::write(
        out.join("constants.rs"),
        sh_codegen::emit::rust::constants(),
    )?;
    std::fs::write(out.join("routines.rs"), sh_codegen::emit::rust::library())
}
