use super::*;
use crate::surface::SurfacePoint;
use crate::{
    AreaLight, Camera, Distribution, EnvironmentMap, Ground, Indirect, Material, Mesh, Object,
    Settings, Sphere,
};
use glam::{Affine3A, Vec3};

fn scene(spheres: usize, shadows: bool) -> Scene {
    let object = Object {
        name: "ball".into(),
        mesh: Mesh::default(),
        material: Material {
            albedo: [0.5; 3],
            texture: None,
        },
        transform: Affine3A::IDENTITY,
        spheres: vec![
            Sphere {
                center: [0.0; 3],
                radius: 1.0
            };
            spheres
        ],
        weights: Vec::new(),
        part_of: None,
        surface: Default::default(),
    };
    Scene {
        objects: vec![object],
        environment: EnvironmentMap::constant([1.0; 3]),
        lights: Vec::new(),
        ground: Some(Ground {
            height: 0.0,
            albedo: [0.5; 3],
        }),
        camera: Camera {
            eye: Vec3::Z,
            target: Vec3::ZERO,
            fov: 1.0,
        },
        settings: Settings {
            shadows,
            ..Settings::default()
        },
    }
}

#[test]
fn an_effect_taken_away_leaves_the_plan_of_a_scene_that_never_had_it() {
    let never = Plan::new(&scene(0, false));
    let blank = Plan::new(&scene(0, true));
    assert_eq!(blank.passes, never.passes, "shadows on, but nothing blocks");
    assert_eq!(blank.shaders, never.shaders);
    let off = Plan::new(&scene(8, false));
    assert_eq!(off.passes, never.passes, "blockers, but shadows off");
    assert_eq!(off.shaders, never.shaders);
    let with = Plan::new(&scene(8, true));
    assert_ne!(with, never);
    assert!(with.has(PassKind::Shadow) && !with.has(PassKind::Irradiance));
    assert!(never.has(PassKind::Irradiance) && !never.has(PassKind::Shadow));
    assert!(with.has(PassKind::Upsample) && !never.has(PassKind::Upsample));
}

#[test]
fn light_is_sent_on_only_where_something_can_see_it() {
    let mut bounced = scene(8, true);
    let without = Plan::new(&bounced);
    bounced.settings.indirect = Some(Indirect::default());
    let blank = Plan::new(&bounced);
    assert_eq!(blank.passes, without.passes, "no surface has been sampled");
    for _ in 0..8 {
        bounced.objects[0].surface.push([SurfacePoint::default()]);
    }
    let with = Plan::new(&bounced);
    assert!(with.has(PassKind::LightUpdate) && with.has(PassKind::LightGather));
    bounced.settings.half_resolution = false;
    assert!(Plan::new(&bounced).has(PassKind::LightGather));
    bounced.settings.indirect = None;
    bounced.settings.half_resolution = true;
    assert_eq!(Plan::new(&bounced), without);
    // One convex body alone sees nothing that it lights.
    let mut alone = scene(1, true);
    alone.settings.indirect = Some(Indirect::default());
    alone.objects[0].surface.push([SurfacePoint::default()]);
    assert!(
        Plan::new(&alone).has(PassKind::LightGather),
        "the ground does"
    );
    alone.ground = None;
    assert!(!Plan::new(&alone).has(PassKind::LightGather));
}

#[test]
fn every_pass_reads_what_is_there() {
    let mut full = scene(8, true);
    full.settings.half_resolution = false;
    let mut bounced = full.clone();
    bounced.settings.indirect = Some(Indirect::default());
    bounced.objects[0].surface.push([SurfacePoint::default()]);
    let mut half = bounced.clone();
    half.settings.half_resolution = true;
    for scene in [scene(8, true), scene(0, true), full, bounced, half] {
        let plan = Plan::new(&scene);
        let mut there = Vec::new();
        for pass in &plan.passes {
            for read in pass.reads() {
                let made = read.resolution() == Resolution::Fixed || there.contains(read);
                assert!(
                    made,
                    "{} reads {read:?} before it is written",
                    pass.kind.name()
                );
            }
            there.extend_from_slice(pass.writes());
        }
        assert!(there.contains(&Resource::Picture));
    }
}

#[test]
fn reasons_are_sentences() {
    for pass in Plan::new(&scene(1, true)).passes {
        assert!(
            pass.reason.ends_with('.') && pass.reason.contains(' '),
            "{}",
            pass.reason
        );
    }
    let text = Plan::new(&scene(1, true)).to_string();
    assert!(
        text.contains("1 object and the ground") && text.contains("1 blocker sphere."),
        "{text}"
    );
}

