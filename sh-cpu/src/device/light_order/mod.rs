//! In which order a cluster's receivers meet the spheres that light them, and which of these hide which.
//!
//! Of two disjoint spheres the one of the lesser *power* |c − p|² − r² cannot be hidden by the other from p: the plane on
//! which both powers are equal parts the spheres, and p lies on the side of the lesser. So the order by power is always
//! right, has no cycles, and where it swaps, for a receiver on that plane, neither sphere covers any of the other:
//! nothing jumps. Guerrero et al. 2008 go by the distance of centres instead, of spheres or of whole bodies, which can
//! be wrong for both (section 8.4). Spheres of different bodies that intersect change their order gradually, over the
//! width of the circle in which they cut each other. So do those of one body where lights are discs
//! ([`Blocking::within_bodies`]): each hides half of the lens in which both are seen from afar, and together they send on
//! what their union does. Otherwise they do not hide each other: what one hides of the other is dark in its samples
//! (section 4.2).
//!
//! A node of the forest that stands for several spheres gives each cluster what these give together: its *reflection
//! ratio* (equation 25) brings its light, seen from the middle of the cluster, to the sum of theirs, channel by channel.
//! So clusters whose cuts differ meet without a seam.
//!
//! Powers are compared over the whole cluster. Where lights are discs ([`Blocking::Discs`]), each has a list of the spheres
//! that may cover a part of it somewhere in the cluster: those nearer whose disc comes near enough.
//!
//! Where visibilities are differences of exponentials, all that is nearer is summed up. Sorted by them, spheres fall into *runs*: all of a run hide from all
//! receivers what they can of all of a later one. What was summed up for a run serves all that follow, as in the
//! paper's per-object blocking; only within a run pairs have to be looked at one by one, as in its per-sphere
//! blocking. Bodies apart are runs of their own, or several; bodies that interlock share one.

mod find;
mod gain;
mod pairs;

pub use find::LightCutOptions;
