//! What the spheres of bodies send on, from the light that falls on them to the light that receivers get.

mod common;

use common::{Random, light_of, receiver};
use glam::{Affine3A, Quat, Vec3, vec3};
use sh_cpu::{
    CutOptions, Cuts, LightCutOptions, LightCuts, LightGather, LightUpdate, Path, Shadow,
    SphericalLights, light_gather, shadow_clusters,
};
use sh_scene::surface::{SurfacePoint, SurfaceSamples, directions};
use sh_scene::{Blocking, Body, Forest, Indirect, Light, Limits, Receiver, Sphere};

/// A ball, or several spheres, whose surface reflects evenly.
struct Ball {
    center: Vec3,
    radius: f32,
    surface: SurfaceSamples,
}

impl Ball {
    fn new(center: Vec3, radius: f32, albedo: [f32; 3]) -> Self {
        let mut surface = SurfaceSamples::default();
        surface.push(directions().iter().enumerate().map(|(j, &d)| SurfacePoint {
            position: (Vec3::from(d) * radius).into(),
            direction: j as u32,
            normal: d,
            albedo,
            ..Default::default()
        }));
        Self {
            center,
            radius,
            surface,
        }
    }
}

/// Bodies, and what they send on.
struct World {
    forest: Forest,
    light: Light,
    lights: SphericalLights,
    indirect: Indirect,
}

impl World {
    fn new(balls: &[Ball], light: Light, indirect: Indirect) -> Self {
        let spheres: Vec<Sphere> = balls
            .iter()
            .map(|ball| Sphere {
                center: ball.center.into(),
                radius: ball.radius,
            })
            .collect();
        let forest = Forest::new(&spheres, &vec![1; balls.len()]);
        let bodies = balls.iter().map(|ball| Body {
            surface: &ball.surface,
            transform: Affine3A::from_translation(ball.center),
            spheres: 1,
        });
        let mut lights = SphericalLights::default();
        let update = LightUpdate {
            indirect,
            limits: Limits::default(),
            accumulation: light.order,
        };
        lights
            .update(Path::best(), bodies, &forest, &light, update)
            .unwrap();
        Self {
            forest,
            light,
            lights,
            indirect,
        }
    }

    /// Light that no body and light that bodies have sent on.
    fn at(&self, receivers: &[Receiver]) -> [Vec<[f32; 3]>; 2] {
        let everyone = 0..receivers.len();
        let clusters = std::slice::from_ref(&everyone);
        let cut = CutOptions {
            limits: Limits::default(),
            ratios: true,
            accumulation: self.light.order,
        };
        let path = Path::best();
        let mut cuts = Cuts::default();
        cuts.bound(receivers, clusters, 0..1);
        cuts.find(path, &self.forest, &self.light, cut);
        let shadow = Shadow {
            clusters,
            cuts: &cuts,
            light: &self.light,
            accumulation: self.light.order,
            baked: None,
            eye: None,
        };
        let mut direct = vec![[0.0; 3]; receivers.len()];
        shadow_clusters(path, receivers, &shadow, &mut direct).unwrap();
        let mut cuts = LightCuts::default();
        let options = LightCutOptions {
            cut,
            blocking: self.indirect.blocking,
        };
        cuts.find(
            path,
            receivers,
            clusters,
            &self.forest,
            &self.lights,
            options,
        );
        let gather = LightGather {
            clusters,
            cuts: &cuts,
            lights: &self.lights,
            eye: None,
        };
        let mut sent = vec![[0.0; 3]; receivers.len()];
        light_gather(path, receivers, &gather, &mut sent).unwrap();
        [direct, sent]
    }
}

fn even(order: usize) -> Light {
    light_of(order, |_| [1.0; 3])
}

fn bounces(bounces: u32) -> Indirect {
    Indirect {
        bounces,
        ..Indirect::default()
    }
}

/// One ball under an even sky emits its albedo in all directions: seen from a floor below, (r/d)² of it.
#[test]
fn a_ball_under_an_even_sky_sends_on_its_albedo() {
    let albedo = [0.9, 0.5, 0.1];
    let world = World::new(
        &[Ball::new(Vec3::Y * 2.0, 0.8, albedo)],
        even(4),
        bounces(1),
    );
    let [_, sent] = world.at(&[receiver(Vec3::ZERO, Vec3::Y)]);
    for (sent, albedo) in sent[0].iter().zip(albedo) {
        assert!(
            (sent - 0.16 * albedo).abs() < 2e-3 * albedo,
            "{sent} of {albedo}"
        );
    }
}

/// Light from one side: the ball is bright there, to eyes on that side.
#[test]
fn the_lit_side_is_the_bright_one() {
    let light = light_of(4, |d| [d.x.max(0.0), 0.0, 0.0]);
    let turned = Affine3A::from_rotation_translation(Quat::from_rotation_y(1.0), Vec3::Y);
    let ball = Ball::new(Vec3::ZERO, 0.5, [1.0; 3]);
    let forest = Forest::new(
        &[Sphere {
            center: Vec3::Y.into(),
            radius: 0.5,
        }],
        &[1],
    );
    // However the body is turned.
    for transform in [Affine3A::from_translation(Vec3::Y), turned] {
        let mut lights = SphericalLights::default();
        let body = Body {
            surface: &ball.surface,
            transform,
            spheres: 1,
        };
        let update = LightUpdate {
            indirect: bounces(1),
            limits: Limits::default(),
            accumulation: 4,
        };
        lights
            .update(Path::best(), [body], &forest, &light, update)
            .unwrap();
        let world = World {
            forest: forest.clone(),
            light: light.clone(),
            lights,
            indirect: bounces(1),
        };
        let facing = |x: f32| receiver(vec3(2.0 * x, 1.0, 0.0), vec3(-x, 0.0, 0.0));
        let [_, sent] = world.at(&[facing(1.0), facing(-1.0)]);
        assert!(sent[0][0] > 8.0 * sent[1][0], "{sent:?}");
        assert!(sent[0][0] > 0.02);
    }
}

