//! What README shows works: its scene loads, and its lines run.

use crate::readme_text::{block, words};
use crate::{Folder, run};

/// A ring of columns, as OBJ: closed and small.
fn mesh() -> String {
    let mut text = String::new();
    for i in 0..8 {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 8.0).sin_cos();
        text += &format!("v {cos} 0 {sin}\nv {cos} 1 {sin}\n");
    }
    for i in 0..8 {
        let [a, b] = [2 * i + 1, 2 * ((i + 1) % 8) + 1];
        text += &format!("f {a} {} {} {b}\n", a + 1, b + 1);
    }
    text + "f 1 3 5 7 9 11 13 15\nf 16 14 12 10 8 6 4 2\n"
}

/// The files that README's scene names.
fn scene(folder: &Folder) {
    folder.put("scene.toml", block("toml", "# scene.toml"));
    folder.put("bunny.obj", mesh());
    let walking = include_str!("../../../sh-bake/tests/good/animated.gltf");
    folder.put("fox.glb", walking.replace("\"Wave\"", "\"Walk\""));
    let grey = include_bytes!("../../../sh-bake/tests/good/grey.hdr");
    folder.put("city.hdr", grey);
}

#[test]
fn the_lines_run() {
    let folder = Folder::new("readme");
    scene(&folder);
    let mut count = 0;
    for line in block("sh", "gaunt").lines() {
        let words = words(line);
        // `echo text | gaunt …` gives the text to it.
        let (input, words) = match words.iter().position(|word| word == "|") {
            Some(bar) => (words[1..bar].join(" ") + "\n", &words[bar + 1..]),
            None => (String::new(), &words[..]),
        };
        let (program, arguments) = words.split_first().expect("a line has words");
        if program == "gaunt-lab" {
            // Minutes of measuring; whether it takes them is for its own tests.
            continue;
        }
        assert_eq!(program, "gaunt", "{line}");
        // Files are in the folder, and so is what `-o` names.
        let here = |(i, word): (usize, &String)| {
            let ending = word.rsplit_once('.').map_or("0", |(_, end)| end);
            let is_output = i > 0 && arguments[i - 1] == "-o";
            match is_output || ending.chars().all(char::is_alphabetic) {
                true => folder.file(word),
                false => word.clone(),
            }
        };
        let mut arguments: Vec<String> = arguments.iter().enumerate().map(here).collect();
        count += 1;
        // Small pictures will do, and a window that nobody has to close.
        let window = folder.file("window.png");
        let more: &[&str] = match arguments[0].as_str() {
            "render" if arguments.iter().any(|a| a == "--backend") => &["--size", "32x18"],
            "render" => &["--size", "32x18", "--backend", "cpu"],
            "compare" => &["--size", "24x14"],
            "plan" => &["--size", "32x18", "--backend", "cpu"],
            "view" => &["--screenshot", &window, "--frames", "1", "--backend", "cpu"],
            _ => &[],
        };
        arguments.extend(more.iter().map(|word| word.to_string()));
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let output = run(&arguments, input.as_bytes());
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{line}: {complaint}");
        // Tables, reports and answers; `eval` would tell an error on standard output.
        assert!(!output.stdout.is_empty(), "{line} says nothing");
        assert!(!output.stdout.starts_with(b"{\"error\""), "{line}");
    }
    assert!(count >= 10, "{count} lines");
    for name in [
        "picture.png",
        "picture.exr",
        "truth.png",
        "sheet.png",
        "f0000.png",
        "f0059.png",
    ] {
        assert!(folder.names().iter().any(|n| n == name), "no {name}");
    }
}

#[test]
fn words_are_those_of_a_shell() {
    assert_eq!(words("gaunt eval 'a b' # c"), ["gaunt", "eval", "a b"]);
    assert_eq!(words("a  'f#1' ''"), ["a", "f#1", ""]);
}
