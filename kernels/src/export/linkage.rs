//! SPIR-V whose functions other modules can link.

use super::source::Source;
use super::{ExportError, Language, translate};

/// Words before the first instruction.
const HEADER: usize = 5;

const OP_NAME: u32 = 5;
const OP_CAPABILITY: u32 = 17;
const OP_FUNCTION: u32 = 54;
const OP_DECORATE: u32 = 71;
const OP_MEMBER_DECORATE: u32 = 72;
const OP_TYPES: std::ops::RangeInclusive<u32> = 19..=39;

const CAPABILITY_LINKAGE: u32 = 5;
const DECORATION_LINKAGE_ATTRIBUTES: u32 = 41;
const LINKAGE_EXPORT: u32 = 0;

/// The library as SPIR-V: naga writes the functions, the words that export them are put in here.
pub fn module(source: &Source) -> Result<Vec<u32>, ExportError> {
    let words = translate::spirv(Language::SpirvLibrary, &source.wgsl(), true)?;
    let public: Vec<&str> = source
        .declarations
        .iter()
        .filter(|d| d.routine.is_some())
        .map(|d| d.name.as_str())
        .collect();
    let mut exports = Vec::new();
    for instruction in instructions(&words) {
        if instruction[0] & 0xffff != OP_NAME {
            continue;
        }
        let name = string(&instruction[2..]);
        let function = instructions(&words)
            .any(|other| other[0] & 0xffff == OP_FUNCTION && other[2] == instruction[1]);
        if function && public.contains(&name.as_str()) {
            let literal = literal(&name);
            let length = 4 + literal.len() as u32;
            exports.extend([
                length << 16 | OP_DECORATE,
                instruction[1],
                DECORATION_LINKAGE_ATTRIBUTES,
            ]);
            exports.extend(literal);
            exports.push(LINKAGE_EXPORT);
        }
    }
    let mut out = words[..HEADER].to_vec();
    let capability = [2 << 16 | OP_CAPABILITY, CAPABILITY_LINKAGE];
    if !instructions(&words).any(|instruction| instruction == capability) {
        out.extend(capability);
    }
    let mut waiting = Some(exports);
    for instruction in instructions(&words) {
        // Decorations come after names and before types.
        let op = instruction[0] & 0xffff;
        if op == OP_DECORATE || op == OP_MEMBER_DECORATE || OP_TYPES.contains(&op) {
            out.extend(waiting.take().unwrap_or_default());
        }
        out.extend(instruction);
    }
    Ok(out)
}

/// The instructions of a module, each with its first word.
fn instructions(words: &[u32]) -> impl Iterator<Item = &[u32]> {
    let mut at = HEADER;
    std::iter::from_fn(move || {
        let length = (words.get(at)? >> 16).max(1) as usize;
        let instruction = words.get(at..at + length)?;
        at += length;
        Some(instruction)
    })
}

/// A literal's text: up to the first zero byte.
fn string(words: &[u32]) -> String {
    let bytes = words.iter().flat_map(|word| word.to_le_bytes());
    bytes
        .take_while(|byte| *byte != 0)
        .map(char::from)
        .collect()
}

/// A text as a literal: its bytes and at least one zero, to whole words.
fn literal(text: &str) -> Vec<u32> {
    let mut bytes = text.as_bytes().to_vec();
    bytes.resize(text.len() / 4 * 4 + 4, 0);
    let words = bytes.as_chunks::<4>().0.iter();
    words.map(|bytes| u32::from_le_bytes(*bytes)).collect()
}
