//! A ball as a receiver sees it: the circle in its sky that stands for it.
//!
//! What is below a receiver's horizon, its tangent plane, takes no light from it. A ball that the horizon cuts is stood
//! for by a circle that touches the horizon at the ball's azimuth and hides the same share of an even sky, weighted by the
//! cosine, as the part of the ball above. With h the distance of its centre over its radius, ν the cosine between the
//! normal and the direction of the centre and k² = 1 − h²ν² (the plane cuts it where k² > 0) that share is
//!
//! ```text
//! F = (1/π) [ (ν arccos(−ν √((h²−1)/(1−ν²))) − √(k² (h²−1))) / h² + arctan √(k²/(h²−1)) ]     cut
//! F = max(ν, 0) / h²                                                                             else
//! ```
//! (the form factor of a sphere, Snyder 1996, "Area light sources for real-time graphics"), and a circle of radius θ that
//! touches the horizon hides sin³ θ: sin θ = F^(1/3). It is that of a ball which touches the plane at the foot of the centre,
//! whose radius [`Routines::horizon_radius`] tells without a root. Where a ball just touches the plane both agree, and as it
//! sinks F goes to 0: nothing jumps. The self-shadow rule of Ren et al. 2006, section 6.2, lets a cut ball shrink to nothing
//! as the receiver comes near: a body that stands on the ground has no shadow at its foot then.
//!
//! From inside a ball one is seen that reaches to the receiver, about a half space towards the centre; what is sunk deeper
//! than the receiver is inside does not count. At the very centre, the one place where the circle jumps, there is no
//! direction.
//!
//! **A receiver's own body** is different. A surface lies in the balls that bound it, or next to them, and what of them
//! rises above its horizon is for the most part not there. So a ball of the receiver's own body does not count inside of it,
//! and comes gradually outside: its sine, and that alone, grows with 1 − sin² of the ball as it is, until that is [`OWN`].

use crate::constants::{self, FOOT, TINY};
use crate::{Lane, Routines};

/// 1 − sin² of the angular radius from which on a ball of the receiver's own body counts as others do: .2 radii outside.
///
/// ```
/// use sh_core::seen::{OWN, Seen};
/// let own = |distance: f64| Seen::above([0.0, distance, 0.0], [0.0, 1.0, 0.0], 1.0, 1.0).sine;
/// assert_eq!(own(1.0), 0.0);
/// assert!((own((1.0 - OWN).sqrt().recip()) - (1.0 - OWN).sqrt()).abs() < 1e-12);
/// ```
pub const OWN: f64 = constants::OWN;

/// A ball as a receiver sees it: sine and cosine of its angular radius (0..=90°), and the direction of its centre. A sine
/// of 0 means that it does not count.
///
/// ```
/// use sh_core::seen::Seen;
/// let seen = Seen::whole([0.0, 5.0, 0.0], 3.0_f64);
/// assert!((seen.sine - 0.6).abs() < 1e-12 && (seen.cosine - 0.8).abs() < 1e-12);
/// assert_eq!(seen.direction, [0.0, 1.0, 0.0]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Seen<L> {
    /// Sine of the angular radius.
    pub sine: L,
    /// Its cosine.
    pub cosine: L,
    /// Towards the middle, a unit vector.
    pub direction: [L; 3],
}

impl<L: Lane> Seen<L> {
    /// A ball as it is. `center` is seen from the receiver.
    ///
    /// Cost: 12 operations, a division and two square roots.
    ///
    /// ```
    /// use sh_core::seen::Seen;
    /// // From inside it is as large as it can be.
    /// assert_eq!(Seen::whole([0.0, 1.0, 0.0], 3.0_f32).sine, 1.0);
    /// ```
    #[inline(always)]
    pub fn whole(center: [L; 3], radius: L) -> Self {
        let (zero, one) = (radius.lift(0.0), radius.lift(1.0));
        let square = dot(center, center);
        let inverse = one / square.sqrt().max(radius.lift(TINY));
        let beside = (-radius).mul_add(radius, square).max(zero);
        Self {
            sine: (radius * inverse).min(one),
            cosine: (beside.sqrt() * inverse).min(one),
            direction: each(
                #[inline(always)]
                |k| center[k] * inverse,
            ),
        }
    }

