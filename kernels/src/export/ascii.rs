//! Comments in ASCII: some shader compilers read nothing else, not even in comments.

/// What stands for what.
const WORDS: [(&str, &str); 31] = [
    ("‖f̂‖", "|f^|"),
    ("f̂", "f^"),
    ("√(", "sqrt("),
    ("√4π", "sqrt(4 pi)"),
    ("√", "sqrt "),
    ("4π", "4 pi"),
    ("π", "pi"),
    ("θ", "theta"),
    ("α", "alpha"),
    ("β", "beta"),
    ("γ", "gamma"),
    ("Γ", "Gamma"),
    ("‖", "|"),
    ("⁻¹", "^-1"),
    ("²", "^2"),
    ("³", "^3"),
    ("·", "*"),
    ("×", "x"),
    ("−", "-"),
    ("–", "-"),
    ("—", "-"),
    ("≤", "<="),
    ("≥", ">="),
    ("∫", "integral of"),
    ("Σ", "sum of"),
    ("₀", "0"),
    ("₁", "1"),
    ("…", "..."),
    ("°", " degrees"),
    ("ö", "oe"),
    ("’", "'"),
];

/// The text without what is not ASCII; a character that nobody has named a word for becomes `?`.
pub fn plain(text: &str) -> String {
    let mut text = text.to_string();
    for (from, to) in WORDS {
        text = text.replace(from, to);
    }
    let known = |c: char| if c.is_ascii() { c } else { '?' };
    text.chars().map(known).collect()
}

/// Breaks a line of words at spaces, so that no line is longer than `width` where words allow it.
pub fn wrapped(line: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in line.split(' ') {
        let full = lines
            .last()
            .is_some_and(|l| !l.is_empty() && l.len() + 1 + word.len() > width);
        if full {
            lines.push(String::new());
        }
        if let Some(last) = lines.last_mut() {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stand_for_signs() {
        assert_eq!(
            plain("‖f̂‖² ≤ √(4π)·β, √4π"),
            "|f^|^2 <= sqrt(4 pi)*beta, sqrt(4 pi)"
        );
        assert_eq!(plain("ж"), "?");
    }

    #[test]
    fn lines_are_broken_at_spaces() {
        assert_eq!(wrapped("one two three", 7), ["one two", "three"]);
        assert_eq!(wrapped("unbreakable", 3), ["unbreakable"]);
        assert_eq!(wrapped("", 3), [""]);
    }
}
