use super::passes::{
    IRRADIANCE, LIGHT_GATHER, LIGHT_UPDATE, LIGHT_VIEW, PUNCTUAL, RESOLVE, SCATTER, SHADOW, SHARES,
    UPSAMPLE,
};
use super::*;
use crate::surface::SurfacePoint;
use crate::{
    AreaLight, Camera, Distribution, EnvironmentMap, Ground, Indirect, Material, Mesh, Object,
    PunctualLight, PunctualShape, Settings, Sphere,
};
use glam::Vec3;

fn scene(spheres: usize, shadows: bool) -> Scene {
    let object = Object {
        name: "ball".into(),
        mesh: Mesh::default(),
        material: Material::diffuse([0.5; 3]),
        spheres: vec![
            Sphere {
                center: [0.0; 3],
                radius: 1.0
            };
            spheres
        ],
        ..Object::default()
    };
    Scene {
        punctual: Vec::new(),
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
    assert!(with.has(&SHADOW) && !with.has(&IRRADIANCE));
    assert!(never.has(&IRRADIANCE) && !never.has(&SHADOW));
    assert!(with.has(&UPSAMPLE) && !never.has(&UPSAMPLE));
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
    assert!(with.has(&LIGHT_UPDATE) && with.has(&LIGHT_GATHER));
    bounced.settings.half_resolution = false;
    assert!(Plan::new(&bounced).has(&LIGHT_GATHER));
    bounced.settings.indirect = None;
    bounced.settings.half_resolution = true;
    assert_eq!(Plan::new(&bounced), without);
    // One convex body alone sees nothing that it lights.
    let mut alone = scene(1, true);
    alone.settings.indirect = Some(Indirect::default());
    alone.objects[0].surface.push([SurfacePoint::default()]);
    assert!(Plan::new(&alone).has(&LIGHT_GATHER), "the ground does");
    alone.ground = None;
    assert!(!Plan::new(&alone).has(&LIGHT_GATHER));
}

/// Scenes that call for as different plans as there are.
fn varied() -> Vec<Scene> {
    let mut full = scene(8, true);
    full.settings.half_resolution = false;
    let mut bounced = full.clone();
    bounced.settings.indirect = Some(Indirect::default());
    bounced.objects[0].surface.push([SurfacePoint::default()]);
    let mut half = bounced.clone();
    half.settings.half_resolution = true;
    let mut open = bounced.clone();
    open.settings.shadows = false;
    let mut again = half.clone();
    again.settings.indirect = Some(Indirect {
        bounces: 3,
        ..Indirect::default()
    });
    vec![
        scene(8, true),
        scene(0, true),
        full,
        bounced,
        half,
        open,
        again,
    ]
}

#[test]
fn every_pass_reads_what_is_there() {
    for scene in varied() {
        for plan in [Plan::new(&scene), Plan::of_receivers(&scene)] {
            assert_eq!(plan.check(), Ok(()), "{plan}");
            // Whichever pass is taken away, somebody misses what it gives; what only adds to light is not missed.
            for index in 0..plan.passes.len() {
                let mut less = plan.clone();
                let gone = less.passes.remove(index);
                let missed = match less.check() {
                    Err(PlanError::Missing { missing, .. }) => missing.contains(gone.name()),
                    Ok(()) => gone.is(&LIGHT_GATHER),
                    Err(_) => false,
                };
                assert!(missed, "{plan}\nwithout {gone:?}: {:?}", less.check());
            }
        }
    }
}

/// Whatever order the table has: what a pass needs comes before it, and phases are kept.
#[test]
fn the_order_of_passes_follows_from_their_slots() {
    for scene in varied() {
        let plan = Plan::new(&scene);
        let mut turned = plan.passes.clone();
        turned.reverse();
        let again = Plan {
            passes: order::sorted(turned),
            ..plan.clone()
        };
        assert_eq!(again.check(), Ok(()), "{again}");
        let mut backwards = plan.clone();
        backwards.passes.reverse();
        assert!(matches!(backwards.check(), Err(PlanError::Order { .. })));
    }
    let mut half = scene(8, true);
    half.settings.indirect = Some(Indirect::default());
    half.objects[0].surface.push([SurfacePoint::default()]);
    let plan = Plan::new(&half);
    let order: Vec<_> = plan
        .passes
        .iter()
        .map(|p| (p.name(), p.at.name()))
        .collect();
    assert_eq!(
        order,
        [
            ("points", "points"),
            ("shadow", "points"),
            ("light_update", "spheres"),
            ("gbuffer", "halves"),
            ("shadow", "halves"),
            ("light_gather", "halves"),
            ("shares", "halves"),
            ("gbuffer", "samples"),
            ("upsample", "samples"),
            ("shadow", "rest"),
            ("light_gather", "rest"),
            ("scatter", "rest"),
            ("resolve", "pixels"),
        ]
    );
}

/// Steps: once, then band by band through all passes of a phase.
#[test]
fn steps_go_through_all_passes_band_by_band() {
    let plan = Plan::new(&scene(8, true));
    let steps = plan.steps(2, 3);
    let names: Vec<_> = steps
        .iter()
        .map(|step| (plan.passes[step.pass].name(), step.part))
        .collect();
    let (coarse, fine) = (["gbuffer", "shadow", "shares"], plan.passes.len() - 3);
    assert_eq!(names.len(), 2 * coarse.len() + 3 * fine);
    for (step, name) in names.iter().zip(coarse) {
        assert_eq!(*step, (name, Part::Band(0)));
    }
    assert_eq!(names[3], ("gbuffer", Part::Band(1)));
    assert_eq!(names[6], ("gbuffer", Part::Band(0)));
    assert_eq!(names.last(), Some(&("resolve", Part::Band(2))));
    // A caller's receivers are lit at once.
    let lit = Plan::of_receivers(&scene(8, true));
    let step = Step {
        pass: 0,
        part: Part::Whole,
    };
    assert_eq!(lit.steps(0, 0), [step]);
}

/// Bounces are turns: in each but the first, points gather what the turn before has sent.
#[test]
fn bounces_are_turns_of_the_passes_over_points() {
    let mut bounced = scene(8, true);
    bounced.objects[0].surface.push([SurfacePoint::default()]);
    let steps = |bounces: u32| -> Vec<_> {
        let mut scene = bounced.clone();
        scene.settings.indirect = Some(Indirect {
            bounces,
            ..Indirect::default()
        });
        let plan = Plan::of_receivers(&scene);
        let steps = plan.steps(0, 0).into_iter();
        steps
            .map(|step| {
                let planned = &plan.passes[step.pass];
                (planned.name(), planned.at.name(), step.part)
            })
            .collect()
    };
    let first = |part| {
        [
            ("points", "points", part),
            ("shadow", "points", part),
            ("light_update", "spheres", part),
        ]
    };
    let last = |part| {
        [
            ("shadow", "receivers", part),
            ("light_gather", "receivers", part),
        ]
    };
    let again = |turn| {
        [
            ("light_gather", "points", Part::Turn(turn)),
            ("light_update", "spheres", Part::Turn(turn)),
        ]
    };
    let once = Part::Whole;
    assert_eq!(steps(1), [&first(once)[..], &last(once)].concat());
    let three = steps(3);
    assert_eq!(three[..3], first(Part::Turn(0)));
    assert_eq!(three[3..5], again(1));
    assert_eq!(three[5..7], again(2));
    assert_eq!(three[7..], last(Part::Whole));
}

/// The caller's receivers are neither seen nor resolved, and what spheres send them is kept apart.
#[test]
fn receivers_of_the_callers_are_lit_and_nothing_else() {
    let mut scene = scene(8, true);
    scene.settings.indirect = Some(Indirect::default());
    scene.objects[0].surface.push([SurfacePoint::default()]);
    let plan = Plan::of_receivers(&scene);
    let names: Vec<_> = plan.passes.iter().map(Planned::name).collect();
    let expected = ["points", "shadow", "light_update", "shadow", "light_gather"];
    assert_eq!(names, expected);
    let sent = plan.maker(resource::SENT, Domain::Receivers);
    assert_eq!(sent, Some(4));
    for pass in [&UPSAMPLE, &SHARES, &SCATTER, &RESOLVE] {
        assert!(plan.left_out.iter().any(|left| left.name == pass.name));
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

/// Spots, points and suns are looked from once and added to what samples get at last, and to what falls on bodies before these send it
/// on; without shadows nobody looks from them, and dark ones are none.
#[test]
fn lights_with_sharp_shadows_come_last() {
    let mut lit = scene(8, true);
    lit.settings.half_resolution = true;
    lit.settings.indirect = Some(Indirect::default());
    lit.objects[0].surface.push([SurfacePoint::default()]);
    lit.objects[0].mesh = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let shape = PunctualShape::Point {
        position: Vec3::Y,
        radius: 0.1,
    };
    lit.punctual = vec![PunctualLight::new(shape, [1.0; 3])];
    let plan = Plan::new(&lit);
    plan.check().unwrap();
    let at = |name: &str, domain: Domain| {
        let mut all = plan.passes.iter();
        all.position(|p| p.name() == name && p.at == domain)
            .unwrap_or_else(|| panic!("no {name} over {domain:?}"))
    };
    let views = at("light_view", Domain::Views);
    let points = at("punctual", Domain::Points);
    assert!(views < points && at("shadow", Domain::Points) < points);
    assert!(points < at("light_update", Domain::Spheres));
    let samples = at("punctual", Domain::Samples);
    assert!(at("scatter", Domain::Rest) < samples && samples < at("resolve", Domain::Pixels));
    assert!(plan.passes[views].reason.contains("6 views of 832 by 832"));

    lit.settings.shadows = false;
    let open = Plan::new(&lit);
    assert!(open.has(&PUNCTUAL) && !open.has(&LIGHT_VIEW));
    let knows = |shader: &Shader| shader.constants.contains(&("VIEWS", true));
    assert!(!open.shaders.iter().any(knows) && plan.shaders.iter().any(knows));
    lit.punctual[0].intensity = [0.0; 3];
    assert!(!Plan::new(&lit).has(&PUNCTUAL));
}

#[test]
fn what_is_left_out_is_told_in_sentences() {
    let mut bare = scene(0, true);
    bare.ground = None;
    let left = Plan::new(&bare).left_out;
    let names: Vec<_> = left.iter().map(|left| left.name).collect();
    let expected = [
        "points",
        "light_update",
        "shadow",
        "light_gather",
        "punctual",
        "shares",
        "upsample",
        "scatter",
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
    for (i, shader) in plan.shaders.iter().enumerate() {
        assert!(!plan.shaders[..i].contains(shader), "{shader}");
    }
    let text: Vec<_> = plan.shaders.iter().map(Shader::to_string).collect();
    assert!(
        text.contains(
            &"shadow, order 4, without LAMPS, without DISTRIBUTIONS, without GLOSS".to_string()
        ),
        "{text:?}"
    );
    assert!(
        text.contains(
            &"upsample, order 4, without LAMPS, without DISTRIBUTIONS, with SENT".to_string()
        ),
        "{text:?}"
    );
}
