//! `gaunt view`, looked at: pictures of its window, drawn in memory and on a virtual display.
//!
//! The virtual display is Xvfb, and what draws on it a Vulkan driver. Where one of them is missing its test shows as
//! ignored, never as passed; with `GAUNT_REQUIRE_GPU=1` it is a failure.

use image::RgbImage;
use libtest_mimic::{Arguments, Failed, Trial};
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};

/// The width of the panel, at the right.
const PANEL: u32 = 320;

/// The height of the bar with the time, at the bottom, where something moves.
const BAR: u32 = 38;

const IN_MEMORY: [(&str, fn()); 4] = [
    (
        "the_window_shows_what_render_makes",
        the_window_shows_what_render_makes,
    ),
    ("frames_are_those_of_render", frames_are_those_of_render),
    ("overlays_are_over_the_bodies", overlays_are_over_the_bodies),
    ("misuse_is_told_in_a_sentence", misuse_is_told_in_a_sentence),
];

fn main() {
    let arguments = Arguments::from_args();
    let required = std::env::var_os("GAUNT_REQUIRE_GPU").is_some_and(|value| value != "0");
    let missing = match (
        Command::new("Xvfb").arg("-help").output(),
        gaunt::gpu::Gpu::open(),
    ) {
        (Err(error), _) => Some(format!("Xvfb cannot be started: {error}")),
        (_, Err(error)) => Some(error.to_string()),
        _ => None,
    };
    let passes = |test: fn()| {
        move || {
            test();
            Ok(())
        }
    };
    let mut trials: Vec<Trial> = IN_MEMORY
        .iter()
        .map(|&(name, test)| Trial::test(name, passes(test)))
        .collect();
    let name = "a_display_shows_the_same_window";
    trials.push(match missing {
        None => Trial::test(name, passes(a_display_shows_the_same_window)),
        Some(reason) => Trial::test(name, move || Err(Failed::from(reason)))
            .with_kind("no display")
            .with_ignored_flag(!required),
    });
    libtest_mimic::run(&arguments, trials).exit();
}

/// A cube of 8 vertices on y = 0.
const CUBE: &str = "
v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1
f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1
";

const STILL: &str = "[[objects]]\nmesh = \"cube.obj\"\nspheres = 16\n";

const MOVING: &str = "[[objects]]\nmesh = \"cube.obj\"\nspheres = 16\nkeys = [{ time = 0 }, \
                      { time = 2, translate = [3, 0, 0], rotate = [0, 90, 0] }]\n";

/// A folder for one test, gone afterwards.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str, scene: &str) -> Self {
        let path = std::env::temp_dir().join(format!("gaunt-view-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a folder for temporary files");
        let folder = Self(path);
        std::fs::write(folder.file("cube.obj"), CUBE).expect("writing a mesh");
        std::fs::write(folder.file("scene.toml"), scene).expect("writing a scene");
        folder
    }

    fn file(&self, name: &str) -> String {
        self.0.join(name).to_str().expect("a path in UTF-8").into()
    }

    /// Runs the program on its scene, without a display unless one is given.
    fn run(&self, command: &str, arguments: &[&str], display: Option<&str>) -> Output {
        let mut program = Command::new(env!("CARGO_BIN_EXE_gaunt"));
        program
            .arg(command)
            .arg(self.file("scene.toml"))
            .args(arguments);
        program.env("GAUNT_CACHE", self.file("cache"));
        program.env("XDG_RUNTIME_DIR", &self.0);
        program.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        program.envs(display.map(|display| ("DISPLAY", display)));
        program.output().expect("the program starts")
    }

    /// The picture that a run has to write, and what it says.
    fn picture(
        &self,
        command: &str,
        arguments: &[&str],
        display: Option<&str>,
    ) -> (RgbImage, String) {
        let out = self.file("picture.png");
        let option = if command == "view" {
            "--screenshot"
        } else {
            "-o"
        };
        let all = [&[option, &out, "--backend", "cpu"], arguments].concat();
        let output = self.run(command, &all, display);
        let complaint = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.success(),
            "{command} {arguments:?}: {complaint}"
        );
        let picture = image::open(&out).expect("a PNG").into_rgb8();
        std::fs::remove_file(out).expect("it was there");
        (
            picture,
            String::from_utf8_lossy(&output.stdout).into_owned(),
        )
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A part of a picture.
fn part(picture: &RgbImage, [x, y]: [u32; 2], [width, height]: [u32; 2]) -> RgbImage {
    image::imageops::crop_imm(picture, x, y, width, height).to_image()
}

/// The largest difference of two pictures, in steps of 256.
#[track_caller]
fn difference(a: &RgbImage, b: &RgbImage) -> u8 {
    assert_eq!(a.dimensions(), b.dimensions());
    let pairs = a.iter().zip(b.iter());
    pairs.map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
}

/// Whether there is a panel: dark, with light words and blue bars on it.
#[track_caller]
fn check_panel(panel: &RgbImage) {
    let pixels = f64::from(panel.width() * panel.height());
    let share =
        |is: fn([u8; 3]) -> bool| panel.pixels().filter(|p| is(p.0)).count() as f64 / pixels;
    let back = share(|p| p == [31, 32, 36]);
    let words = share(|[r, g, b]| r > 120 && g > 120 && b > 120);
    let blue = share(|[r, g, b]| b > 120 && b > r.saturating_add(50) && b > g);
    assert!((0.6..0.97).contains(&back), "{back} of the panel is empty");
    assert!(
        (0.005..0.2).contains(&words),
        "{words} of the panel is words"
    );
    assert!((0.001..0.2).contains(&blue), "{blue} of the panel is blue");
}

