//! Good files give what is in them.

use glam::{Affine3A, Vec3};
use sh_bake::{SphereSet, load_environment, load_mesh, load_scene, shapes};
use sh_scene::plan::{Domain, Plan};
use sh_scene::{AreaShape, Mesh, PunctualLight, PunctualShape, View};
use std::path::{Path, PathBuf};

fn good(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/good")
        .join(name)
}

/// Whether all triangles face the way their normals point.
fn faces_outward(mesh: &Mesh) -> bool {
    let vec = |list: &[[f32; 3]], i: u32| Vec3::from(list[i as usize]);
    mesh.triangles.iter().all(|t| {
        let [a, b, c] = t.map(|i| vec(&mesh.positions, i));
        let facing = (b - a).cross(c - a);
        t.iter().all(|&i| facing.dot(vec(&mesh.normals, i)) > 0.0)
    })
}

#[test]
fn polygons_are_cut_and_normals_computed() {
    let model = load_mesh(&good("polygon.obj")).unwrap();
    let mesh = &model.parts[0].mesh;
    assert_eq!((model.parts.len(), mesh.triangles.len()), (1, 4));
    assert_eq!(mesh.normals.len(), mesh.positions.len());
    assert!(faces_outward(mesh));
    // The pentagon and the triangle meet at a right angle: the two corners they share are split.
    assert_eq!(mesh.positions.len(), 8);
}

#[test]
fn triangles_without_area_are_left_out_with_a_warning() {
    let model = load_mesh(&good("some_zero_area.obj")).unwrap();
    assert_eq!(model.parts[0].mesh.triangles.len(), 1);
    assert_eq!(model.warnings.len(), 1);
    let warning = &model.warnings[0];
    assert!(
        warning.contains("some_zero_area.obj") && warning.contains("1 of 2"),
        "{warning}"
    );
}

#[test]
fn nodes_move_and_mirror_their_meshes() {
    let model = load_mesh(&good("mirrored.gltf")).unwrap();
    let part = &model.parts[0];
    // A strip of two triangles, scaled by -2 in x and moved by 10.
    assert_eq!(part.mesh.triangles.len(), 2);
    assert_eq!(part.mesh.positions[1], [8.0, 0.0, 0.0]);
    assert!(faces_outward(&part.mesh));
    assert_eq!(part.mesh.normals[0], [0.0, 0.0, 1.0]);
    assert_eq!(part.material.albedo, [0.5, 0.25, 1.0]);
    let texture = part.material.texture.as_ref().unwrap();
    assert_eq!((texture.width, texture.height), (2, 1));
    assert_eq!(texture.rgba, [255, 0, 0, 255, 0, 0, 255, 255]);
    assert_eq!(part.mesh.uvs[1], [1.0, 1.0]);
}

/// How polished a surface is: a file's factors and texture, which a scene may overrule; what neither says of is diffuse, but a metal where
/// a glTF file has a material and says nothing.
#[test]
fn finishes_are_read() {
    let model = load_mesh(&good("polished.gltf")).unwrap();
    let material = &model.parts[0].material;
    assert_eq!(
        (material.finish.roughness, material.finish.metallic),
        (0.5, 0.25)
    );
    // Green is 0 in both texels, blue in the first: as numbers, not as colours.
    assert!(material.texture.is_none() && material.finish_texture.is_some());
    assert_eq!(model.parts[0].mesh.uvs.len(), 4);
    let finish = material.finish_at(Some([0.75, 0.5]));
    assert_eq!((finish.roughness, finish.metallic), (0.0, 0.25));
    let silent = load_mesh(&good("mirrored.gltf")).unwrap();
    let finish = silent.parts[0].material.finish;
    assert_eq!((finish.roughness, finish.metallic), (1.0, 1.0));
    let plain = load_mesh(&good("polygon.obj")).unwrap();
    assert_eq!(plain.parts[0].material.finish, sh_scene::Finish::DIFFUSE);

    let scene = load_scene(&good("polished.toml")).unwrap().scene;
    let finishes: Vec<_> = scene.objects.iter().map(|o| &o.material).collect();
    assert!(finishes[0].finish_texture.is_some());
    // What the scene says counts for all of it, and the file's factor for the rest.
    assert!(finishes[1].finish_texture.is_none());
    let [one, other] = [1, 2].map(|i: usize| finishes[i].finish);
    assert_eq!((one.roughness, one.metallic), (0.125, 0.25));
    assert_eq!((other.roughness, other.metallic), (1.0, 1.0));
    assert!(!scene.settings.gloss && !scene.mirrors());
}

