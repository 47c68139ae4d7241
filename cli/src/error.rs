//! Why the program stopped.

use std::fmt::Display;

/// What goes to standard error: a sentence, or several.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file or stream that cannot be used.
    #[error("cannot {doing} {path}: {source}")]
    File {
        /// What was tried: "write to".
        doing: &'static str,
        /// Which file.
        path: String,
        /// What the system says.
        source: std::io::Error,
    },
    /// An option that makes no sense, though its form is right.
    #[error("{0}")]
    Usage(String),
    /// A picture that could not be encoded.
    #[error("cannot encode {path}: {source}")]
    Encode {
        /// Which picture.
        path: String,
        /// What the encoder says.
        source: image::ImageError,
    },
    /// Results that could not be put into JSON.
    #[error("cannot write the results as JSON: {0}")]
    Json(#[from] serde_json::Error),
    /// No GPU, or one that failed.
    #[error("{0}")]
    Gpu(String),
    /// Something that cannot be exported.
    #[error(transparent)]
    Export(#[from] sh_kernels::export::ExportError),
    /// Something wrong with a scene or one of its files.
    #[error(transparent)]
    Scene(#[from] sh_bake::Error),
    /// Something wrong with the settings of the light.
    #[error(transparent)]
    Light(#[from] sh_scene::LightError),
    /// Something wrong with a pass on the CPU.
    #[error(transparent)]
    Cpu(#[from] sh_cpu::Error),
    /// Something wrong with a pass on the GPU.
    #[error(transparent)]
    Pass(#[from] sh_gpu::Error),
}

impl Error {
    /// A [`Error::File`] about a path or the name of a stream.
    pub fn file(doing: &'static str, path: impl Display, source: std::io::Error) -> Self {
        Self::File {
            doing,
            path: path.to_string(),
            source,
        }
    }
}
