//! What a scene file says of indirect light.

use crate::error::Error;
use crate::keys::Section;
use sh_scene::{Blocking, Indirect, Method};

/// What `[indirect]` knows.
pub(crate) const KEYS: [&str; 4] = ["method", "bounces", "blocking", "basis"];

/// Reads `[indirect]`.
pub(crate) fn read(s: &Section) -> Result<Indirect, Error> {
    let names = || {
        Method::ALL
            .map(|m| format!("\"{}\"", m.name()))
            .join(" or ")
    };
    let method = match s.string("method")? {
        Some(name) => Method::ALL
            .into_iter()
            .find(|method| method.name() == name)
            .ok_or_else(|| {
                let message = format!("is \"{name}\", but it has to be {}.", names());
                s.error("method", message)
            })?,
        None => {
            let message = format!("is missing: it has to be {}.", names());
            return Err(s.error("method", message));
        }
    };
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