/// A wall gets no spheres, is not complained of for its edges, and sends light by its patches; by spheres it cannot, which is said.
#[test]
fn what_blocks_no_light_has_no_spheres() {
    let wall = load_scene(&good("wall.toml")).unwrap();
    let [wall_body, other] = &wall.scene.objects[..] else {
        panic!("two objects");
    };
    assert!(wall_body.spheres.is_empty() && wall_body.weights.is_empty());
    assert!(wall_body.basis.is_some() && !other.spheres.is_empty());
    let closed = |warnings: &[String]| warnings.iter().filter(|w| w.contains("not closed")).count();
    assert_eq!(
        closed(&wall.report.warnings),
        0,
        "{:?}",
        wall.report.warnings
    );
    assert_eq!((wall.report.fits.len(), wall.report.weights.len()), (1, 1));
    let by_spheres = load_scene(&good("wall_by_spheres.toml")).unwrap();
    let said = |w: &String| w.contains("polygon.obj has no spheres, so it sends no light on");
    assert!(by_spheres.report.warnings.iter().any(said));
    assert!(by_spheres.scene.objects[0].surface.points.is_empty());
}

/// One object sends light on by its patches where all others do by their spheres; where nothing is sent on, it is said that it asks in
/// vain.
#[test]
fn an_object_sends_light_on_by_a_method_of_its_own() {
    let mixed = load_scene(&good("wall_alone.toml")).unwrap();
    let [wall, other] = &mixed.scene.objects[..] else {
        panic!("two objects");
    };
    assert!(wall.basis.is_some() && wall.surface.points.is_empty());
    assert!(other.basis.is_none() && !other.surface.points.is_empty());
    let quiet = |w: &String| !w.contains("no light") && !w.contains("method");
    assert!(
        mixed.report.warnings.iter().all(quiet),
        "{:?}",
        mixed.report.warnings
    );
    let plan = Plan::new(&mixed.scene);
    for domain in [Domain::Patches, Domain::Points] {
        assert!(plan.runs_over(domain), "{domain:?}");
    }
    let unlit = load_scene(&good("wall_unlit.toml")).unwrap();
    let said = |w: &String| w.contains("polygon.obj asks for method") && w.contains("[indirect]");
    assert!(unlit.report.warnings.iter().any(said));
    assert!(unlit.scene.objects[0].basis.is_none());
}

