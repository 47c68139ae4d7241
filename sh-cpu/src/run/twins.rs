//! The passes of the table on the CPU: how each takes what it needs from the store.

use super::work::Stages;
use crate::error::Error;
use crate::passes::gbuffer::gbuffer;
use crate::passes::invalid::invalid;
use crate::passes::irradiance::irradiance;
use crate::passes::points::place;
use crate::passes::resolve::resolve;
use crate::passes::scatter::scatter;
use crate::passes::shares::shares;
use crate::passes::upsample::upsample;
use crate::store::{Camera, Store};
use sh_scene::passes::{
    GBUFFER, INVALID, INVALID_SAMPLES, IRRADIANCE, LIGHT_GATHER, LIGHT_UPDATE, POINTS, RESOLVE,
    SCATTER, SHADOW, SHARES, UPSAMPLE,
};
use sh_scene::{Body, Domain, Pass, Tiles, View};

/// A pass of the table on the CPU.
pub(super) struct Twin {
    pub pass: &'static Pass,
    /// Does a part of it; how many tasks that were.
    pub run: fn(&mut Store, Domain, u32, &mut Stages) -> Result<u64, Error>,
    /// Name and bytes of what it keeps and writes.
    pub memory: fn(&mut Store, Domain) -> Vec<(&'static str, usize)>,
}

/// All of them.
static TWINS: [Twin; 11] = [
    Twin {
        pass: &POINTS,
        run: |store, _, _, stages| {
            let bodies = store.scene.objects.iter().map(Body::from);
            let points = &mut store.sets.points;
            stages.time("points", || place(bodies, points));
            Ok(points.clusters.len() as u64)
        },
        memory: |store, _| {
            let points = &store.sets.points;
            let bytes = bytes(&points.receivers) + bytes(&points.sent);
            vec![("points of surfaces", bytes)]
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
            let triangles = store
                .camera
                .as_ref()
                .map(|c| c.geometry.hierarchy().bytes());
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
            stages.time("irradiance", || {
                irradiance(set.receivers, light, set.room())
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
                Domain::Rest => false,
                Domain::Points => !store.scene.settings.shadows,
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
            let set = store.sets.of(at);
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
                Domain::Points => return Vec::new(),
                _ => "light sent to a band",
            };
            vec![(name, count * size_of::<[f32; 3]>())]
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
            let pixels = camera.pixels(band);
            stages.time("resolve", || {
                resolve(
                    &view,
                    rows,
                    &sets.samples,
                    &sets.radiance,
                    environment,
                    pixels,
                )
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
    let (view, sets) = (camera.view, &mut store.sets);
    if at == Domain::Halves {
        // All of them at once: whatever lies underneath a band of samples is there.
        let (grid, tiles) = (view.halves(), view.halves().tiles());
        stages.time("gbuffer", || {
            gbuffer(
                &camera.geometry,
                &view,
                grid,
                0..tiles.rows,
                &mut sets.samples,
            )
        })?;
        sets.halves.receivers = std::mem::take(&mut sets.samples.receivers);
        sets.half_clusters = tiles.clusters();
        return Ok(sets.half_clusters.len() as u64);
    }
    let (grid, rows) = (view.samples(), camera.rows(band));
    stages.time("gbuffer", || {
        gbuffer(&camera.geometry, &view, grid, rows, &mut sets.samples)
    })?;
    sets.sample_clusters = camera.tiles(band).clusters();
    Ok(sets.sample_clusters.len() as u64)
}

/// The camera, for a pass that needs one.
fn camera<'s, 'a>(camera: &'s mut Option<Camera<'a>>) -> Result<&'s mut Camera<'a>, Error> {
    camera.as_mut().ok_or(Error::NoCamera)
}

fn radiance(store: &mut Store, at: Domain) -> (&'static str, usize) {
    let name = match at {
        Domain::Halves => "radiance at half resolution",
        Domain::Rest => "radiance of the rest of a band",
        Domain::Points => "light on points of surfaces",
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
