//! What the shading kernels compute, in f64: obvious rather than fast.

use sh_core::Routines;
use sh_scene::{Light, Receiver, Sphere};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Centre relative to the receiver, and radius, of the sphere that counts.
pub fn replaced(receiver: &Receiver, sphere: &Sphere) -> Option<([f64; 3], f64)> {
    let normal = receiver.normal.map(f64::from);
    let center: [f64; 3] =
        std::array::from_fn(|i| f64::from(sphere.center[i]) - f64::from(receiver.position[i]));
    let (r, c) = (f64::from(sphere.radius), dot(center, normal));
    let square = dot(center, center);
    // From inside the sphere counts that reaches to the receiver.
    let over = c / r * (r * r / square).max(1.0);
    if c >= r {
        return Some((center, r));
    }
    if over <= -1.0 || r <= 0.0 {
        return None;
    }
    let foot: [f64; 3] = std::array::from_fn(|i| center[i] - c * normal[i]);
    let radius = r * <[f64; 4]>::horizon_radius(over, (r * r / square).min(1.0));
    Some((
        std::array::from_fn(|i| foot[i] + radius * normal[i]),
        radius,
    ))
}

/// Radiance of albedo 1 under blockers, whose logarithms are accumulated with `A` coefficients.
pub fn shadow<const C: usize, const A: usize>(
    receiver: &Receiver,
    spheres: &[Sphere],
    light: &Light,
) -> [f64; 3]
where
    [f64; C]: Routines<f64>,
    [f64; A]: Routines<f64>,
{
    let mut f = [0.0; A];
    for (center, radius) in spheres.iter().filter_map(|s| replaced(receiver, s)) {
        let distance = dot(center, center).sqrt();
        if radius > 0.0 && distance > 0.0 {
            let sine = (radius / distance).min(1.0);
            let cosine = (1.0 - sine * sine).max(0.0).sqrt();
            let log = <[f64; A]>::cap_log_shading(sine, cosine);
            let turned = <[f64; A]>::zonal(log, center.map(|x| x / distance));
            f = std::array::from_fn(|i| f[i] + turned[i]);
        }
    }
    let lobe = <[f64; C]>::cosine(receiver.normal.map(f64::from));
    let transfer = f.transfer(receiver.normal.map(f64::from));
    let shadowed = channels(&transfer[..C], light);
    let open = channels(&lobe, light);
    std::array::from_fn(|i| shadowed[i].clamp(0.0, open[i].max(0.0)))
}

/// Radiance of albedo 1 without blockers.
pub fn irradiance<const C: usize>(receiver: &Receiver, light: &Light) -> [f64; 3]
where
    [f64; C]: Routines<f64>,
{
    channels(&<[f64; C]>::cosine(receiver.normal.map(f64::from)), light).map(|x| x.max(0.0))
}

fn channels(transfer: &[f64], light: &Light) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (t, l) in transfer.iter().zip(&light.coefficients) {
        for i in 0..3 {
            sum[i] += t * f64::from(l[i]);
        }
    }
    sum
}