/// Spots, points and suns of a scene file and of glTF files, which go where their object does; candela become watts, which is said.
#[test]
fn lights_with_sharp_shadows_are_read() {
    let loaded = load_scene(&good("lights.toml")).unwrap();
    let lights = &loaded.scene.punctual;
    assert_eq!(lights.len(), 5, "{lights:?}");
    let placed: Vec<_> = lights
        .iter()
        .map(|light| light.placed(&loaded.scene.objects).unwrap())
        .collect();
    let near = |a: Vec3, b: [f32; 3]| assert!(a.abs_diff_eq(b.into(), 1e-5), "{a} {b:?}");
    let PunctualShape::Spot {
        position,
        towards,
        angle,
        blend,
        radius,
    } = placed[0].shape
    else {
        panic!("{:?}", placed[0]);
    };
    near(position, [0.0, 1.0, 0.0]);
    near(towards, [-2.0, 0.0, 0.0]);
    assert!((angle - 60.0_f32.to_radians()).abs() < 1e-6);
    assert!(blend == 0.5 && (radius - 0.1).abs() < 1e-6);
    assert_eq!(placed[0].intensity, [10.0, 5.0, 0.0]);
    let PunctualShape::Sun { direction, .. } = placed[1].shape else {
        panic!("{:?}", placed[1]);
    };
    near(direction, [0.0, 1.0, 0.0]);
    assert_eq!(placed[1].intensity, [3.0, 2.0, 1.0]);

    // The file's own: its node is 10 m along x, which the object turns to -z.
    let PunctualShape::Spot {
        position,
        towards,
        angle,
        blend,
        ..
    } = placed[2].shape
    else {
        panic!("{:?}", placed[2]);
    };
    near(position, [0.0, 4.0, -10.0]);
    near(towards, [0.0, -1.0, 0.0]);
    assert!((angle - 0.8).abs() < 1e-6 && (blend - 0.25).abs() < 1e-6);
    assert_eq!(placed[2].intensity, [2.0, 1.0, 0.5]);
    let PunctualShape::Point { position, .. } = placed[3].shape else {
        panic!("{:?}", placed[3]);
    };
    near(position, [3.0, 3.0, -11.0]);
    assert_eq!(placed[3].intensity, [1.0; 3]);
    let PunctualShape::Sun { direction, .. } = placed[4].shape else {
        panic!("{:?}", placed[4]);
    };
    near(direction, [0.0, 1.0, 0.0]);
    assert_eq!(placed[4].intensity, [3.0; 3]);
    // The file's camera stands 4 m before its node, which is 10 m along x; the object turns that to -z, and looks along -x.
    let camera = loaded.scene.camera;
    near(camera.eye, [4.0, 1.0, -10.0]);
    near((camera.target - camera.eye).normalize(), [-1.0, 0.0, 0.0]);
    assert_eq!(camera.fov, 0.5);
    assert!(
        loaded
            .scene
            .environment
            .pixels
            .iter()
            .all(|p| *p == [0.0; 3])
    );
    let said = |text: &str| {
        let all = loaded.report.warnings.iter();
        all.filter(|w| w.contains("lights.gltf") && w.contains(text))
            .count()
    };
    assert_eq!(["its 3 lights", "range", "orthographic"].map(said), [1; 3]);
    let lifted = load_scene(&good("lifted.toml")).unwrap();
    let sun = &lifted.scene.punctual[..];
    assert!(matches!(
        sun,
        [PunctualLight {
            shape: PunctualShape::Sun { .. },
            ..
        }]
    ));
    let said = |w: &String| w.starts_with("The sun of the built-in sky, ");
    assert!(lifted.report.warnings.iter().any(said));
}

/// Lamps of a scene file: bound to an object by its name or that of its file, and bright where they say.
#[test]
fn lamps_are_bound_to_objects() {
    let scene = load_scene(&good("lamps.toml")).unwrap().scene;
    let lamps = scene.placed_lights().unwrap();
    let AreaShape::Local { center, radius } = lamps[0].shape else {
        panic!("a ball");
    };
    assert!(
        center.abs_diff_eq(Vec3::new(-2.0, 5.0, 0.0), 1e-5),
        "{center}"
    );
    assert!((radius - 0.2).abs() < 1e-6);
    // Its object stands on its head.
    let below = lamps[0].distribution.unwrap();
    assert!(below.at(Vec3::Y)[0] > 0.9 && below.at(Vec3::NEG_Y)[0] < 0.1);
    assert_eq!(scene.lights[1].object, Some(2));
    let of_map = lamps[1].distribution.unwrap();
    let grey = load_environment(&good("grey.hdr")).unwrap().pixels[0][1];
    assert!((of_map.at(Vec3::X)[1] - grey).abs() < 1e-3 * grey);
    assert_eq!(lamps[1].radiance, [1.0; 3]);
    let given = lamps[2].distribution.unwrap();
    assert_eq!(given.coefficients()[0], [1.0, 2.0, 3.0]);
    assert_eq!(given.coefficients()[2], [0.5; 3]);
    assert_eq!(scene.light().unwrap().emitters.len(), 3);
}

