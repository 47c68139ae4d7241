//! Light that spheres give which are even, against rays.

use glam::{Vec3, vec3};
use sh_core::seen::Seen;
use sh_core::{Routines, for_order};
use sh_cpu::{
    CutOptions, LightCutOptions, LightCuts, LightGather, Path, SphericalLights, light_gather,
};
use sh_scene::{Blocking, Forest, Limits, Receiver, Sphere};

/// Bodies that each send on one radiance in every direction.
struct Bright {
    spheres: Vec<Sphere>,
    /// Spheres and radiance of each body.
    bodies: Vec<(usize, [f32; 3])>,
    forest: Forest,
    lights: SphericalLights,
}

const WHITE: [f32; 3] = [1.0; 3];
const UP: [f32; 3] = [0.0, 1.0, 0.0];

fn ball(center: Vec3, radius: f32) -> Sphere {
    Sphere {
        center: center.into(),
        radius,
    }
}

impl Bright {
    fn new(bodies: &[(Vec<Sphere>, [f32; 3])], order: usize) -> Self {
        let spheres: Vec<Sphere> = bodies.iter().flat_map(|body| body.0.clone()).collect();
        let counts: Vec<usize> = bodies.iter().map(|body| body.0.len()).collect();
        let forest = Forest::new(&spheres, &counts);
        let bodies: Vec<_> = bodies.iter().map(|body| (body.0.len(), body.1)).collect();
        Self {
            lights: SphericalLights::even(&forest, order, &bodies),
            spheres,
            bodies,
            forest,
        }
    }

    /// Bodies of one white sphere each.
    fn balls(spheres: &[[f32; 4]], order: usize) -> Self {
        let bodies: Vec<_> = spheres
            .iter()
            .map(|&[x, y, z, radius]| (vec![ball(vec3(x, y, z), radius)], WHITE))
            .collect();
        Self::new(&bodies, order)
    }

    fn at(&self, blocking: Blocking, receivers: &[Receiver]) -> Vec<[f32; 3]> {
        let mut cuts = LightCuts::default();
        let everyone = 0..receivers.len();
        let clusters = std::slice::from_ref(&everyone);
        let options = LightCutOptions {
            cut: CutOptions {
                limits: Limits::LEAVES,
                ratios: true,
                accumulation: self.lights.order(),
            },
            blocking,
        };
        let path = Path::best();
        let (forest, lights) = (&self.forest, &self.lights);
        cuts.find(path, receivers, clusters, forest, lights, options);
        let gather = LightGather {
            clusters,
            cuts: &cuts,
            lights,
            eye: None,
        };
        let mut radiance = vec![[0.0; 3]; receivers.len()];
        light_gather(path, receivers, &gather, &mut radiance).unwrap();
        radiance
    }

    /// What a receiver sees, ray by ray: the nearest sphere's radiance, by the cosine.
    fn truth(&self, receiver: &Receiver) -> [f32; 3] {
        const RAYS: usize = 8000;
        let (p, n) = (Vec3::from(receiver.position), Vec3::from(receiver.normal));
        let (side, other) = n.any_orthonormal_pair();
        let mut sum = [0.0; 3];
        for i in 0..RAYS {
            let square = (i as f32 + 0.5) / RAYS as f32;
            let (sin, cos) = (2.399_963_2 * i as f32).sin_cos();
            let flat = square.sqrt();
            let ray = (side * cos + other * sin) * flat + n * (1.0 - square).sqrt();
            let mut nearest = (f32::INFINITY, [0.0; 3]);
            let mut of_body = self
                .bodies
                .iter()
                .flat_map(|&(n, c)| std::iter::repeat_n(c, n));
            for sphere in &self.spheres {
                let color = of_body.next().unwrap();
                let to = Vec3::from(sphere.center) - p;
                let along = to.dot(ray);
                let beside = sphere.radius.powi(2) - (to.length_squared() - along * along);
                if beside > 0.0 && along > 0.0 && along - beside.sqrt() < nearest.0 {
                    nearest = (along - beside.sqrt(), color);
                }
            }
            for (sum, c) in sum.iter_mut().zip(nearest.1) {
                *sum += c / RAYS as f32;
            }
        }
        sum
    }

    /// What bodies give where none hides another.
    fn apart(&self, receivers: &[Receiver]) -> Vec<[f32; 3]> {
        let mut sum = vec![[0.0; 3]; receivers.len()];
        let mut rest = &self.spheres[..];
        for &(count, color) in &self.bodies {
            let (own, others) = rest.split_at(count);
            rest = others;
            let alone = Self::new(&[(own.to_vec(), color)], 4).at(Blocking::Discs, receivers);
            for (sum, alone) in sum.iter_mut().flatten().zip(alone.iter().flatten()) {
                *sum += alone;
            }
        }
        sum
    }

