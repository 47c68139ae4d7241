//! Sphere sets bound what they were fitted to: whole triangles, by proof.

use glam::{DVec3, Vec3};
use sh_bake::{SphereSet, shapes};
use sh_scene::{Mesh, Sphere};

fn shapes_of_all_kinds() -> Vec<(&'static str, Mesh)> {
    let mut open = shapes::cylinder(0.5, 1.0);
    open.triangles.truncate(open.triangles.len() * 3 / 4);
    let flat = Mesh {
        positions: vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 1.0], [3.0, 0.0, 1.0]],
        triangles: vec![[0, 1, 2], [1, 3, 2]],
        ..Mesh::default()
    };
    let needle = Mesh {
        positions: vec![[0.0; 3], [100.0, 0.0, 0.0], [50.0, 1e-4, 0.0]],
        triangles: vec![[0, 1, 2]],
        ..Mesh::default()
    };
    let mut far = shapes::ball(0.01, 2);
    for p in &mut far.positions {
        p[0] += 1000.0;
    }
    vec![
        ("ball", shapes::ball(1.0, 3)),
        ("box", shapes::rounded_box(Vec3::new(1.0, 2.0, 0.3), 0.0)),
        (
            "rounded box",
            shapes::rounded_box(Vec3::new(1.0, 2.0, 0.3), 0.05),
        ),
        ("torus knot", shapes::torus_knot(2, 3, 1.0, 0.4, 0.15)),
        ("cone", shapes::cone(1.0, 2.0)),
        ("cylinder", shapes::cylinder(0.1, 3.0)),
        ("capsule", shapes::capsule(0.3, 1.0)),
        ("twisted column", shapes::twisted_column(0.2, 2.0, 2.0)),
        ("open cylinder", open),
        ("flat", flat),
        ("needle", needle),
        ("far away", far),
    ]
}

/// Whether some sphere holds a point, with a little less than its radius.
fn held(spheres: &[Sphere], point: DVec3, slack: f64) -> bool {
    spheres.iter().any(|s| {
        let center = DVec3::from(s.center.map(f64::from));
        center.distance(point) <= f64::from(s.radius) + slack
    })
}

/// Many points of a triangle, the corners among them.
fn points(mesh: &Mesh, triangle: &[u32; 3]) -> Vec<DVec3> {
    const STEPS: u32 = 12;
    let [a, b, c] = triangle.map(|i| DVec3::from(mesh.positions[i as usize].map(f64::from)));
    let at = |i: u32, j: u32| {
        a + (b - a) * (f64::from(i) / f64::from(STEPS))
            + (c - a) * (f64::from(j) / f64::from(STEPS))
    };
    (0..=STEPS)
        .flat_map(|i| (0..=STEPS - i).map(move |j| at(i, j)))
        .collect()
}

#[test]
fn every_triangle_of_every_shape_lies_in_the_spheres_and_damage_is_found() {
    let mut holes = 0;
    for (name, mesh) in shapes_of_all_kinds() {
        let one = SphereSet::fit(&[&mesh], 1);
        assert_eq!(
            (one.spheres.len(), one.uncovered(&[&mesh])),
            (1, None),
            "{name}"
        );
        let whole = SphereSet::fit(&[&mesh], 10);
        assert!(whole.spheres.len() <= 10, "{name}");
        assert_eq!(whole.uncovered(&[&mesh]), None, "{name}");
        let size = whole.spheres.iter().map(|s| s.radius).fold(0.0, f32::max);
        for i in 0..whole.spheres.len() {
            for damage in 0..4 {
                let mut set = whole.clone();
                let sphere = &mut set.spheres[i];
                match damage {
                    0 => sphere.radius *= 0.99,
                    1 => sphere.radius *= 0.7,
                    2 => sphere.center[i % 3] += 0.02 * sphere.radius,
                    _ => sphere.radius = 0.0,
                }
                match set.uncovered(&[&mesh]) {
                    // It names a place outside all spheres, or so near to their common edge that none holds what is
                    // around it.
                    Some(hole) => {
                        holes += 1;
                        let hole = DVec3::from(hole.map(f64::from));
                        let slack = -1e-4 * f64::from(size);
                        assert!(
                            !held(&set.spheres, hole, slack),
                            "{name}, sphere {i}, damage {damage}: {hole}"
                        );
                    }
                    None => {
                        let mut all = mesh.triangles.iter().flat_map(|t| points(&mesh, t));
                        let slack = 1e-6 * f64::from(size);
                        let missed = all.find(|p| !held(&set.spheres, *p, slack));
                        assert_eq!(missed, None, "{name}, sphere {i}, damage {damage}");
                    }
                }
            }
        }
    }
    assert!(holes > 100, "{holes}");
}

