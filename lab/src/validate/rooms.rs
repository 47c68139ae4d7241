//! Rooms whose bodies send light to and fro by their patches, against paths.

use super::Options;
use super::measure::{Sight, Traced};
use super::sheets;
use crate::rooms::{FUNCTIONS, bytes, plane, room, teapots, told};
use gaunt::Error;
use gaunt::compare::{Figures, scale};
use serde::Serialize;
use sh_reference::paths::Source;
use sh_scene::Scene;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// Errors of one way to light a room; parts of the mean indirect light where nothing else is said.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Which room.
    pub name: &'static str,
    /// Functions a body.
    pub functions: usize,
    /// SH order.
    pub order: usize,
    /// How often light is sent on.
    pub bounces: u32,
    /// RMS of direct light, in parts of the mean radiance.
    pub direct: f64,
    /// RMS and bias of indirect light.
    pub patches: [f64; 2],
    /// The noise of the truth, which RMS are without.
    pub noise: f64,
    /// RMS and bias of indirect light on what stands in the room, in parts of its mean there.
    pub pieces: [f64; 2],
    /// The share of indirect light.
    pub share: f64,
    /// Bytes of what is known of the bodies' light, of bodies that are alike once.
    pub bytes: usize,
}

/// A room and how it is looked at.
struct Room {
    name: &'static str,
    title: &'static str,
    make: fn() -> Scene,
    /// How many of its bodies are walls: the first.
    walls: u32,
}

/// All of them.
const ROOMS: [Room; 3] = [
    Room {
        name: "plane",
        title: "a pot above a plane",
        make: plane,
        walls: 1,
    },
    Room {
        name: "room",
        title: "a room of twelve bodies",
        make: room,
        walls: crate::rooms::WALLS as u32,
    },
    Room {
        name: "teapots",
        title: "thirty pots in a room",
        make: teapots,
        walls: crate::rooms::WALLS as u32,
    },
];

/// The names of all rooms.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    ROOMS.iter().map(|room| room.name)
}

/// Functions, order and bounces that the room of twelve bodies is lit with, besides those that it has.
const WAYS: [[u32; 3]; 12] = [
    [1, 4, 3],
    [2, 4, 3],
    [4, 4, 3],
    [8, 4, 3],
    [32, 4, 3],
    [64, 4, 3],
    [16, 3, 3],
    [16, 5, 3],
    [16, 6, 3],
    [16, 4, 1],
    [16, 4, 2],
    [16, 4, 8],
];

/// The row of a room as it is, and its sheet.
pub(super) fn rows(name: &str, traced: Traced, options: &Options) -> Result<Vec<Row>, Error> {
    let Some(room) = ROOMS.iter().find(|room| room.name == name) else {
        return Ok(Vec::new());
    };
    let scene = (room.make)();
    let sight = Sight::new(&scene, traced, Source::Projected)?;
    if let Some(folder) = &options.out {
        sheets::write(folder, (name, room.title), &scene, &sight, options)?;
    }
    Ok(vec![row(room, FUNCTIONS, &scene, &sight)?])
}

/// The room of twelve bodies, and the pot above a plane, in all ways.
pub(super) fn ways(traced: Traced) -> Result<Vec<Row>, Error> {
    let mut rows = in_ways(&ROOMS[0], &[[16, 4, 1], [64, 4, 3]], traced)?;
    rows.extend(in_ways(&ROOMS[1], &WAYS, traced)?);
    Ok(rows)
}

fn in_ways(room: &Room, ways: &[[u32; 3]], traced: Traced) -> Result<Vec<Row>, Error> {
    let mut scene = (room.make)();
    let mut rows = Vec::new();
    let mut sights = HashMap::new();
    let mut known = FUNCTIONS as u32;
    for [functions, order, bounces] in ways.iter().copied() {
        if functions != known {
            told(&mut scene.objects, functions as usize);
            known = functions;
        }
        scene.settings = scene.settings.with_order(order as usize);
        if let Some(indirect) = &mut scene.settings.indirect {
            indirect.bounces = bounces;
        }
        let sight = match sights.entry([order, bounces]) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(place) => place.insert(Sight::new(&scene, traced, Source::Projected)?),
        };
        rows.push(row(room, functions as usize, &scene, sight)?);
    }
    Ok(rows)
}

fn row(room: &Room, functions: usize, scene: &Scene, sight: &Sight) -> Result<Row, Error> {
    let ours = sight.ours(scene)?.parts;
    let errors = sight.errors(&ours);
    let only = |all: &[[f32; 3]]| -> Vec<[f32; 3]> {
        let pairs = sight.seen.receivers().iter().zip(all);
        let there = pairs.filter(|(r, _)| r.covered != 0 && r.object > room.walls);
        there.map(|(_, light)| *light).collect()
    };
    let truth = only(&sight.truth.parts.indirect);
    let noise = only(&sight.truth.errors.indirect);
    let pieces = Figures::new(&only(&ours.indirect), &truth, &noise, scale(&truth));
    Ok(Row {
        name: room.name,
        functions,
        order: scene.settings.order,
        bounces: scene.settings.indirect.map_or(0, |i| i.bounces),
        direct: errors.direct.rms,
        patches: errors.relative,
        noise: errors.indirect.noise / errors.share,
        pieces: [pieces.rms, pieces.bias],
        share: errors.share,
        bytes: bytes(&scene.objects),
    })
}
