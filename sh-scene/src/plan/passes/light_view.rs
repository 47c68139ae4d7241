//! What spots, points and suns see.

use crate::LightViews;
use crate::plan::facts::counted;
use crate::plan::resource::{NEARNESS, PUNCTUAL_LIGHTS, SURFACES};
use crate::plan::{Cost, Domain, Entry, Orders, Pass, Run, Slot};

/// How near what is before lights with sharp shadows is.
pub static LIGHT_VIEW: Pass = Pass {
    name: "light_view",
    slots: |_| {
        vec![
            Slot::read(SURFACES).named(&["body"]),
            Slot::read(PUNCTUAL_LIGHTS).named(&["source", "view"]),
            Slot::write(NEARNESS).named(&["coarse"]),
        ]
    },
    wanted: |facts| {
        // Without one, `punctual` tells.
        if facts.punctual == 0 {
            return Ok(Vec::new());
        }
        if !facts.settings.shadows {
            return Err("Shadows are switched off.".into());
        }
        if facts.drawn == 0 {
            return Err("No object has a triangle that could be before a light.".into());
        }
        let views = LightViews::count(&facts.scene.punctual);
        let side = LightViews::side(views);
        let views = counted(views, "view", "views");
        let reason = format!(
            "What is before spots, points and suns is looked up in {views} of {side} by {side} texels."
        );
        Ok(vec![Run::once(Domain::Views, reason)])
    },
    entries: |_| {
        ["view", "coarsen", "coarsen_again", "coarsen_last"]
            .map(|name| Entry::new("light_view", name, Orders::None))
            .to_vec()
    },
    cost: |_| Cost {
        multiply_adds: 0.0,
        nanoseconds: 250.0,
    },
};
