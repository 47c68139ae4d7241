//! Pictures that are laid over the picture: clusters in colours, heat maps with a legend.

use super::wish::{Layer, Legend, Overlay, Wish};
use crate::Error;
use crate::compare::Seen;
use egui::{Color32, ColorImage};
use sh_cpu::{CutOptions, Cuts, Path};
use sh_scene::passes::{INVALID_SAMPLES, InvalidSamples};
use sh_scene::resource::Given;
use sh_scene::{Domain, Light, Plan, Scene, Tiles};
use std::sync::Arc;

/// How much of the picture is left to be seen through a layer of colours.
const VEIL: f32 = 0.45;

/// From dark to bright: five points of viridis (Smith and van der Walt 2015, CC0).
const HEAT: [[f32; 3]; 5] = [
    [68.0, 1.0, 84.0],
    [59.0, 82.0, 139.0],
    [33.0, 145.0, 140.0],
    [94.0, 201.0, 98.0],
    [253.0, 231.0, 37.0],
];

/// The colour of a share, 0 to 1, of a heat map's range.
pub(super) fn heat(share: f32) -> Color32 {
    // What is no number is not above 0.
    let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
    let at = share * (HEAT.len() - 1) as f32;
    let below = (at as usize).min(HEAT.len() - 2);
    let part = at - below as f32;
    let [r, g, b] = [0, 1, 2].map(|c| {
        let (from, to) = (HEAT[below][c], HEAT[below + 1][c]);
        (from + (to - from) * part).round() as u8
    });
    Color32::from_rgb(r, g, b)
}

/// The colour of the nth thing of many: neighbours differ, and nothing is too dark or too pale.
pub(super) fn distinct(n: usize) -> Color32 {
    let golden = 0.618_034 * n as f32;
    egui::ecolor::Hsva::new(golden.fract(), 0.62, 0.92, 1.0).into()
}

/// The layer of an overlay, if it is one and is there with the picture; `given` is what the plan gives besides.
pub(super) fn of(
    scene: &Scene,
    plan: &Plan,
    wish: &Wish,
    given: &Given,
) -> Result<Option<Layer>, Error> {
    Ok(match wish.overlay {
        Overlay::Clusters | Overlay::Cut => Some(of_clusters(scene, plan, wish)?),
        Overlay::Invalid => of_invalid(given, wish),
        Overlay::None | Overlay::Spheres | Overlay::Error => None,
    })
}

/// Pixels with an invalid sample, and what is wrong with them.
fn of_invalid(given: &Given, wish: &Wish) -> Option<Layer> {
    let [width, height] = wish.size;
    let found = InvalidSamples::of(given, width)?;
    let counts = given.get(&INVALID_SAMPLES)?;
    // One pixel is hard to see: the four by four that it is among are coloured.
    const BLOCK: u32 = 4;
    let mut colors = vec![None; width.div_ceil(BLOCK) as usize * height.div_ceil(BLOCK) as usize];
    let place = |x: u32, y: u32| (y / BLOCK * width.div_ceil(BLOCK) + x / BLOCK) as usize;
    for ([x, y], count) in (0..height)
        .flat_map(|y| (0..width).map(move |x| [x, y]))
        .zip(counts)
    {
        let worst = count[..3].iter().position(|&count| count > 0);
        let color: &mut Option<usize> = &mut colors[place(x, y)];
        *color = worst.map_or(*color, |worst| Some(color.map_or(worst, |c| c.min(worst))));
    }
    let shown = [Color32::RED, Color32::YELLOW, Color32::BLUE];
    let image = veil(width, height, |x, y| {
        colors[place(x, y)].map(|worst| shown[worst])
    });
    Some(Layer {
        image: Arc::new(image),
        legend: Legend {
            title: "Invalid samples".into(),
            ends: None,
            notes: match found.pixels {
                0 => vec![found.to_string()],
                _ => vec![
                    found.to_string(),
                    "Red: no number. Yellow: infinite. Blue: negative.".into(),
                ],
            },
        },
    })
}

