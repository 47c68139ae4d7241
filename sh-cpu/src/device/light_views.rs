//! What lights with sharp shadows see, and what of them a receiver sees. `kernels/punctual.wgsl` does the same.
//!
//! A receiver looks its light up in the view that shows it best. Of a light of radius R what is at k in that picture, before
//! the receiver at k', is blurred by R (k − k'). So the nearest of all that is near enough to be in the way, by blocks of texels,
//! bounds how far it has to look; among points spread over that far it looks for what is in the way; the mean nearness of these
//! says over how much of the picture to take the share that is not (Fernando, "Percentage-Closer Soft Shadows", 2005).
//!
//! In the way is what a ray from the receiver to some part of the light passes, by a texel, what rises above the receiver's own
//! plane, by half a texel and by [`RISE`], and is nearer to the light by a texel at least. Its place is known from the picture, so
//! that no bias is needed that would part a shadow from what casts it: on a plane, however it leans, all else lies in the plane.

use glam::Vec3;
use sh_core::constants::{
    GOLDEN_COSINE, GOLDEN_SINE, LEAST_BLUR, NOWHERE, RISE, SEARCH_TAPS, SHADOW_TAPS, SHARP,
    SHARP_TAPS, VIEW_BLOCK, WIDE,
};
use sh_scene::{Ground, LightView, LightViews, PunctualRecord};
use std::sync::LazyLock;

/// The lights of a scene, and what is before them.
#[derive(Debug, Default)]
pub(crate) struct Views {
    pub seen: LightViews,
    /// View by view, row by row from the top: how near what is seen is.
    pub nearest: Vec<f32>,
    /// The nearest of each block of texels, view by view; of each block of these; of each view.
    pub coarse: Vec<f32>,
    pub ground: Option<Ground>,
}

/// What a receiver looks up.
struct Look<'a> {
    views: &'a Views,
    index: usize,
    view: &'a LightView,
    radius: f32,
    place: Vec3,
    normal: Vec3,
    /// Its picture, in texels from the upper left corner.
    at: [f32; 2],
    nearness: f32,
    /// What is nearer to the light than it by less than that is not told apart from it, in metres.
    footprint: f32,
    /// How near the receiver's own plane is at a texel: a constant, and what is added for each texel to the right and down. What is
    /// no nearer is not in the way.
    plane: [f32; 3],
}

impl Views {
    /// Takes over the lights of a scene and the ground that hides some of them; whether they, and what they see, are what they were.
    /// `still` says that no triangle has moved, which nobody sees where there are no views.
    pub fn take(&mut self, seen: LightViews, still: bool, ground: Option<Ground>) -> bool {
        let still = still || seen.views.is_empty();
        if still && self.seen == seen && self.ground == ground {
            return true;
        }
        self.nearest.clear();
        (self.seen, self.ground) = (seen, ground);
        false
    }

    /// Texels of a block of each level, and where the level begins.
    pub fn levels(&self) -> [usize; 3] {
        let count = self.seen.views.len();
        let side = self.seen.side / VIEW_BLOCK as usize;
        let first = count * side * side;
        let side = side / VIEW_BLOCK as usize;
        let second = first + count * side * side;
        [first, second, second + count]
    }

