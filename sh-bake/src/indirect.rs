//! What a scene file says of indirect light.

use crate::error::Error;
use crate::keys::Section;
use sh_scene::{Blocking, Indirect};

/// What `[indirect]` knows.
pub(crate) const KEYS: [&str; 3] = ["method", "bounces", "blocking"];

/// The methods there are.
const METHOD: &str = "spherical-lights";

/// Reads `[indirect]`.
pub(crate) fn read(s: &Section) -> Result<Indirect, Error> {
    match s.string("method")? {
        Some(METHOD) => {}
        Some(other) => {
            let message = format!("is \"{other}\", but the method there is is \"{METHOD}\".");
            return Err(s.error("method", message));
        }
        None => {
            let message = format!("is missing: the method there is is \"{METHOD}\".");
            return Err(s.error("method", message));
        }
    }
    let mut indirect = Indirect::default();
    if let Some(bounces) = s.count("bounces", 1..=Indirect::MOST_BOUNCES as usize)? {
        indirect.bounces = bounces as u32;
    }
    if let Some(name) = s.string("blocking")? {
        let known = Blocking::ALL.into_iter().find(|b| b.name() == name);
        indirect.blocking = known.ok_or_else(|| {
            let names = Blocking::ALL
                .map(|b| format!("\"{}\"", b.name()))
                .join(", ");
            s.error(
                "blocking",
                format!("is \"{name}\", but it has to be one of {names}."),
            )
        })?;
    }
    Ok(indirect)
}
