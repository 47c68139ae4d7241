//! Whole pictures.

mod common;

#[path = "../../tests/shared/ball_basis.rs"]
mod ball_basis;

use ball_basis::ball_basis;
use bytemuck::Zeroable;
use common::{Random, object, scene, sphere_mesh};
use glam::{Affine3A, Vec3, vec3};
use sh_cpu::{
    Error, Frame, Frames, Gbuffer, Geometry, SampleLight, gbuffer, invalid, render, resolve,
};
use sh_scene::passes::{GBUFFER, RESOLVE, SHADOW};
use sh_scene::passes::{INVALID_SAMPLES, InvalidSamples};
use sh_scene::surface::{SurfacePoint, directions};
use sh_scene::{
    AreaLight, Domain, EnvironmentMap, Ground, Indirect, Method, PASSES, Plan, PlanError, Receiver,
    Scene, View,
};
use sh_scene::{PunctualLight, PunctualShape};
use std::sync::Mutex;

/// A ball on the ground under an even sky.
fn ball() -> Scene {
    let body = object(sphere_mesh(1.0, 24), Affine3A::from_translation(Vec3::Y));
    let mut scene = scene(vec![body]);
    scene.ground = Some(Ground {
        height: 0.0,
        albedo: [0.5; 3],
    });
    scene.camera.eye = vec3(0.0, 3.0, 6.0);
    scene.camera.target = vec3(0.0, 0.7, 0.0);
    scene
}

/// Two of them side by side, which light each other and the ground.
fn two_balls() -> Scene {
    let mut scene = ball();
    scene.objects[0]
        .surface
        .push(directions().iter().enumerate().map(|(j, &d)| SurfacePoint {
            position: d,
            direction: j as u32,
            normal: d,
            albedo: [0.9, 0.7, 0.5],
            ..SurfacePoint::default()
        }));
    let mut second = scene.objects[0].clone();
    second.transform = Affine3A::from_translation(vec3(2.1, 1.0, 0.3));
    scene.objects.push(second);
    scene.settings.indirect = Some(Indirect::default());
    scene
}

/// The same by patches, in two bounces.
fn two_balls_by_patches() -> Scene {
    let mut scene = two_balls();
    let mut random = Random(7);
    let basis = ball_basis(&mut || random.number(), 1.0, 4);
    for object in &mut scene.objects {
        object.surface = Default::default();
        object.basis = Some(basis.clone());
    }
    scene.settings.indirect = Some(Indirect {
        method: Method::BasisIrradiance,
        bounces: 2,
        ..Indirect::default()
    });
    scene
}

fn picture(scene: &Scene, plan: &Plan) -> Frame {
    render(scene, plan, (64, 48), &|_| ()).unwrap()
}

#[test]
fn a_ball_casts_a_shadow_on_the_ground() {
    let mut scene = ball();
    let shadowed = picture(&scene, &Plan::new(&scene));
    scene.settings.shadows = false;
    let open = picture(&scene, &Plan::new(&scene));
    assert_eq!(
        (shadowed.width, shadowed.height, shadowed.pixels.len()),
        (64, 48, 64 * 48)
    );
    let names = |frame: &Frame| frame.stages.iter().map(|s| s.0).collect::<Vec<_>>();
    assert_eq!(
        names(&shadowed),
        [
            "hierarchy",
            "light",
            "forest",
            "gbuffer",
            "cut",
            "shadow",
            "resolve"
        ]
    );
    assert_eq!(
        names(&open),
        ["hierarchy", "light", "gbuffer", "irradiance", "resolve"]
    );

    let at = |frame: &Frame, x: usize, y: usize| frame.pixels[y * 64 + x][1];
    // Down the middle column, where the ball meets the ground it is darkest; the sky and the ball's top are
    // as they were.
    let share = |y| at(&shadowed, 32, y) / at(&open, 32, y);
    let darkest = (0..48).map(share).fold(1.0, f32::min);
    assert!(darkest < 0.7, "{darkest}");
    assert_eq!(share(0), 1.0);
    assert!(share(47) > darkest + 0.1, "{}", share(47));
    // Far away on the ground the shadow fades.
    let (far, open_far) = (at(&shadowed, 1, 12), at(&open, 1, 12));
    assert!((far - open_far).abs() < 0.05 * open_far, "{far} {open_far}");
    for (shadowed, open) in shadowed
        .pixels
        .iter()
        .flatten()
        .zip(open.pixels.iter().flatten())
    {
        assert!(*shadowed >= 0.0 && *shadowed <= open * 1.000_1 && open.is_finite());
    }
}

