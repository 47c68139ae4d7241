//! Scenes that the tests share.
#![allow(dead_code, reason = "each test file uses its own part")]

use glam::{Affine3A, Vec3, vec3};
use sh_scene::{
    Camera, EnvironmentMap, Light, Material, Mesh, Object, Receiver, Scene, Settings, Sphere,
};

/// A sphere of `rings` by `2 rings` quads around the origin, with exact normals.
pub fn sphere_mesh(radius: f32, rings: u32) -> Mesh {
    let columns = 2 * rings;
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        for column in 0..=columns {
            let (u, v) = (column as f32 / columns as f32, ring as f32 / rings as f32);
            // The seam's two columns must be the same points to the bit.
            let (sin_phi, cos_phi) = (std::f32::consts::TAU * (u % 1.0)).sin_cos();
            let (sin_theta, cos_theta) = match ring {
                0 => (0.0, 1.0),
                r if r == rings => (0.0, -1.0),
                _ => (std::f32::consts::PI * v).sin_cos(),
            };
            let normal = vec3(sin_theta * sin_phi, cos_theta, sin_theta * cos_phi);
            mesh.positions.push((normal * radius).into());
            mesh.normals.push(normal.into());
            mesh.uvs.push([u, v]);
        }
    }
    for ring in 0..rings {
        for column in 0..columns {
            let at = ring * (columns + 1) + column;
            let below = at + columns + 1;
            mesh.triangles.push([at, below, below + 1]);
            mesh.triangles.push([at, below + 1, at + 1]);
        }
    }
    mesh
}

/// A body of plain white with one bounding sphere around the origin.
pub fn object(mesh: Mesh, transform: Affine3A) -> Object {
    let radius = mesh
        .positions
        .iter()
        .map(|&p| Vec3::from(p).length())
        .fold(0.0, f32::max);
    Object {
        name: "body".into(),
        mesh,
        material: Material::diffuse([1.0; 3]),
        transform,
        spheres: vec![Sphere {
            center: [0.0; 3],
            radius,
        }],
        ..Object::default()
    }
}

/// `objects` under an even sky of radiance 1, seen from +Z.
pub fn scene(objects: Vec<Object>) -> Scene {
    Scene {
        punctual: Vec::new(),
        objects,
        environment: EnvironmentMap::constant([1.0; 3]),
        lights: Vec::new(),
        ground: None,
        camera: Camera {
            eye: vec3(0.0, 0.0, 5.0),
            target: Vec3::ZERO,
            fov: 0.8,
        },
        settings: Settings {
            window: Some(8.0),
            half_resolution: false,
            ..Settings::default()
        },
    }
}

/// The light of a small map that shows this radiance in each direction.
pub fn light_of(order: usize, radiance: impl Fn(Vec3) -> [f32; 3]) -> Light {
    let (width, height) = (32, 16);
    let pixels = (0..width * height)
        .map(|i| {
            let (u, v) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
            radiance(EnvironmentMap::direction(
                u / width as f32,
                v / height as f32,
            ))
        })
        .collect();
    let map = EnvironmentMap {
        width,
        height,
        pixels,
    };
    Light::project(&map, None, order, 2.0 * order as f32).unwrap()
}

/// A covered receiver.
pub fn receiver(position: Vec3, normal: Vec3) -> Receiver {
    Receiver {
        position: position.into(),
        covered: 1,
        normal: normal.normalize().into(),
        object: 0,
    }
}

/// Numbers in 0..1 that look random and are the same on every run (xorshift).
pub struct Random(pub u64);

impl Random {
    pub fn number(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f32 / (1_u64 << 24) as f32
    }

    pub fn within(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.number()
    }

    pub fn point(&mut self, reach: f32) -> Vec3 {
        Vec3::from_array(core::array::from_fn(|_| self.within(-reach, reach)))
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let p = self.point(1.0);
            if (0.01..1.0).contains(&p.length_squared()) {
                return p.normalize();
            }
        }
    }
}
