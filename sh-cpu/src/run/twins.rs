//! The passes of the table on the CPU: how each takes what it needs from the store.

use super::work::Stages;
use crate::error::Error;
use crate::passes::basis_update::{basis_update, dark};
use crate::passes::gbuffer::gbuffer;
use crate::passes::invalid::invalid;
use crate::passes::irradiance::{irradiance, mirrored};
use crate::passes::light_view::light_view;
use crate::passes::points::{place, place_patches};
use crate::passes::punctual::punctual;
use crate::passes::resolve::{SampleLight, resolve};
use crate::passes::scatter::scatter;
use crate::passes::shares::shares;
use crate::passes::upsample::upsample;
use crate::store::{Camera, Store};
use sh_scene::passes::{
    BASIS_GATHER, BASIS_UPDATE, GBUFFER, INVALID, INVALID_SAMPLES, IRRADIANCE, LIGHT_GATHER,
    LIGHT_UPDATE, LIGHT_VIEW, POINTS, PUNCTUAL, RESOLVE, SCATTER, SHADOW, SHARES, UPSAMPLE,
};
use sh_scene::plan::Facts;
use sh_scene::{BasisBody, Body, Domain, Pass, Tiles, View};

/// A pass of the table on the CPU.
pub(super) struct Twin {
    pub pass: &'static Pass,
    /// Does a part of it; how many tasks that were.
    pub run: fn(&mut Store, Domain, u32, &mut Stages) -> Result<u64, Error>,
    /// Name and bytes of what it keeps and writes.
    pub memory: fn(&mut Store, Domain) -> Vec<(&'static str, usize)>,
}

/// All of them.
static TWINS: [Twin; 15] = [
    Twin {
        pass: &LIGHT_VIEW,
        run: |store, _, _, stages| {
            let geometry = store.geometry.as_ref().ok_or(Error::NoCamera)?;
            stages.time("light_view", || light_view(geometry, store.views));
            Ok(store.views.seen.views.len() as u64)
        },
        memory: |store, _| vec![("what lights see", store.views.bytes())],
    },
    Twin {
        pass: &PUNCTUAL,
        run: |store, at, _, stages| {
            let mut set = store.sets.of(at);
            stages.time("punctual", || {
                punctual(set.receivers, store.views, set.eye, set.room())
            })?;
            Ok(set.clusters.len() as u64)
        },
        memory: |_, _| Vec::new(),
    },
    Twin {
        pass: &POINTS,
        run: |store, at, _, stages| {
            let objects = &store.scene.objects;
            let (sets, spheres) = (&mut store.sets, &mut store.spheres);
            stages.time("points", || match at {
                Domain::Patches => {
                    place_patches(BasisBody::all(objects), &mut sets.patches);
                    dark(BasisBody::all(objects), spheres.patch_lights);
                    spheres.point_cuts.forget();
                }
                _ => place(objects.iter().map(Body::from), &mut sets.points),
            });
            Ok(sets.of(at).clusters.len() as u64)
        },
        memory: |store, at| {
            let (name, points) = match at {
                Domain::Patches => ("points of patches", &store.sets.patches),
                _ => ("points of surfaces", &store.sets.points),
            };
            vec![(name, bytes(&points.receivers) + bytes(&points.sent))]
        },
    },
    Twin {
        pass: &BASIS_UPDATE,
        run: |store, _, _, stages| {
            let bodies = BasisBody::all(&store.scene.objects);
            let count = bodies.clone().count() as u64;
            let (spheres, points) = (&mut store.spheres, &store.sets.patches);
            let order = spheres.light.order;
            stages.time("basis_update", || {
                basis_update(points, bodies, order, spheres.patch_lights)
            })?;
            Ok(count)
        },
        memory: |store, _| {
            let bodies = BasisBody::all(&store.scene.objects);
            let bases = bodies.map(|body| body.basis.bytes()).sum();
            vec![
                ("functions of bodies", bases),
                ("what patches send on", store.spheres.patch_lights.bytes()),
            ]
        },
    },
    Twin {
        pass: &LIGHT_UPDATE,
        run: |store, _, _, stages| {
            let bodies = store.scene.objects.iter().map(Body::from);
            let (spheres, points) = (&mut store.spheres, &store.sets.points);
            stages.time("light_update", || spheres.update(points, bodies))?;
            Ok(spheres.forest.spheres() as u64)
        },
        memory: |store, _| vec![("what spheres send on", store.spheres.lights.bytes())],
    },
    Twin {
        pass: &GBUFFER,
        run: see,
        memory: |store, at| {
            let triangles = store.geometry.as_ref().map(|g| g.hierarchy().bytes());
            let sets = &store.sets;
            match at {
                Domain::Halves => vec![(
                    "receivers at half resolution",
                    bytes(&sets.halves.receivers),
                )],
                _ => vec![
                    ("triangles", triangles.unwrap_or(0)),
                    ("receivers of a band", bytes(&sets.samples.receivers)),
                    ("albedo of a band", bytes(&sets.samples.albedo)),
                ],
            }
        },
    },
    Twin {
        pass: &IRRADIANCE,
        run: |store, at, _, stages| {
            let (light, mut set) = (store.spheres.light, store.sets.of(at));
            stages.time("irradiance", || match set.eye {
                Some(eye) => mirrored(set.receivers, light, eye, set.room()),
                None => irradiance(set.receivers, light, set.room()),
            })?;
            Ok(set.clusters.len() as u64)
        },
        memory: |store, at| vec![radiance(store, at)],
    },
    Twin {
        pass: &SHADOW,
        run: |store, at, _, stages| {
            let mut set = store.sets.of(at);
            store.spheres.shade(&mut set, stages)?;
            Ok(set.clusters.len() as u64)
        },
        memory: |store, at| {
            let mut all = vec![radiance(store, at)];
            // What all of them share, once.
            let shares = match at {
                Domain::Rest | Domain::Gloss => false,
                Domain::Points | Domain::Patches => !store.scene.settings.shadows,
                _ => true,
            };
            if shares {
                let nodes = size_of_val(store.spheres.forest.nodes());
                all.push(("tree of blockers", nodes));
                all.push(("cuts", store.spheres.cuts.bytes()));
            }
            all
        },
    },
    Twin {
        pass: &LIGHT_GATHER,
        run: |store, at, _, stages| {
            let set = store.sets.gathering(at);
            let gathered = store.spheres.gather(&set, stages)?;
            match set.sent {
                Some(sent) => *sent = gathered,
                None => add(set.radiance, &gathered),
            }
            Ok(set.clusters.len() as u64)
        },
        memory: |store, at| {
            let count = store.sets.of(at).radiance.capacity();
            let name = match at {
                Domain::Halves => "light sent, at half resolution",
                Domain::Rest => "light sent to the rest of a band",
                Domain::Points | Domain::Patches | Domain::Gloss => return Vec::new(),
                _ => "light sent to a band",
            };
            vec![(name, count * size_of::<[f32; 3]>())]
        },
    },
    Twin {
        pass: &BASIS_GATHER,
        run: |store, at, _, stages| {
            let set = store.sets.gathering(at);
            let bodies = BasisBody::all(&store.scene.objects);
            let gathered = store.spheres.gather_patches((&set, at), bodies, stages)?;
            // What spheres have sent comes first.
            let first = Facts::of(store.scene, at == Domain::Receivers)
                .senders
                .is_err();
            match set.sent {
                Some(sent) if first => *sent = gathered,
                Some(sent) => add(sent, &gathered),
                None => add(set.radiance, &gathered),
            }
            Ok(set.clusters.len() as u64)
        },
        memory: |store, at| {
            let count = store.sets.of(at).radiance.capacity();
            let name = match at {
                Domain::Halves => "light of patches, at half resolution",
                Domain::Rest => "light of patches for the rest of a band",
                Domain::Patches => {
                    let cuts = store.spheres.point_cuts.bytes();
                    return vec![("cuts of patches, for points of patches", cuts)];
                }
                Domain::Points => return Vec::new(),
                _ => "light of patches for a band",
            };
            let cuts = store.spheres.patch_cuts.bytes();
            vec![
                (name, count * size_of::<[f32; 3]>()),
                ("cuts of patches", cuts),
            ]
        },
    },
    Twin {
        pass: &SHARES,
        run: |store, at, _, stages| {
            let (light, mut set) = (store.spheres.light, store.sets.of(at));
            stages.time("shares", || {
                let mut open = vec![[0.0; 3]; set.receivers.len()];
                irradiance(set.receivers, light, &mut open)?;
                shares(set.room(), &open)
            })?;
            Ok(set.clusters.len() as u64)
        },
        memory: |store, at| {
            let count = store.sets.of(at).receivers.len();
            vec![(
                "unblocked light at half resolution",
                count * size_of::<[f32; 3]>(),
            )]
        },
    },
    Twin {
        pass: &UPSAMPLE,
        run: |store, at, band, stages| {
            let camera = camera(&mut store.camera)?;
            let (view, rows) = (camera.view, camera.rows(band));
            let sets = &mut store.sets;
            let tasks = sets.of(at).clusters.len() as u64;
            stages.time("upsample", || {
                let mut set = sets.of(at);
                irradiance(set.receivers, store.spheres.light, set.room())?;
                let (samples, radiance) = (&sets.samples, &mut sets.radiance);
                upsample(&view, &sets.halves, rows, samples, radiance, &mut sets.rest)
            })?;
            Ok(tasks)
        },
        memory: |store, at| {
            let rest = room(&store.sets.rest.receivers);
            vec![
                radiance(store, at),
                ("receivers of the rest of a band", rest),
            ]
        },
    },
    Twin {
        pass: &SCATTER,
        run: |store, _, _, stages| {
            let sets = &mut store.sets;
            stages.time("scatter", || {
                scatter(&sets.rest.indices, &sets.rest_radiance, &mut sets.radiance);
            });
            Ok(sets.rest.clusters.len() as u64)
        },
        memory: |store, _| {
            let samples = room(&store.sets.rest.indices);
            vec![("samples of the rest of a band", samples)]
        },
    },
    Twin {
        pass: &INVALID,
        run: |store, _, band, stages| {
            let camera = camera(&mut store.camera)?;
            let (view, rows) = (camera.view, camera.rows(band));
            let tasks = u64::from(rows.len() as u32 * Tiles::SIDE / View::OVERSAMPLE);
            let (sets, counts) = (&store.sets, camera.given(INVALID_SAMPLES, band));
            stages.time("invalid", || {
                invalid(&view, rows, &sets.samples, &sets.radiance, counts)
            })?;
            Ok(tasks)
        },
        memory: |store, _| {
            let pixels = store.camera.as_ref().map_or(0, |c| c.pixels.len());
            vec![("invalid samples", pixels * size_of::<[u32; 4]>())]
        },
    },
    Twin {
        pass: &RESOLVE,
        run: |store, _, band, stages| {
            let camera = camera(&mut store.camera)?;
            let (view, rows) = (camera.view, camera.rows(band));
            let tasks = u64::from(rows.len() as u32 * Tiles::SIDE / View::OVERSAMPLE);
            let (sets, environment) = (&store.sets, &store.scene.environment);
            let lit = SampleLight {
                radiance: &sets.radiance,
                mirrored: store.scene.mirrors().then_some(&sets.gloss_radiance[..]),
            };
            let pixels = camera.pixels(band);
            stages.time("resolve", || {
                resolve(&view, rows, &sets.samples, lit, environment, pixels)
            })?;
            Ok(tasks)
        },
        memory: |store, _| {
            let pixels = store.camera.as_ref().map(|c| bytes(&c.pixels));
            vec![("picture", pixels.unwrap_or(0))]
        },
    },
];

/// The twin of a pass.
///
/// # Errors
/// Where there is none.
pub(super) fn twin(pass: &Pass) -> Result<&'static Twin, Error> {
    let found = TWINS.iter().find(|twin| twin.pass == pass);
    found.ok_or(Error::NoTwin { pass: pass.name })
}