    /// Bytes of pictures.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.nearest[..]) + size_of_val(&self.coarse[..])
    }

    /// The share of a light that a place with a unit normal sees. `turn` is 0 to 3, another for each sample of a pixel.
    pub fn visible(&self, light: &PunctualRecord, place: Vec3, normal: Vec3, turn: u32) -> f32 {
        if let Some(ground) = self.ground {
            let light_below = match light.distant == 0.0 {
                true => light.position[1] < ground.height,
                false => light.position[1] < 0.0,
            };
            if (place.y < ground.height) != light_below {
                return 0.0;
            }
        }
        let Some(look) = self.look(light, place, normal) else {
            return 1.0;
        };
        look.visible(turn)
    }

    fn look(&self, light: &PunctualRecord, place: Vec3, normal: Vec3) -> Option<Look<'_>> {
        if self.nearest.is_empty() {
            return None;
        }
        let first = light.first as usize;
        let depth = |view: &LightView| (place - Vec3::from(view.origin)).dot(view.forward.into());
        let mut index = first;
        for other in first + 1..first + light.views as usize {
            if depth(&self.seen.views[other]) > depth(&self.seen.views[index]) {
                index = other;
            }
        }
        let view = self.seen.views.get(index)?;
        let [across, up, nearness] = view.place(place)?;
        if !(across.abs() <= 1.0 && up.abs() <= 1.0) {
            return None;
        }
        let side = self.seen.side as f32;
        let texel = 2.0 / (side * view.inverse);
        let plane = plane(view, place, normal, 2.0 / side);
        Some(Look {
            plane,
            views: self,
            index,
            view,
            radius: light.radius,
            place,
            normal,
            at: [(0.5 + 0.5 * across) * side, (0.5 - 0.5 * up) * side],
            nearness,
            footprint: match view.distant == 0.0 {
                true => texel / nearness,
                false => texel,
            },
        })
    }
}

impl Look<'_> {
    fn side(&self) -> f32 {
        self.views.seen.side as f32
    }

    fn visible(&self, turn: u32) -> f32 {
        let [_, last, _] = self.views.levels();
        let mut nearest = self.views.coarse[last + self.index];
        let mut reach = LEAST_BLUR;
        for _ in 0..2 {
            if nearest <= self.nearness {
                return 1.0;
            }
            reach = self.blurred(nearest);
            nearest = self.nearest_within(reach);
        }
        if nearest <= self.nearness {
            return 1.0;
        }
        reach = reach.min(self.blurred(nearest));
        let few = |reach: f32, many| if reach < SHARP { SHARP_TAPS } else { many };
        let mut seen = self.spread(reach, few(reach, SEARCH_TAPS), turn);
        // Something near by may have spread points so far that what hides the light lies between them.
        for _ in 0..2 {
            if seen[0] > 0.0 || seen[3] <= self.nearness {
                break;
            }
            reach = self.blurred(seen[3]);
            seen = self.spread(reach, few(reach, SEARCH_TAPS), turn);
        }
        let [found, clear, sum, _] = seen;
        if found == 0.0 {
            return 1.0;
        }
        let width = self.blurred(sum / found);
        if reach < SHARP && width == reach {
            // These are the texels that were just looked at.
            return clear / (found + clear);
        }
        let [hidden, clear, ..] = self.spread(width, few(width, SHADOW_TAPS), turn);
        clear / (hidden + clear).max(1.0)
    }

    /// By how many texels the shadow of something so near is blurred: by so much at least that texels have no corners.
    fn blurred(&self, nearness: f32) -> f32 {
        self.shifted(nearness)
            .clamp(LEAST_BLUR, WIDE * 0.5 * self.side())
    }

    /// By how many texels the light's edge shifts something so near over the receiver's picture.
    fn shifted(&self, nearness: f32) -> f32 {
        self.radius * (nearness - self.nearness) * self.view.inverse * 0.5 * self.side()
    }

    /// The nearest of all that is in blocks which come within so many texels.
    fn nearest_within(&self, reach: f32) -> f32 {
        let block = VIEW_BLOCK as f32;
        let views = self.views;
        let [second, _, _] = views.levels();
        let few = 2.0 * reach <= 3.0 * block;
        let (first, size) = match few {
            true => (0, block),
            false => (second, block * block),
        };
        let side = (self.side() / size) as usize;
        let first = first + self.index * side * side;
        let last = side as f32 - 1.0;
        let cell = |at: f32| (at / size).floor().clamp(0.0, last) as usize;
        let [low, high] = [-reach, reach].map(|by| self.at.map(|at| cell(at + by)));
        let mut nearest = NOWHERE;
        for row in low[1]..=high[1] {
            for column in low[0]..=high[0] {
                nearest = nearest.max(views.coarse[first + row * side + column]);
            }
        }
        nearest
    }

    /// Looks at texels on a spiral that fills a disc evenly: how many are in the way, how many are not, and how near the former are
    /// in sum. What hides nothing only because the light is too small for it is neither; how near the nearest of that is comes last.
    fn spread(&self, reach: f32, taps: u32, turn: u32) -> [f32; 4] {
        let mut found = [0.0, 0.0, 0.0, NOWHERE];
        let side = self.views.seen.side;
        let first = self.index * side * side;
        let nearest = &self.views.nearest[first..first + side * side];
        let [plane, right, down] = self.plane;
        let last = self.side() - 1.0;
        for [far, x, y] in spiral(taps) {
            let [x, y] = match turn {
                0 => [*x, *y],
                1 => [-*y, *x],
                2 => [-*x, -*y],
                _ => [*y, -*x],
            };
            let far = reach * far;
            let cell = |k: usize, aside: f32| (self.at[k] + far * aside).clamp(0.0, last) as usize;
            let (column, row) = (cell(0, x), cell(1, y));
            let nearness = nearest[row * side + column];
            let [x, y] = [column, row].map(|at| at as f32 + 0.5);
            let behind = nearness <= plane + right * x + down * y;
            if behind || !self.is_in_the_way([x, y], nearness) {
                found[1] += 1.0;
            } else if far <= self.shifted(nearness) + 1.0 {
                found[0] += 1.0;
                found[2] += nearness;
            } else {
                found[3] = found[3].max(nearness);
            }
        }
        found
    }

    /// Whether what is seen in the middle of a texel rises before the light, wherever on the light.
    fn is_in_the_way(&self, [x, y]: [f32; 2], nearness: f32) -> bool {
        if nearness <= self.nearness {
            return false;
        }
        let scale = 2.0 / self.side();
        let seen = [x * scale - 1.0, 1.0 - y * scale, nearness];
        let towards = self.view.position(seen) - self.place;
        let before = match self.view.distant == 0.0 {
            true => 1.0 / self.nearness - 1.0 / nearness,
            false => nearness - self.nearness,
        };
        let height = towards.dot(self.normal);
        before > self.footprint && height > RISE * towards.length() + 0.5 * self.footprint
    }
}

