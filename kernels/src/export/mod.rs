//! The library of an SH order as one flat file in a shading language, for any renderer (feature `export`).
//!
//! What is exported is the WGSL that the passes are linked from: the generated routines, the exponentials that are
//! made of products, the table of logarithms and the packing of halves. naga translates it; names, comments and the
//! head of the file are put back afterwards, so that every language has the same names: prefix and routine.
//!
//! ```
//! use sh_kernels::export::{Language, Request, export};
//! let request = Request { routines: &["product", "cosine"], ..Request::new(Language::Hlsl, 4) };
//! let file = export(&request)?;
//! assert_eq!(file.name, "sh4.hlsl");
//! let text = String::from_utf8(file.bytes).unwrap();
//! assert!(text.contains(" sh4_product(float f[16], float g[16])") && !text.contains("sh4_rotate"));
//! # Ok::<(), sh_kernels::export::ExportError>(())
//! ```

mod ascii;
mod entries;
mod head;
mod linkage;
mod source;
mod tidy;
mod translate;

use crate::{MAX_ORDER, MIN_ORDER};
use source::Source;

pub use entries::Signature;

/// What a file can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Language {
    /// WebGPU's own, for any implementation.
    Wgsl,
    /// Desktop OpenGL 4.5 and Vulkan.
    Glsl450,
    /// Desktop OpenGL 3.3. Without the packing of halves.
    Glsl330,
    /// OpenGL ES 3.0 and WebGL 2.
    Glsl300Es,
    /// Direct3D, shader model 6.
    Hlsl,
    /// Metal 2.
    Msl,
    /// A module with an entry point for each routine, for Vulkan 1.1.
    Spirv,
    /// A module whose functions are exported, for `spirv-link`.
    SpirvLibrary,
}

impl Language {
    /// All of them.
    pub const ALL: [Language; 8] = [
        Language::Wgsl,
        Language::Glsl450,
        Language::Glsl330,
        Language::Glsl300Es,
        Language::Hlsl,
        Language::Msl,
        Language::Spirv,
        Language::SpirvLibrary,
    ];

    /// Its name with its version, for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wgsl => "WGSL",
            Self::Glsl450 => "GLSL 450",
            Self::Glsl330 => "GLSL 330",
            Self::Glsl300Es => "GLSL 300 es",
            Self::Hlsl => "HLSL, shader model 6",
            Self::Msl => "MSL 2",
            Self::Spirv => "SPIR-V 1.3 with entry points",
            Self::SpirvLibrary => "SPIR-V 1.3 with exported functions",
        }
    }

    /// What `gaunt export --lang` calls it.
    pub fn option(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Glsl450 | Self::Glsl330 | Self::Glsl300Es => "glsl",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::Spirv | Self::SpirvLibrary => "spirv",
        }
    }

    /// What its files end in, after the prefix without its underscore.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Wgsl => ".wgsl",
            Self::Glsl450 => "_450.glsl",
            Self::Glsl330 => "_330.glsl",
            Self::Glsl300Es => "_300es.glsl",
            Self::Hlsl => ".hlsl",
            Self::Msl => ".metal",
            Self::Spirv => ".spv",
            Self::SpirvLibrary => "_library.spv",
        }
    }

    /// Whether its files are bytes that a note has to explain ([`note`]).
    pub fn is_binary(self) -> bool {
        matches!(self, Self::Spirv | Self::SpirvLibrary)
    }

    /// Whether it can pack halves.
    fn packs_halves(self) -> bool {
        self != Self::Glsl330
    }
}

/// What to export.
#[derive(Clone, Copy, Debug)]
pub struct Request<'a> {
    /// The language.
    pub language: Language,
    /// SH order, [`MIN_ORDER`] to [`MAX_ORDER`].
    pub order: usize,
    /// Names of routines, without prefix; none stands for all. What they need comes with them.
    pub routines: &'a [&'a str],
    /// What every name starts with, in place of `sh4_` at order 4.
    pub prefix: Option<&'a str>,
}

impl Request<'_> {
    /// Everything of an order.
    pub fn new(language: Language, order: usize) -> Self {
        Self {
            language,
            order,
            routines: &[],
            prefix: None,
        }
    }
}

