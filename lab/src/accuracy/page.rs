//! ACCURACY.md: what accuracy costs, on one page.

use super::{PictureRow, Results, table};
use sh_scene::Quality;
use std::fmt::Write;
use std::path::PathBuf;

const HEAD: &str = "\
# What accuracy costs

Written by `gaunt-lab accuracy --plot docs/accuracy.svg --page ACCURACY.md`, in about a minute on two cores; the errors
are the same on every machine, the times are ratios within one run.

A receiver's visibility is an SH vector. It is made by summing a *logarithm* for each blocker and taking the
*exponential* of the sum once (Ren et al. 2006). Every pair of the two is measured here against the truth: the
projected product of the blockers' binary visibilities, exact to 1e-10.

- **mean, p95, max**: |g - truth| / |1| over 1,000 random sets of 1 to 12 circular blockers of 3 to 45 degrees in the
  upper half of the sphere. **heavy**: the mean over 200 sets of 2 to 24 blockers that nearly coincide. **stacked**:
  the largest over 1 to 4,096 identical blockers of 40 degrees.
- **rounding**: what single precision adds to that. **mul, add**: operations a receiver, for 6.5 blockers on average.
- A method is on the front if no other is both faster and more accurate.

## What to choose

";

const METHODS: &str = "
`saturating` is the exponential where visibility itself is asked for: by other renderers, and for what spheres hide of
each other. (The shadow pass has `transfer`, of the same kind but fitted to the light that is reflected, which is told by
pictures below.) It is made of samples on an octahedral rule, each held in
0..1.2996 by a fitted function in the place of e^x, after the ripples of many blockers are compressed to the size of
one blocker's. That is why it has a bound where all others but the sampled ones diverge.

- *Orders 3 to 6*: no published method is both faster and more accurate. The product chain (no logarithm at all: a
  product for each blocker) errs a little less at a multiple of the time, until blockers overlap.
- *OL* is the fastest, where an error of a tenth and more does not matter. *HYB* and *PS\\*-2* agree with each other, as
  published; they are the choice where the result must be the exponential of what was summed. `saturating` is not that:
  it goes with its own logarithm alone.
- *Fitted* logarithms beat the eigen logarithm where blockers overlap, the eigen logarithm where few stand apart.
- *Accumulating* in a higher order than the light's halves the error of the visibility; a higher order of both also
  sharpens the light, for little more.
- What the fit gives away: one blocker alone is 0.014 off at 40 degrees and order 4 (PS\\*-2 with the eigen logarithm:
  0.0002).

Errors of the built-in scene are those of the table at the end of the page: of what albedo 1 reflects, under light of order 6,
so that the presets' softer lights count as errors.
";

/// What each preset gives and costs: the built-in scene with its own numbers of spheres.
fn presets(pictures: &[PictureRow]) -> String {
    let of = |quality: Quality| {
        pictures.iter().find(|row| {
            row.factor == 1.0
                && row.order == quality.order()
                && row.accumulation_order == quality.accumulation()
        })
    };
    let mut text = "| preset | light, accumulation | error of the built-in scene | time of its shadows |\n|---|---|---|---|\n".to_string();
    let unit = of(Quality::default()).map_or(f64::NAN, |row| row.ms);
    for quality in Quality::ALL {
        if let Some(row) = of(quality) {
            writeln!(
                text,
                "| `{}` | {}, {} | {:.1} % | {} |",
                quality.name(),
                quality.order(),
                quality.accumulation(),
                100.0 * row.rms,
                table::short(row.ms / unit),
            )
            .expect("writing to a string");
        }
    }
    text
}

/// The page. `charts` are the files of both charts, as the page is to link them.
pub fn markdown(results: &Results, charts: Option<&(PathBuf, PathBuf)>) -> String {
    let mut text = HEAD.to_string();
    text += &presets(&results.pictures);
    text += METHODS;
    if let Some((methods, pictures)) = charts {
        let (methods, pictures) = (methods.display(), pictures.display());
        write!(
            text,
            "\n![Error against time, by method]({methods})\n\n![Error against time, whole pictures]({pictures})\n"
        )
        .expect("writing to a string");
    }
    text += "\n## Methods\n\nTimes are multiples of the default method's at the same order.\n\n";
    text += &table::markdown(&results.methods);
    text += "\n## Whole pictures\n\nThe built-in scene against rays that meet its triangles, lit by order 6: root of the \
             mean square and mean of the difference in luminance, over the mean.\n\n";
    text += &table::pictures_markdown(&results.pictures);
    text
}
