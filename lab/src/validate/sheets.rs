//! A sheet of pictures for each scene, as `gaunt compare` draws it.

use super::Options;
use super::measure::Sight;
use gaunt::Error;
use gaunt::compare::pictures::Pictures;
use gaunt::compare::{balls, sheet};
use gaunt::image::{Output, exposure};
use sh_scene::{Method, Scene};
use std::path::Path;

/// Writes the sheet of a scene into a folder, by its method: that of patches beside that of spheres.
pub(super) fn write(
    folder: &Path,
    (name, title): (&str, &str),
    scene: &Scene,
    sight: &Sight,
    options: &Options,
) -> Result<(), Error> {
    let by = match scene.settings.indirect.unwrap_or_default().method {
        Method::SphericalLights => "",
        Method::BasisIrradiance => "-patches",
    };
    let file = folder.join(format!("{name}{by}.png"));
    let output = Output::create(&file)?;
    let light = scene.light()?;
    let ours = sight.ours(scene)?;
    let pictures = Pictures {
        scene,
        seen: &sight.seen,
        exposure: exposure(&light, scene),
    };
    let spheres = balls::picture(scene, &light, &ours.emission, &sight.seen);
    let mut rows = pictures.rows(&ours.parts, &sight.truth.parts, None, spheres);
    // Direct light alone looks as all light does: it is in the tables.
    rows.remove(1);
    let mut title = title.to_string();
    if let Some(first) = title.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let title = format!(
        "{title}: order {}, {} paths",
        scene.settings.order, options.paths
    );
    sheet::write(output, &file, &title, &rows, options.size)
}
