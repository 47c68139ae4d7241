//! What the blocker spheres cover exactly: the truth between capsules and spherical harmonics.

use super::cast::Samples;
use glam::{Vec3, Vec3A};
use sh_scene::{Receiver, Sphere};

/// The part of the sky that a blocker covers: everything within an angle of a direction.
#[derive(Clone, Copy, Debug)]
struct Cap {
    axis: Vec3A,
    cos: f32,
}

/// The caps of all spheres that count for a receiver, after the self-shadow rule of Ren et al. 2006, section 6.2, in
/// its continuous form: a sphere across the receiver's plane is replaced by one that touches the plane.
fn caps(receiver: &Receiver, spheres: &[Sphere], out: &mut Vec<Cap>) {
    out.clear();
    let (p, normal) = (Vec3::from(receiver.position), Vec3::from(receiver.normal));
    for sphere in spheres {
        let center = Vec3::from(sphere.center);
        let r = sphere.radius;
        let height = (center - p).dot(normal);
        if height <= -r {
            continue;
        }
        let (center, radius) = if height >= r {
            (center, r)
        } else {
            let foot = center - normal * height;
            let circle = (r * r - height * height).max(0.0).sqrt();
            let away =
                ((p.distance(foot) - circle) / circle.max(f32::MIN_POSITIVE)).clamp(0.0, 1.0);
            let radius = (1.0 - away) * height.max(0.0) + away * 0.5 * (r + height);
            (foot + normal * radius, radius)
        };
        let towards = Vec3A::from(center - p);
        let distance = towards.length();
        if radius > 0.0 && distance > 0.0 {
            let sin = (radius / distance).min(1.0);
            out.push(Cap {
                axis: towards / distance,
                cos: (1.0 - sin * sin).sqrt(),
            });
        }
    }
    // The largest first: most directions that are covered are covered by them.
    out.sort_by(|a, b| a.cos.total_cmp(&b.cos));
}

/// Radiance that albedo 1 reflects behind the spheres, as [`super::cast::Caster::shade`].
pub fn shade<const N: usize>(
    receiver: &Receiver,
    index: usize,
    samples: &Samples,
    spheres: &[Sphere],
    light: impl Fn(Vec3A) -> [Vec3A; N],
) -> [Vec3A; N] {
    let mut blockers = Vec::new();
    caps(receiver, spheres, &mut blockers);
    samples.mean(receiver, index, |direction| {
        let open = blockers.iter().all(|cap| cap.axis.dot(direction) < cap.cos);
        open.then(|| light(direction))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sphere_overhead_covers_the_square_of_its_sine() {
        let receiver = Receiver {
            position: [0.0; 3],
            covered: 1,
            normal: [0.0, 1.0, 0.0],
            object: 0,
        };
        let ball = |y: f32, radius: f32| Sphere {
            center: [0.0, y, 0.0],
            radius,
        };
        let samples = Samples::new(1024, 5);
        let lit = |spheres: &[Sphere]| {
            let [lit] = shade(&receiver, 3, &samples, spheres, |_| [Vec3A::ONE]);
            lit.x
        };
        // ∫ of cos θ / π over a cap of angle a about the normal is sin² a.
        assert!((lit(&[ball(2.0, 1.0)]) - 0.75).abs() < 0.01);
        // Below the plane, or around the receiver with its centre below: nothing.
        assert_eq!(lit(&[ball(-2.0, 1.0)]), 1.0);
        assert_eq!(lit(&[ball(-0.5, 1.0)]), 1.0);
    }
}
