//! (under construction)
fn main() {
    for file in gaunt::fit::all(&|_| {}) {
        std::fs::write(
            std::path::Path::new("codegen/data").join(file.name),
            file.text,
        )
        .unwrap();
    }
}
