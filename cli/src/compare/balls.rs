//! A picture of the spheres that stand for the bodies.

use super::view::Seen;
use glam::Vec3;
use sh_reference::basis::evaluate;
use sh_scene::{Light, Scene};

/// A sphere, how it shines, and the colour of its body.
struct Ball {
    center: Vec3,
    radius: f32,
    /// An SH vector for each channel, if it sends anything on.
    emission: Option<[Vec<f64>; 3]>,
    albedo: [f32; 3],
}

/// The spheres of all bodies, the ground below them and the sky behind; linear radiance. Each shows what it emits in the
/// direction of its surface's normal, or its body's colour in the open light where nothing is sent on.
pub fn picture(
    scene: &Scene,
    light: &Light,
    emission: &[Vec<[f32; 3]>],
    seen: &Seen,
) -> Vec<[f32; 3]> {
    let albedos = albedos(scene, seen);
    let albedos = scene.objects.iter().zip(albedos);
    let albedos = albedos.flat_map(|(o, albedo)| std::iter::repeat_n(albedo, o.spheres.len()));
    let balls: Vec<Ball> = scene
        .world_spheres()
        .iter()
        .zip(albedos)
        .enumerate()
        .map(|(i, (sphere, albedo))| Ball {
            center: sphere.center.into(),
            radius: sphere.radius,
            emission: emission.get(i).map(|vector| channels(vector)),
            albedo,
        })
        .collect();
    let eye = scene.camera.eye;
    seen.picture(|ray, _| {
        let nearest = balls
            .iter()
            .filter_map(|ball| Some((distance(ball, eye, ray)?, ball)))
            .min_by(|a, b| a.0.total_cmp(&b.0));
        let ground = scene.ground.and_then(|ground| {
            let distance = (ground.height - eye.y) / ray.y;
            (ray.y < 0.0 && distance > 0.0).then_some((distance, ground))
        });
        let lit = |normal: [f32; 3], albedo: [f32; 3]| {
            let light = light.irradiance(normal);
            std::array::from_fn(|c| albedo[c] * light[c])
        };
        match (nearest, ground) {
            (Some((near, _)), Some((distance, ground))) if distance < near => {
                lit([0.0, 1.0, 0.0], ground.albedo)
            }
            (Some((near, ball)), _) => {
                let normal = (eye + ray * near - ball.center).normalize_or(Vec3::Y);
                match &ball.emission {
                    Some(channels) => {
                        let towards = normal.as_dvec3().to_array();
                        channels.each_ref().map(|c| evaluate(c, towards) as f32)
                    }
                    None => lit(normal.into(), ball.albedo),
                }
            }
            (None, Some((_, ground))) => lit([0.0, 1.0, 0.0], ground.albedo),
            (None, None) => scene.environment.sample(ray),
        }
    })
}

/// The vectors of red, green and blue.
fn channels(coefficients: &[[f32; 3]]) -> [Vec<f64>; 3] {
    [0, 1, 2].map(|c| coefficients.iter().map(|k| f64::from(k[c])).collect())
}

/// The mean colour of what is seen of each body; of one that is not seen, its material's without its texture.
fn albedos(scene: &Scene, seen: &Seen) -> Vec<[f32; 3]> {
    let mut sums = vec![([0.0; 3], 0.0); scene.objects.len()];
    for (receiver, albedo) in seen.receivers().iter().zip(&seen.samples.albedo) {
        if let Some((sum, count)) = sums.get_mut((receiver.object as usize).wrapping_sub(1)) {
            for (sum, c) in sum.iter_mut().zip(albedo) {
                *sum += c;
            }
            *count += 1.0;
        }
    }
    let bodies = sums.iter().zip(&scene.objects);
    bodies
        .map(|((sum, count), object)| match *count > 0.0 {
            true => sum.map(|c: f32| c / count),
            false => object.material.albedo,
        })
        .collect()
}

/// Where a ray from the eye meets a sphere first, if the eye is outside.
fn distance(ball: &Ball, eye: Vec3, ray: Vec3) -> Option<f32> {
    let towards = ball.center - eye;
    let along = towards.dot(ray);
    // From the nearest point of the ray, which does not cancel where the sphere is far.
    let aside = (towards - ray * along).length_squared();
    let half = ball.radius * ball.radius - aside;
    let distance = along - half.max(0.0).sqrt();
    (half >= 0.0 && distance > 0.0).then_some(distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_meet_the_near_side_of_a_sphere() {
        let ball = Ball {
            center: Vec3::new(0.0, 0.0, -5.0),
            radius: 2.0,
            emission: None,
            albedo: [1.0; 3],
        };
        assert_eq!(distance(&ball, Vec3::ZERO, Vec3::NEG_Z), Some(3.0));
        assert_eq!(distance(&ball, Vec3::ZERO, Vec3::Z), None, "behind");
        assert_eq!(distance(&ball, Vec3::new(2.5, 0.0, 0.0), Vec3::NEG_Z), None);
        assert_eq!(distance(&ball, ball.center, Vec3::Y), None, "inside");
    }
}
