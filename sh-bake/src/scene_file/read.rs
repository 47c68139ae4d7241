//! The file as a whole.

use super::content::SceneFile;
use super::sections;
use crate::error::{Error, read};
use crate::keys::{Section, Source};
use crate::objects::ObjectEntry;
use crate::{indirect, lights};
use sh_scene::IrradianceBasis;
use std::ops::Range;
use std::path::Path;

use toml::de::{DeTable, DeValue};

impl SceneFile {
    /// Reads a scene file.
    pub(crate) fn read(path: &Path) -> Result<Self, Error> {
        let bytes = read(path)?;
        let text = String::from_utf8(bytes).map_err(|e| {
            let valid = e.utf8_error().valid_up_to();
            Error::file(
                path,
                format!("the scene is not UTF-8 text after byte {valid}."),
            )
        })?;
        Self::parse(path, &text)
    }

    /// A scene of one mesh and nothing else said.
    pub(crate) fn of_mesh(path: &Path) -> Self {
        Self {
            of_mesh: true,
            objects: vec![ObjectEntry::of_mesh(path)],
            ..Self::default()
        }
    }

    /// Reads a scene's text; `path` is what relative paths are relative to and what errors name.
    pub(crate) fn parse(path: &Path, text: &str) -> Result<Self, Error> {
        let source = Source { path, text };
        let parsed = DeTable::parse(text).map_err(|e| {
            let message = format!(
                "the TOML cannot be understood: {}.",
                e.message().trim_end_matches('.')
            );
            source.error(&e.span().unwrap_or(0..0), message)
        })?;
        let (span, root) = (parsed.span(), parsed.get_ref());
        let top = [
            "objects",
            "lights",
            "environment",
            "ground",
            "indirect",
            "camera",
            "settings",
        ];
        let root_section = Section::new(source, "", span.clone(), root, &top)?;

        let mut scene = Self {
            objects: objects(&root_section, source, root)?,
            ..Self::default()
        };
        (scene.lights, scene.punctual) = lights::read(&root_section, path, &scene.objects)?;
        let section = |name: &'static str, known: &[&str]| match root.get(name) {
            None => Ok(None),
            Some(value) => {
                let table = table(source, name, value.span(), value.get_ref())?;
                Section::new(source, name, value.span(), table, known).map(Some)
            }
        };
        if let Some(s) = section("environment", &sections::ENVIRONMENT)? {
            scene.read_environment(&s, path)?;
        }
        if let Some(s) = section("ground", &sections::GROUND)? {
            scene.read_ground(&s)?;
        }
        if let Some(s) = section("indirect", &indirect::KEYS)? {
            scene.settings.indirect = Some(indirect::read(&s)?);
            if let Some(functions) = s.count("basis", 1..=IrradianceBasis::MOST)? {
                scene.functions = functions;
            }
        }
        if let Some(s) = section("camera", &sections::CAMERA)? {
            scene.read_camera(&s)?;
        }
        if let Some(s) = section("settings", &sections::SETTINGS)? {
            scene.read_settings(&s)?;
        }
        Ok(scene)
    }
}

/// The objects, of which there has to be one.
fn objects(
    root_section: &Section,
    source: Source,
    root: &DeTable,
) -> Result<Vec<ObjectEntry>, Error> {
    let entries = match root.get("objects").map(|v| (v.span(), v.get_ref())) {
        None => {
            let message = "is missing: a scene needs an [[objects]].";
            return Err(root_section.error("objects", message));
        }
        Some((_, DeValue::Array(array))) => array,
        Some((span, _)) => {
            let message = "objects has to be a list of tables, each headed [[objects]].";
            return Err(source.error(&span, message));
        }
    };
    let mut objects = Vec::new();
    for entry in entries.iter() {
        let table = table(source, "objects", entry.span(), entry.get_ref())?;
        objects.push(ObjectEntry::read(source, entry.span(), table)?);
    }
    if objects.is_empty() {
        return Err(root_section.error("objects", "is empty: a scene needs an [[objects]]."));
    }
    Ok(objects)
}