/// Half resolution against the full one: where a pixel is off, it is off by little, and few receivers are shaded.
#[test]
fn half_resolution_keeps_the_picture() {
    let mut scene = ball();
    let size = (160, 119);
    let made = |scene: &Scene| render(scene, &Plan::new(scene), size, &|_| ()).unwrap();
    let full = made(&scene);
    scene.settings.half_resolution = true;
    let half = made(&scene);
    assert!(
        half.shadowed * 3 < full.shadowed,
        "{} of {}",
        half.shadowed,
        full.shadowed
    );
    let mean = full.pixels.iter().map(|p| p[1]).sum::<f32>() / full.pixels.len() as f32;
    let (mut square, mut worst) = (0.0, 0.0_f32);
    for (a, b) in full.pixels.iter().zip(&half.pixels) {
        let off = (a[1] - b[1]).abs() / mean;
        square += off * off;
        worst = worst.max(off);
    }
    let rms = (square / full.pixels.len() as f32).sqrt();
    println!(
        "rms {rms:.5}, worst {worst:.4}, {} of {} shaded",
        half.shadowed, full.shadowed
    );
    assert!(rms < 0.004 && worst < 0.06, "{rms} {worst}");
}

/// The same of what bodies send on alone, against that at full resolution: what comes by way of bodies is all in the half
/// picture as well, where it is upsampled and where it is found anew.
#[test]
fn half_resolution_keeps_the_bounced_light() {
    let size = (160, 119);
    let bounced = |half: bool| -> Vec<f32> {
        let mut scene = two_balls();
        scene.settings.half_resolution = half;
        let made = |scene: &Scene| render(scene, &Plan::new(scene), size, &|_| ()).unwrap();
        let with = made(&scene);
        scene.settings.indirect = None;
        let without = made(&scene);
        let pairs = with.pixels.iter().zip(&without.pixels);
        pairs.map(|(with, without)| with[1] - without[1]).collect()
    };
    let (full, half) = (bounced(false), bounced(true));
    let lit: Vec<(f32, f32)> = full
        .into_iter()
        .zip(half)
        .filter(|(a, _)| *a > 1e-3)
        .collect();
    let mean = lit.iter().map(|(a, _)| a).sum::<f32>() / lit.len() as f32;
    let bias = lit.iter().map(|(a, b)| b - a).sum::<f32>() / lit.len() as f32 / mean;
    let square = lit.iter().map(|(a, b)| (b - a).powi(2)).sum::<f32>() / lit.len() as f32;
    let worst = lit.iter().map(|(a, b)| (b - a).abs()).fold(0.0, f32::max) / mean;
    let rms = square.sqrt() / mean;
    println!(
        "{} pixels of {mean:.4}: bias {bias:.5}, rms {rms:.5}, worst {worst:.4}",
        lit.len()
    );
    assert!(lit.len() > 2000 && mean > 0.01, "{} of {mean}", lit.len());
    assert!(
        bias.abs() < 0.003 && rms < 0.035 && worst < 0.7,
        "{bias} {rms} {worst}"
    );
}

