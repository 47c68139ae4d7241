//! Runs the program and looks at its picture. Without an adapter it shows as ignored, never as passed; with
//! `GAUNT_REQUIRE_GPU=1` a missing adapter is a failure.

use libtest_mimic::{Arguments, Failed, Trial};
use std::process::Command;

/// A picture as sRGB bytes.
struct Picture {
    width: u32,
    pixels: Vec<u8>,
}

impl Picture {
    /// The mean of red, green and blue, each from 0 to 255, over the 9 by 9 pixels around one.
    fn mean(&self, x: u32, y: u32) -> [f32; 3] {
        let mut sum = [0.0; 3];
        for (dx, dy) in (0..81).map(|i| (i % 9, i / 9)) {
            let at = ((y + dy - 4) * self.width + x + dx - 4) as usize * 4;
            sum = std::array::from_fn(|c| sum[c] + f32::from(self.pixels[at + c]) / 81.0);
        }
        sum
    }
}

/// The picture, or what the program said instead.
fn run() -> Result<Picture, String> {
    let path = std::env::temp_dir().join(format!("gaunt-host-{}.png", std::process::id()));
    let output = Command::new(env!("CARGO_BIN_EXE_host")).arg("-o").arg(&path).output();
    let output = output.map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let bytes = std::fs::read(&path).map_err(|error| error.to_string())?;
    std::fs::remove_file(&path).map_err(|error| error.to_string())?;
    let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().map_err(|error| error.to_string())?;
    let mut pixels = vec![0; reader.output_buffer_size().unwrap_or(0)];
    let info = reader.next_frame(&mut pixels).map_err(|error| error.to_string())?;
    Ok(Picture { width: info.width, pixels })
}

fn main() {
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    let picture = run();
    let missing = matches!(&picture, Err(reason) if reason.contains("no GPU adapter"));
    let trial = Trial::test("shadows_are_where_they_must_be", move || {
        look(&picture.map_err(Failed::from)?);
        Ok(())
    });
    let trial = trial.with_ignored_flag(missing && !required);
    libtest_mimic::run(&Arguments::from_args(), vec![trial]).exit();
}

/// The sun is at the right: balls are bright there, and their shadows lie on the ground at the left.
fn look(picture: &Picture) {
    let grey = |x: u32, y: u32| picture.mean(x, y).iter().sum::<f32>() / 3.0;
    let open = grey(560, 200);
    // Left of the large ball, the white one and the blue one, at their feet.
    for (x, y) in [(205, 285), (362, 352), (436, 312)] {
        let shadow = grey(x, y);
        assert!(shadow < 0.75 * open, "({x}, {y}) should lie in shadow: {shadow} beside {open}");
    }
    for (left, right, y) in [(215, 350, 205), (222, 318, 80), (437, 515, 270)] {
        let [dark, bright] = [grey(left, y), grey(right, y)];
        assert!(dark < 0.9 * bright, "a ball's left side is {dark}, its right side {bright}");
    }
    // Light comes through nowhere and is missing nowhere far from the balls.
    for (x, y) in [(40, 100), (600, 100), (600, 380), (450, 60)] {
        let ground = grey(x, y);
        assert!((ground / open - 1.0).abs() < 0.1, "({x}, {y}) should be open: {ground} beside {open}");
    }
    // The sky, and no bands on the ground below it.
    let [red, _, blue] = picture.mean(500, 12);
    assert!(blue > red + 30.0, "the sky is blue");
    let steps = (60..390).map(|y| (grey(620, y) - grey(620, y + 1)).abs());
    assert!(steps.fold(0.0, f32::max) < 2.0, "the ground has steps");
}
