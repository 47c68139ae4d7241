//! Things to light, made from a counter: the same in every run.

#[path = "../../../tests/shared/ball_basis.rs"]
mod ball_basis;

use ball_basis::{ball_basis, panel_basis};
use glam::{Affine3A, Quat, Vec3};
use sh_scene::surface::{SurfacePoint, SurfaceSamples, directions};
use sh_scene::{
    AreaLight, Blocking, Camera, Distribution, EnvironmentMap, Ground, Indirect, Light, Limits,
    Material, Mesh, Method, Object, Receiver, Scene, Settings, Sphere, View,
};

/// Numbers in 0..1, the same every time (SplitMix64).
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 40) as f32 / (1 << 24) as f32
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0
    }

    pub fn receivers(&mut self, count: usize) -> Vec<Receiver> {
        (0..count)
            .map(|i| Receiver {
                position: (self.vector() * 3.0).into(),
                covered: u32::from(i % 7 != 3),
                normal: self.vector().normalize().into(),
                object: i as u32,
            })
            .collect()
    }

    /// Spheres that take about a fifth of the sky together.
    pub fn spheres(&mut self, count: usize) -> Vec<Sphere> {
        let radius = 3.0 / (count.max(1) as f32).sqrt();
        (0..count)
            .map(|_| Sphere {
                center: (self.vector() * 3.0).into(),
                radius: radius * (0.2 + self.next()),
            })
            .collect()
    }

    /// Light that is positive nearly everywhere.
    pub fn light(&mut self, order: usize) -> Light {
        let mut coefficients: Vec<[f32; 3]> = (0..order * order)
            .map(|_| (self.vector() * 0.4).into())
            .collect();
        coefficients[0] = [3.0, 4.0, 5.0];
        Light {
            order,
            coefficients,
            emitters: Vec::new(),
        }
    }
}

/// A mesh of one quad, counter-clockwise seen from `normal`.
pub fn quad(center: Vec3, right: Vec3, up: Vec3) -> Mesh {
    let corner = |x: f32, y: f32| (center + right * x + up * y).into();
    Mesh {
        positions: vec![
            corner(-1.0, -1.0),
            corner(1.0, -1.0),
            corner(1.0, 1.0),
            corner(-1.0, 1.0),
        ],
        normals: vec![right.cross(up).normalize().into(); 4],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        ..Mesh::default()
    }
}

/// A quad that stands on a ground plane, under a sky that differs everywhere.
pub fn standing_quad() -> Scene {
    let object = Object {
        name: "quad".into(),
        mesh: quad(Vec3::ZERO, Vec3::X, Vec3::Y),
        material: Material::diffuse([0.25, 0.5, 0.75]),
        transform: Affine3A::from_translation(Vec3::Y),
        spheres: vec![
            Sphere {
                center: [-0.5, 0.0, 0.0],
                radius: 0.5,
            },
            Sphere {
                center: [0.5, 0.0, 0.0],
                radius: 0.5,
            },
        ],
        ..Object::default()
    };
    let mut numbers = Numbers(5);
    let pixels = (0..32 * 16)
        .map(|_| [numbers.next(), numbers.next(), numbers.next()])
        .collect();
    Scene {
        punctual: Vec::new(),
        objects: vec![object],
        environment: EnvironmentMap {
            width: 32,
            height: 16,
            pixels,
        },
        lights: Vec::new(),
        ground: Some(Ground {
            height: 0.0,
            albedo: [0.1, 0.2, 0.3],
        }),
        camera: Camera {
            eye: Vec3::new(1.0, 1.5, 5.0),
            target: Vec3::Y,
            fov: 0.8,
        },
        settings: Settings {
            order: 4,
            accumulation: 4,
            shadows: true,
            window: Some(8.0),
            half_resolution: false,
            limits: Limits::default(),
            gloss: true,
            indirect: None,
        },
    }
}

/// A ball of so many rings.
pub fn ball(radius: f32, rings: u32) -> Mesh {
    let columns = 2 * rings;
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        for column in 0..=columns {
            let turn = std::f32::consts::TAU * (column % columns) as f32 / columns as f32;
            let tilt = std::f32::consts::PI * ring as f32 / rings as f32;
            let flat = tilt.sin();
            let normal = Vec3::new(flat * turn.sin(), tilt.cos(), flat * turn.cos());
            mesh.positions.push((normal * radius).into());
            mesh.normals.push(normal.into());
        }
    }
    for ring in 0..rings {
        for column in 0..columns {
            let (at, below) = (
                ring * (columns + 1) + column,
                (ring + 1) * (columns + 1) + column,
            );
            mesh.triangles.push([at, below, below + 1]);
            mesh.triangles.push([at, below + 1, at + 1]);
        }
    }
    mesh
}

