//! A picture beside its truth: `cargo run --release -p sh-tests --example truth -- SCENE.toml OUT.png [WIDTH [RAYS]]`.
//!
//! Left what the shadow pass makes; right the same light (the same SH vector) with visibility from rays against
//! the real triangles; below the difference, grey where there is none. Prints the RMS and the mean of the
//! difference in luminance relative to the mean. `default` in place of a scene is the built-in one.

use gaunt::image::{exposure, screen};
use sh_cpu::{CutOptions, Cuts, Gbuffer, Geometry, Path, Shadow};
use sh_reference::{basis, raycast, sampled};
use sh_scene::{Receiver, Tiles, View};

type Row = Vec<[f32; 3]>;

/// Radiance that albedo 1 reflects at a receiver: rays over the sphere of directions.
fn truth(
    caster: &raycast::Caster,
    light: &[Vec<f64>; 3],
    rays: &[[f64; 3]],
    receiver: &Receiver,
) -> [f32; 3] {
    let normal = receiver.normal.map(f64::from);
    let origin = std::array::from_fn(|i| f64::from(receiver.position[i]) + 1e-4 * normal[i]);
    let mut sum = [0.0; 3];
    for direction in rays {
        let cosine: f64 = (0..3).map(|i| direction[i] * normal[i]).sum();
        if cosine > 0.0 && !caster.blocked(origin, *direction, 0.0) {
            for (sum, light) in sum.iter_mut().zip(light) {
                *sum += cosine * basis::evaluate(light, *direction);
            }
        }
    }
    sum.map(|s| (s * 4.0 / rays.len() as f64).max(0.0) as f32)
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, output, ..] = &arguments[..] else {
        eprintln!("usage: truth SCENE.toml|default OUT.png [WIDTH [RAYS]]");
        std::process::exit(1);
    };
    let number = |i: usize, default: usize| {
        arguments
            .get(i)
            .map_or(default, |a| a.parse().expect("a number"))
    };
    let (width, rays) = (
        number(2, 320),
        sampled::directions(number(3, 1024)).collect::<Vec<_>>(),
    );
    let scene = match scene.as_str() {
        "default" => sh_bake::default_scene(None, &|_| {}).0,
        path => {
            sh_bake::load_scene(path.as_ref())
                .unwrap_or_else(|e| panic!("{e}"))
                .scene
        }
    };
    let height = width * 9 / 16;
    let view = View {
        camera: scene.camera,
        width: width as u32,
        height: height as u32,
    };
    let settings = &scene.settings;
    let light = scene.light().expect("a light");
    let channels: [Vec<f64>; 3] =
        std::array::from_fn(|c| light.coefficients.iter().map(|x| f64::from(x[c])).collect());
    let caster = raycast::Caster::new(
        scene
            .objects
            .iter()
            .flat_map(raycast::world_triangles)
            .collect(),
    );
    let geometry = Geometry::new(&scene).expect("a scene that can be cast");
    let forest = scene.forest();
    let exposure = exposure(&light);

    let mut picture = image::RgbImage::new(2 * width as u32, 2 * height as u32);
    let (mut square, mut bias, mut mean, mut count) = (0.0, 0.0, 0.0, 0.0);
    let (mut samples, mut cuts) = (Gbuffer::default(), Cuts::default());
    let grid = view.samples();
    let options = CutOptions {
        limits: settings.limits,
        ratios: true,
        accumulation: settings.accumulation,
    };
    for row in 0..grid.tiles().rows {
        sh_cpu::gbuffer(&geometry, &view, grid, row..row + 1, &mut samples).expect("a row");
        let tiles = Tiles {
            rows: 1,
            ..grid.tiles()
        };
        let (receivers, clusters) = (&samples.receivers, tiles.clusters());
        cuts.bound(receivers, &clusters, 0..clusters.len());
        cuts.find(Path::best(), &forest, options);
        let shadow = Shadow {
            clusters: &clusters,
            cuts: &cuts,
            light: &light,
            accumulation: settings.accumulation,
            baked: None,
        };
        let mut ours: Row = vec![[0.0; 3]; receivers.len()];
        sh_cpu::shadow_clusters(Path::best(), receivers, &shadow, &mut ours).expect("a shadow");
        // One sample of each pixel.
        let pixels = (0..Tiles::SIDE / 2).flat_map(|y| (0..width).map(move |x| (x, y)));
        for (x, line) in pixels {
            let y = (row * Tiles::SIDE / 2 + line) as usize;
            if y >= height {
                continue;
            }
            let at = tiles.index(2 * x as u32, 2 * line);
            let (receiver, albedo, ours) = (&receivers[at], samples.albedo[at], ours[at]);
            let truth = if receiver.covered == 0 {
                [0.0; 3]
            } else {
                truth(&caster, &channels, &rays, receiver)
            };
            let mut put = |column: usize, row: usize, color: [f32; 3]| {
                let (column, row) = (column as u32, row as u32);
                picture.put_pixel(column, row, image::Rgb(screen(color, column, row)));
            };
            let shown = |c: [f32; 3]| std::array::from_fn(|i| c[i] * albedo[i] * exposure);
            put(x, y, shown(ours));
            put(x + width, y, shown(truth));
            put(
                x,
                y + height,
                std::array::from_fn(|i| 0.5 + 0.5 * (ours[i] - truth[i]) * exposure),
            );
            let luminance = |c: [f32; 3]| f64::from(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
            let difference = luminance(ours) - luminance(truth);
            if receiver.covered != 0 {
                square += difference * difference;
                bias += difference;
                mean += luminance(truth);
                count += 1.0;
            }
        }
    }
    let mean = mean / count;
    println!(
        "order {} accumulated in {}: RMS {:.4}, bias {:+.4} of the mean radiance",
        settings.order,
        settings.accumulation,
        (square / count).sqrt() / mean,
        bias / count / mean
    );
    picture.save(output).expect("the picture is written");
}
