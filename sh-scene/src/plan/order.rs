//! The order of passes, from what they read and write.

use super::{Access, Planned};

/// Passes so that each comes after those whose work it needs. Where that leaves a choice, domains' phases decide, and
/// then the order in which the passes came.
///
/// Of a resource, whoever makes it comes first, then whoever changes it in place, then whoever only reads it; whoever reads
/// that of the turn before comes before all of them. Passes that
/// wait for each other keep the order in which they came; [`super::Plan::check`] finds them.
pub(super) fn sorted(passes: Vec<Planned>) -> Vec<Planned> {
    let mut left: Vec<Planned> = passes;
    left.sort_by_key(|pass| pass.at.phase());
    let mut sorted = Vec::with_capacity(left.len());
    while !left.is_empty() {
        let phase = left[0].at.phase();
        let free = |pass: &Planned| {
            let mut others = left.iter().filter(|other| *other != pass);
            pass.at.phase() == phase && !others.any(|other| precedes(other, pass))
        };
        let next = left.iter().position(free).unwrap_or(0);
        sorted.push(left.remove(next));
    }
    sorted
}

/// Whether a pass has to be done before another.
fn precedes(first: &Planned, then: &Planned) -> bool {
    let after = then.slots();
    first.slots().iter().any(|slot| {
        let same = |other: &&super::Slot| other.bound(then.at) == slot.bound(first.at);
        after
            .iter()
            .filter(same)
            .any(|other| rank(slot.access) < rank(other.access))
    })
}

fn rank(access: Access) -> u32 {
    match access {
        Access::ReadBefore => 0,
        Access::Write => 1,
        Access::Modify | Access::Add => 2,
        Access::Read | Access::ReadIfAny => 3,
    }
}
