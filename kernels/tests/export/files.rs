//! What is checked in, what names are called, and what is said of requests that cannot be had.

use sh_kernels::export::{ExportError, File, Language, Request, export, note, routines};
use sh_kernels::{MAX_ORDER, MIN_ORDER};
use sha2::{Digest, Sha256};
use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::OnceLock;

pub const TESTS: &[(&str, fn())] = &[
    ("what_is_checked_in_is_what_is_exported", checked_in),
    ("every_language_has_the_same_names", names),
    ("every_head_tells_what_the_file_is", heads),
    ("what_is_asked_for_comes_with_what_it_needs", subsets),
    ("what_cannot_be_had_is_told", refusals),
];

/// Everything of an order, made once for all tests.
pub fn whole(language: Language, order: usize) -> &'static File {
    static FILES: [[OnceLock<File>; Language::ALL.len()]; MAX_ORDER - MIN_ORDER + 1] =
        [const { [const { OnceLock::new() }; Language::ALL.len()] }; MAX_ORDER - MIN_ORDER + 1];
    FILES[order - MIN_ORDER][language as usize].get_or_init(|| {
        export(&Request::new(language, order)).expect("every order is exported in every language")
    })
}

fn text(file: &File) -> String {
    String::from_utf8(file.bytes.clone()).expect("a text")
}

/// The WGSL byte by byte, all else by hash.
fn checked_in() {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/include"));
    let rewrite = std::env::var_os("GAUNT_REWRITE").is_some_and(|value| value != "0");
    let mut hashes = String::from(
        "# SHA-256 of what `gaunt export --all` writes beside the WGSL files of this folder. Written by\n\
         # GAUNT_REWRITE=1 cargo test -p sh-kernels --features export --test export what_is_checked_in\n",
    );
    for order in MIN_ORDER..=MAX_ORDER {
        for language in Language::ALL {
            let file = whole(language, order);
            if language != Language::Wgsl {
                let hash = Sha256::digest(&file.bytes);
                let hash: String = hash.iter().map(|byte| format!("{byte:02x}")).collect();
                hashes += &format!("{hash}  {}\n", file.name);
                continue;
            }
            let path = folder.join(&file.name);
            if rewrite {
                std::fs::write(&path, &file.bytes).expect("kernels/include can be written");
            }
            let there = std::fs::read(&path).unwrap_or_default();
            assert!(
                there == file.bytes,
                "kernels/include/{} is stale: run with GAUNT_REWRITE=1",
                file.name
            );
        }
    }
    let path = folder.join("hashes.txt");
    if rewrite {
        std::fs::write(&path, &hashes).expect("kernels/include can be written");
    }
    let there = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(
        there, hashes,
        "kernels/include/hashes.txt is stale: run with GAUNT_REWRITE=1"
    );
}

/// Prefix and routine, in every language, and nothing at the top of a file without the prefix.
fn names() {
    for prefix in [None, Some("occlusion_"), Some("SHx")] {
        for language in Language::ALL {
            let request = Request {
                prefix,
                ..Request::new(language, 3)
            };
            let file = export(&request).expect("these prefixes can be had");
            let prefix = prefix.unwrap_or("sh3_");
            let lacking = |name: &String| language == Language::Glsl330 && name.ends_with("_half");
            let expected: BTreeSet<String> = routines()
                .into_iter()
                .filter(|name| !lacking(name))
                .map(|name| format!("{prefix}{name}"))
                .collect();
            assert!(expected.len() > 30);
            let found = match language {
                Language::Spirv => spirv_names(&file.bytes, 15, 3, None),
                Language::SpirvLibrary => spirv_names(&file.bytes, 71, 3, Some(41)),
                _ => declared(&text(&file), prefix)
                    .into_iter()
                    .filter(|name| expected.contains(name))
                    .collect(),
            };
            assert_eq!(found, expected, "{language:?}");
        }
    }
}

/// The functions that a text declares; whatever it declares has to have the prefix.
fn declared(text: &str, prefix: &str) -> BTreeSet<String> {
    let mut functions = BTreeSet::new();
    for line in text.lines() {
        let other = ["//", "#", "}", "{", ")", " ", "precision ", "using "];
        if line.is_empty() || other.iter().any(|start| line.starts_with(start)) {
            continue;
        }
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let words: Vec<&str> = line.split(|c| !is_word(c)).collect();
        assert!(
            words.iter().any(|word| word.starts_with(prefix)),
            "`{line}` has no prefix"
        );
        let before = line.split('(').next().unwrap_or_default();
        if line.contains('(') && !before.contains('=') {
            functions.extend(before.rsplit(|c| !is_word(c)).next().map(str::to_string));
        }
    }
    functions
}