fn see(store: &mut Store, at: Domain, band: u32, stages: &mut Stages) -> Result<u64, Error> {
    let camera = camera(&mut store.camera)?;
    let geometry = store.geometry.as_ref().ok_or(Error::NoCamera)?;
    let (view, sets) = (camera.view, &mut store.sets);
    if at == Domain::Halves {
        // All of them at once: whatever lies underneath a band of samples is there.
        let (grid, tiles) = (view.halves(), view.halves().tiles());
        stages.time("gbuffer", || {
            gbuffer(geometry, &view, grid, 0..tiles.rows, &mut sets.samples)
        })?;
        sets.halves.receivers = std::mem::take(&mut sets.samples.receivers);
        sets.half_clusters = tiles.clusters();
        return Ok(sets.half_clusters.len() as u64);
    }
    let (grid, rows) = (view.samples(), camera.rows(band));
    stages.time("gbuffer", || {
        gbuffer(geometry, &view, grid, rows, &mut sets.samples)
    })?;
    sets.sample_clusters = camera.tiles(band).clusters();
    if store.scene.mirrors() {
        sets.polish(view.camera.eye.into());
    }
    Ok(sets.sample_clusters.len() as u64)
}

/// The camera, for a pass that needs one.
fn camera(camera: &mut Option<Camera>) -> Result<&mut Camera, Error> {
    camera.as_mut().ok_or(Error::NoCamera)
}

fn radiance(store: &mut Store, at: Domain) -> (&'static str, usize) {
    let name = match at {
        Domain::Halves => "radiance at half resolution",
        Domain::Rest => "radiance of the rest of a band",
        Domain::Gloss => "mirrored light of a band",
        Domain::Points => "light on points of surfaces",
        Domain::Patches => "light on points of patches",
        _ => "radiance of a band",
    };
    (name, room(store.sets.of(at).radiance))
}

/// Adds what was sent.
fn add(radiance: &mut [[f32; 3]], sent: &[[f32; 3]]) {
    for (radiance, sent) in radiance.iter_mut().zip(sent) {
        for (radiance, sent) in radiance.iter_mut().zip(sent) {
            *radiance += sent;
        }
    }
}

/// Bytes of a list whose length changes from band to band.
fn room<T>(all: &Vec<T>) -> usize {
    all.capacity() * size_of::<T>()
}

fn bytes<T>(all: &[T]) -> usize {
    size_of_val(all)
}
