//! Surface samples: what makes a body's spheres lights (Guerrero et al. 2008, section 4.2).
//!
//! Each sphere stands for a part of the surface ([`rules`]), and is looked at from 92 directions
//! ([`sh_scene::surface`]). In each there is at most one point. Rays go through 4096 directions that each have the same
//! share of the sphere, 36 to 48 in each direction's Voronoi cell, and one through the direction itself:
//!
//! - the point is what is seen in the direction itself, or else in the nearest of the cell's in which anything is;
//! - its albedo is the mean over the cell's rays, but for those on which only other spheres have surface; `share` says how
//!   many are left. Rays that meet nothing at all, outside of the body, count as black.
//!
//! A cell outside of the body has a black point, so that its neighbours do not stand for it
//! ([`SurfaceSamples::stands`]).
//!
//! The paper has the albedo as an SH vector instead, and multiplies it with the light's (eq. 11): what either has beyond
//! the order is lost before the product. Here a cell's light is multiplied with its albedo, and only their sum is cut
//! off. With a checkered texture, in light from one side, the emission of order 4 misses that of 65536 rays lit each for
//! itself (root mean square over the sphere and four lights, relative to it)
//!
//! | body | mean albedo in each cell | product of vectors |
//! |---|---|---|
//! | ball, one sphere | 1.9 % | 4.5 % |
//! | capsule, two spheres | 3.5 % | 9.0 % |
//!
//! as the test in `emission.rs` measures.

mod paint;
mod part;
mod rules;
mod shell;

pub(crate) use paint::{albedo, normal};
pub(crate) use part::Part;
pub(crate) use shell::Crossing;

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use rules::{Body, Seen};
use sh_scene::surface::{DIRECTIONS, cell_of, directions, stratified};
use sh_scene::{Material, Mesh, Sphere, SurfacePoint, SurfaceSamples};
use std::sync::LazyLock;

/// Changes whenever the same body may get other samples than before: those that were kept are then of no use.
pub(crate) const SURFACE_VERSION: u32 = 2;

/// Samples the surface of a body, given as parts that share one space, for the spheres that bound it. Samples have an
/// entry for each sphere, without points where nothing is seen of it. The same input gives the same samples, whatever
/// the number of threads. Takes about 4 ms a sphere and thread.
///
/// Albedo is base colour times texture times vertex colour, and is kept within 0 and 1.
///
/// ```
/// use sh_bake::{bake_surface, shapes};
/// use sh_scene::{Material, Sphere};
/// let (mesh, grey) = (shapes::ball(1.0, 3), Material::diffuse([0.5; 3]));
/// let samples = bake_surface(&[(&mesh, &grey)], &[Sphere { center: [0.0; 3], radius: 1.0 }]);
/// assert_eq!(samples.points.len(), 92);
/// assert!(samples.points.iter().all(|p| (p.albedo[0] - 0.5).abs() < 1e-6));
/// ```
///
/// # Panics
/// If a triangle names a vertex that is not there.
pub fn bake_surface(parts: &[(&Mesh, &Material)], spheres: &[Sphere]) -> SurfaceSamples {
    bake_with(parts, spheres, &|| {})
}

/// [`bake_surface`], telling `progress` of each sphere that is done: from several threads.
pub(crate) fn bake_with(
    parts: &[Part],
    spheres: &[Sphere],
    progress: &(dyn Fn() + Sync),
) -> SurfaceSamples {
    let body = Body::new(parts, spheres);
    let points = |sphere: usize| {
        let points = points(&body, parts, sphere);
        progress();
        points
    };
    let points: Vec<Vec<SurfacePoint>> = (0..spheres.len()).into_par_iter().map(points).collect();
    let mut samples = SurfaceSamples::default();
    for points in points {
        samples.push(points);
    }
    samples.expose(spheres);
    samples
}

/// What is known of a direction's cell.
#[derive(Clone, Copy, Default)]
struct Cell {
    rays: u32,
    /// Those that see something, and those that meet nothing at all.
    seeing: u32,
    open: u32,
    /// The sum over all.
    albedo: Vec3,
    /// What is seen nearest to the direction, along which, and the cosine between.
    nearest: Option<(f64, DVec3, Crossing)>,
}

/// The points of a sphere.
fn points(body: &Body, parts: &[Part], sphere: usize) -> Vec<SurfacePoint> {
    let Some(mut seat) = body.seat(sphere) else {
        return Vec::new();
    };
    let mut cells = [Cell::default(); DIRECTIONS];
    for (ray, j) in rays() {
        let cell = &mut cells[*j];
        cell.rays += 1;
        match seat.seen(*ray) {
            Seen::Surface(crossing) => {
                cell.seeing += 1;
                cell.albedo += paint::albedo(&parts[crossing.part as usize], &crossing);
                let cosine = ray.dot(axis(*j));
                if cell.nearest.is_none_or(|(before, ..)| cosine > before) {
                    cell.nearest = Some((cosine, *ray, crossing));
                }
            }
            Seen::Others => {}
            Seen::Nothing => cell.open += 1,
        }
    }
    let mut points = Vec::new();
    let mut dark = true;
    for (j, cell) in cells.iter().enumerate() {
        let straight = match seat.seen(axis(j)) {
            Seen::Surface(crossing) => Some((axis(j), crossing)),
            Seen::Others | Seen::Nothing => None,
        };
        let nearest = cell.nearest.map(|(_, ray, crossing)| (ray, crossing));
        let (place, normal) = match straight.or(nearest) {
            Some((ray, crossing)) => {
                dark = false;
                let normal = paint::normal(&parts[crossing.part as usize], &crossing, ray);
                let normal = normal.as_vec3().normalize_or(ray.as_vec3());
                (seat.place(ray, crossing.distance), normal)
            }
            None if 2 * cell.open > cell.rays => {
                (seat.place(axis(j), seat.radius()), axis(j).as_vec3())
            }
            None => continue,
        };
        let own = cell.seeing + cell.open;
        points.push(SurfacePoint {
            position: place.as_vec3().to_array(),
            direction: j as u32,
            normal: normal.to_array(),
            share: own as f32 / cell.rays.max(1) as f32,
            albedo: (cell.albedo / own.max(1) as f32).to_array(),
            ..Default::default()
        });
    }
    if dark {
        // It would take time to light what reflects nothing.
        points.clear();
    }
    points
}

/// One of the directions.
fn axis(j: usize) -> DVec3 {
    DVec3::from(directions()[j].map(f64::from)).normalize()
}

/// The directions of all rays, each with the cell it is in.
fn rays() -> &'static [(DVec3, usize)] {
    static ALL: LazyLock<Vec<(DVec3, usize)>> = LazyLock::new(|| {
        let all = stratified(32, 64).map(|d| (d.as_dvec3().normalize(), cell_of(d)));
        all.collect()
    });
    &ALL
}

#[cfg(test)]
mod emission;
#[cfg(test)]
mod tests;
