//! Lines of `gaunt eval`. Whatever the line, the answer is one line: JSON with one key, `ok` with numbers or
//! `error` with a sentence.

#![no_main]

use gaunt::eval::{Backend, answer};
use libfuzzer_sys::fuzz_target;
use serde_json::Value;

fuzz_target!(|line: &[u8]| {
    for mut backend in [Backend::F64, Backend::F32] {
        check(&answer(&mut backend, line));
    }
});

fn check(answer: &str) {
    assert!(!answer.contains('\n'), "more than a line: {answer:?}");
    let value: Value = serde_json::from_str(answer).expect("an answer is JSON");
    let object = value.as_object().expect("an answer is an object");
    assert_eq!(object.len(), 1, "more than one key: {answer}");
    match (object.get("ok"), object.get("error")) {
        (Some(Value::Array(numbers)), None) => {
            assert!(!numbers.is_empty());
            let finite = |n: &Value| n.as_f64().is_some_and(f64::is_finite);
            assert!(numbers.iter().all(finite), "not all numbers: {answer}");
        }
        (None, Some(Value::String(sentence))) => {
            assert!(sentence.contains(' '), "no sentence: {answer}");
        }
        _ => panic!("neither numbers nor a sentence: {answer}"),
    }
}