/// The passes of a plan are what runs, and each has something to do.
#[test]
fn what_runs_is_what_the_plan_says() {
    let mut sharp = two_balls();
    let shape = PunctualShape::Point {
        position: 3.0 * Vec3::Y,
        radius: 0.1,
    };
    sharp.punctual = vec![PunctualLight::new(shape, [9.0; 3])];
    let mut scenes = vec![ball(), two_balls(), two_balls_by_patches(), sharp];
    for scene in scenes.clone() {
        let mut half = scene.clone();
        half.settings.half_resolution = true;
        let mut open = scene;
        open.settings.shadows = false;
        scenes.extend([half, open]);
    }
    let mut seen = Vec::new();
    for scene in scenes {
        let plan = Plan::giving(&scene, &[INVALID_SAMPLES]);
        seen.extend(plan.passes.iter().map(|planned| planned.pass));
        let frame = picture(&scene, &plan);
        // What is no pass of its own: the scene's part, and finding spheres.
        let parts = [
            "hierarchy",
            "light",
            "forest",
            "cut",
            "light_cut",
            "patch_cut",
        ];
        let mut ran: Vec<_> = frame.stages.iter().map(|stage| stage.0).collect();
        ran.retain(|name| !parts.contains(name));
        let mut planned: Vec<_> = plan.passes.iter().map(|pass| pass.name()).collect();
        ran.sort_unstable();
        planned.sort_unstable();
        planned.dedup();
        assert_eq!(ran, planned, "{plan}");
        for (pass, work) in plan.passes.iter().zip(&frame.work) {
            assert!(work.tasks > 0, "{} has nothing to do", pass.name());
        }
    }
    for pass in PASSES {
        assert!(seen.contains(&pass), "no scene here calls for {pass:?}");
    }
}

/// Each sample counts once, as the worst of its channels.
#[test]
fn the_worst_of_three_channels_counts() {
    let view = View {
        camera: scene(Vec::new()).camera,
        width: 1,
        height: 1,
    };
    let tiles = view.samples().tiles();
    let seen = Receiver {
        covered: 1,
        ..Receiver::zeroed()
    };
    let samples = Gbuffer {
        receivers: vec![seen; tiles.len()],
        albedo: vec![[0.5; 4]; tiles.len()],
    };
    let (nan, infinity) = (f32::NAN, f32::INFINITY);
    for (radiance, found) in [
        ([0.0, -0.0, f32::MAX], [0, 0, 0]),
        ([-1e-45, 0.0, 1.0], [0, 0, 1]),
        ([1.0, f32::NEG_INFINITY, -1.0], [0, 1, 0]),
        ([infinity, 0.0, nan], [1, 0, 0]),
        ([0.0, 0.0, -nan], [1, 0, 0]),
    ] {
        let mut all = vec![[0.0; 3]; tiles.len()];
        all[tiles.index(1, 0)] = radiance;
        let mut counts = [[9; 4]];
        invalid(&view, 0..tiles.rows, &samples, &all, &mut counts).unwrap();
        assert_eq!(counts[0][..3], found, "{radiance:?}");
        assert_eq!(counts[0][3], 4);
    }
}

/// What passes say that they read and write is what they need: without any pass that writes what another reads, and in no
/// other order, there is no picture; without one that only adds, there is.
#[test]
fn a_plan_without_what_is_read_is_refused() {
    let mut scene = two_balls();
    for half in [false, true] {
        scene.settings.half_resolution = half;
        let full = Plan::new(&scene);
        let mut optional = Vec::new();
        for left_out in 0..full.passes.len() {
            let mut plan = full.clone();
            plan.passes.remove(left_out);
            match render(&scene, &plan, (24, 16), &|_| ()) {
                Ok(_) => optional.push(full.passes[left_out].name()),
                Err(error) => assert!(matches!(error, Error::Plan(_)), "{error}"),
            }
        }
        // At half resolution and for the rest of the samples.
        let gathers = if half { 2 } else { 1 };
        assert_eq!(optional, vec!["light_gather"; gathers]);
        assert!(full.runs_over(Domain::Halves) == half);
    }
}

