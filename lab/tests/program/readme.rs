//! README's lines are taken as they stand: all of their arguments are accepted.

use crate::readme_text::{block, words};
use crate::run;

/// What stops each command before it measures anything, once all arguments before it are accepted: how the line ends, and
/// what is complained about then.
const STOPS: [(&str, &[&str], &str); 2] = [
    (
        "bench",
        &["--backend", "none-of-them"],
        "invalid value 'none-of-them' for '--backend",
    ),
    ("accuracy", &["--page"], "a value is required for '--page"),
];

/// Whether the program takes the arguments of a command.
fn takes(arguments: &[&str]) -> bool {
    let stop = STOPS.iter().find(|stop| stop.0 == arguments[0]);
    let &(_, end, complaint) = stop.expect("a command that is known here");
    let output = run(&[arguments, end].concat());
    assert!(!output.status.success());
    String::from_utf8_lossy(&output.stderr).contains(complaint)
}

#[test]
fn the_lines_are_taken() {
    let text = block("sh", "gaunt");
    let lines = text.lines().filter(|line| line.starts_with("gaunt-lab"));
    let mut count = 0;
    for line in lines {
        let words = words(line);
        let arguments: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        assert!(takes(&arguments), "{line}");
        count += 1;
    }
    assert!(count >= 3, "{count} lines");
}

#[test]
fn a_line_that_is_wrong_is_found() {
    assert!(takes(&["bench", "battle"]));
    assert!(!takes(&["bench", "no-such-scene"]));
    assert!(!takes(&["accuracy", "--no-plot", "chart.svg"]));
}
