//! Meshes as files give them, whatever the format, and the checks that all of them go through.

use crate::error::{Error, shown};
use crate::model::{Figure, Part};
use crate::normals;
use glam::{Affine3A, DVec3, Vec3, Vec3A};
use sh_scene::motion::{Bone, Clip, Influences, Joint, MotionError, Pose, Skeleton, Skin};
use sh_scene::{Material, Mesh};
use std::path::Path;

/// The albedo of a mesh that has none: a light grey.
pub(crate) const WHITE: [f32; 3] = [0.8; 3];

/// Coordinates beyond this are taken as damage: squares and volumes of them would leave `f32`.
const FARTHEST: f32 = 1e9;

/// What a part's vertices were before anything moved them, and what carries them.
pub(crate) struct Bind {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) influences: Vec<Influences>,
}

/// What moves a model, as a file gives it.
pub(crate) struct RawFigure {
    pub(crate) joints: Vec<Joint>,
    pub(crate) bones: Vec<Bone>,
    pub(crate) clips: Vec<Clip>,
}

impl RawFigure {
    /// The figure with a skin for each part.
    pub(crate) fn finish(self, parts: &[Part], binds: Vec<Bind>) -> Result<Figure, MotionError> {
        let skeleton = Skeleton::new(self.joints)?;
        let mut still = Pose::default();
        still.set(&skeleton, &self.bones, None);
        let skin = |(part, bind): (&Part, Bind)| {
            let normals = part.mesh.normals.iter().zip(&bind.influences);
            let normals: Vec<_> = normals
                .map(|(normal, influences)| at_rest(*normal, influences, still.bones()))
                .collect();
            Skin::new(&bind.positions, &normals, bind.influences)
        };
        let skins = parts.iter().zip(binds).map(skin);
        Ok(Figure {
            skins: skins.collect::<Result<_, _>>()?,
            skeleton,
            bones: self.bones,
            clips: self.clips,
        })
    }
}

/// The normal that bones make into `normal`: they turn by the inverse of their transpose, so the transpose turns
/// back.
fn at_rest(normal: [f32; 3], influences: &Influences, bones: &[Affine3A]) -> [f32; 3] {
    let n = Vec3A::from(normal);
    let back = |(bone, weight): (u32, f32)| {
        let turn = bones.get(bone as usize).map(|b| b.matrix3.transpose());
        turn.unwrap_or_default() * n * weight
    };
    let sum: Vec3A = influences.each().map(back).sum();
    sum.normalize_or(n).to_array()
}

/// A part as a file gives it, not yet checked.
pub(crate) struct RawPart {
    pub(crate) name: String,
    pub(crate) positions: Vec<[f32; 3]>,
    /// As many as positions, or none.
    pub(crate) normals: Vec<[f32; 3]>,
    /// As many as positions, or none.
    pub(crate) uvs: Vec<[f32; 2]>,
    /// As many as positions, or none.
    pub(crate) colors: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) material: Material,
    /// Where the part can move.
    pub(crate) bind: Option<Bind>,
}

impl RawPart {
    /// The part with everything checked and made whole; none where it has no triangle with an area.
    pub(crate) fn finish(
        mut self,
        path: &Path,
        warnings: &mut Vec<String>,
    ) -> Result<Option<(Part, Option<Bind>)>, Error> {
        let what = if self.name.is_empty() {
            String::new()
        } else {
            format!("{}: ", self.name)
        };
        for t in &self.triangles {
            for &i in t {
                let Some(p) = self.positions.get(i as usize) else {
                    let count = self.positions.len();
                    let message = format!("{what}vertex index {i} is out of range 0..{count}.");
                    return Err(Error::file(path, message));
                };
                if let Some(c) = p.iter().find(|c| !c.is_finite() || c.abs() > FARTHEST) {
                    let message = format!(
                        "{what}the position of vertex {i} has a coordinate {c}, and coordinates have to be \
                         finite and within ±{FARTHEST:e}.",
                    );
                    return Err(Error::file(path, message));
                }
            }
        }
        let before = self.triangles.len();
        self.triangles = with_area(&self.positions, &self.triangles);
        let dropped = before - self.triangles.len();
        if dropped > 0 {
            let display = shown(path);
            warnings.push(format!(
                "{display}: {what}{dropped} of {before} triangles have no area and were left out."
            ));
        }
        if self.triangles.is_empty() {
            return Ok(None);
        }

        let good = |n: &[f32; 3]| (0.25..4.0).contains(&Vec3::from(*n).length_squared());
        let given = self.normals.len() == self.positions.len();
        if given
            && self
                .triangles
                .iter()
                .flatten()
                .all(|&i| good(&self.normals[i as usize]))
        {
            for n in &mut self.normals {
                *n = Vec3::from(*n).normalize_or(Vec3::Y).to_array();
            }
        } else {
            if given {
                let display = shown(path);
                warnings.push(format!(
                    "{display}: {what}some normals are no unit vectors; all were computed anew."
                ));
            }
            let smoothed = normals::smooth(&self.positions, &self.triangles);
            let taken = |i: &u32| *i as usize;
            self.positions = smoothed
                .source
                .iter()
                .map(|i| self.positions[taken(i)])
                .collect();
            if let Some(bind) = &mut self.bind {
                let source = || smoothed.source.iter();
                bind.positions = source().map(|i| bind.positions[taken(i)]).collect();
                bind.influences = source().map(|i| bind.influences[taken(i)]).collect();
            }
            if !self.uvs.is_empty() {
                self.uvs = smoothed.source.iter().map(|i| self.uvs[taken(i)]).collect();
            }
            if !self.colors.is_empty() {
                let source = smoothed.source.iter();
                self.colors = source.map(|i| self.colors[taken(i)]).collect();
            }
            (self.normals, self.triangles) = (smoothed.normals, smoothed.triangles);
        }
        let mesh = Mesh {
            positions: self.positions,
            normals: self.normals,
            uvs: self.uvs,
            colors: self.colors,
            triangles: self.triangles,
        };
        let part = Part {
            name: self.name,
            mesh,
            material: self.material,
        };
        Ok(Some((part, self.bind)))
    }
}

/// The triangles that have an area: their height over the longest edge is more than a billionth of it.
pub(crate) fn with_area(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let has_area = |t: &&[u32; 3]| {
        let [a, b, c] = t.map(|i| DVec3::from(positions[i as usize].map(f64::from)));
        let longest = a
            .distance_squared(b)
            .max(b.distance_squared(c))
            .max(c.distance_squared(a));
        (b - a).cross(c - a).length() > 1e-9 * longest
    };
    triangles.iter().filter(has_area).copied().collect()
}
