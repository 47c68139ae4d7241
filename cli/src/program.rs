//! What every program of ours does around its commands: arguments, errors as sentences, the exit code.

use crate::Error;
use clap::Parser;
use std::io::Write;
use std::process::ExitCode;

/// Runs a program: reads its arguments, does what `command` makes of them, prints the text that it returns, and tells
/// an error in a sentence on standard error. The exit code is 1 where anything was wrong.
///
/// ```no_run
/// #[derive(clap::Parser)]
/// struct Arguments {
///     name: String,
/// }
///
/// fn main() -> std::process::ExitCode {
///     gaunt::program::run("greet", |arguments: Arguments| Ok(format!("Hello, {}.", arguments.name)))
/// }
/// ```
pub fn run<A: Parser>(name: &str, command: impl FnOnce(A) -> Result<String, Error>) -> ExitCode {
    tell_less_of_exr();
    let arguments = match A::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help goes to standard output and is no failure. Where printing fails, nobody reads it.
            let _ = error.print();
            return if error.use_stderr() {
                ExitCode::FAILURE
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    match command(arguments).and_then(|text| say(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            let text = error.to_string();
            let end = if text.ends_with(['.', '!', '?']) {
                ""
            } else {
                "."
            };
            let _ = writeln!(std::io::stderr(), "{name}: {text}{end}");
            ExitCode::FAILURE
        }
    }
}

/// A damaged EXR file can end its decoder in a panic, which the loader catches and tells in a sentence: nobody needs
/// to read both.
fn tell_less_of_exr() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let place = panic
            .location()
            .map(|location| location.file().replace('\\', "/"));
        if !place.is_some_and(|file| file.contains("/exr-")) {
            usual(panic);
        }
    }));
}

/// Prints to standard output what there is to print. A reader that has gone away is no failure.
fn say(text: &str) -> Result<(), Error> {
    if text.is_empty() {
        return Ok(());
    }
    let mut output = std::io::stdout().lock();
    match writeln!(output, "{text}").and_then(|()| output.flush()) {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(Error::file("write to", "standard output", error))
        }
        _ => Ok(()),
    }
}

/// The value of an option for a picture's width and height: `1280x720`.
///
/// # Errors
/// What such a value looks like.
///
/// ```
/// use gaunt::program::size;
/// assert_eq!(size("640x360"), Ok([640, 360]));
/// assert!(size("640").is_err() && size("0x360").is_err());
/// ```
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides = text
        .split_once(['x', 'X'])
        .and_then(|(w, h)| Some([w.parse().ok()?, h.parse().ok()?]));
    match sides {
        Some([w, h]) if (1..=16_384).contains(&w) && (1..=16_384).contains(&h) => Ok([w, h]),
        Some(_) => Err("each side must be 1 to 16384 pixels".into()),
        None => Err("a size looks like 1280x720".into()),
    }
}
