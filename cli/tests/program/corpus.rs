//! The lines that fuzzing `gaunt eval` keeps (`fuzz/corpus/eval`), and thousands of changes to each: whatever
//! the line, the answer is one line of JSON, with numbers or with a sentence.

use gaunt::eval::{Backend, answer};
use serde_json::Value;
use std::path::Path;

/// Changes to each line, in every kind.
const CHANGES: usize = 20;

/// What numbers are exchanged for.
const NUMBERS: [&str; 16] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2.5",
    "65",
    "5e-324",
    "-1e-45",
    "1e19",
    "-3.4e38",
    "1e154",
    "1.7976931348623157e308",
    "-1.7976931348623157e308",
    "1e999",
    "3.141592653589793",
    "18446744073709551616",
];

#[test]
fn every_line_of_the_fuzzing_corpus_and_changes_to_it_are_answered() {
    let lines = corpus();
    assert!(lines.len() > 50, "{} lines", lines.len());
    let mut random = 1_u64;
    let mut below = |n: usize| {
        random = random
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (random >> 33) as usize % n.max(1)
    };
    let (mut numbers, mut sentences) = (0, 0);
    let mut check = |line: &[u8]| {
        for mut backend in [Backend::F64, Backend::F32] {
            match is_numbers(&answer(&mut backend, line)) {
                true => numbers += 1,
                false => sentences += 1,
            }
        }
    };
    for line in &lines {
        check(line);
        let places = number_places(line);
        for _ in 0..CHANGES {
            if !places.is_empty() {
                // From one number to all of them.
                let share = 1 + below(places.len());
                let mut changed = line.clone();
                for place in places.iter().rev() {
                    if below(places.len()) < share {
                        let number = NUMBERS[below(NUMBERS.len())];
                        changed.splice(place.clone(), number.bytes());
                    }
                }
                check(&changed);
            }
            let mut bytes = line.clone();
            if !bytes.is_empty() {
                let at = below(bytes.len());
                bytes[at] = below(256) as u8;
                check(&bytes);
                bytes.remove(at);
                check(&bytes);
            }
            let other = &lines[below(lines.len())];
            let crossed = [&line[..below(line.len())], &other[below(other.len())..]].concat();
            check(&crossed);
        }
    }
    // Both kinds of answers have been met, many times.
    assert!(
        numbers > 1000 && sentences > 1000,
        "{numbers} and {sentences}"
    );
}

/// The files of the corpus, in the order of their names.
fn corpus() -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz/corpus/eval");
    let mut paths: Vec<_> = std::fs::read_dir(folder)
        .expect("the corpus is there")
        .map(|entry| entry.expect("its entries can be read").path())
        .collect();
    paths.sort();
    paths
        .iter()
        .map(|path| std::fs::read(path).expect("its files can be read"))
        .collect()
}

/// Where the numbers of a line stand.
fn number_places(line: &[u8]) -> Vec<std::ops::Range<usize>> {
    let part = |b: &u8| b.is_ascii_digit() || b"+-.eE".contains(b);
    let mut places = Vec::new();
    let mut at = 0;
    while at < line.len() {
        let length = line[at..].iter().take_while(|b| part(b)).count();
        if line[at..at + length].iter().any(u8::is_ascii_digit) {
            places.push(at..at + length);
        }
        at += length.max(1);
    }
    places
}

/// Whether an answer is numbers; it has to be those or a sentence.
fn is_numbers(answer: &str) -> bool {
    assert!(!answer.contains('\n'), "more than a line: {answer:?}");
    let value: Value = serde_json::from_str(answer).expect("an answer is JSON");
    let object = value.as_object().expect("an answer is an object");
    assert_eq!(object.len(), 1, "more than one key: {answer}");
    match (object.get("ok"), object.get("error")) {
        (Some(Value::Array(numbers)), None) => {
            let finite = |n: &Value| n.as_f64().is_some_and(f64::is_finite);
            assert!(
                !numbers.is_empty() && numbers.iter().all(finite),
                "{answer}"
            );
            true
        }
        (None, Some(Value::String(sentence))) => {
            assert!(sentence.contains(' '), "no sentence: {answer}");
            false
        }
        _ => panic!("neither numbers nor a sentence: {answer}"),
    }
}
