//! What README shows, as text.

/// The README's block that is marked with a language, and in which a line begins with `first`.
pub fn block(language: &str, first: &str) -> String {
    let text = include_str!("../../README.md");
    let mut blocks = text.split("\n```").skip(1).step_by(2);
    let found = blocks.find_map(|block| {
        let (mark, inside) = block.split_once('\n')?;
        (mark == language && inside.starts_with(first)).then(|| inside.to_string())
    });
    found.unwrap_or_else(|| panic!("README has no block of {language} that begins with {first:?}"))
}

/// A line's words as a shell takes them: quotes hold together, and what follows # is a comment.
pub fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quoted, mut begun) = (Vec::new(), String::new(), false, false);
    for c in line.chars() {
        match c {
            '\'' => (quoted, begun) = (!quoted, true),
            '#' if !quoted && !begun => break,
            ' ' if !quoted => {
                if begun {
                    words.push(std::mem::take(&mut word));
                }
                begun = false;
            }
            c => {
                word.push(c);
                begun = true;
            }
        }
    }
    if begun {
        words.push(word);
    }
    words
}
