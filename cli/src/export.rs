//! `gaunt export`: the library of routines as files that other renderers include.

use crate::Error;
use crate::image::Output;
use flate2::{Compression, GzBuilder};
use rayon::prelude::*;
use sh_kernels::export::{ExportError, File, Language, Request, export, note};
use sh_kernels::{MAX_ORDER, MIN_ORDER};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};

/// What to export, and where to.
#[derive(Clone, Debug)]
pub struct Options {
    /// What `--lang` says: `wgsl`, `glsl`, `hlsl`, `msl` or `spirv`. `None` stands for all, at all orders.
    pub language: Option<String>,
    /// SH order.
    pub order: usize,
    /// Names of routines; none stands for all.
    pub routines: Vec<String>,
    /// What names start with, instead of `sh4_` at order 4.
    pub prefix: Option<String>,
    /// A folder, or an archive whose name ends in `.tar.gz`.
    pub out: PathBuf,
}

/// What stands beside the files where everything is exported.
const COMPANIONS: [(&str, &str); 3] = [
    ("README.md", include_str!("../EXPORT.md")),
    ("LICENSE-APACHE", include_str!("../LICENSE-APACHE")),
    ("LICENSE-MIT", include_str!("../LICENSE-MIT")),
];

/// Writes the files and says which.
///
/// # Errors
/// A language, order, routine or prefix that cannot be had, or a file that cannot be written: a sentence.
pub fn run(options: &Options) -> Result<String, Error> {
    let files = files(options)?;
    let archive = options.out.to_string_lossy().ends_with(".tar.gz");
    if archive {
        let output = Output::create(&options.out)?;
        let bytes = archived(&options.out, &files)?;
        write(output, &options.out, &bytes)?;
    } else {
        let failed = |error| Error::file("make the folder", options.out.display(), error);
        std::fs::create_dir_all(&options.out).map_err(failed)?;
        for File { name, bytes } in &files {
            let path = options.out.join(name);
            write(Output::create(&path)?, &path, bytes)?;
        }
    }
    let mut text = String::new();
    for File { name, bytes } in &files {
        let path = match archive {
            true => PathBuf::from(name),
            false => options.out.join(name),
        };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:>8} bytes  {}", bytes.len(), path.display());
    }
    let _ = write!(text, "in {}", options.out.display());
    Ok(text)
}

/// All files of a request, each made on a thread of its own.
fn files(options: &Options) -> Result<Vec<File>, Error> {
    let routines: Vec<&str> = options.routines.iter().map(String::as_str).collect();
    let (languages, orders): (Vec<Language>, _) = match &options.language {
        Some(name) => {
            let named = Language::ALL.into_iter().filter(|l| l.option() == name);
            (named.collect(), options.order..=options.order)
        }
        None => (Language::ALL.into(), MIN_ORDER..=MAX_ORDER),
    };
    if languages.is_empty() {
        let name = options.language.as_deref().unwrap_or_default();
        return Err(Error::Usage(format!(
            "there is no language `{name}`; there are wgsl, glsl, hlsl, msl and spirv"
        )));
    }
    let requests: Vec<Request<'_>> = orders
        .flat_map(|order| languages.iter().map(move |language| (order, *language)))
        .map(|(order, language)| Request {
            language,
            order,
            routines: &routines,
            prefix: options.prefix.as_deref(),
        })
        .collect();
    let each: Vec<_> = requests
        .par_iter()
        .map(|request| Ok([Some(export(request)?), note(request)?]))
        .collect();
    let mut files = Vec::new();
    let mut left_out = None;
    for made in each {
        match made {
            Ok(made) => files.extend(made.into_iter().flatten()),
            // What one version of a language lacks, another may have.
            Err(error @ ExportError::Inexpressible { .. }) => left_out = Some(error),
            Err(error) => return Err(error.into()),
        }
    }
    if let (true, Some(error)) = (files.is_empty(), left_out) {
        return Err(error.into());
    }
    if options.language.is_none() {
        files.extend(COMPANIONS.map(|(name, text)| File {
            name: name.into(),
            bytes: text.into(),
        }));
    }
    Ok(files)
}

fn write(output: Output, path: &Path, bytes: &[u8]) -> Result<(), Error> {
    output.finish(|file| {
        let written = file.write_all(bytes);
        written.map_err(|error| Error::file("write to", path.display(), error))
    })
}

/// The files in a folder `gaunt-shaders-<version>`, the same bytes whenever and wherever it is made.
fn archived(path: &Path, files: &[File]) -> Result<Vec<u8>, Error> {
    let failed = |error| Error::file("write to", path.display(), error);
    let gzip = GzBuilder::new()
        .mtime(0)
        .write(Vec::new(), Compression::best());
    let mut tar = tar::Builder::new(gzip);
    for File { name, bytes } in files {
        let mut header = tar::Header::new_gnu();
        header.set_size(bytes.len() as u64);
        header.set_mode(0o644);
        header.set_mtime(0);
        let name = format!("gaunt-shaders-{}/{name}", env!("CARGO_PKG_VERSION"));
        tar.append_data(&mut header, name, bytes.as_slice())
            .map_err(failed)?;
    }
    tar.into_inner()
        .and_then(|gzip| gzip.finish())
        .map_err(failed)
}
