//! What can be wrong with an input, as sentences.

use std::path::{Path, PathBuf};

/// Why something could not be loaded. Every message is a sentence that names the file and what in it is
/// wrong.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that cannot be read at all.
    #[error("{}: the file cannot be read: {source}.", shown(path))]
    Read {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A file whose name's ending says nothing that is known.
    #[error("{}: the ending of the file's name is none of {known}.", shown(path))]
    Format {
        /// The file.
        path: PathBuf,
        /// The endings that would be right.
        known: &'static str,
    },
    /// A scene file that has something wrong at a line.
    #[error("{}, line {line}: {message}", shown(path))]
    Scene {
        /// The scene file.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
        /// What is wrong, with the key's name, and what would be right.
        message: String,
    },
    /// A mesh or environment file that has something wrong.
    #[error("{}: {message}", shown(path))]
    File {
        /// The file.
        path: PathBuf,
        /// What is wrong, where, and what would be right.
        message: String,
    },
}

impl Error {
    pub(crate) fn file(path: &Path, message: impl AsRef<str>) -> Self {
        Self::File {
            path: path.to_path_buf(),
            message: one_line(message.as_ref()),
        }
    }
}

/// A text that quotes a file, with control characters written out: so that what the file holds can neither
/// break a message into lines nor steer a terminal.
pub(crate) fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    for c in text.chars() {
        match c.is_control() {
            true => line.extend(c.escape_default()),
            false => line.push(c),
        }
    }
    line
}

/// A path as messages show it.
pub(crate) fn shown(path: &Path) -> String {
    one_line(&path.display().to_string())
}

/// The bytes of a file.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Error> {
    std::fs::read(path).map_err(|source| Error::Read {
        path: path.to_path_buf(),
        source,
    })
}

/// The name of a file, as a person knows it.
pub(crate) fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(
        || PathBuf::from(path).display().to_string(),
        |n| n.to_string_lossy().into(),
    )
}