    /// Root of the mean square of the error over receivers and channels.
    fn error(&self, blocking: Blocking, receivers: &[Receiver]) -> f32 {
        self.error_of(&self.at(blocking, receivers), receivers)
    }

    /// The same of what was found in another way.
    fn error_of(&self, found: &[[f32; 3]], receivers: &[Receiver]) -> f32 {
        let mut sum = 0.0;
        for (receiver, found) in receivers.iter().zip(found) {
            for (found, true_one) in found.iter().zip(self.truth(receiver)) {
                sum += (found - true_one).powi(2);
            }
        }
        (sum / (3 * receivers.len()) as f32).sqrt()
    }
}

fn receiver(position: [f32; 3], normal: [f32; 3]) -> Receiver {
    Receiver {
        position,
        covered: 1,
        normal,
        object: 0,
    }
}

/// A square of floor, `reach` to either side.
fn floor(side: usize, reach: f32) -> Vec<Receiver> {
    let at = |i: usize| reach * (2.0 * (i as f32 + 0.5) / side as f32 - 1.0);
    (0..side * side)
        .map(|i| receiver([at(i % side), 0.0, at(i / side)], UP))
        .collect()
}

/// The light of an even sky past spheres that lie wholly above the horizon, by the same exponential.
fn left_of_sky<const C: usize>(receiver: &Receiver, spheres: &[Sphere]) -> f32
where
    [f32; C]: Routines<f32>,
{
    let mut sum = [0.0; C];
    for sphere in spheres {
        let center = [0, 1, 2].map(|k| sphere.center[k] - receiver.position[k]);
        let seen = Seen::whole(center, sphere.radius);
        sum = sum.add_cap_log_saturating(seen.sine, seen.cosine, seen.direction);
    }
    sum.exp_saturating()
        .dot(&<[f32; C]>::cosine(receiver.normal))
}

/// Equation 23 telescopes: what spheres and sky show together is all that there is.
#[test]
fn visibilities_of_spheres_and_sky_add_up_to_one() {
    let spheres = [
        [0.0, 2.0, 0.0, 0.8],
        [0.6, 5.0, 0.3, 1.5],
        [-2.5, 2.0, 1.0, 0.7],
        [3.0, 1.2, -2.0, 0.9],
        [0.2, 9.0, -0.5, 2.0],
    ];
    let at = [receiver([0.1, 0.0, 0.2], UP)];
    for order in 2..=6 {
        let bright = Bright::balls(&spheres, order);
        let sky = for_order!(order, C => left_of_sky::<C>(&at[0], &bright.spheres));
        for blocking in [Blocking::Runs, Blocking::Sphere, Blocking::Object] {
            let sent = bright.at(blocking, &at)[0][0];
            let sum = sent + sky;
            assert!(
                (sum - 1.0).abs() < 2e-6,
                "order {order}, {blocking:?}: {sum}"
            );
            assert!(sent > 0.2 && sky > 0.2);
        }
    }
}

/// A ball of radiance 1 above a floor gives (r/d)² of what a sky of radiance 1 does.
#[test]
fn a_bright_ball_lights_the_floor_by_its_form_factor() {
    for (ratio, tolerance) in [(0.15_f32, 0.02), (0.3, 0.03), (0.5, 0.04), (0.8, 0.06)] {
        // Exponentials of order 4 know it only roughly.
        let bright = Bright::balls(&[[0.0, 2.0, 0.0, 2.0 * ratio]], 4);
        for (blocking, tolerance) in [(Blocking::Discs, 1e-6), (Blocking::Runs, tolerance)] {
            let found = bright.at(blocking, &[receiver([0.0; 3], UP)])[0][1];
            let off = found - ratio * ratio;
            assert!(off.abs() < tolerance, "{blocking:?}, {ratio}: {found}");
        }
    }
}

