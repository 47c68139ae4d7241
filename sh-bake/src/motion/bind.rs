//! What holds a sphere in a skinned mesh: its anchors on the bones.

use super::coordinates;
use glam::{Affine3A, DVec3};
use rayon::prelude::*;
use sh_scene::motion::{Anchor, Anchors, Skin};
use sh_scene::{Mesh, Sphere};

/// Bones that a sphere hangs on at most.
const MOST_BONES: usize = 8;
/// Coordinates whose absolute values sum to more than this are not used: vertices far away would pull and
/// push a sphere out of the body. Inside a convex mesh the sum is 1.
const MOST_SIZE: f64 = 2.0;
/// How far, relative to the mesh, coordinates may miss the point they are of.
const MOST_ERROR: f64 = 1e-6;

/// Binds spheres to what moves the meshes they bound (Ren et al. 2006, section 6.2): each centre's mean value
/// coordinates with respect to the vertices, summed over what each bone has of them. `skins` has one for each
/// mesh, and `bones` are those with which [`Skin::pose`] makes the meshes as they are now.
///
/// Where a mesh is open, or the coordinates are large and of both signs (a centre well outside), the nearest
/// point of the surface takes the centre along as if it were fixed to it. A sphere hangs on at most 8 bones;
/// those with the smallest shares are left out, and the others take over theirs. On a running fox of 24 bones
/// and 64 spheres that moves centres by up to 0.3 % of the fox's length.
///
/// ```
/// use glam::{Affine3A, Vec3};
/// use sh_bake::{SphereSet, bind_spheres, shapes};
/// use sh_scene::motion::{Influences, Skin};
/// let mesh = shapes::ball(1.0, 2);
/// let all = vec![Influences::one(0); mesh.positions.len()];
/// let skin = Skin::new(&mesh.positions, &mesh.normals, all)?;
/// let mut spheres = SphereSet::fit(&[&mesh], 1).spheres;
/// let anchors = bind_spheres(&[&mesh], &[skin], &[Affine3A::IDENTITY], &spheres);
/// anchors.pose(&[Affine3A::from_translation(Vec3::X)], &mut spheres);
/// assert!((spheres[0].center[0] - 1.0).abs() < 1e-3);
/// # Ok::<(), sh_scene::motion::MotionError>(())
/// ```
///
/// # Panics
/// If there are fewer skins than meshes, or vertices in a skin than in its mesh, or a skin names a bone that is
/// missing.
pub fn bind_spheres(
    meshes: &[&Mesh],
    skins: &[Skin],
    bones: &[Affine3A],
    spheres: &[Sphere],
) -> Anchors {
    bind(meshes, skins, bones, spheres, MOST_BONES)
}

/// [`bind_spheres`] to so many bones at most.
fn bind(
    meshes: &[&Mesh],
    skins: &[Skin],
    bones: &[Affine3A],
    spheres: &[Sphere],
    most_bones: usize,
) -> Anchors {
    let (points, triangles) = crate::spheres::joined(meshes);
    let sources: Vec<(usize, usize)> = meshes
        .iter()
        .enumerate()
        .flat_map(|(m, mesh)| (0..mesh.positions.len()).map(move |v| (m, v)))
        .collect();
    let body = Body {
        size: crate::spheres::extent(&points, &triangles),
        points,
        triangles,
        sources,
        skins,
        bones,
        most_bones,
    };
    let anchors: Vec<Vec<Anchor>> = spheres.par_iter().map(|s| body.hold(s)).collect();
    Anchors::new(anchors)
}

/// All that binding looks at.
struct Body<'a> {
    points: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    /// Which skin and vertex each point is.
    sources: Vec<(usize, usize)>,
    size: f64,
    skins: &'a [Skin],
    bones: &'a [Affine3A],
    most_bones: usize,
}

/// A bone's part in a sphere: weight, and position in the bone's mesh space times weight.
#[derive(Clone, Copy, Default)]
struct Share {
    weight: f64,
    point: DVec3,
}