/// How near a plane is in a view, whose texels are `scale` of the picture wide: it changes evenly over the picture. Where the light is behind
/// the plane all is nearer.
fn plane(view: &LightView, place: Vec3, normal: Vec3, scale: f32) -> [f32; 3] {
    let [right, up, forward, origin] =
        [view.right, view.up, view.forward, view.origin].map(Vec3::from);
    let [right, up, ahead] = [right, up, forward].map(|axis| normal.dot(axis));
    let behind = normal.dot(place - origin);
    let (whole, by) = match view.distant == 0.0 {
        true => (ahead, behind),
        false => (ahead * view.far - behind, ahead),
    };
    if by.is_nan() || by >= 0.0 {
        return [NOWHERE, 0.0, 0.0];
    }
    // From -1 to 1 across and up, texels count from the upper left corner.
    [
        (whole - right + up) / by,
        right * scale / by,
        -up * scale / by,
    ]
}

/// Points of a spiral that fills a disc evenly: how far from the middle they are, over the radius, and in which direction.
fn spiral(taps: u32) -> &'static [[f32; 3]] {
    static ALL: LazyLock<[Vec<[f32; 3]>; 3]> = LazyLock::new(|| {
        [SHARP_TAPS, SEARCH_TAPS, SHADOW_TAPS].map(|taps| {
            let mut direction = [1.0, 0.0];
            let point = |tap: u32| {
                let [x, y] = direction;
                direction = [
                    x * GOLDEN_COSINE - y * GOLDEN_SINE,
                    x * GOLDEN_SINE + y * GOLDEN_COSINE,
                ];
                [((tap as f32 + 0.5) / taps as f32).sqrt(), x, y]
            };
            (0..taps).map(point).collect()
        })
    });
    let all = ALL.iter();
    all.into_iter()
        .find(|points| points.len() == taps as usize)
        .map_or(&[], |points| points)
}
