//! A comparison in words.

use super::comparison::Comparison;
use super::measure::Figures;
use std::fmt::Write;

fn bounces(count: u32) -> String {
    match count {
        0 => "no bounce".into(),
        1 => "one bounce".into(),
        n => format!("{n} bounces"),
    }
}

/// What was compared, in a line.
pub(super) fn title(comparison: &Comparison) -> String {
    let Comparison {
        scene,
        order,
        accumulation_order,
        paths,
        spheres,
        ..
    } = comparison;
    let name = scene.rsplit(['/', '\\']).next().unwrap_or(scene);
    let light = match comparison.light {
        "map" => "the map as it is",
        _ => "the same light",
    };
    format!(
        "{name}: {spheres} spheres, light of order {order}, shadows in order {accumulation_order}; \
         truth of {paths} paths a pixel, {}, {light}",
        bounces(comparison.bounces)
    )
}

/// The figures as a table.
pub(super) fn table(comparison: &Comparison) -> String {
    let mut text = title(comparison);
    // Writing to a string cannot fail.
    let _ = write!(
        text,
        ".\n{} receivers at {} x {}; {:.1} s for ours, {:.1} s for the truth. Indirect light is {:.1} % of all light.\n\n",
        comparison.receivers,
        comparison.width,
        comparison.height,
        comparison.seconds_ours,
        comparison.seconds_truth,
        100.0 * comparison.indirect_share,
    );
    text.push_str("| difference, in parts of the mean radiance | RMS | mean | 99th percentile | bias | the truth's noise, which the RMS is without |\n|");
    text.push_str(&"---|".repeat(6));
    let rows = [
        ("direct light", Some(comparison.direct)),
        ("indirect light", Some(comparison.indirect)),
        ("all light", Some(comparison.total)),
        (
            "direct light, the ground reflecting",
            comparison.direct_ground,
        ),
        (
            "indirect light, the ground reflecting",
            comparison.indirect_ground,
        ),
        ("all light, the ground reflecting", comparison.total_ground),
    ];
    for (name, figures) in rows {
        if let Some(figures) = figures {
            let Figures {
                rms,
                mean,
                p99,
                bias,
                noise,
            } = figures;
            let [rms, mean, p99, bias, noise] = [rms, mean, p99, bias, noise].map(|f| 100.0 * f);
            let _ = write!(
                text,
                "\n| {name} | {rms:.2} % | {mean:.2} % | {p99:.2} % | {bias:+.2} % | {noise:.2} % |"
            );
        }
    }
    if let Some(Figures {
        rms,
        mean,
        p99,
        bias,
        ..
    }) = comparison.half_resolution
    {
        let [rms, mean, p99, bias] = [rms, mean, p99, bias].map(|f| 100.0 * f);
        let _ = write!(
            text,
            "\n\nHalf resolution, which the table is without, against all samples, in parts of the picture's mean: \
             RMS {rms:.2} %, mean {mean:.2} %, 99th percentile {p99:.2} %, bias {bias:+.2} %."
        );
    }
    if let Some(sheet) = &comparison.sheet {
        let _ = write!(text, "\n\nThe pictures are in {}.", sheet.display());
    }
    text
}