    /// What of a ball is above the horizon of a receiver with this unit normal: the ball as it is where it lies wholly
    /// above, otherwise what stands for it. `own` is 1 for a ball of the receiver's own body and 0 for all others.
    ///
    /// Cost: 60 operations, four divisions and two square roots.
    ///
    /// ```
    /// use sh_core::seen::Seen;
    /// let up = [0.0, 1.0, 0.0];
    /// let height = |y: f64| Seen::above([2.0, y, 0.0], up, 1.0, 0.0);
    /// // Wholly above as it is, half sunk less, wholly sunk nothing.
    /// assert!((height(1.0).sine - 1.0 / 5.0_f64.sqrt()).abs() < 1e-12);
    /// assert!(height(0.0).sine > 0.2 && height(0.0).sine < 0.4);
    /// assert_eq!(height(-1.0).sine, 0.0);
    /// ```
    #[inline(always)]
    pub fn above(center: [L; 3], normal: [L; 3], radius: L, own: L) -> Self
    where
        [L; 4]: Routines<L>,
    {
        let (zero, one, tiny) = (radius.lift(0.0), radius.lift(1.0), radius.lift(TINY));
        let radius = radius.max(tiny);
        let height = dot(center, normal);
        let square = dot(center, center);
        let foot = each(
            #[inline(always)]
            |k| (-height).mul_add(normal[k], center[k]),
        );
        let foot_squared = dot(foot, foot);
        let (own_square, inverse_square) = (radius * radius, one / square.max(tiny * tiny));
        // From inside a ball counts that reaches to the receiver: its height is over more than its radius.
        let inside = (own_square * inverse_square).max(one);
        let sine_squared = (own_square * inverse_square).min(one);
        let over = height * (one / radius) * inside;
        // At the very centre it does not count.
        let over = L::select((tiny * tiny).lt(square), over, -one);
        let cut = height.lt(radius);
        let part = <[L; 4]>::horizon_radius(over, sine_squared);
        let grown = ((one - sine_squared) * radius.lift(1.0 / OWN)).min(one);
        let counted = radius * L::select(cut, part, one);
        // The ball touches the plane at the foot.
        let touching_squared = counted.mul_add(counted, foot_squared);
        // Under the foot, where nothing counts, rounding must not make a small ball a near one.
        let touching_squared = touching_squared.max(square * radius.lift(FOOT));
        let distance_squared = L::select(cut, touching_squared, square);
        let beside = L::select(
            cut,
            foot_squared,
            (-counted).mul_add(counted, square).max(zero),
        );
        let inverse = one / distance_squared.sqrt().max(tiny);
        let counts = (-one).lt(over);
        Self {
            sine: L::select(counts, (counted * inverse).min(one), zero)
                * own.mul_add(grown - one, one),
            cosine: (beside.sqrt() * inverse).min(one),
            direction: each(
                #[inline(always)]
                |k| {
                    let touching = counted.mul_add(normal[k], foot[k]);
                    L::select(cut, touching, center[k]) * inverse
                },
            ),
        }
    }
}

/// Three values. (The standard library's own ways are not always inlined, and would then be compiled without the
/// instruction set.)
#[inline(always)]
fn each<L>(value: impl Fn(usize) -> L) -> [L; 3] {
    [value(0), value(1), value(2)]
}

#[inline(always)]
fn dot<L: Lane>(a: [L; 3], b: [L; 3]) -> L {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[cfg(test)]
mod tests {
    use super::Seen;
    use crate::constants::{NEAR, REACH};

    /// What takes the place of a sphere that the horizon cuts may stick out of it, but no farther than lamps are looked for.
    #[test]
    fn what_stands_for_a_cut_sphere_is_near_it() {
        let mut most = 0.0_f64;
        for i in -100..100 {
            for j in 0..100 {
                let (height, aside) = (f64::from(i) / 100.0, f64::from(j) / 20.0);
                if height.hypot(aside) > f64::from(NEAR) {
                    let seen = Seen::above([aside, height, 0.0], [0.0, 1.0, 0.0], 1.0, 0.0);
                    // A ball that touches the plane at the foot.
                    let radius = aside * seen.sine / seen.cosine.max(1e-9);
                    most = most.max((radius - height).abs() + radius);
                }
            }
        }
        assert!(most > 1.3 && most < f64::from(REACH), "{most}");
    }
}
