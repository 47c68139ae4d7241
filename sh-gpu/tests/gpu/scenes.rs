//! Things to light, made from a counter: the same in every run.

use glam::{Affine3A, Vec3};
use sh_scene::{
    Camera, EnvironmentMap, Ground, Light, Material, Mesh, Object, Receiver, Scene, Settings,
    Sphere, View,
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
    }
}

/// A quad that stands on a ground plane, under a sky that differs everywhere.
pub fn standing_quad() -> Scene {
    let object = Object {
        name: "quad".into(),
        mesh: quad(Vec3::ZERO, Vec3::X, Vec3::Y),
        material: Material {
            albedo: [0.25, 0.5, 0.75],
            texture: None,
        },
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
    };
    let mut numbers = Numbers(5);
    let pixels = (0..32 * 16)
        .map(|_| [numbers.next(), numbers.next(), numbers.next()])
        .collect();
    Scene {
        objects: vec![object],
        environment: EnvironmentMap {
            width: 32,
            height: 16,
            pixels,
        },
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
            window: 8.0,
        },
    }
}

/// The scene's own camera.
pub fn view(scene: &Scene, width: u32, height: u32) -> View {
    View {
        camera: scene.camera,
        width,
        height,
    }
}
