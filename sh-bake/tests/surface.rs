//! Surface samples of loaded scenes: made where they are asked for, kept, and carried along.

use glam::{Quat, Vec3};
use sh_bake::{Cache, ClipChoice, Loaded, load_scene_with, shapes};
use sh_scene::surface::DIRECTIONS;
use sh_scene::{Blocking, Indirect, IrradianceBasis, Method};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// A folder of its own for each test, gone afterwards.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let name = format!("sh-bake-surface-{test}-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        let mesh = shapes::capsule(0.5, 1.0);
        let mut text = String::new();
        for [x, y, z] in &mesh.positions {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        for t in &mesh.triangles {
            let [a, b, c] = t.map(|i| i + 1);
            writeln!(text, "f {a} {b} {c}").unwrap();
        }
        std::fs::write(path.join("capsule.obj"), text).unwrap();
        Self(path)
    }

    /// Two capsules that differ in what `second` says, and whatever else.
    fn scene(&self, second: &str, rest: &str) -> PathBuf {
        let path = self.0.join("scene.toml");
        let object = "[[objects]]\nmesh = \"capsule.obj\"\nspheres = 3\n";
        std::fs::write(&path, format!("{object}{object}{second}\n{rest}")).unwrap();
        path
    }

    fn cache(&self) -> Cache {
        Cache::at(self.0.join("cache"))
    }

    /// The files of the cache that end so.
    fn kept(&self, ending: &str) -> Vec<PathBuf> {
        let entries = std::fs::read_dir(self.0.join("cache"));
        let paths = entries
            .into_iter()
            .flatten()
            .map(|entry| entry.unwrap().path());
        paths
            .filter(|p| p.extension().is_some_and(|e| e == ending))
            .collect()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

const INDIRECT: &str = "[indirect]\nmethod = \"spherical-lights\"\n";

fn load(scene: &Path, cache: Option<&Cache>) -> Loaded {
    load_scene_with(scene, ClipChoice::None, cache, &|_| {}).unwrap()
}

#[test]
fn surfaces_are_sampled_where_a_scene_asks_for_it() {
    let folder = Folder::new("asked");
    let without = load(&folder.scene("", ""), None);
    assert_eq!(without.scene.settings.indirect, None);
    assert!(without.scene.objects.iter().all(|o| o.surface.is_empty()));
    assert!(without.report.surfaces.is_empty());

    let rest = format!("{INDIRECT}bounces = 3\nblocking = \"object\"\n");
    let told = Mutex::new(Vec::new());
    let path = folder.scene("albedo = 0.5\ntranslate = [0, 9, 0]", &rest);
    let with = load_scene_with(&path, ClipChoice::None, None, &|step| {
        if step.stage == "sampling surfaces" {
            told.lock().unwrap().push((step.done, step.total));
        }
    });
    let with = with.unwrap();
    let indirect = Indirect {
        bounces: 3,
        blocking: Blocking::Object,
        ..Indirect::default()
    };
    assert_eq!(with.scene.settings.indirect, Some(indirect));
    for (object, albedo) in with.scene.objects.iter().zip([0.8, 0.5]) {
        assert_eq!(object.surface.spheres(), object.spheres.len());
        let points = &object.surface.points;
        assert!(points.len() > DIRECTIONS, "{}", points.len());
        let bright = points
            .iter()
            .filter(|p| (p.albedo[1] - albedo).abs() < 1e-5)
            .count();
        assert!(2 * bright > points.len(), "{bright} of {}", points.len());
        assert!(points.iter().all(|p| p.albedo[1] < albedo + 1e-5));
    }
    let told = told.into_inner().unwrap();
    assert!(told.contains(&(0, 6)) && told.contains(&(6, 6)), "{told:?}");
    let reports = &with.report.surfaces;
    assert_eq!(reports.len(), 2);
    for (report, object) in reports.iter().zip(&with.scene.objects) {
        assert_eq!(
            (report.spheres, report.points),
            (3, object.surface.points.len())
        );
        assert_eq!(report.bytes, object.surface.bytes());
        assert!(!report.cached && report.name == "capsule.obj");
    }
}

#[test]
fn samples_are_found_again_bit_by_bit() {
    let folder = Folder::new("again");
    let cache = folder.cache();
    let scene = folder.scene("translate = [0, 9, 0]", INDIRECT);
    let without = load(&scene, None);
    let first = load(&scene, Some(&cache));
    assert_eq!(
        folder.kept("surface").len(),
        1,
        "bodies that are alike are one"
    );
    let second = load(&scene, Some(&cache));
    let cached = [&without, &first, &second].map(|l| l.report.surfaces[0].cached);
    assert_eq!(cached, [false, false, true]);
    for loaded in [&first, &second] {
        assert_eq!(loaded.report.surfaces.len(), 1);
        for (object, before) in loaded.scene.objects.iter().zip(&without.scene.objects) {
            assert_eq!(object.surface, before.surface);
        }
    }
    // Another colour is another surface of the same spheres.
    let other = load(&folder.scene("albedo = 0.1", INDIRECT), Some(&cache));
    let cached: Vec<bool> = other.report.surfaces.iter().map(|s| s.cached).collect();
    assert_eq!(cached, [true, false]);
    assert_eq!(
        (folder.kept("surface").len(), folder.kept("spheres").len()),
        (2, 1)
    );
}

#[test]
fn a_damaged_file_is_as_good_as_none_and_is_replaced() {
    let folder = Folder::new("damaged");
    let cache = folder.cache();
    let scene = folder.scene("", INDIRECT);
    let truth = load(&scene, Some(&cache));
    let file = folder.kept("surface").remove(0);
    let good = std::fs::read(&file).unwrap();
    let mut damaged = vec![
        Vec::new(),
        good[..good.len() - 1].to_vec(),
        good[..16].to_vec(),
    ];
    for place in [0, 17, 60, good.len() - 1] {
        let mut bytes = good.clone();
        bytes[place] ^= 4;
        damaged.push(bytes);
    }
    for bytes in damaged {
        std::fs::write(&file, &bytes).unwrap();
        let loaded = load(&scene, Some(&cache));
        assert!(!loaded.report.surfaces[0].cached, "{} bytes", bytes.len());
        assert_eq!(
            loaded.scene.objects[0].surface,
            truth.scene.objects[0].surface
        );
        assert_eq!(std::fs::read(&file).unwrap(), good);
    }
    assert!(load(&scene, Some(&cache)).report.surfaces[0].cached);
}

#[test]
fn samples_go_along_with_a_clip() {
    let folder = Folder::new("clip");
    let mesh = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/good/animated.gltf");
    let path = folder.0.join("clip.toml");
    let object = format!("[[objects]]\nmesh = {mesh:?}\nspheres = 2\nclip = \"0\"\n");
    std::fs::write(&path, object + INDIRECT).unwrap();
    let mut loaded = load(&path, None);
    let period = loaded.motion.period();
    let mut moved = 0.0_f32;
    let start = loaded.scene.objects[0].surface.clone();
    assert!(!start.points.is_empty());
    for frame in 0..8 {
        loaded
            .motion
            .pose(period * f64::from(frame) / 8.0, &mut loaded.scene);
        let object = &loaded.scene.objects[0];
        for (i, sphere) in object.spheres.iter().enumerate() {
            let turn = Quat::from_array(object.surface.rotations[i]);
            assert!((turn.length() - 1.0).abs() < 1e-5);
            for (p, before) in object.surface.of(i).iter().zip(start.of(i)) {
                let away = Vec3::from(p.position).distance(sphere.center.into());
                assert!(away < 2.0 * sphere.radius, "a point left its sphere: {p:?}");
                let from = Vec3::from(before.position);
                moved = moved.max(from.distance(p.position.into()));
            }
        }
    }
    assert!(moved > 0.1, "{moved}");
}

/// Bodies whose light is told in functions have these in place of samples, found once for those that are alike, in as many
/// functions as the scene asks for, and from the cache bit by bit. A damaged file is as good as none.
#[test]
fn functions_are_found_where_a_scene_asks_for_them() {
    let folder = Folder::new("functions");
    let asks = "[indirect]\nmethod = \"basis-irradiance\"\nbounces = 2\nbasis = 5\n";
    let (scene, cache) = (folder.scene("albedo = 0.5", asks), folder.cache());
    let first = load(&scene, Some(&cache));
    let indirect = first.scene.settings.indirect.unwrap();
    assert_eq!(
        (indirect.method, indirect.bounces),
        (Method::BasisIrradiance, 2)
    );
    let bases = |loaded: &Loaded| -> Vec<Arc<IrradianceBasis>> {
        let objects = loaded.scene.objects.iter();
        objects
            .map(|o| Arc::clone(o.basis.as_ref().unwrap()))
            .collect()
    };
    let found = bases(&first);
    assert!(found.iter().all(|basis| basis.count() == 5));
    assert!(first.scene.objects.iter().all(|o| o.surface.is_empty()));
    // They differ in their albedo, and so in what patches send on.
    assert_eq!(first.report.bases.len(), 2);
    assert_ne!(found[0].sends(), found[1].sends());
    assert!(first.report.bases.iter().all(|b| b.held > 0.5 && !b.cached));
    let second = load(&scene, Some(&cache));
    assert!(second.report.bases.iter().all(|b| b.cached));
    assert_eq!(bases(&second), found);
    let kept = folder.kept("basis");
    assert_eq!(kept.len(), 2);
    for (file, cut) in kept.iter().zip([100, 40_000]) {
        let bytes = std::fs::read(file).unwrap();
        std::fs::write(file, &bytes[..cut]).unwrap();
    }
    let third = load(&scene, Some(&cache));
    assert!(third.report.bases.iter().all(|b| !b.cached));
    assert_eq!(bases(&third), found);
    // Alike, they share one.
    let alike = load(&folder.scene("", asks), None);
    let [a, b] = &bases(&alike)[..] else {
        panic!("two bodies")
    };
    assert!(Arc::ptr_eq(a, b) && alike.report.bases.len() == 1);
}