fn table<'a>(
    source: Source,
    name: &str,
    span: Range<usize>,
    value: &'a DeValue<'a>,
) -> Result<&'a DeTable<'a>, Error> {
    match value {
        DeValue::Table(table) => Ok(table),
        _ => Err(source.error(&span, format!("{name} has to be a table, headed [{name}]."))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sh_scene::Settings;

    fn parse(text: &str) -> Result<SceneFile, String> {
        SceneFile::parse(Path::new("dir/s.toml"), text).map_err(|e| e.to_string())
    }

    #[test]
    fn the_smallest_scene_has_a_sensible_rest() {
        let scene = parse("[[objects]]\nmesh = \"a.obj\"\n").unwrap();
        assert_eq!(scene.objects[0].mesh, Path::new("dir/a.obj"));
        assert_eq!(scene.objects[0].spheres, 32);
        assert_eq!(scene.settings, Settings::default());
        assert!(scene.ground && scene.map.is_none());
    }

    #[test]
    fn the_example_in_the_documentation_is_a_scene() {
        let example: String = include_str!("../lib.rs")
            .lines()
            .skip_while(|line| !line.contains("```toml"))
            .skip(1)
            .take_while(|line| !line.contains("```"))
            .map(|line| line.trim_start_matches("//!").to_string() + "\n")
            .collect();
        let scene = parse(&example).unwrap();
        let turned = glam::Quat::from_rotation_y(90.0_f32.to_radians());
        assert!(scene.objects[0].place.rotation.abs_diff_eq(turned, 1e-6));
        let keys = scene.objects[0].keys.as_ref().unwrap();
        assert_eq!(keys.duration(), 2.0);
        assert_eq!(scene.objects[0].clip.as_ref().unwrap().name, "Walk");
        assert!(scene.turn > 0.0);
        assert_eq!(scene.eye, Some([3.0, 2.0, 5.0]));
        assert_eq!(
            (scene.settings.order, scene.settings.window),
            (4, Some(8.0))
        );
        assert_eq!((scene.lights.len(), scene.punctual.len()), (2, 1));
        assert_eq!(scene.lights[1].object, Some(0));
        assert!(scene.lights[1].light.distribution.is_some());
        assert!(!scene.settings.half_resolution);
        assert_eq!(scene.settings.accumulation, 6);
        assert_eq!(scene.settings.indirect, Some(Default::default()));
    }

    #[test]
    fn what_is_wrong_is_named_with_file_line_and_key() {
        let object = "[[objects]]\nmesh = \"a.obj\"\n";
        for (text, expected) in [
            ("", "line 1: objects is missing"),
            ("objects = 3", "line 1: objects has to be a list of tables"),
            ("objects = [3]", "line 1: objects has to be a table"),
            ("objects = []", "line 1: objects is empty"),
            (
                "[[objects]]\nspheres = 3",
                "line 1: objects.mesh is missing",
            ),
            (
                "[[objects]]\nmesh = 3",
                "line 2: objects.mesh has to be a string, not a number.",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nshperes = 3",
                "line 3: the key `shperes` is not known in [objects]; did you mean `spheres`?",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nspheres = 0",
                "line 3: objects.spheres is 0, but it has to be a whole number from 1 to 4096.",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nspheres = 2.5",
                "line 3: objects.spheres is 2.5, but",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nscale = 0",
                "line 3: objects.scale is 0, but it has to be a number above 0",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nscale = nan",
                "line 3: objects.scale is NaN",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nalbedo = [1, 2, 0]",
                "line 3: objects.albedo has 2 in it",
            ),
            (
                "[[objects]]\nmesh = \"a.obj\"\nrotate = [1, 2]",
                "line 3: objects.rotate has to be three numbers",
            ),
            ("[[objects]\n", "line 1: the TOML cannot be understood"),
        ] {
            let message = parse(text).err().unwrap_or_default();
            assert!(
                message.starts_with("dir/s.toml, ") && message.contains(expected),
                "{text}: {message}"
            );
        }
        for (text, expected) in [
            (
                "[settings]\norder = 1",
                "line 4: settings.order is 1, but it has to be a whole number from 2 to 6.",
            ),
            ("[settings]\norder = 7", "line 4: settings.order is 7"),
            (
                "[settings]\norder = 5\naccumulation_order = 4",
                "line 5: settings.accumulation_order is 4, but it has to be a whole number from the order, 5, to 6.",
            ),
            (
                "[settings]\naccumulation_order = 7",
                "line 4: settings.accumulation_order is 7, but it has to be a whole number from 2 to 6.",
            ),
            (
                "[settings]\naccumulation_order = \"high\"",
                "line 4: settings.accumulation_order has to be a whole number from 2 to 6, not a string.",
            ),
            (
                "[settings]\naccumulation_oder = 5",
                "line 4: the key `accumulation_oder` is not known in [settings]; did you mean `accumulation_order`?",
            ),
            ("[settings]\nwindow = -1", "line 4: settings.window is -1"),
            (
                "[settings]\nblocker_angle = 31",
                "line 4: settings.blocker_angle is 31, but it has to be a number of degrees from 0 to 30.",
            ),
            (
                "[lights]\nradiance = 1",
                "line 3: lights has to be a list of tables, not a table.",
            ),
            (
                "[[lights]]\nradiance = 1",
                "line 3: lights.direction is missing: a light needs a direction and an angle, or a center and a radius.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 0",
                "line 5: lights.radius is 0, but it has to be a number of metres above 0.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nangle = 2",
                "line 5: lights.angle has no place beside center: a light needs a direction and an angle, or a center and a radius.",
            ),
            (
                "[[lights]]\ndirection = [0, 0, 0]\nangle = 2",
                "line 4: lights.direction has no length, so there is nowhere to shine from.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\nobject = \"b.obj\"",
                "line 7: lights.object is \"b.obj\", but no object is called so; the objects are a.obj.",
            ),
            (
                "[[objects]]\nmesh = \"b/a.obj\"\n[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\nobject = \"a.obj\"",
                "line 9: lights.object is \"a.obj\", but several objects are called so",
            ),
            (
                "[[lights]]\ndirection = [0, 1, 0]\nangle = 1\nradiance = 1\nobject = \"a.obj\"",
                "line 7: lights.object has no place beside direction: it is for a ball, which has a center.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\ntowards = [0, 1, 0]",
                "line 3: lights.spread is missing: it is the angle about `towards`",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\nspread = 90",
                "line 7: lights.spread says within which angle a ball glows, but there is no `towards`.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\nspread = 90\ntowards = [0, 0, 0]",
                "line 8: lights.towards has no length, so there is nowhere to glow to.",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\ndistribution = [1]\nmap = \"a.hdr\"",
                "line 7: lights.distribution has no place beside map: one of them says",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\ndistribution = [1, 2]",
                "line 7: lights.distribution has 2 SH coefficients, but an order has 1, 4, 9, 16, 25 or 36 of them",
            ),
            (
                "[[lights]]\ncenter = [0, 1, 0]\nradius = 1\nradiance = 1\ndistribution = [1, [2, 3], 4, 5]",
                "line 7: lights.distribution has to be a list of numbers, or of triples",
            ),
            (
                "[[lights]]\nkind = \"lamp\"",
                "line 4: lights.kind is \"lamp\", but it has to be \"spot\", \"point\" or \"sun\"",
            ),
            (
                "[[lights]]\nintensity = 2\nradiance = 1",
                "line 4: lights.intensity is for a light with sharp shadows",
            ),
            (
                "[[lights]]\nkind = \"point\"\nposition = [0, 1, 0]\nangle = 3\nintensity = 1",
                "line 6: lights.angle has no place in a point, which has position, radius,",
            ),
            (
                "[[lights]]\nkind = \"spot\"\nposition = [0, 1, 0]\nintensity = 1",
                "line 3: lights.towards is missing: it is the way that a spot shines.",
            ),
            (
                "[[lights]]\nkind = \"spot\"\nposition = [0, 1, 0]\ntowards = [0, -1, 0]\nangle = 180\nintensity = 1",
                "line 7: lights.angle is 180, but it has to be a number of degrees above 0 and below 180.",
            ),
            (
                "[[lights]]\nkind = \"point\"\nposition = [0, 1, 0]",
                "line 3: lights.intensity is missing: it is its radiant intensity",
            ),
            (
                "[[lights]]\nkind = \"sun\"\ndirection = [0, 1, 0]\nintensity = 1\nobject = \"a.obj\"",
                "line 7: lights.object has no place in a sun",
            ),
            (
                "[settings]\nshadows = 1",
                "line 4: settings.shadows has to be true or false, not a number.",
            ),
            (
                "[setings]\norder = 3",
                "line 3: the key `setings` is not known; did you mean `settings`?",
            ),
            ("[camera]\nfov = 0", "line 4: camera.fov is 0"),
            (
                "[camera]\neye = [1, 1, 1]\ntarget = [1, 1, 1]",
                "line 5: camera.target is the same point",
            ),
            (
                "[environment]\nintensity = -2",
                "line 4: environment.intensity is -2",
            ),
            (
                "[environment]\nfile = \"x\"",
                "line 4: the key `file` is not known in [environment], which knows map",
            ),
            ("[ground]\nheight = inf", "line 4: ground.height is inf"),
            ("ground = 3", "ground"),
        ] {
            let message = parse(&format!("{object}{text}")).err().unwrap_or_default();
            assert!(message.contains(expected), "{text}: {message}");
        }
    }

    #[test]
    fn settings_follow_the_order_where_they_say_nothing() {
        let settings = |text: &str| {
            let scene = parse(&format!(
                "[[objects]]\nmesh = \"a.obj\"\n[settings]\n{text}\n"
            ));
            scene.unwrap().settings
        };
        assert_eq!(settings("order = 6"), Settings::default().with_order(6));
        assert_eq!(settings("order = 2").window, None);
        assert_eq!(settings("order = 2\nwindow = 5").window, Some(5.0));
        let both = settings("accumulation_order = 6\norder = 3");
        assert_eq!((both.order, both.accumulation, both.window), (3, 6, None));
    }

    #[test]
    fn ground_can_be_left_out() {
        assert!(
            !parse("[[objects]]\nmesh = \"a.obj\"\n[ground]\nenabled = false")
                .unwrap()
                .ground
        );
    }
}