#[test]
fn a_higher_order_of_accumulation_is_told() {
    let mut scene = scene(3, true);
    assert!(!Plan::new(&scene).to_string().contains("accumulated"));
    scene.settings.accumulation = 6;
    let text = Plan::new(&scene).to_string();
    assert!(
        text.contains("order 4") && text.contains("accumulated in order 6."),
        "{text}"
    );
    scene.settings.shadows = false;
    assert!(!Plan::new(&scene).to_string().contains("accumulated"));
}

/// Effects one at a time: each adds something, and nothing of it is left when it is taken away again.
#[test]
fn what_an_effect_adds_goes_with_it() {
    type Effect = (&'static str, fn(&mut Scene), fn(&mut Scene));
    let lamp = AreaLight::distant(Vec3::Y, 0.1, [1.0; 3]);
    let mut plain = scene(8, true);
    plain.settings.half_resolution = false;
    for _ in 0..8 {
        plain.objects[0].surface.push([SurfacePoint::default()]);
    }
    plain.lights = vec![AreaLight {
        radiance: [0.0; 3],
        ..lamp
    }];
    let effects: [Effect; 4] = [
        (
            "lamps",
            |s| s.lights[0].radiance = [1.0; 3],
            |s| s.lights[0].radiance = [0.0; 3],
        ),
        (
            "upsample",
            |s| s.settings.half_resolution = true,
            |s| s.settings.half_resolution = false,
        ),
        (
            "light_gather",
            |s| s.settings.indirect = Some(Indirect::default()),
            |s| s.settings.indirect = None,
        ),
        (
            "irradiance",
            |s| s.settings.shadows = false,
            |s| s.settings.shadows = true,
        ),
    ];
    let before = Plan::new(&plain);
    for (name, add, remove) in &effects {
        assert!(
            before.left_out.iter().any(|left| left.name == *name),
            "{name}"
        );
        let mut scene = plain.clone();
        add(&mut scene);
        let with = Plan::new(&scene);
        assert!(
            !with.left_out.iter().any(|left| left.name == *name),
            "{name}"
        );
        assert_ne!(with.shaders, before.shaders, "{name}");
        remove(&mut scene);
        assert_eq!(Plan::new(&scene), before, "{name}");
    }
}

/// Shaders know of distributions where a lamp that shines has one, and the reason tells.
#[test]
fn distributions_are_in_the_plan_of_lamps_that_have_one() {
    let mut scene = scene(8, true);
    scene.lights = vec![AreaLight::local(Vec3::Y * 3.0, 0.1, [1.0; 3]); 2];
    let even = Plan::new(&scene);
    scene.lights[1].distribution = Distribution::cap(Vec3::X, 1.0).ok();
    let uneven = Plan::new(&scene);
    let knows = |plan: &Plan| {
        let mut constants = plan.shaders.iter().flat_map(|s| &s.constants);
        constants.any(|constant| *constant == ("DISTRIBUTIONS", true))
    };
    assert!(!knows(&even) && knows(&uneven));
    assert!(!even.to_string().contains("distribution"));
    assert!(
        uneven
            .to_string()
            .contains("2 lamps, 1 with a distribution"),
        "{uneven}"
    );
    scene.lights[1].radiance = [0.0; 3];
    assert!(!knows(&Plan::new(&scene)));
}

#[test]
fn what_is_left_out_is_told_in_sentences() {
    let mut bare = scene(0, true);
    bare.ground = None;
    let left = Plan::new(&bare).left_out;
    let names: Vec<_> = left.iter().map(|left| left.name).collect();
    let expected = [
        "shadow",
        "upsample",
        "light_update",
        "light_gather",
        "lamps",
        "ground",
        "bodies",
    ];
    assert_eq!(names, expected);
    for LeftOut { name, reason } in left {
        assert!(
            reason.ends_with('.') && reason.contains(' '),
            "{name}: {reason}"
        );
    }
}

/// A kernel's module is shared by its entry points, and every pipeline is there once.
#[test]
fn shaders_are_those_of_the_passes() {
    let mut all = scene(8, true);
    all.settings.indirect = Some(Indirect::default());
    all.objects[0].surface.push([SurfacePoint::default()]);
    let plan = Plan::new(&all);
    let kinds: Vec<_> = plan.passes.iter().map(|pass| pass.kind).collect();
    for (i, shader) in plan.shaders.iter().enumerate() {
        assert!(kinds.contains(&shader.pass), "{shader}");
        assert!(!plan.shaders[..i].contains(shader), "{shader}");
    }
    for kind in kinds {
        assert!(
            plan.shaders.iter().any(|shader| shader.pass == kind),
            "{}",
            kind.name()
        );
    }
    let text: Vec<_> = plan.shaders.iter().map(Shader::to_string).collect();
    assert!(
        text.contains(&"shadow, order 4, without LAMPS, without DISTRIBUTIONS".to_string()),
        "{text:?}"
    );
    assert!(
        text.contains(
            &"upsample, order 4, without LAMPS, without DISTRIBUTIONS, with SENT".to_string()
        ),
        "{text:?}"
    );
}