impl Body<'_> {
    fn hold(&self, sphere: &Sphere) -> Vec<Anchor> {
        let x = DVec3::from(sphere.center.map(f64::from));
        let usable = |weights: &Vec<f64>| {
            let size: f64 = weights.iter().map(|w| w.abs()).sum();
            let error = coordinates::error(&self.points, weights, x);
            size <= MOST_SIZE && error <= MOST_ERROR * self.size
        };
        let shares = coordinates::mean_value(&self.points, &self.triangles, x)
            .filter(usable)
            .map(|weights| self.shares(weights.iter().copied().enumerate()))
            .or_else(|| self.nearest(x));
        let Some(shares) = shares else {
            return Vec::new();
        };
        self.fewer(shares, x)
            .into_iter()
            .map(|(bone, share)| Anchor {
                bone,
                weight: share.weight as f32,
                point: share.point.as_vec3(),
            })
            .collect()
    }

    /// What weighted vertices have of each bone, bones with no share left out.
    fn shares(&self, weights: impl Iterator<Item = (usize, f64)>) -> Vec<(u32, Share)> {
        let mut shares = vec![Share::default(); self.bones.len()];
        for (point, weight) in weights.filter(|(_, weight)| *weight != 0.0) {
            let (skin, vertex) = self.sources[point];
            let skin = &self.skins[skin];
            let rest = DVec3::from(skin.position(vertex).map(f64::from));
            for (bone, part) in skin.influences(vertex).each() {
                let share = &mut shares[bone as usize];
                share.weight += weight * f64::from(part);
                share.point += rest * (weight * f64::from(part));
            }
        }
        let shares = (0..).zip(shares);
        shares.filter(|(_, s)| s.weight != 0.0).collect()
    }

    /// The shares of the surface point nearest to `x`, each holding `x` itself where its bone allows it.
    fn nearest(&self, x: DVec3) -> Option<Vec<(u32, Share)>> {
        let found = self.triangles.iter().map(|t| {
            let corners = t.map(|i| self.points[i as usize]);
            let weights = nearest_on(corners, x);
            let point: DVec3 = (0..3).map(|k| corners[k] * weights[k]).sum();
            (point.distance_squared(x), t, weights)
        });
        let (_, t, weights) = found.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let mut shares = self.shares((0..3).map(|k| (t[k] as usize, weights[k])));
        for (bone, share) in &mut shares {
            if let Some(local) = self.in_bone(*bone, x) {
                share.point = local * share.weight;
            }
        }
        Some(shares)
    }

    /// At most `most_bones` of the shares, which together hold `x` as all of them did.
    fn fewer(&self, mut shares: Vec<(u32, Share)>, x: DVec3) -> Vec<(u32, Share)> {
        if shares.len() > self.most_bones {
            let mut fewer = shares.clone();
            fewer.sort_by(|a, b| b.1.weight.abs().total_cmp(&a.1.weight.abs()));
            fewer.truncate(self.most_bones);
            fewer.sort_by_key(|(bone, _)| *bone);
            let kept: f64 = fewer.iter().map(|(_, share)| share.weight).sum();
            let invertible = fewer.iter().all(|(b, _)| self.in_bone(*b, x).is_some());
            if kept > 0.5 && invertible {
                shares = fewer;
                for (_, share) in &mut shares {
                    share.weight /= kept;
                    share.point /= kept;
                }
            }
        }
        // The rest of the way to `x`, which all bones go alike: what was left out, and rounding.
        let held = |(bone, share): &(u32, Share)| {
            let bone = self.bones[*bone as usize];
            let turn = bone.matrix3.as_dmat3();
            turn * share.point + bone.translation.as_dvec3() * share.weight
        };
        let miss = x - shares.iter().map(held).sum::<DVec3>();
        let corrections: Option<Vec<DVec3>> = shares
            .iter()
            .map(|(bone, _)| Some(self.in_bone(*bone, miss)? - self.in_bone(*bone, DVec3::ZERO)?))
            .collect();
        for ((_, share), correction) in shares.iter_mut().zip(corrections.unwrap_or_default()) {
            share.point += correction * share.weight;
        }
        shares
    }

    /// A point in a bone's mesh space; none where the bone flattens it.
    fn in_bone(&self, bone: u32, x: DVec3) -> Option<DVec3> {
        let bone = self.bones[bone as usize];
        let turn = bone.matrix3.as_dmat3();
        let longest = [turn.x_axis, turn.y_axis, turn.z_axis]
            .map(DVec3::length)
            .into_iter()
            .fold(0.0, f64::max);
        (turn.determinant().abs() > 1e-6 * longest.powi(3))
            .then(|| turn.inverse() * (x - bone.translation.as_dvec3()))
            .filter(|p| p.is_finite() && p.as_vec3().is_finite())
    }
}

/// Barycentric coordinates of the point of a triangle that is nearest to `x` (Ericson 2005, "Real-Time Collision
/// Detection", section 5.1.5).
fn nearest_on([a, b, c]: [DVec3; 3], x: DVec3) -> [f64; 3] {
    let (ab, ac, bc) = (b - a, c - a, c - b);
    let (d1, d2) = (ab.dot(x - a), ac.dot(x - a));
    if d1 <= 0.0 && d2 <= 0.0 {
        return [1.0, 0.0, 0.0];
    }
    let (d3, d4) = (ab.dot(x - b), ac.dot(x - b));
    if d3 >= 0.0 && d4 <= d3 {
        return [0.0, 1.0, 0.0];
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let t = d1 / ab.length_squared();
        return [1.0 - t, t, 0.0];
    }
    let (d5, d6) = (ab.dot(x - c), ac.dot(x - c));
    if d6 >= 0.0 && d5 <= d6 {
        return [0.0, 0.0, 1.0];
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let t = d2 / ac.length_squared();
        return [1.0 - t, 0.0, t];
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let t = (d4 - d3) / bc.length_squared();
        return [0.0, 1.0 - t, t];
    }
    let sum = va + vb + vc;
    [va / sum, vb / sum, vc / sum]
}