/// The names in the instructions `op` of a module: literals from word `at` on, of those whose word before it is `kind`.
fn spirv_names(bytes: &[u8], op: u32, at: usize, kind: Option<u32>) -> BTreeSet<String> {
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
    let mut rest = &words[5..];
    let mut names = BTreeSet::new();
    while let Some(first) = rest.first() {
        let (instruction, after) = rest.split_at((first >> 16) as usize);
        if first & 0xffff == op && kind.is_none_or(|kind| instruction[at - 1] == kind) {
            let bytes = instruction[at..].iter().flat_map(|word| word.to_le_bytes());
            names.insert(bytes.take_while(|b| *b != 0).map(char::from).collect());
        }
        rest = after;
    }
    names
}

fn heads() {
    for language in Language::ALL {
        let request = Request::new(language, 4);
        let note = note(&request).expect("a note");
        let file = note.as_ref().unwrap_or_else(|| whole(language, 4));
        let text = text(file);
        assert!(text.is_ascii(), "{language:?}");
        let comments = text.lines().filter(|line| line.starts_with("//"));
        assert!(
            !comments.clone().any(|line| line.contains('?')),
            "{language:?}: a sign has no word"
        );
        let head: Vec<&str> = text.lines().take(22).collect();
        let head = head.join("\n");
        for part in [
            "Spherical harmonics of order 4",
            concat!("Gaunt ", env!("CARGO_PKG_VERSION")),
            &format!("gaunt export --lang {} --order 4", language.option()),
            "MIT or Apache-2.0",
            "l*l + l + m",
            "right-handed",
        ] {
            assert!(head.contains(part), "{language:?} does not tell `{part}`");
        }
        for routine in routines() {
            let name = format!("sh4_{routine}(");
            let lines: Vec<&str> = text.lines().collect();
            let Some(at) = lines.iter().position(|line| line.contains(&name)) else {
                continue;
            };
            let above = lines[..at].iter().rev().take(3);
            let told = language.is_binary() || above.clone().any(|line| line.starts_with("//"));
            assert!(told, "{language:?}: {routine} has no comment");
        }
    }
}

fn subsets() {
    for language in [
        Language::Wgsl,
        Language::Glsl300Es,
        Language::Hlsl,
        Language::Msl,
    ] {
        let request = Request {
            routines: &["exp_hyb"],
            ..Request::new(language, 2)
        };
        let file = export(&request).expect("exp_hyb is there");
        let text = text(&file);
        let functions = declared(&text, "sh2_");
        for needed in [
            "sh2_exp_hyb",
            "sh2_square",
            "sh2_optimal_linear",
            "sh2_halved",
        ] {
            assert!(
                functions.contains(needed),
                "{language:?}: {needed} is missing"
            );
        }
        for needless in [
            "sh2_product",
            "sh2_rotate",
            "sh2_exp_ps_star",
            "sh2_pack_half",
        ] {
            assert!(
                !functions.contains(needless),
                "{language:?}: {needless} is not needed"
            );
        }
        assert!(text.contains("--order 2 --routines exp_hyb"));
    }
}

fn refusals() {
    let request = Request::new(Language::Glsl330, 4);
    let unknown = export(&Request {
        routines: &["product", "divide"],
        ..request
    });
    let sentence = unknown.unwrap_err().to_string();
    assert!(
        sentence.starts_with("there is no routine `divide`; there are accumulate_blocker, "),
        "{sentence}"
    );
    assert!(sentence.contains(", product, ") && sentence.ends_with("zonal"));
    let halves = export(&Request {
        routines: &["pack_half"],
        ..request
    });
    assert!(matches!(halves, Err(ExportError::Inexpressible { .. })));
    for order in [0, 1, 7, usize::MAX] {
        let refused = export(&Request { order, ..request });
        assert_eq!(refused, Err(ExportError::Order(order)));
    }
    for prefix in [
        "",
        "1st_",
        "a__b_",
        "gl_",
        "s h_",
        "ä_",
        "a_very_long_prefix_of_more_than_32_letters_",
    ] {
        let refused = export(&Request {
            prefix: Some(prefix),
            ..request
        });
        assert_eq!(refused, Err(ExportError::Prefix(prefix.into())));
    }
}