#[test]
fn vertices_have_their_colours() {
    let model = load_mesh(&good("colored.gltf")).unwrap();
    let part = &model.parts[0];
    assert_eq!(part.material.albedo, [0.5, 1.0, 0.25]);
    let first = Vec3::from(part.mesh.colors[0]);
    assert!(first.abs_diff_eq(Vec3::new(1.0, 0.0, 0.2), 1e-6));
    assert_eq!(part.mesh.colors.len(), part.mesh.positions.len());
    assert_eq!(model.warnings, [""; 0]);
}

#[test]
fn reflectances_beyond_one_are_clamped_with_a_warning() {
    let model = load_mesh(&good("too_bright.gltf")).unwrap();
    let part = &model.parts[0];
    assert_eq!(part.material.albedo, [0.5, 1.0, 0.0]);
    assert_eq!(part.mesh.colors[0], [1.0, 0.5, 0.0]);
    for (warning, what) in model.warnings.iter().zip(["baseColorFactor", "COLOR_0"]) {
        let whole = warning.contains("too_bright.gltf: mesh 0 (flag), primitive 0: ");
        assert!(
            whole && warning.contains(what) && warning.contains("clamped"),
            "{warning}"
        );
    }
    assert_eq!(model.warnings.len(), 2);
}

#[test]
fn a_skin_puts_the_mesh_where_its_joints_are() {
    let model = load_mesh(&good("skinned.gltf")).unwrap();
    // The joint's (0, 1, 5) after the inverse bind matrix' (0, -1, 0); the mesh's own node counts for
    // nothing.
    assert_eq!(model.parts[0].mesh.positions[0], [0.0, 0.0, 5.0]);
    assert_eq!(model.parts[0].mesh.normals[0], [0.0, 0.0, 1.0]);
}

#[test]
fn environments_are_read_as_radiance() {
    let map = load_environment(&good("ramp.exr")).unwrap();
    assert_eq!((map.width, map.height), (4, 2));
    assert_eq!(map.pixels[6], [2.5, 1.0, 0.5]);
    let map = load_environment(&good("grey.hdr")).unwrap();
    // RGBE (128, 64, 32, 129): mantissa · 2^(129 - 136).
    assert_eq!(map.pixels[3], [1.0, 0.5, 0.25]);
}

#[test]
fn the_smallest_scene_gets_a_sensible_rest() {
    let loaded = load_scene(&good("smallest.toml")).unwrap();
    let (scene, report) = (loaded.scene, loaded.report);
    assert!(loaded.motion.is_still());
    assert_eq!(scene.objects.len(), 1);
    assert_eq!(report.fits.len(), 1);
    assert!(
        report.fits[0]
            .outside_volume_ratio
            .is_none_or(|ratio| ratio > 3.0),
        "a pentagon and a flag on its edge enclose next to nothing"
    );
    let [low, _] = scene.bounds().unwrap();
    assert_eq!(scene.ground.unwrap().height, low.y);
    assert_eq!((scene.settings.order, scene.settings.window), (4, None));
    let up = scene.environment.sample(Vec3::Y);
    assert!(up[2] > up[0], "a blue sky");
    assert!(scene.light().unwrap().irradiance([0.0, 1.0, 0.0])[1] > 0.1);
}

#[test]
fn a_mesh_file_is_a_scene() {
    let scene = load_scene(&good("triangle.glb")).unwrap().scene;
    assert_eq!(
        scene.objects[0].name,
        "triangle.glb: mesh 0 (flag), primitive 0"
    );
}