/// A file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name.
    pub name: String,
    /// What is in it: text in UTF-8 (ASCII alone), or little-endian words of SPIR-V.
    pub bytes: Vec<u8>,
}

/// Why nothing was exported.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// An order that there is no library of.
    #[error("there is no library of order {0}: orders are {MIN_ORDER} to {MAX_ORDER}")]
    Order(usize),
    /// A routine that does not exist.
    #[error("there is no routine `{name}`; there are {known}")]
    Routine {
        /// What was asked for.
        name: String,
        /// All names, with commas between.
        known: String,
    },
    /// A routine that a language cannot express.
    #[error(
        "`{name}` cannot be written in {language}, which packs no halves; ask for GLSL 450 or 300 es"
    )]
    Inexpressible {
        /// The routine.
        name: String,
        /// The language.
        language: &'static str,
    },
    /// A prefix that some language would not take.
    #[error(
        "`{0}` cannot start names: a prefix is a letter and up to 32 letters, digits and single underscores, \
         and neither `gl_` nor another word that a language keeps for itself"
    )]
    Prefix(String),
    /// What naga says of a text that it should have taken.
    #[error("{language}: {message}")]
    Translation {
        /// The language.
        language: &'static str,
        /// The translator's words.
        message: String,
    },
}

/// The library of an order in a language.
///
/// # Errors
/// An order, routine or prefix that does not exist or cannot be had, as a sentence.
pub fn export(request: &Request<'_>) -> Result<File, ExportError> {
    let source = Source::new(request)?;
    let head = || head::text(request, &source);
    let text = match request.language {
        Language::Wgsl => {
            translate::module(request.language, &source.wgsl())?;
            head() + "\n" + &source.wgsl()
        }
        Language::Spirv => {
            return Ok(File {
                name: name(request),
                bytes: bytes(&entries::module(&source)?),
            });
        }
        Language::SpirvLibrary => {
            return Ok(File {
                name: name(request),
                bytes: bytes(&linkage::module(&source)?),
            });
        }
        language => {
            let text = translate::text(language, &source)?;
            tidy::file(language, &source, &head(), &text)
        }
    };
    // Names that a language reserves were changed in translation: better none than other names.
    for function in source.functions() {
        if !text.contains(&format!(" {}{function}(", source.prefix)) {
            return Err(ExportError::Prefix(source.prefix.clone()));
        }
    }
    Ok(File {
        name: name(request),
        bytes: text.into_bytes(),
    })
}

/// What there is to know about a file that cannot say it itself: the same head as in other languages, and for each
/// entry point what it takes and gives. `None` for a language whose files have their own.
///
/// # Errors
/// As [`export`].
pub fn note(request: &Request<'_>) -> Result<Option<File>, ExportError> {
    if !request.language.is_binary() {
        return Ok(None);
    }
    let source = Source::new(request)?;
    let text = head::lines(request, &source).join("\n") + "\n" + &entries::note(&source)?;
    Ok(Some(File {
        name: name(request) + ".txt",
        bytes: text.into_bytes(),
    }))
}

/// The names of all routines, sorted.
pub fn routines() -> Vec<String> {
    Source::new(&Request::new(Language::Wgsl, MIN_ORDER)).map_or_else(
        |_| Vec::new(),
        |source| {
            let mut names = source.functions();
            names.sort();
            names
        },
    )
}

/// What a routine takes and gives, in numbers of 32 bits. `None` where there is no such routine or order.
pub fn signature(order: usize, routine: &str) -> Option<Signature> {
    let routines = [routine];
    let request = Request {
        routines: &routines,
        ..Request::new(Language::Wgsl, order)
    };
    let source = Source::new(&request).ok()?;
    entries::signatures(&source).ok()?.remove(routine)
}

fn name(request: &Request<'_>) -> String {
    let prefix = prefix(request);
    prefix.trim_end_matches('_').to_string() + request.language.ending()
}

fn prefix(request: &Request<'_>) -> String {
    match request.prefix {
        Some(prefix) => prefix.to_string(),
        None => format!("sh{}_", request.order),
    }
}

fn bytes(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}