/// A caller's receivers get the light that they have in a picture, to the bit: here they are its samples.
#[test]
fn receivers_of_ones_own_are_lit_as_in_a_picture() {
    let mut scene = two_balls();
    scene.settings.half_resolution = false;
    let (width, height) = (40, 30);
    let picture = render(&scene, &Plan::new(&scene), (width, height), &|_| ()).unwrap();
    let view = View {
        camera: scene.camera,
        width,
        height,
    };
    let (grid, tiles) = (view.samples(), view.samples().tiles());
    let mut samples = Gbuffer::default();
    let geometry = Geometry::new(&scene).unwrap();
    gbuffer(&geometry, &view, grid, 0..tiles.rows, &mut samples).unwrap();
    let plan = Plan::of_receivers(&scene);
    let mut frames = Frames::default();
    let lit = frames.light(&scene, &plan, &samples.receivers, &tiles.clusters());
    let lit = lit.unwrap();
    assert!(lit.sent.iter().any(|sent| sent[0] > 0.0));
    let both = lit.radiance.iter().zip(&lit.sent);
    let radiance: Vec<[f32; 3]> = both
        .map(|(direct, sent)| std::array::from_fn(|c| direct[c] + sent[c]))
        .collect();
    let mut pixels = vec![[0.0; 3]; picture.pixels.len()];
    let map = &scene.environment;
    let lit = SampleLight {
        radiance: &radiance,
        mirrored: None,
    };
    resolve(&view, 0..tiles.rows, &samples, lit, map, &mut pixels).unwrap();
    assert_eq!(pixels, picture.pixels);
    // The plan of a picture lights no receivers of one's own, and clusters have to hold them all.
    let wrong = frames.light(&scene, &Plan::new(&scene), &samples.receivers, &[]);
    let gives = |error: &Error| matches!(error, Error::Plan(PlanError::Gives { .. }));
    assert!(gives(&wrong.unwrap_err()));
    let wrong = render(&scene, &plan, (8, 8), &|_| ());
    assert!(gives(&wrong.unwrap_err()));
    let wrong = frames.light(&scene, &plan, &samples.receivers, &[]);
    assert!(matches!(
        wrong.unwrap_err(),
        Error::Clusters { .. } | Error::Length { .. }
    ));
}

#[test]
fn the_number_of_threads_changes_no_pixel() {
    let mut scene = ball();
    scene.settings.half_resolution = true;
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| picture(&scene, &Plan::new(&scene))).pixels
    };
    assert!(on(1) == on(2));
}

#[test]
fn the_sky_shows_the_environment_along_the_view() {
    let mut scene = scene(vec![]);
    let pixels = (0..64 * 32)
        .map(|i| [(i % 64) as f32, (i / 64) as f32, 1.0])
        .collect();
    scene.environment = EnvironmentMap {
        width: 64,
        height: 32,
        pixels,
    };
    scene.camera.eye = Vec3::ZERO;
    scene.camera.target = Vec3::X;
    scene.camera.fov = 0.1;
    let frame = render(&scene, &Plan::new(&scene), (2, 2), &|_| ()).unwrap();
    // +X is at u = 3/4, v = 1/2: between the texels 47 and 48 across, 15 and 16 down. To the right of it the
    // view turns towards +Z, larger u; upwards v falls.
    let [a, b, c, d] = [0, 1, 2, 3].map(|i| frame.pixels[i]);
    let mean: f32 = (a[0] + b[0] + c[0] + d[0]) / 4.0;
    assert!((mean - 47.5).abs() < 1e-3, "{mean}");
    assert!(
        b[0] > a[0] && d[0] > c[0] && a[1] < c[1] && b[1] < d[1],
        "{:?}",
        frame.pixels
    );
    assert!(frame.pixels.iter().all(|p| (p[2] - 1.0).abs() < 1e-6));
}

