//! Sphere sets on disk: found again, and never in the way.

use sh_bake::{Cache, ClipChoice, Loaded, load_scene_with, shapes};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A folder of its own for each test, gone afterwards.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path =
            std::env::temp_dir().join(format!("sh-bake-cache-{test}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// A scene of one cone.
    fn scene(&self) -> PathBuf {
        let mesh = shapes::cone(1.0, 2.0);
        let mut text = String::new();
        for [x, y, z] in &mesh.positions {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|i| i + 1);
            writeln!(text, "f {a} {b} {c}").unwrap();
        }
        std::fs::write(self.0.join("cone.obj"), text).unwrap();
        self.counted(6)
    }

    /// A scene of the cone with so many spheres.
    fn counted(&self, count: usize) -> PathBuf {
        let path = self.0.join(format!("cone-{count}.toml"));
        let text = format!("[[objects]]\nmesh = \"cone.obj\"\nspheres = {count}\n");
        std::fs::write(&path, text).unwrap();
        path
    }

    fn cache(&self) -> Cache {
        Cache::at(self.0.join("cache"))
    }

    /// The sets in the cache.
    fn kept(&self) -> Vec<PathBuf> {
        self.files("spheres")
    }

    /// The files of the cache with an ending.
    fn files(&self, ending: &str) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(self.0.join("cache"))
            .into_iter()
            .flatten();
        let paths = entries.map(|entry| entry.unwrap().path());
        paths
            .filter(|path| path.extension().is_some_and(|e| e == ending))
            .collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn load(scene: &Path, cache: Option<&Cache>) -> Loaded {
    load_scene_with(scene, ClipChoice::None, cache, &|_| {}).unwrap()
}

#[test]
fn a_set_is_found_again_bit_by_bit() {
    let folder = Folder::new("again");
    let (scene, cache) = (folder.scene(), folder.cache());
    let without = load(&scene, None);
    assert!(folder.kept().is_empty());
    let first = load(&scene, Some(&cache));
    assert_eq!(folder.kept().len(), 1);
    let second = load(&scene, Some(&cache));
    let cached = [&without, &first, &second].map(|loaded| loaded.report.fits[0].cached);
    assert_eq!(cached, [false, false, true]);
    assert_eq!(folder.files("weights").len(), 1);
    let cached = [&without, &first, &second].map(|loaded| loaded.report.weights[0].cached);
    assert_eq!(cached, [false, false, true]);
    // Weights that are damaged are found anew.
    std::fs::write(&folder.files("weights")[0], b"gaunt weights 1\nnone").unwrap();
    let third = load(&scene, Some(&cache));
    assert!(!third.report.weights[0].cached);
    for loaded in [&first, &second, &third] {
        let weights = |loaded: &Loaded| loaded.scene.objects[0].weights.clone();
        assert_eq!(weights(loaded), weights(&without));
        assert_eq!(weights(loaded).len(), loaded.scene.objects[0].spheres.len());
    }
    for loaded in [&first, &second] {
        assert_eq!(
            loaded.scene.objects[0].spheres,
            without.scene.objects[0].spheres
        );
        let ratio = |loaded: &Loaded| {
            loaded.report.fits[0]
                .outside_volume_ratio
                .unwrap()
                .to_bits()
        };
        assert_eq!(ratio(loaded), ratio(&without));
    }
    // Another number of spheres is another set.
    let other = load(&folder.counted(5), Some(&cache));
    assert!(!other.report.fits[0].cached);
    assert_eq!(folder.kept().len(), 2);
}

#[test]
fn a_damaged_file_is_as_good_as_none_and_is_replaced() {
    let folder = Folder::new("damaged");
    let (scene, cache) = (folder.scene(), folder.cache());
    let truth = load(&scene, Some(&cache));
    let file = folder.kept().remove(0);
    let good = std::fs::read(&file).unwrap();
    let mut damaged: Vec<Vec<u8>> = vec![
        Vec::new(),
        vec![0; 20],
        good[..good.len() - 1].to_vec(),
        good[..good.len() - 16].to_vec(),
        good[..16].to_vec(),
        [&good[..], &[0; 16]].concat(),
    ];
    // One bit, in the first bytes, the ratio, a sphere and the hash.
    for place in [0, 17, 30, good.len() - 1] {
        let mut bytes = good.clone();
        bytes[place] ^= 4;
        damaged.push(bytes);
    }
    for bytes in damaged {
        std::fs::write(&file, &bytes).unwrap();
        let loaded = load(&scene, Some(&cache));
        assert!(!loaded.report.fits[0].cached, "{} bytes", bytes.len());
        assert_eq!(
            loaded.scene.objects[0].spheres,
            truth.scene.objects[0].spheres
        );
        assert_eq!(std::fs::read(&file).unwrap(), good);
    }
    assert!(load(&scene, Some(&cache)).report.fits[0].cached);
    assert_eq!(folder.kept().len(), 1, "nothing is left behind");
    assert!(folder.files("part").is_empty(), "nothing is left behind");
}

#[test]
fn a_folder_that_cannot_be_is_no_error() {
    let folder = Folder::new("nowhere");
    let scene = folder.scene();
    // Where the folder would be there is a file.
    std::fs::write(folder.0.join("cache"), "in the way").unwrap();
    let loaded = load(&scene, Some(&folder.cache()));
    assert!(!loaded.report.fits[0].cached && !loaded.scene.objects[0].spheres.is_empty());
    // And where the set's file would be there is a folder.
    std::fs::remove_file(folder.0.join("cache")).unwrap();
    load(&scene, Some(&folder.cache()));
    let file = folder.kept().remove(0);
    std::fs::remove_file(&file).unwrap();
    std::fs::create_dir(&file).unwrap();
    assert!(!load(&scene, Some(&folder.cache())).report.fits[0].cached);
    assert_eq!(folder.kept(), [file]);
}

#[test]
fn several_at_once_do_no_harm() {
    let folder = Folder::new("several");
    let (scene, cache) = (folder.scene(), folder.cache());
    let spheres: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4)
            .map(|_| scope.spawn(|| load(&scene, Some(&cache))))
            .collect();
        let loaded = threads.into_iter().map(|thread| thread.join().unwrap());
        loaded
            .map(|loaded| loaded.scene.objects[0].spheres.clone())
            .collect()
    });
    assert!(spheres.iter().all(|s| *s == spheres[0]));
    assert_eq!(folder.kept().len(), 1);
    assert!(load(&scene, Some(&cache)).report.fits[0].cached);
}

#[test]
fn progress_moves_within_a_fit_and_ends_complete() {
    let folder = Folder::new("progress");
    let told = std::sync::Mutex::new(Vec::new());
    load_scene_with(&folder.scene(), ClipChoice::None, None, &|step| {
        if step.stage == "fitting spheres" {
            told.lock().unwrap().push((step.done, step.total));
        }
    })
    .unwrap();
    let told = told.into_inner().unwrap();
    let total = told[0].1;
    assert!(
        told.iter().all(|(done, all)| done <= all && *all == total),
        "{told:?}"
    );
    assert!(told.contains(&(0, total)) && told.contains(&(total, total)));
    let between = told
        .iter()
        .filter(|(done, _)| (1..total).contains(done))
        .count();
    assert!(between >= 5, "{told:?}");
}
