//! `gaunt eval`: SH routines as a service, JSON lines in, one JSON line out for each, in order.
//!
//! A request names an operation, an order and its arguments; the answer is `{"ok":[…]}` or
//! `{"error":"a sentence"}`. No request ends the program: what is wrong with a line is told in its answer,
//! and the next line is answered as if nothing had happened.
//!
//! | op | arguments | answer |
//! |---|---|---|
//! | `basis`, `cosine` | `dir` | n² |
//! | `product` | `f`, `g` | n² |
//! | `square` | `f` | n² |
//! | `log` | `f`, `method`: `eigen`, `samples` | n² |
//! | `triple` | `f`, `g`, `h` | 1 |
//! | `rotate` | `f`, `quat` (x, y, z, w) | n² |
//! | `zonal` | `z` (n numbers), `dir` | n² |
//! | `cap` | `angle` | n |
//! | `cap_log` | `angle`, `method`: `fitted`, `fitted:saturating` (or another exponential), `table`, `eigen`, `samples` | n |
//! | `exp` | `f`, `method`: `saturating`, `sampled`, `sampled:50`, `ps:21`, `ps*:2`, `ol`, `hyb`, `eigen` | n² |
//! | `window` | `f`, `h` | n² |

mod compute;
mod gpu;
mod parse;

pub use compute::compute;
pub use gpu::Evaluator;
pub use parse::{CapLog, LogMethod, Op, Request, parse};

use crate::Error;
use std::io::{BufRead, Write};

/// What computes the answers.
pub enum Backend {
    /// In double precision.
    F64,
    /// In single precision. What exists in double precision alone (`log`, and the methods of `cap_log` other
    /// than `fitted`) is rounded to single.
    F32,
    /// The generated WGSL, on any adapter there is.
    Gpu(Box<Evaluator>),
}

/// Answers the lines of `input` on `output` until the input ends or nobody reads the output any more.
pub fn serve(
    mut backend: Backend,
    mut input: impl BufRead,
    mut output: impl Write,
) -> Result<(), Error> {
    let mut line = Vec::new();
    loop {
        line.clear();
        let read = input
            .read_until(b'\n', &mut line)
            .map_err(|source| Error::file("read from", "standard input", source))?;
        if read == 0 {
            return Ok(());
        }
        let written = writeln!(output, "{}", answer(&mut backend, &line));
        match written.and_then(|()| output.flush()) {
            Ok(()) => {}
            Err(error) if error.kind() == std::io::ErrorKind::BrokenPipe => return Ok(()),
            Err(source) => return Err(Error::file("write to", "standard output", source)),
        }
    }
}

/// The answer to one line.
///
/// ```
/// use gaunt::eval::{Backend, answer};
/// let line = br#"{"op": "basis", "order": 2, "dir": [0, 0, 1]}"#;
/// let expected = r#"{"ok":[0.28209479177387814,0.0,0.4886025119029199,0.0]}"#;
/// assert_eq!(answer(&mut Backend::F64, line), expected);
/// assert!(answer(&mut Backend::F64, b"{}").starts_with(r#"{"error":"#));
/// ```
pub fn answer(backend: &mut Backend, line: &[u8]) -> String {
    let result = parse(line).and_then(|request| {
        let values = match backend {
            Backend::F64 => compute::<f64>(&request),
            Backend::F32 => compute::<f32>(&request.in_single_precision()?),
            Backend::Gpu(evaluator) => evaluator.evaluate(&request.in_single_precision()?),
        }?;
        match values.iter().position(|v| !v.is_finite()) {
            None => Ok(values),
            Some(at) => Err(format!(
                "number {at} of the result is not finite: the arguments are too large for this backend"
            )),
        }
    });
    let answer = match result {
        Ok(values) => serde_json::json!({ "ok": values }),
        Err(sentence) => serde_json::json!({ "error": sentence }),
    };
    answer.to_string()
}