/// A receiver that crosses the plane of equal power of two spheres sees no jump, whether they are apart, touch, cut or
/// hold each other, and neither does one that comes out of a sphere.
#[test]
fn nothing_jumps_where_the_order_swaps() {
    let apart = [[-1.2, 1.5, 0.0, 1.0], [1.2, 2.0, 0.0, 1.2]];
    let touching = [[-1.0, 1.5, 0.0, 1.0], [1.0, 1.5, 0.0, 1.0]];
    let cutting = [[-0.5, 1.5, 0.0, 1.0], [0.7, 1.9, 0.0, 1.2]];
    let nested = [[0.0, 1.5, 0.0, 1.0], [0.1, 1.6, 0.0, 0.5]];
    let around = [[-1.0, 0.3, 0.0, 1.0], [1.5, 1.5, 0.0, 1.0]];
    for spheres in [apart, touching, cutting, nested, around] {
        let step = |count: usize| {
            let colored: Vec<_> = spheres
                .iter()
                .zip([[1.0, 0.0, 0.2], [0.0, 1.0, 0.5]])
                .map(|(&[x, y, z, radius], color)| (vec![ball(vec3(x, y, z), radius)], color))
                .collect();
            let bright = Bright::new(&colored, 4);
            let at: Vec<Receiver> = (0..=count)
                .map(|i| receiver([-3.0 + 6.0 * i as f32 / count as f32, 0.0, 0.1], UP))
                .collect();
            let found = bright.at(Blocking::Discs, &at);
            let changes = found.windows(2);
            let change = |w: &[[f32; 3]]| {
                (0..3)
                    .map(|c| (w[1][c] - w[0][c]).abs())
                    .fold(0.0, f32::max)
            };
            changes.map(change).fold(0.0, f32::max)
        };
        let (coarse, fine) = (step(250), step(4000));
        assert!(
            coarse > 1e-4 && fine < coarse / 6.0,
            "{spheres:?}: {coarse} {fine}"
        );
    }
}

/// Two links of a chain: each passes before and behind the other (section 8.4, figure 11 above).
#[test]
fn links_of_a_chain_hide_each_other_on_both_sides() {
    let ring = |middle: Vec3, a: Vec3, b: Vec3| -> Vec<Sphere> {
        (0..14)
            .map(|i| {
                let (sin, cos) = (std::f32::consts::TAU * i as f32 / 14.0).sin_cos();
                ball(middle + a * cos + b * sin, 0.3)
            })
            .collect()
    };
    let links = [
        (
            ring(vec3(-0.55, 2.0, 0.0), Vec3::X * 1.1, vec3(0.0, 0.8, 0.8)),
            [1.0, 0.0, 0.0],
        ),
        (
            ring(vec3(0.55, 2.0, 0.0), Vec3::X * 1.1, vec3(0.0, 0.8, -0.8)),
            [0.0, 1.0, 0.0],
        ),
    ];
    compare(&links);
}

/// Three bars of which each lies on the next (figure 11 below): whole bodies have no order.
#[test]
fn bars_that_lie_on_each_other_in_a_circle() {
    let bar = |from: Vec3, to: Vec3| -> Vec<Sphere> {
        (0..9)
            .map(|i| ball(from.lerp(to, i as f32 / 8.0), 0.25))
            .collect()
    };
    let corner = |k: i32, height: f32| {
        let (sin, cos) = (std::f32::consts::TAU * k as f32 / 3.0).sin_cos();
        vec3(1.2 * cos, height, 1.2 * sin)
    };
    // Each begins low under the end of the one before it.
    let bars = [0, 1, 2].map(|k| {
        let beyond = (corner(k + 1, 2.7) - corner(k, 1.5)) * 0.1;
        let mut color = [0.1; 3];
        color[k as usize] = 1.0;
        (
            bar(corner(k, 1.5) - beyond, corner(k + 1, 2.7) + beyond),
            color,
        )
    });
    compare(&bars);
}

/// Discs are nearer the truth than sums, and both than bodies that do not hide each other; sums by bodies are no nearer than
/// those by spheres, and what is summed up for several changes nothing.
fn compare(bodies: &[(Vec<Sphere>, [f32; 3])]) {
    let bright = Bright::new(bodies, 4);
    let receivers = floor(12, 2.0);
    let error = |blocking| bright.error(blocking, &receivers);
    let [discs, sums, object] = [Blocking::Discs, Blocking::Runs, Blocking::Object].map(error);
    let apart = bright.error_of(&bright.apart(&receivers), &receivers);
    println!("error of discs {discs}, sums {sums}, by bodies {object}, of none {apart}");
    // Of functions of order 4, whose own error is most of it, a wrong order of bodies that overlap little is hardly seen.
    assert!(
        sums < 0.8 * apart && sums < object + 1e-5,
        "{sums} {object} {apart}"
    );
    assert!(
        discs < 0.45 * apart && discs < 0.6 * sums,
        "{discs} {sums} {apart}"
    );
    let [runs, sphere] =
        [Blocking::Runs, Blocking::Sphere].map(|blocking| bright.at(blocking, &receivers));
    for (runs, sphere) in runs.iter().flatten().zip(sphere.iter().flatten()) {
        assert!((runs - sphere).abs() < 1e-5, "{runs} {sphere}");
    }
}