#[test]
fn a_missing_number_is_never_taken_for_covered() {
    let mut mesh = shapes::ball(1.0, 1);
    let mut set = SphereSet::fit(&[&mesh], 1);
    assert_eq!(set.uncovered(&[&mesh]), None);
    set.spheres[0].radius = f32::NAN;
    assert!(set.uncovered(&[&mesh]).is_some());
    set.spheres[0].radius = 10.0;
    mesh.positions[0][1] = f32::NAN;
    assert!(set.uncovered(&[&mesh]).is_some());
    set.spheres.clear();
    assert!(set.uncovered(&[&mesh]).is_some());
}

#[test]
fn an_open_mesh_has_the_solid_that_it_encloses_by_more_than_half() {
    let mut mesh = shapes::ball(1.0, 4);
    let closed = SphereSet::fit(&[&mesh], 4).outside_volume_ratio.unwrap();
    // Without its northern cap down to a height of 0.8: a tenth of the surface.
    let low = |t: &[u32; 3]| t.iter().any(|&i| mesh.positions[i as usize][1] < 0.8);
    mesh.triangles = mesh.triangles.iter().copied().filter(low).collect();
    assert!(!sh_bake::is_closed(&[&mesh]));
    let open = SphereSet::fit(&[&mesh], 4).outside_volume_ratio.unwrap();
    assert!(closed < 0.02 && open < 0.1, "{closed} {open}");
    // A single side of a box encloses nothing by more than half.
    let mut side = shapes::rounded_box(Vec3::ONE, 0.0);
    let top = |t: &[u32; 3]| t.iter().all(|&i| side.positions[i as usize][1] == 0.5);
    side.triangles = side.triangles.iter().copied().filter(top).collect();
    assert!(!side.triangles.is_empty());
    assert_eq!(SphereSet::fit(&[&side], 4).outside_volume_ratio, None);
}

#[test]
fn bodies_without_volume_size_or_end_are_fitted_too() {
    let mesh = |positions: Vec<[f32; 3]>, triangles: Vec<[u32; 3]>| Mesh {
        positions,
        triangles,
        ..Mesh::default()
    };
    for (mesh, name) in [
        (mesh(vec![[1.0; 3]], vec![[0, 0, 0]]), "a point"),
        (
            mesh(vec![[0.0; 3], [1.0; 3]], vec![[0, 1, 0], [1, 0, 1]]),
            "a line",
        ),
        (
            mesh(vec![[-1e9; 3], [1e9; 3], [1e9, -1e9, 0.0]], vec![[0, 1, 2]]),
            "large",
        ),
        (
            mesh(vec![[0.0; 3], [1e-9; 3], [1e-9, 0.0, 0.0]], vec![[0, 1, 2]]),
            "small",
        ),
    ] {
        for count in [1, 9] {
            let set = SphereSet::fit(&[&mesh], count);
            assert!(
                set.spheres
                    .iter()
                    .all(|s| s.radius.is_finite() && s.radius >= 0.0),
                "{name}"
            );
            assert!(!set.spheres.is_empty(), "{name}");
            assert_eq!(set.uncovered(&[&mesh]), None, "{name}");
        }
    }
}
