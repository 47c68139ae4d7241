//! What a scene file says of indirect light.

use crate::error::Error;
use crate::keys::Section;
use sh_scene::{Blocking, Indirect, Method};

/// What `[indirect]` knows.
pub(crate) const KEYS: [&str; 4] = ["method", "bounces", "blocking", "basis"];

/// The names of all methods.
fn names() -> String {
    Method::ALL
        .map(|m| format!("\"{}\"", m.name()))
        .join(" or ")
}

/// Reads by what light is sent on, of a scene or of one object.
pub(crate) fn method(s: &Section) -> Result<Option<Method>, Error> {
    let Some(name) = s.string("method")? else {
        return Ok(None);
    };
    let known = Method::ALL.into_iter().find(|m| m.name() == name);
    known.map(Some).ok_or_else(|| {
        let message = format!("is \"{name}\", but it has to be {}.", names());
        s.error("method", message)
    })
}

/// Reads `[indirect]`.
pub(crate) fn read(s: &Section) -> Result<Indirect, Error> {
    let method = method(s)?.ok_or_else(|| {
        let message = format!("is missing: it has to be {}.", names());
        s.error("method", message)
    })?;
    let mut indirect = Indirect {
        method,
        ..Indirect::default()
    };
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
