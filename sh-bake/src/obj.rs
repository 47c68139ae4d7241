//! Wavefront OBJ, read by tobj.
//!
//! tobj says what is wrong but not where, and computes with indices before it checks them. So the numbers
//! in the file are looked through first, line by line.

use crate::error::Error;
use crate::raw::{RawPart, WHITE};
use sh_scene::Material;
use std::path::Path;

/// The file's faces as one part.
pub(crate) fn load(path: &Path, bytes: &[u8]) -> Result<RawPart, Error> {
    let text = std::str::from_utf8(bytes).map_err(|e| {
        Error::file(
            path,
            format!("the file is not text after byte {}.", e.valid_up_to()),
        )
    })?;
    check(text).map_err(|(line, message)| Error::file(path, format!("line {line}: {message}")))?;

    let options = tobj::LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    let no_materials = |_: &Path| Ok((Vec::new(), Default::default()));
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)
        .map_err(|e| Error::file(path, format!("the file cannot be understood: {e}.")))?;

    let mut part = RawPart {
        name: String::new(),
        positions: Vec::new(),
        normals: Vec::new(),
        uvs: Vec::new(),
        colors: Vec::new(),
        triangles: Vec::new(),
        material: Material::diffuse(WHITE),
        bind: None,
    };
    for model in &models {
        let mesh = &model.mesh;
        let first = part.positions.len() as u32;
        part.positions.extend(mesh.positions.as_chunks::<3>().0);
        part.normals.extend(mesh.normals.as_chunks::<3>().0);
        let triangles = mesh.indices.as_chunks::<3>().0;
        part.triangles
            .extend(triangles.iter().map(|t| t.map(|i| i + first)));
    }
    if part.normals.len() != part.positions.len() {
        part.normals.clear();
    }
    Ok(part)
}

/// Looks through the numbers of a file: the first line that is wrong, from 1, and how.
fn check(text: &str) -> Result<(), (usize, String)> {
    let mut counts = [0_i64; 3];
    const NAMES: [&str; 3] = ["position", "texture coordinate", "normal"];
    let kind = |keyword: &str| ["v", "vt", "vn"].iter().position(|k| *k == keyword);
    // An index from the front may look ahead, one from the back counts from its own line.
    let mut totals = [0_i64; 3];
    for line in text.lines() {
        if let Some(k) = line.split_whitespace().next().and_then(kind) {
            totals[k] += 1;
        }
    }
    for (number, line) in text.lines().enumerate() {
        let wrong = |message: String| Err((number + 1, message));
        let mut words = line.split_whitespace();
        let Some(keyword) = words.next() else {
            continue;
        };
        if let Some(k) = kind(keyword) {
            counts[k] += 1;
            let needed = if k == 1 { 2 } else { 3 };
            let numbers = words.clone().take(needed).map(str::parse::<f32>);
            if words.clone().count() < needed || numbers.into_iter().any(|n| n.is_err()) {
                return wrong(format!(
                    "a {} needs {needed} numbers, but here is `{line}`.",
                    NAMES[k]
                ));
            }
        } else if keyword == "f" || keyword == "l" {
            for corner in words {
                for (k, index) in corner.split('/').enumerate() {
                    if index.is_empty() && k > 0 {
                        continue;
                    }
                    let parsed = index.parse::<i64>().ok().filter(|_| k < 3);
                    let Some(i) = parsed else {
                        return wrong(format!(
                            "`{corner}` is no corner of a face; `1/2/3` would be one."
                        ));
                    };
                    let inside = (1..=totals[k]).contains(&i) || (-counts[k]..=-1).contains(&i);
                    if !inside {
                        let name = NAMES[k];
                        let total = totals[k];
                        return wrong(format!(
                            "the face's {name} index {i} is out of range: the file has {total} of them."
                        ));
                    }
                }
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn message(text: &str) -> String {
        load(Path::new("x.obj"), text.as_bytes())
            .err()
            .map(|e| e.to_string())
            .unwrap_or_default()
    }

    const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv -1 0.5 0\n";

    #[test]
    fn polygons_become_triangles_and_indices_may_count_from_the_back() {
        let part = load(
            Path::new("x.obj"),
            format!("{CORNERS}f 1 2 3 4 5\nf -5 -4 -3\n").as_bytes(),
        );
        let part = part.unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(part.triangles.len(), 4);
        assert_eq!(part.positions.len(), 5);
    }

    #[test]
    fn what_is_wrong_is_named_with_its_line() {
        for (face, expected) in [
            (
                "f 1 2 9",
                "line 6: the face's position index 9 is out of range: the file has 5 of them.",
            ),
            ("f 1 2 0", "line 6: the face's position index 0"),
            ("f 1 2 -6", "line 6: the face's position index -6"),
            (
                "f 1/1 2/1 3/1",
                "line 6: the face's texture coordinate index 1",
            ),
            ("f 1//9 2//9 3//9", "line 6: the face's normal index 9"),
            ("f 1 2 x", "line 6: `x` is no corner"),
            (
                "f 1 2 99999999999999999999",
                "line 6: `99999999999999999999` is no corner",
            ),
            ("v 1 2", "line 6: a position needs 3 numbers"),
            ("v 1 2 z", "line 6: a position needs 3 numbers"),
            ("vn 1 2", "line 6: a normal needs 3 numbers"),
        ] {
            let message = message(&format!("{CORNERS}{face}\n"));
            assert!(
                message.contains(expected) && message.starts_with("x.obj: "),
                "{message}"
            );
        }
    }

    #[test]
    fn corners_without_normals_among_others_lose_them_all() {
        let text = format!("{CORNERS}vn 0 0 1\nf 1//1 2//1 3\nf 1 3 4\n");
        let part = load(Path::new("x.obj"), text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
        assert!(part.normals.is_empty());
    }
}
