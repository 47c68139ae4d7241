//! What cannot be done is told in a sentence, and nothing is left behind.

use crate::program::Folder;
use crate::{failure, run, success};

#[test]
fn wrong_arguments_are_refused_in_a_sentence() {
    let folder = Folder::new("lab-misuse");
    let missing = folder.file("missing");
    let (mesh, chart) = (folder.file("missing.obj"), folder.file("chart.bmp"));
    let broken = folder.put("broken.obj", "v nan 0 0\nf 1 1 1\n");
    let refused: [(&[&str], &str); 10] = [
        (&["fit", "--out", &missing], "--out"),
        (&["fit", "--only", "circles.txt"], "lens.txt"),
        (&["spheres", &mesh], "missing.obj"),
        (&["spheres", &broken], "broken.obj"),
        (&["spheres", "--counts", "0"], "--counts"),
        (&["bench", "battle", "--plot", &chart], "--plot"),
        (&["bench", "rays", "--plot", &chart], "chart.bmp"),
        (&["accuracy", "--plot", &chart], "chart.bmp"),
        (&["validate", "--size", "9000x9"], "at most 8192 pixels"),
        (&["sing"], "sing"),
    ];
    for (arguments, named) in refused {
        let sentence = failure(arguments);
        assert!(sentence.contains(named), "{arguments:?}: {sentence}");
    }
    assert_eq!(folder.names(), ["broken.obj"]);
}

#[test]
fn without_a_command_there_is_help() {
    let output = run(&[]);
    assert_eq!(output.status.code(), Some(1));
    let help = String::from_utf8_lossy(&output.stderr);
    for command in ["accuracy", "bench", "validate", "spheres", "fit"] {
        assert!(help.contains(command), "{help}");
        assert!(!success(&[command, "--help"]).is_empty());
    }
}

/// One file is fitted in a second, and it is what the sources hold.
#[test]
fn one_file_is_fitted_and_written() {
    let folder = Folder::new("lab-fit");
    let out = folder.file("");
    let told = success(&["fit", "--only", "lens.txt", "--out", &out]);
    assert!(told.contains("lens.txt new"), "{told}");
    assert_eq!(folder.names(), ["lens.txt"]);
    let told = success(&["fit", "--only", "lens.txt", "--out", &out]);
    assert!(told.contains("lens.txt unchanged"), "{told}");
}
