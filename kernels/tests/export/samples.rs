//! The shaders of docs/EXPORT.md.

const PAGE: &str = include_str!("../../../docs/EXPORT.md");

/// The page's block number `index` of a kind, such as `hlsl`, for an order: the page's are of order 4.
pub fn sample(kind: &str, index: usize, order: usize) -> String {
    let fence = format!("\n```{kind}\n");
    let block = PAGE.split(&fence).nth(index + 1);
    let block = block.and_then(|text| text.split("\n```").next());
    let block = block.unwrap_or_else(|| panic!("docs/EXPORT.md has no block {index} of {kind}"));
    let count = (order * order).to_string();
    let of_order = block.replace("sh4", &format!("sh{order}"));
    // 16 is a number of coefficients wherever it stands alone.
    let mut text = String::new();
    let mut rest = of_order.as_str();
    while let Some(at) = rest.find("16") {
        let (before, after) = (&rest[..at], &rest[at + 2..]);
        let digit = |c: char| c.is_ascii_alphanumeric();
        let alone = !before.ends_with(digit) && !after.starts_with(digit);
        text += before;
        text += if alone { &count } else { "16" };
        rest = after;
    }
    text + rest + "\n"
}
