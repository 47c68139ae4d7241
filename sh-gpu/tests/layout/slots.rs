//! The slots of the table of passes are what the kernels are bound to: nothing is read or written that no slot tells of,
//! and no slot tells of what no kernel looks at.

use glam::Vec3;
use sh_kernels::{Binding, Kind, Pass as Kernel};
use sh_scene::plan::{Access, Facts, Slot};
use sh_scene::resource::SURFACES;
use sh_scene::{
    Camera, Domain, EnvironmentMap, Indirect, Limits, PASSES, Pass, Plan, Scene, Settings,
};

/// What passes are bound to that is nobody else's: kernel, what it calls it, and what it is.
const PRIVATE: [(&str, &str, &str); 19] = [
    (
        "light_view",
        "nearest",
        "what was drawn, before it is made coarser",
    ),
    ("punctual", "eye", "from where what is mirrored is seen"),
    ("gbuffer", "band", "the part of the picture at hand"),
    ("gbuffer", "places", "what was drawn, before it is packed"),
    ("gbuffer", "surfaces", "what was drawn, before it is packed"),
    ("resolve", "band", "the part of the picture at hand"),
    ("upsample", "band", "the part of the picture at hand"),
    ("upsample", "rule", "constants"),
    ("irradiance", "eye", "from where what is mirrored is seen"),
    ("shadow", "eye", "from where what is mirrored is seen"),
    ("light_gather", "eye", "from where what is mirrored is seen"),
    ("basis_gather", "eye", "from where what is mirrored is seen"),
    (
        "light_gather",
        "lighting",
        "limits, and how many nodes there are",
    ),
    ("light_update", "lighting", "how many nodes there are"),
    ("light_update", "cells", "constants"),
    (
        "basis_gather",
        "lighting",
        "limits, and how many nodes there are",
    ),
    (
        "basis_update",
        "before",
        "what bodies gave themselves in the turn before",
    ),
    ("basis_update", "weights", "of bodies' functions"),
    ("basis_update", "weighed", "of bodies' functions"),
];

fn scene() -> Scene {
    Scene {
        punctual: Vec::new(),
        objects: Vec::new(),
        environment: EnvironmentMap {
            width: 1,
            height: 1,
            pixels: vec![[1.0; 3]],
        },
        lights: Vec::new(),
        ground: None,
        camera: Camera {
            eye: Vec3::ONE,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        settings: Settings {
            order: 4,
            accumulation: 4,
            shadows: true,
            window: None,
            half_resolution: true,
            limits: Limits::default(),
            gloss: true,
            indirect: Some(Indirect {
                bounces: 2,
                ..Indirect::default()
            }),
        },
    }
}

/// What a scene calls for that has everything, with and without shadows, at half and at full resolution.
fn facts<'a>(scene: &'a Scene) -> Vec<Facts<'a>> {
    let with = |shadows: bool, half: bool| Facts {
        blockers: 2,
        lamps: 1,
        uneven: 1,
        drawn: 1,
        shadows,
        half,
        senders: Ok(2),
        punctual: 2,
        ..Facts::of(scene, false)
    };
    let by_patches = |facts: Facts<'a>| Facts {
        senders: Err("none"),
        patched: Ok(2),
        ..facts
    };
    vec![
        with(true, true),
        with(true, false),
        with(false, false),
        by_patches(with(true, true)),
        by_patches(with(true, false)),
    ]
}

/// What the entry points that a pass has of its own are bound to.
fn bound(pass: &Pass, facts: &Facts) -> Vec<(&'static str, &'static Binding)> {
    let mut all = Vec::new();
    for entry in (pass.entries)(facts) {
        let kernel = Kernel::ALL.into_iter().find(|k| k.name() == entry.kernel);
        let kernel = kernel.unwrap_or_else(|| panic!("there is no kernel {}", entry.kernel));
        // A pipeline that draws is two entry points.
        let stages = [
            entry.name.to_string(),
            format!("{}_vertex", entry.name),
            format!("{}_fragment", entry.name),
        ];
        let points = kernel.entries().iter();
        let points = points.filter(|point| stages.iter().any(|stage| stage == point.name));
        let before = all.len();
        all.extend(points.flat_map(|point| point.bindings.iter().map(|b| (kernel.name(), b))));
        assert!(all.len() > before, "{} has no {}", entry.kernel, entry.name);
    }
    all
}

/// Whether a slot tells of what a kernel does with something.
fn tells(slot: &Slot, binding: &Binding) -> bool {
    let written = matches!(slot.access, Access::Write | Access::Modify | Access::Add);
    let read = slot.access != Access::Write;
    slot.bindings.contains(&binding.name)
        && match binding.kind {
            Kind::Written | Kind::Target => written,
            _ => read,
        }
}

#[test]
fn kernels_are_bound_to_what_slots_tell_of() {
    let scene = scene();
    let mut checked = 0;
    for facts in facts(&scene) {
        for pass in PASSES {
            let Ok(runs) = (pass.wanted)(&facts) else {
                continue;
            };
            let bindings = bound(pass, &facts);
            for run in runs {
                let slots = (pass.slots)(run.at);
                for (kernel, binding) in &bindings {
                    let private = PRIVATE
                        .iter()
                        .any(|(k, n, _)| (*k, *n) == (*kernel, binding.name));
                    // Written at half resolution as well, where nobody asks for it.
                    let idle = binding.name == "albedo" && run.at == Domain::Halves;
                    let told = slots.iter().any(|slot| tells(slot, binding));
                    assert!(
                        told != (private || idle),
                        "{pass:?} over {}: {binding:?}",
                        run.at.name()
                    );
                    checked += 1;
                }
                for slot in slots.iter().filter(|slot| !slot.bindings.is_empty()) {
                    // Without a body or a ground, whatever is drawn is not there.
                    let drawn = slot.resource == SURFACES;
                    // What is written may be read; that it is written, another slot tells of.
                    let bound = bindings.iter().any(|(_, binding)| {
                        let named = slot.bindings.contains(&binding.name);
                        tells(slot, binding) || (named && binding.kind == Kind::Written)
                    });
                    assert!(bound || drawn, "{pass:?} over {}: {slot:?}", run.at.name());
                }
            }
        }
    }
    assert!(checked > 60, "{checked}");
    assert!(Plan::new(&scene).check().is_ok());
}
