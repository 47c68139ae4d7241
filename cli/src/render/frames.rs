//! Frames of a motion: which ones, at what rate, and into which files.

use crate::Error;
use crate::image::PictureFile;
use std::ops::Range;
use std::path::{Path, PathBuf};

/// The frames to render.
#[derive(Clone, Debug, PartialEq)]
pub struct Frames {
    /// Their numbers; frame n is at n / `rate` seconds.
    pub numbers: Range<u32>,
    /// Frames a second, above 0.
    pub rate: f64,
}

/// Reads a range of frame numbers, `0..60` without its end or `0..=60` with it. The error says what a range looks
/// like.
///
/// ```
/// use gaunt::render::frame_numbers;
/// assert_eq!(frame_numbers("0..60"), Ok(0..60));
/// assert_eq!(frame_numbers("5..=7"), Ok(5..8));
/// assert!(frame_numbers("7..7").unwrap_err().contains("no frame"));
/// ```
pub fn frame_numbers(text: &str) -> Result<Range<u32>, String> {
    let number = |text: &str| text.trim().parse::<u32>().ok().filter(|n| *n < u32::MAX);
    let ends = text.split_once("..").and_then(|(start, end)| {
        let (end, more) = match end.strip_prefix('=') {
            Some(end) => (end, 1),
            None => (end, 0),
        };
        Some(number(start)?..number(end)? + more)
    });
    match ends {
        None => Err("frames are a range like 0..60, or 0..=60 with frame 60".into()),
        Some(range) if range.is_empty() => Err(format!(
            "there is no frame in {text}: a range ends above its start, and 0..60 is frames 0 to 59"
        )),
        Some(range) => Ok(range),
    }
}

/// Reads a rate of frames: above 0, at most 1000. The error says so.
pub fn frame_rate(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(rate) if rate > 0.0 && rate <= 1e3 => Ok(rate),
        _ => Err("the rate is a number of frames a second, above 0 and at most 1000".into()),
    }
}

/// File names with a number in them, like `f%04d.png`.
#[derive(Clone, Debug, PartialEq)]
pub struct Pattern {
    folder: PathBuf,
    before: String,
    /// Digits at least, filled up with zeros.
    digits: usize,
    after: String,
}

impl Pattern {
    /// A path whose file name has one `%d`, or `%04d` for at least 4 digits.
    ///
    /// # Errors
    /// A sentence where it has none, several, or another `%`.
    ///
    /// ```
    /// use gaunt::render::Pattern;
    /// use std::path::Path;
    /// let pattern = Pattern::new(Path::new("out/f%04d.png"))?;
    /// assert_eq!(pattern.path(7), Path::new("out/f0007.png"));
    /// assert_eq!(pattern.path(12345), Path::new("out/f12345.png"));
    /// assert!(Pattern::new(Path::new("f.png")).is_err());
    /// # Ok::<(), gaunt::Error>(())
    /// ```
    pub fn new(path: &Path) -> Result<Self, Error> {
        let wrong = || {
            Error::Usage(format!(
                "cannot write frames to {}: with --frames the name given by --out needs one number in it, %d or \
                 %04d, like f%04d.png",
                path.display()
            ))
        };
        let name = path.file_name().and_then(|name| name.to_str());
        let (before, rest) = name.and_then(|n| n.split_once('%')).ok_or_else(wrong)?;
        let (digits, after) = rest.split_once('d').ok_or_else(wrong)?;
        let digits = match digits.strip_prefix('0') {
            _ if digits.is_empty() => 0,
            Some(digits) if digits.bytes().all(|b| b.is_ascii_digit()) => {
                let digits = digits.parse().ok();
                digits.filter(|n| (1..=20).contains(n)).ok_or_else(wrong)?
            }
            _ => return Err(wrong()),
        };
        if after.contains('%') {
            return Err(wrong());
        }
        Ok(Self {
            folder: path.parent().unwrap_or(Path::new("")).into(),
            before: before.into(),
            digits,
            after: after.into(),
        })
    }

    /// The file of a frame.
    pub fn path(&self, number: u32) -> PathBuf {
        let (before, after, digits) = (&self.before, &self.after, self.digits);
        self.folder
            .join(format!("{before}{number:0digits$}{after}"))
    }
}

/// The files that pictures go to, one after the other. The first is opened at once: nobody should wait for a
/// picture that has no place to go.
pub(super) struct Files {
    pattern: Option<Pattern>,
    first: Option<PictureFile>,
}

impl Files {
    pub(super) fn open(out: &Path, frames: Option<&Frames>) -> Result<Self, Error> {
        let pattern = frames.map(|_| Pattern::new(out)).transpose()?;
        let first = match (&pattern, frames) {
            (Some(pattern), Some(frames)) => {
                PictureFile::create(&pattern.path(frames.numbers.start))
            }
            _ => PictureFile::create(out),
        };
        Ok(Self {
            pattern,
            first: Some(first?),
        })
    }

    /// The file for a frame; without frames, the only one.
    pub(super) fn next(&mut self, number: u32) -> Result<PictureFile, Error> {
        match (self.first.take(), &self.pattern) {
            (Some(first), _) => Ok(first),
            (None, Some(pattern)) => PictureFile::create(&pattern.path(number)),
            (None, None) => Err(Error::Usage(
                "there is one picture, and it is written".into(),
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_that_are_none_are_refused() {
        for text in [
            "",
            "5",
            "5..",
            "..5",
            "a..b",
            "-1..3",
            "1.5..3",
            "0...3",
            "0..=",
            "3..9999999999",
        ] {
            let sentence = frame_numbers(text).unwrap_err();
            assert!(sentence.contains("0..60"), "{text}: {sentence}");
        }
        for text in ["3..3", "9..3", "5..=4"] {
            let sentence = frame_numbers(text).unwrap_err();
            assert!(sentence.contains("no frame"), "{text}: {sentence}");
        }
        assert_eq!(frame_numbers("4..=4"), Ok(4..5));
    }

    #[test]
    fn rates_are_above_zero() {
        assert_eq!(frame_rate("23.976"), Ok(23.976));
        for text in ["0", "-3", "nan", "inf", "1e9", "fast"] {
            assert!(frame_rate(text).is_err(), "{text}");
        }
    }

    #[test]
    fn patterns_need_one_number() {
        let path = |text: &str| Pattern::new(Path::new(text)).map(|pattern| pattern.path(42));
        assert_eq!(path("%d.exr").unwrap(), Path::new("42.exr"));
        assert_eq!(path("a/%06d-x.png").unwrap(), Path::new("a/000042-x.png"));
        for text in [
            "f.png",
            "f%.png",
            "f%4d.png",
            "f%0d.png",
            "f%x.png",
            "%d%d.png",
            "f%099d.png",
            "%d/f.png",
            "",
        ] {
            let sentence = path(text).unwrap_err().to_string();
            assert!(sentence.contains("%04d"), "{text}: {sentence}");
        }
    }
}