#[test]
fn a_camera_always_looks_somewhere() {
    let folder = std::env::temp_dir().join(format!("sh-bake-camera-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("scene.toml");
    let mesh = good("triangle.glb");
    for place in ["[0, 0, 0]", "[9e8, -9e8, 9e8]"] {
        for camera in [
            "fov = 30",
            "eye = [0, 0, 0]",
            "eye = [9e8, -9e8, 9e8]",
            "target = [9e8, 9e8, 0]",
        ] {
            let text = format!(
                "[[objects]]\nmesh = {mesh:?}\nspheres = 1\nscale = 1e-8\ntranslate = {place}\n\
                 [environment]\nmap = {:?}\n[camera]\n{camera}\n",
                good("grey.hdr"),
            );
            std::fs::write(&path, text).unwrap();
            let scene = load_scene(&path).unwrap().scene;
            let view = View {
                camera: scene.camera,
                width: 4,
                height: 3,
            };
            let axes = view.axes();
            assert!(
                axes.iter().all(|a| (a.length() - 1.0).abs() < 1e-5),
                "{place}, {camera}: {axes:?}"
            );
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_full_scene_is_taken_at_its_word() {
    let scene = load_scene(&good("full.toml")).unwrap().scene;
    let quad = &scene.objects[0];
    let expected = Affine3A::from_translation(Vec3::new(0.0, 2.0, 0.0))
        * Affine3A::from_rotation_y(90.0_f32.to_radians())
        * Affine3A::from_scale(Vec3::splat(0.5));
    assert!(quad.transform.abs_diff_eq(expected, 1e-6));
    assert_eq!(quad.material.albedo, [0.25; 3]);
    assert!(quad.spheres.len() <= 3 && scene.objects[1].spheres.len() <= 5);
    assert_eq!(
        scene.world_spheres().len(),
        quad.spheres.len() + scene.objects[1].spheres.len()
    );
    assert_eq!(scene.ground.unwrap().height, -1.5);
    assert_eq!(scene.camera.eye, Vec3::new(0.0, 1.0, 9.0));
    assert_eq!(
        (
            scene.settings.order,
            scene.settings.accumulation,
            scene.settings.window,
            scene.settings.shadows
        ),
        (5, 6, Some(7.5), false)
    );
    // Turned by a quarter: one of the map's four columns, and doubled.
    let turned = load_environment(&good("ramp.exr")).unwrap();
    assert_eq!(
        scene.environment.pixels[0],
        turned.pixels[1].map(|c| 2.0 * c)
    );
}

#[test]
fn spheres_bound_every_shape_whatever_their_number() {
    let shapes = [
        shapes::ball(1.0, 3),
        shapes::rounded_box(Vec3::new(1.0, 2.0, 0.3), 0.05),
        shapes::torus_knot(2, 3, 1.0, 0.4, 0.15),
        shapes::cone(1.0, 2.0),
        shapes::capsule(0.3, 1.0),
        shapes::twisted_column(0.2, 2.0, 2.0),
    ];
    for (i, mesh) in shapes.iter().enumerate() {
        let mut last = f32::INFINITY;
        for count in [1, 6, 30] {
            let set = SphereSet::fit(&[mesh], count);
            assert!(!set.spheres.is_empty() && set.spheres.len() <= count);
            assert_eq!(set.uncovered(&[mesh]), None, "shape {i}, {count} spheres");
            let ratio = set.outside_volume_ratio.expect("shapes are closed");
            assert!(
                ratio <= last + 0.05,
                "shape {i}: {count} spheres, {last} became {ratio}"
            );
            last = ratio;
        }
    }
}

#[test]
fn a_set_made_smaller_is_found_not_to_bound() {
    let mesh = shapes::cone(1.0, 2.0);
    let mut set = SphereSet::fit(&[&mesh], 8);
    for sphere in &mut set.spheres {
        sphere.radius *= 0.98;
    }
    assert!(set.uncovered(&[&mesh]).is_some());
}

#[test]
fn the_same_mesh_gets_the_same_spheres_on_any_number_of_threads() {
    let mesh = shapes::torus_knot(2, 3, 1.0, 0.4, 0.15);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| SphereSet::fit(&[&mesh], 24))
    };
    let one = on(1);
    assert_eq!(one, on(2));
    assert_eq!(one, on(5));
}

#[test]
fn one_triangle_and_none_are_fitted_too() {
    let mesh = Mesh {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let set = SphereSet::fit(&[&mesh], 16);
    assert!(!set.spheres.is_empty());
    assert_eq!(set.uncovered(&[&mesh]), None);
    assert!(SphereSet::fit(&[&Mesh::default()], 16).spheres.is_empty());
}