/// White balls in an even sky are a furnace: with every bounce they come nearer to being as bright as the sky, and no
/// bounce takes them beyond.
#[test]
fn a_white_furnace_comes_to_its_limit() {
    let mut random = Random(7);
    let mut balls: Vec<Ball> = Vec::new();
    while balls.len() < 12 {
        let (center, radius) = (random.point(1.6), random.within(0.3, 0.5));
        if balls
            .iter()
            .all(|b| b.center.distance(center) > b.radius + radius + 0.02)
        {
            balls.push(Ball::new(center, radius, [1.0; 3]));
        }
    }
    let receivers: Vec<Receiver> = balls
        .iter()
        .flat_map(|ball| {
            directions()
                .iter()
                .step_by(9)
                .map(|&d| receiver(ball.center + Vec3::from(d) * ball.radius, d.into()))
        })
        .collect();
    let mean_of = |count: u32| {
        let [direct, sent] = World::new(&balls, even(4), bounces(count)).at(&receivers);
        let sum: f32 = direct.iter().zip(&sent).map(|(d, s)| d[0] + s[0]).sum();
        sum / receivers.len() as f32
    };
    let means = [1, 2, 3, 4, 8, 16].map(mean_of);
    println!("mean radiance by bounces {means:?}");
    assert!(means.is_sorted(), "{means:?}");
    assert!(means[0] > 0.75 && means[5] < 1.03, "{means:?}");
    assert!(
        (means[5] - means[4]).abs() < 0.01 && means[5] > 0.93,
        "{means:?}"
    );
}

#[test]
fn albedo_that_is_no_number_counts_as_black() {
    let bad = [f32::NAN, f32::INFINITY, 0.5];
    let balls = [
        Ball::new(Vec3::Y * 2.0, 0.8, bad),
        Ball::new(vec3(2.0, 1.0, 0.0), 0.5, [0.5; 3]),
    ];
    let world = World::new(&balls, even(4), bounces(2));
    let [_, sent] = world.at(&[receiver(Vec3::ZERO, Vec3::Y), receiver(Vec3::X, Vec3::Y)]);
    for radiance in sent.iter().flatten() {
        assert!(radiance.is_finite() && *radiance >= 0.0, "{sent:?}");
    }
    assert!(sent[0][2] > 0.05, "the third channel is as good as ever");
}

/// Spheres without points send nothing on, and so does a scene in the dark.
#[test]
fn without_points_or_light_nothing_is_sent_on() {
    let at = [receiver(Vec3::ZERO, Vec3::Y)];
    let mut bare = Ball::new(Vec3::Y * 2.0, 0.8, [1.0; 3]);
    bare.surface = SurfaceSamples::default();
    bare.surface.push([]);
    let unlit = Ball::new(Vec3::Y * 2.0, 0.8, [1.0; 3]);
    let dark = light_of(4, |_| [0.0; 3]);
    for (ball, light) in [(bare, even(4)), (unlit, dark)] {
        let [_, sent] = World::new(&[ball], light, bounces(1)).at(&at);
        assert_eq!(sent[0], [0.0; 3]);
    }
}

/// All ways to hide light give the same where nothing hides anything: sums by whatever to the last digits, and discs, which
/// know a ball exactly, a twentieth more than functions of order 6.
#[test]
fn ways_of_blocking_agree_where_nothing_is_blocked() {
    let balls = [
        Ball::new(vec3(-2.0, 1.5, 0.0), 0.7, [0.8, 0.2, 0.2]),
        Ball::new(vec3(2.0, 1.5, 0.0), 0.7, [0.2, 0.8, 0.2]),
    ];
    let at = [receiver(Vec3::ZERO, Vec3::Y)];
    let sent = Blocking::ALL.map(|blocking| {
        let indirect = Indirect {
            blocking,
            ..bounces(1)
        };
        World::new(&balls, even(6), indirect).at(&at)[1][0]
    });
    let [discs, sums @ ..] = sent;
    for (c, disc) in discs.iter().enumerate() {
        for other in &sums {
            let share = other[c] / disc;
            assert!((share - 0.952).abs() < 0.005, "{share}: {sent:?}");
            assert!((other[c] - sums[0][c]).abs() < 1e-5, "{sent:?}");
        }
    }
}

/// The bodies have to be those of the forest.
#[test]
fn bodies_that_are_not_the_forests_are_refused() {
    let ball = Ball::new(Vec3::Y, 0.5, [1.0; 3]);
    let body = Body {
        surface: &ball.surface,
        transform: Affine3A::IDENTITY,
        spheres: 1,
    };
    let update = LightUpdate {
        indirect: bounces(1),
        limits: Limits::default(),
        accumulation: 4,
    };
    let mut lights = SphericalLights::default();
    let refused = lights.update(Path::best(), [body], &Forest::default(), &even(4), update);
    let sentence = refused.unwrap_err().to_string();
    assert!(sentence.contains("bodies"), "{sentence}");
}