/// Two analytic lights: one in the sky, one near by.
pub fn lamps() -> Vec<AreaLight> {
    vec![
        AreaLight::distant(Vec3::new(1.0, 2.0, 0.7), 0.3, [9.0, 7.0, 4.0]),
        AreaLight {
            window: Some(6.0),
            distribution: Distribution::cap(Vec3::new(0.5, -1.0, 0.2), 1.5).ok(),
            ..AreaLight::local(Vec3::new(-2.0, 1.5, 1.0), 0.4, [1.0, 2.0, 8.0])
        },
    ]
}

/// A ball of many colours with forty blockers before a quad on the ground, lit by the sky and by lamps, at half resolution.
pub fn ball_and_quad() -> Scene {
    let mut scene = standing_quad();
    let mut numbers = Numbers(8);
    let spheres = (0..40)
        .map(|_| Sphere {
            center: (numbers.vector().normalize() * 0.35).into(),
            radius: 0.15,
        })
        .collect();
    let mut mesh = ball(0.5, 24);
    mesh.colors = mesh.positions.iter().map(|p| p.map(|c| c + 0.5)).collect();
    scene.objects.push(Object {
        name: "ball".into(),
        mesh,
        transform: Affine3A::from_translation(Vec3::new(0.6, 0.5, 1.2)),
        spheres,
        ..scene.objects[0].clone()
    });
    scene.lights = lamps();
    scene.settings.half_resolution = true;
    scene
}

/// Points in most directions around each sphere, somewhat off it.
pub fn surface(numbers: &mut Numbers, spheres: &[Sphere]) -> SurfaceSamples {
    let mut samples = SurfaceSamples::default();
    for sphere in spheres {
        let mut points = Vec::new();
        for (direction, towards) in (0..).zip(directions()) {
            if numbers.next() < 0.3 {
                continue;
            }
            let away = Vec3::from(*towards) * sphere.radius * (0.9 + 0.2 * numbers.next());
            points.push(SurfacePoint {
                position: (Vec3::from(sphere.center) + away).into(),
                direction,
                normal: (Vec3::from(*towards) + numbers.vector() * 0.2)
                    .normalize()
                    .into(),
                albedo: [numbers.next(), numbers.next(), numbers.next()],
                ..Default::default()
            });
        }
        samples.push(points);
        let turn = Quat::from_scaled_axis(numbers.vector() * 2.0);
        *samples.rotations.last_mut().unwrap() = turn.to_array();
    }
    samples
}

/// The same, with bodies whose spheres send light on twice.
pub fn bouncing() -> Scene {
    let mut scene = ball_and_quad();
    let mut numbers = Numbers(21);
    for object in &mut scene.objects {
        object.surface = surface(&mut numbers, &object.spheres);
    }
    scene.settings.indirect = Some(Indirect {
        bounces: 2,
        blocking: Blocking::Discs,
        ..Indirect::default()
    });
    scene
}

/// Balls that send light on by their patches, three times, on a flat body that does so too, beside a quad that does so by its
/// spheres.
pub fn shining() -> Scene {
    let mut scene = ball_and_quad();
    let mut numbers = Numbers(33);
    scene.objects[0].surface = surface(&mut numbers, &scene.objects[0].spheres);
    scene.objects[1].basis = Some(ball_basis(&mut || numbers.next(), 0.5, 9));
    let turn = Quat::from_euler(glam::EulerRot::XYZ, 0.4, 1.0, -0.3);
    scene.objects.push(Object {
        name: "another".into(),
        transform: Affine3A::from_scale_rotation_translation(
            Vec3::splat(0.6),
            turn,
            Vec3::new(-0.5, 0.4, 1.5),
        ),
        basis: Some(ball_basis(&mut || numbers.next(), 0.5, 4)),
        ..scene.objects[1].clone()
    });
    // Flat, and with so few functions that some of its points are enough for what bodies send.
    let panel = panel_basis(&mut || numbers.next(), 4.0, 2);
    assert!(panel.few() < panel.patches());
    scene.objects.push(Object {
        name: "panel".into(),
        transform: Affine3A::from_rotation_translation(
            Quat::from_rotation_x(std::f32::consts::PI),
            Vec3::new(-2.0, 2.5, 2.0),
        ),
        basis: Some(panel),
        ..Object::default()
    });
    scene.settings.indirect = Some(Indirect {
        method: Method::BasisIrradiance,
        bounces: 3,
        ..Indirect::default()
    });
    scene
}

/// The scene's own camera.
pub fn view(scene: &Scene, width: u32, height: u32) -> View {
    View {
        camera: scene.camera,
        width,
        height,
    }
}