#[test]
fn progress_rises_to_one() {
    let scene = ball();
    let seen = Mutex::new(Vec::new());
    render(&scene, &Plan::new(&scene), (16, 67), &|part| {
        seen.lock().unwrap().push(part)
    })
    .unwrap();
    let seen = seen.into_inner().unwrap();
    assert!(
        seen.len() > 1 && seen.windows(2).all(|w| w[0] < w[1]),
        "{seen:?}"
    );
    assert_eq!(seen.last(), Some(&1.0));
}

#[test]
fn plans_that_make_no_picture_are_refused() {
    let scene = ball();
    let full = Plan::new(&scene);
    let refused = |plan: &Plan| render(&scene, plan, (8, 8), &|_| ()).unwrap_err();
    for (pass, sentence) in [
        (
            &GBUFFER,
            "the plan has no gbuffer pass, which would give shadow its receivers",
        ),
        (
            &SHADOW,
            "the plan has no irradiance, shadow or scatter pass, which would give resolve its radiance",
        ),
        (
            &RESOLVE,
            "the plan has no resolve pass, which would give the caller its picture",
        ),
    ] {
        let mut plan = full.clone();
        plan.passes.retain(|planned| !planned.is(pass));
        assert_eq!(refused(&plan).to_string(), sentence);
    }
    let mut plan = full.clone();
    plan.passes.reverse();
    let order = matches!(refused(&plan), Error::Plan(PlanError::Order { .. }));
    assert!(order, "{}", refused(&plan));
}

#[test]
fn settings_and_maps_that_do_not_work_are_refused() {
    let good = ball();
    let refused = |change: fn(&mut Scene)| {
        let mut scene = ball();
        change(&mut scene);
        render(&scene, &Plan::new(&good), (8, 8), &|_| ()).unwrap_err()
    };
    assert!(matches!(refused(|s| s.settings.order = 7), Error::Light(_)));
    assert!(matches!(
        refused(|s| s.settings.window = Some(0.0)),
        Error::Light(_)
    ));
    assert!(matches!(
        refused(|s| {
            s.environment.pixels.pop();
        }),
        Error::Environment { .. }
    ));
    assert!(matches!(
        refused(|s| s.camera.fov = 4.0),
        Error::Camera { .. }
    ));
    let none = render(&good, &Plan::new(&good), (0, 8), &|_| ()).unwrap_err();
    assert_eq!(
        none,
        Error::Size {
            width: 0,
            height: 8
        }
    );
}

/// Two lamps that are each almost as bright as single precision holds are more than that together: every sample of what
/// they light is infinite, and counted, and the sky is not.
#[test]
fn infinite_samples_are_counted_where_somebody_asks() {
    let mut scene = ball();
    scene.settings.shadows = false;
    let size = (64, 40);
    let plan = Plan::giving(&scene, &[INVALID_SAMPLES]);
    let counted = |scene: &Scene, plan: &Plan| {
        let frame = render(scene, plan, size, &|_| {}).unwrap();
        InvalidSamples::of(&frame.given, size.0)
    };
    assert_eq!(counted(&scene, &Plan::new(&scene)), None);
    assert_eq!(counted(&scene, &plan), Some(InvalidSamples::default()));

    let lamp = AreaLight::distant(Vec3::Y, 1.5, [3e38; 3]);
    scene.lights = vec![lamp, lamp];
    let frame = render(&scene, &plan, size, &|_| {}).unwrap();
    let counts = &frame.given[&INVALID_SAMPLES];
    let (mut valid, mut all) = (0, 0);
    for ([nan, infinite, negative, covered], pixel) in counts.iter().zip(&frame.pixels) {
        // Differences of infinities are no numbers.
        let found = nan + infinite + negative;
        assert!(
            found == 0 || pixel.iter().any(|c| !c.is_finite()),
            "{pixel:?}"
        );
        valid += covered - found;
        all += covered;
    }
    // Of the ball's lower side the lamps are below the horizon.
    assert!(all > 4000 && valid < all / 5, "{valid} of {all}");
}