/// Clusters or the sizes of their cuts.
fn of_clusters(scene: &Scene, plan: &Plan, wish: &Wish) -> Result<Layer, Error> {
    let cut = wish.overlay == Overlay::Cut;
    let title = if cut {
        "Spheres a cluster looks at"
    } else {
        "Clusters of receivers"
    };
    if !plan.is_blocked() {
        let notes = vec!["Nothing looks at blockers: no receiver needs a cluster.".into()];
        return Ok(Layer {
            image: Arc::new(ColorImage::filled([1, 1], Color32::TRANSPARENT)),
            legend: Legend {
                title: title.into(),
                ends: None,
                notes,
            },
        });
    }
    // The grid of rays that the shadow pass shades: every two by two pixels, or every sample of them.
    let half = plan.runs_over(Domain::Halves);
    let [width, height] = wish.size.map(|side| side.div_ceil(2).max(1));
    let step = if half { 1 } else { 4 };
    let seen = Seen::new(scene, [step * width, step * height])?;
    let (tiles, receivers) = (seen.tiles(), seen.receivers());
    let clusters = tiles.clusters();
    let mut cuts = Cuts::default();
    cuts.bound(receivers, &clusters, 0..clusters.len());
    let options = CutOptions {
        limits: scene.settings.limits,
        ratios: true,
        accumulation: scene.settings.accumulation,
    };
    // Lamps change nothing of it.
    let light = Light {
        order: scene.settings.order,
        coefficients: Vec::new(),
        emitters: Vec::new(),
    };
    cuts.find(Path::best(), &scene.forest(), &light, options);
    let sizes: Vec<usize> = (0..clusters.len())
        .map(|cluster| {
            let blockers = cuts.of(cluster);
            blockers.front.len() + blockers.across.len()
        })
        .collect();
    let used: Vec<usize> = (0..clusters.len())
        .filter(|&cluster| {
            receivers[clusters[cluster].clone()]
                .iter()
                .any(|r| r.covered != 0)
        })
        .collect();
    let largest = used
        .iter()
        .map(|&cluster| sizes[cluster])
        .max()
        .unwrap_or(0);
    let total: usize = used.iter().map(|&cluster| sizes[cluster]).sum();
    let color = |cluster: usize| match cut {
        true => heat(sizes[cluster] as f32 / largest.max(1) as f32),
        // Neighbours in both directions differ.
        false => {
            distinct(cluster % tiles.columns as usize + 7 * (cluster / tiles.columns as usize))
        }
    };
    let image = veil(width, height, |x, y| {
        let (x, y) = (step * x + step / 2, step * y + step / 2);
        let at = tiles.index(x, y);
        (receivers[at].covered != 0).then(|| color(at / Tiles::AREA))
    });
    let side = if half { 32 } else { 8 };
    let mean = total as f64 / used.len().max(1) as f64;
    let notes = match cut {
        true => vec![
            format!("{mean:.1} on average, {largest} at most"),
            format!("of {} spheres", scene.forest().spheres()),
        ],
        false => vec![
            format!("{} clusters of {side} × {side} pixels", used.len()),
            "All receivers of one share a cut.".into(),
        ],
    };
    Ok(Layer {
        image: Arc::new(image),
        legend: Legend {
            title: title.into(),
            ends: cut.then(|| ["0".into(), largest.to_string()]),
            notes,
        },
    })
}

/// A picture of colours that lets the one below through; nothing where there is no colour.
pub(super) fn veil(
    width: u32,
    height: u32,
    color: impl Fn(u32, u32) -> Option<Color32>,
) -> ColorImage {
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = pixels.map(|(x, y)| match color(x, y) {
        Some(color) => color.gamma_multiply(VEIL),
        None => Color32::TRANSPARENT,
    });
    ColorImage::new([width as usize, height as usize], pixels.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_grows_brighter() {
        let bright = |share: f32| {
            let [r, g, b, _] = heat(share).to_array().map(f32::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        for i in 0..100 {
            assert!(bright(i as f32 / 100.0) < bright((i + 1) as f32 / 100.0));
        }
        assert_eq!(heat(f32::NAN), heat(0.0));
        assert_eq!(heat(9.0), heat(1.0));
    }
}
