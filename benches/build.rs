//! Writes every form of the routines that have several, which `src/forms.rs` includes. sh-core itself
//! has only the form that is the default for an order.

use sh_codegen::emit::rust::function;
use sh_codegen::routines::{FORMS, ORDERS};

fn main() -> std::io::Result<()> {
    let out = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR for build scripts");
    println!("cargo::rerun-if-changed=build.rs");
    let mut text = String::new();
    for order in ORDERS {
        for form in FORMS {
            text += &function(form, order, "sh");
        }
    }
    std::fs::write(std::path::Path::new(&out).join("forms.rs"), text)
}
