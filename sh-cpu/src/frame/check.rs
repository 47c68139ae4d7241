//! Whether a plan makes a picture.

use crate::Error;
use sh_scene::{Plan, Resolution, Resource};

/// Whether it does: what each pass reads is there or was written before, and a picture is written.
pub(super) fn check_plan(plan: &Plan) -> Result<(), Error> {
    let writes = |at: &[sh_scene::Pass], resource: &Resource| {
        at.iter().any(|pass| pass.writes().contains(resource))
    };
    for (index, pass) in plan.passes.iter().enumerate() {
        for resource in pass.reads() {
            let (before, after) = plan.passes.split_at(index);
            if resource.resolution() == Resolution::Fixed || writes(before, resource) {
                continue;
            }
            // What only adds to a resource reads it as well.
            return Err(match writes(&after[1..], resource) {
                true => Error::PlanOrder,
                false => Error::Plan {
                    missing: writers(*resource),
                },
            });
        }
    }
    if writes(&plan.passes, &Resource::Picture) {
        Ok(())
    } else {
        let missing = writers(Resource::Picture);
        Err(Error::Plan { missing })
    }
}

/// The passes that write a resource, as an error names them.
fn writers(resource: Resource) -> &'static str {
    match resource {
        Resource::HalfReceivers => "gbuffer at half resolution",
        Resource::HalfRadiance => "shadow at half resolution",
        Resource::Radiance => "irradiance, shadow or upsample",
        Resource::Emission => "light_update",
        Resource::Picture => "resolve",
        _ => "gbuffer",
    }
}