fn the_window_shows_what_render_makes() {
    let folder = Folder::new("still", STILL);
    let (window, text) = folder.picture("view", &["--size", "800x480"], None);
    assert!(text.contains("800 x 480 pixels, drawn in memory"), "{text}");
    assert_eq!(window.dimensions(), (800, 480));
    let (truth, _) = folder.picture("render", &["--size", "480x480"], None);
    let scene = part(&window, [0, 0], [800 - PANEL, 480]);
    assert!(difference(&scene, &truth) <= 1);
    // There is a scene: the cube's shadow and the sky.
    let (dark, bright) = (truth.iter().min().unwrap(), truth.iter().max().unwrap());
    assert!(bright - dark > 80, "{dark} to {bright}");
    check_panel(&part(&window, [800 - PANEL, 0], [PANEL, 480]));

    let settings = ["--size", "800x480", "--order", "2", "--shadows", "off"];
    let (window, _) = folder.picture("view", &settings, None);
    let scene = part(&window, [0, 0], [800 - PANEL, 480]);
    assert!(
        difference(&scene, &truth) > 20,
        "settings change the picture"
    );
}

fn frames_are_those_of_render() {
    let folder = Folder::new("moving", MOVING);
    let scene = |frames: &str| {
        let (window, _) = folder.picture("view", &["--size", "720x438", "--frames", frames], None);
        part(&window, [0, 0], [720 - PANEL, 438 - BAR])
    };
    let out = folder.file("f%d.png");
    let frames = [
        "--frames",
        "19..20",
        "--fps",
        "30",
        "--size",
        "400x400",
        "--backend",
        "cpu",
    ];
    let output = folder.run("render", &[&["-o", &out], &frames[..]].concat(), None);
    assert!(output.status.success());
    let truth = image::open(folder.file("f19.png"))
        .expect("a PNG")
        .into_rgb8();
    assert!(difference(&scene("20"), &truth) <= 1);
    assert!(difference(&scene("1"), &truth) > 20, "the cube has moved");
}

fn overlays_are_over_the_bodies() {
    let folder = Folder::new("overlays", STILL);
    let size = ["--size", "560x200"];
    let scene = |overlay: &str| {
        let arguments = [&size[..], &["--overlay", overlay]].concat();
        let (window, _) = folder.picture("view", &arguments, None);
        part(&window, [0, 0], [560 - PANEL, 200])
    };
    let plain = scene("none");
    let corner = |picture: &RgbImage| part(picture, [190, 0], [50, 30]);
    let spheres = scene("spheres");
    let both = plain.pixels().zip(spheres.pixels());
    let changed = both.filter(|(a, b)| a != b).count();
    assert!(
        (2_000..40_000).contains(&changed),
        "{changed} of 48000 pixels"
    );
    for overlay in ["clusters", "cut", "error"] {
        let over = scene(overlay);
        // Colours go to the edge: all that is seen is ground and a cube.
        assert!(
            difference(&corner(&plain), &corner(&over)) > 20,
            "{overlay}"
        );
        // The legend hides what is below it.
        let legend = part(&over, [20, 150], [200, 30]);
        let back = legend
            .pixels()
            .filter(|p| p.0.iter().all(|c| *c < 60))
            .count();
        assert!(
            back > 3000,
            "{overlay}: {back} pixels of the legend are empty"
        );
    }
}

fn misuse_is_told_in_a_sentence() {
    let folder = Folder::new("misuse", STILL);
    let refused: [(&[&str], &str); 5] = [
        (&[], "there is no display for a window"),
        (&["--screenshot", "window.jpg"], "must end in .png"),
        (&["--screenshot", "no/such/folder/window.png"], "window.png"),
        (&["--frames", "3"], "--screenshot"),
        (&["--screenshot", "a.png", "--order", "7"], "--order is 7"),
    ];
    for (arguments, named) in refused {
        let output = folder.run("view", arguments, None);
        let sentence = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(sentence.contains(named), "{arguments:?}: {sentence}");
    }
    // A display that is not there is no obstacle to a picture, and one to a window.
    let (_, text) = folder.picture("view", &["--size", "480x160"], Some(":4099"));
    assert!(text.contains("in memory"), "{text}");
    let output = folder.run("view", &[], Some(":4099"));
    let sentence = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1));
    assert!(sentence.contains("cannot open a window"), "{sentence}");
}

/// A virtual display, which goes with this.
struct Display(Child, String);

impl Display {
    fn new() -> Self {
        let mut server = Command::new("Xvfb")
            .args([
                "-displayfd",
                "1",
                "-screen",
                "0",
                "1024x768x24",
                "-nolisten",
                "tcp",
            ])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("Xvfb starts");
        let mut number = String::new();
        let output = server.stdout.take().expect("standard output is a pipe");
        BufReader::new(output)
            .read_line(&mut number)
            .expect("Xvfb says its number");
        Self(server, format!(":{}", number.trim()))
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

fn a_display_shows_the_same_window() {
    let folder = Folder::new("display", STILL);
    let display = Display::new();
    let size = ["--size", "800x480"];
    let (memory, _) = folder.picture("view", &size, None);
    let (window, text) = folder.picture("view", &size, Some(&display.1));
    assert!(text.contains("drawn on a display"), "{text}");
    let scene = |picture: &RgbImage| part(picture, [0, 0], [800 - PANEL, 480]);
    assert!(difference(&scene(&memory), &scene(&window)) <= 2);
    check_panel(&part(&window, [800 - PANEL, 0], [PANEL, 480]));
}
