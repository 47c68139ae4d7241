//! The hard cases of shading, on every vector path and in f64.

#[path = "../../tests/shared/shading_cases/mod.rs"]
mod shading_cases;

use sh_core::{Routines, for_order};
use sh_cpu::{Cuts, Outline, OutlineAll, Path, Point, shade, shadow_on};
use sh_scene::{Light, Receiver, Sphere};
use shading_cases::{CASES, Shade};

/// The pass on a path.
fn on(path: Path) -> impl Fn(&[Receiver], &[Sphere], &Light, usize) -> Vec<[f32; 3]> {
    move |receivers, spheres, light, accumulation| {
        let mut radiance = vec![[f32::NAN; 3]; receivers.len()];
        shadow_on(path, receivers, spheres, light, accumulation, &mut radiance)
            .expect("the case fits");
        radiance
    }
}

/// The pass's text with f64 as its lane.
fn in_f64(
    receivers: &[Receiver],
    spheres: &[Sphere],
    light: &Light,
    accumulation: usize,
) -> Vec<[f32; 3]> {
    #[inline(never)]
    fn with<const C: usize>(r: &Receiver, s: &[Sphere], l: &Light, accumulation: usize) -> [f32; 3]
    where
        [f64; C]: Routines<f64>,
        f64: OutlineAll + Outline<C>,
    {
        let point = Point {
            position: r.position.map(f64::from),
            normal: r.normal.map(f64::from),
            object: f64::from(r.object),
            gloss: None,
        };
        let cuts = Cuts::everything(s, 1, l);
        shade::<f64, C>(
            &point,
            (&cuts, 0),
            l,
            accumulation,
            None::<fn(usize) -> f64>,
        )
        .map(|x| x as f32)
    }
    receivers
        .iter()
        .map(|r| for_order!(light.order, C => with::<C>(r, spheres, light, accumulation)))
        .collect()
}

fn run(name: &str) {
    let (_, case) = CASES
        .iter()
        .find(|c| c.0 == name)
        .expect("a case of that name");
    let mut ways: Vec<(String, Box<Shade>)> = vec![("f64".into(), Box::new(in_f64))];
    for path in Path::all() {
        ways.push((format!("{path:?}"), Box::new(on(path))));
    }
    for (way, shade) in ways {
        for order in 2..=6 {
            println!("order {order}, {way}:");
            case(&shade, order);
        }
    }
}

macro_rules! cases {
    ($($test:ident: $name:literal;)*) => {
        $(
            #[test]
            fn $test() {
                run($name);
            }
        )*

        #[test]
        fn every_case_is_run() {
            let run = [$($name),*];
            for (name, _) in CASES {
                assert!(run.contains(name), "`{name}` is not run");
            }
        }
    };
}

cases! {
    identical_blockers: "identical blockers";
    spheres_of_one_body: "spheres of one body";
    vanishing_blockers: "vanishing blockers";
    blockers_up_to_the_horizon: "blockers up to the horizon";
    receivers_on_in_and_at_the_centre: "receivers on, in and at the centre";
    spheres_across_the_tangent_plane: "spheres across the tangent plane";
    total_occlusion: "total occlusion";
    a_sun_a_million_times_the_sky: "a sun a million times the sky";
    light_of_any_strength: "light of any strength";
    opposite_normals: "opposite normals";
    scales: "scales";
    light_of_a_lower_order: "light of a lower order";
    what_is_not_a_number: "what is not a number";
}
