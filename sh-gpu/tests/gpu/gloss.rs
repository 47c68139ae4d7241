//! Polished surfaces: the GPU's pictures are the CPU's.

use crate::frame::picture_of;
use crate::gpu::Gpu;
use crate::patches::apart;
use crate::scenes::{shining, standing_quad, view};
use glam::Vec3;
use sh_scene::{AreaLight, AreaShape, Blocking, Domain, Finish, Plan, Scene, Texture};

/// The scene with finishes, one of which differs from place to place.
fn polished(mut scene: Scene) -> Scene {
    let finishes = [(0.15, 1.0), (0.5, 0.0), (0.9, 1.0), (0.3, 0.5)];
    for (object, (roughness, metallic)) in scene.objects.iter_mut().zip(finishes.iter().cycle()) {
        object.material.finish = Finish {
            roughness: *roughness,
            metallic: *metallic,
        };
    }
    scene.objects[0].material.finish_texture = Some(Texture {
        width: 2,
        height: 2,
        rgba: vec![
            0, 255, 255, 0, 9, 200, 128, 0, 99, 100, 255, 0, 250, 50, 0, 0,
        ],
    });
    scene
}

fn lamp() -> AreaLight {
    AreaLight {
        shape: AreaShape::Local {
            center: Vec3::new(0.5, 2.5, 2.0),
            radius: 0.3,
        },
        radiance: [20.0, 15.0, 10.0],
        window: None,
        distribution: None,
        object: None,
    }
}

/// At every order, at full and at half resolution, with lamps and without, behind blockers and in the open, with what spheres and
/// patches send, whatever hides it.
pub fn what_is_mirrored_is_what_it_is_on_the_cpu(gpu: &Gpu) {
    let open = {
        let mut scene = polished(standing_quad());
        scene.settings.shadows = false;
        scene
    };
    let mut lit = polished(standing_quad());
    lit.lights.push(lamp());
    let all = [
        ("open", open, 3, false, Blocking::Discs),
        (
            "shadows",
            polished(standing_quad()),
            2,
            false,
            Blocking::Discs,
        ),
        ("lamp", lit, 6, true, Blocking::Discs),
        ("sent", polished(shining()), 4, false, Blocking::Discs),
        ("sums", polished(shining()), 3, true, Blocking::Runs),
    ];
    for (what, mut scene, order, half, blocking) in all {
        scene.settings = scene.settings.with_order(order);
        scene.settings.half_resolution = half;
        if let Some(indirect) = &mut scene.settings.indirect {
            indirect.blocking = blocking;
        }
        let [nearly_all, mean] = apart(gpu, &scene, what);
        assert!(
            nearly_all < 2e-4 && mean < 1e-4,
            "{what}: {nearly_all} {mean}"
        );
        // What is compared is there.
        let view = view(&scene, 96, 64);
        let light = scene.light().unwrap();
        let with = picture_of(gpu, &scene, &view, &light);
        scene.settings.gloss = false;
        let without = picture_of(gpu, &scene, &view, &light);
        let differ = with
            .iter()
            .zip(&without)
            .filter(|(a, b)| (a[0] - b[0]).abs() > 0.01 * b[0]);
        let count = differ.count();
        assert!(count > 100, "{what}: {count} pixels mirror anything");
    }
}

/// A scene without polish, or whose settings do not ask for it, has no pass, memory or pipeline for it, and its picture is the same
/// to the last bit.
pub fn nothing_is_made_for_what_is_matt(gpu: &Gpu) {
    let matt = shining();
    let mut off = polished(shining());
    off.settings.gloss = false;
    let pictures = [&matt, &off].map(|scene| {
        let plan = Plan::new(scene);
        assert!(!plan.runs_over(Domain::Gloss));
        let asked = |shader: &sh_scene::Shader| shader.constants.contains(&("GLOSS", true));
        assert!(!plan.shaders.iter().any(asked));
        let view = view(scene, 64, 48);
        picture_of(gpu, scene, &view, &scene.light().unwrap())
    });
    assert_eq!(pictures[0], pictures[1]);
    let plan = Plan::new(&polished(shining()));
    assert!(plan.runs_over(Domain::Gloss));
}