/// Intersecting spheres of one body hide each other: together they give what is seen of their union, and not the sum.
#[test]
fn spheres_of_one_body_give_what_their_union_gives() {
    let bar = |count: usize, radius: f32| -> Vec<Sphere> {
        let at = |i: usize| 2.0 * i as f32 / (count - 1) as f32 - 1.0;
        (0..count)
            .map(|i| ball(vec3(at(i), 1.5, 0.2 * at(i)), radius))
            .collect()
    };
    let receivers = floor(12, 2.0);
    // Many that overlap are known less well: what several hide of one is taken for independent.
    for (count, radius, most, less) in [
        (2, 1.1, 0.01, 0.95),
        (3, 0.7, 0.02, 0.95),
        (7, 0.5, 0.03, 0.8),
    ] {
        let spheres = bar(count, radius);
        let bright = Bright::new(&[(spheres.clone(), WHITE)], 4);
        let error = bright.error(Blocking::Discs, &receivers);
        let sum: f32 = (spheres.iter())
            .map(|s| Bright::new(&[(vec![*s], WHITE)], 4).at(Blocking::Discs, &receivers)[70][0])
            .sum();
        let found = bright.at(Blocking::Discs, &receivers)[70][0];
        println!("{count} spheres: error {error}, {found} of {sum}");
        assert!(
            error < most && found < less * sum,
            "{count}: {error}, {found} of {sum}"
        );
    }
}

#[test]
fn a_hundred_bodies_are_bounded_and_near_the_truth() {
    let spheres: Vec<[f32; 4]> = (0..100)
        .map(|i| {
            let (sin, cos) = (2.4 * i as f32).sin_cos();
            let away = 0.6 * (i as f32).sqrt();
            [away * cos, 0.5 + 0.03 * i as f32, away * sin, 0.25]
        })
        .collect();
    let receivers = floor(10, 4.0);
    for count in [2, 5, 10, 30, 100] {
        let bright = Bright::balls(&spheres[..count], 4);
        let error = |blocking| bright.error(blocking, &receivers);
        let [discs, sums] = [Blocking::Discs, Blocking::Runs].map(error);
        let apart = bright.error_of(&bright.apart(&receivers), &receivers);
        println!("{count} balls: discs {discs}, sums {sums}, hiding nothing {apart}");
        assert!(discs < 0.25 * apart, "{count}: {discs} of {apart}");
        assert!(discs < sums / 12.0, "{count}: {discs} of {sums}");
    }
    let bright = Bright::balls(&spheres, 4);
    let found = bright.at(Blocking::Discs, &receivers);
    assert!(found.iter().flatten().all(|r| (0.0..=1.0).contains(r)));
    let error = bright.error(Blocking::Discs, &receivers);
    assert!(error < 0.002, "{error}");
}

#[test]
fn spheres_without_extent_give_and_take_nothing() {
    let some = [[0.3, 1.0, 0.0, 0.4], [-0.5, 2.0, 0.2, 0.8]];
    let with = [some[0], [0.1, 0.5, 0.1, 0.0], some[1], [0.0, 0.0, 0.0, 0.0]];
    let receivers = floor(9, 2.0);
    let (without, with) = (Bright::balls(&some, 4), Bright::balls(&with, 4));
    let (a, b) = (
        without.at(Blocking::Discs, &receivers),
        with.at(Blocking::Discs, &receivers),
    );
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
}

/// A black body hides others and gives nothing.
#[test]
fn a_black_body_only_hides() {
    let (low, high) = (
        ball(vec3(0.0, 1.0, 0.0), 0.4),
        ball(vec3(0.0, 3.0, 0.0), 1.0),
    );
    let at = |color: [f32; 3]| {
        let bright = Bright::new(&[(vec![low], color), (vec![high], WHITE)], 4);
        bright.at(Blocking::Discs, &[receiver([0.0; 3], UP)])[0][0]
    };
    let (black, white) = (at([0.0; 3]), at(WHITE));
    // The lower hides all of the higher, and gives (r/d)².
    assert!(
        black == 0.0 && (white - 0.16).abs() < 1e-3,
        "{black} {white}"
    );
}

#[test]
fn inside_a_bright_sphere_all_is_finite_and_bounded() {
    let bright = Bright::balls(&[[0.0, 0.0, 0.0, 1.0], [0.2, 0.3, 0.0, 2.0]], 4);
    let receivers: Vec<Receiver> = (0..200)
        .map(|i| {
            let t = i as f32 * 0.37;
            let position = vec3((3.0 * t).sin(), (2.1 * t).cos(), (1.3 * t).sin()) * 0.9;
            receiver(
                position.into(),
                vec3(t.sin(), t.cos(), 0.3).normalize().into(),
            )
        })
        .chain([receiver([0.0; 3], UP), receiver([0.2, 0.3, 0.0], UP)])
        .collect();
    let found = bright.at(Blocking::Discs, &receivers);
    assert!(
        found.iter().flatten().all(|r| (0.0..=1.0).contains(r)),
        "{found:?}"
    );
}
