//! What the command line says instead of a scene's settings.

use crate::Error;
use sh_core::ORDERS;
use sh_scene::{Quality, Settings};

/// Settings that win over the scene's, and each over the quality's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Both SH orders under one name.
    pub quality: Option<Quality>,
    /// SH order.
    pub order: Option<usize>,
    /// SH order in which the blockers' logarithms are accumulated.
    pub accumulation: Option<usize>,
    /// Whether shadows are cast.
    pub shadows: Option<bool>,
    /// Whether shadows are computed at half resolution.
    pub half_resolution: Option<bool>,
}

impl Overrides {
    /// What can be known to be wrong without a scene.
    ///
    /// # Errors
    /// A sentence where an order is none that there is.
    pub fn check(&self) -> Result<(), Error> {
        let orders = [("order", self.order), ("accumulation", self.accumulation)];
        for (name, order) in orders {
            if let Some(order) = order.filter(|order| !ORDERS.contains(order)) {
                return Err(Error::Usage(format!(
                    "--{name} is {order}, but it has to be {} to {}",
                    ORDERS.start(),
                    ORDERS.end()
                )));
            }
        }
        match (
            self.order.or(self.quality.map(Quality::order)),
            self.accumulation,
        ) {
            (Some(order), Some(accumulation)) => not_below(order, accumulation),
            _ => Ok(()),
        }
    }

    /// The settings of a scene with these in their place.
    ///
    /// # Errors
    /// A sentence where an order is none that there is, or accumulation would be below the order.
    pub fn apply(&self, scene: Settings) -> Result<Settings, Error> {
        self.check()?;
        let mut settings = scene;
        if let Some(quality) = self.quality {
            settings = settings.with_quality(quality);
        }
        if let Some(order) = self.order {
            settings = settings.with_order(order);
        }
        if let Some(accumulation) = self.accumulation {
            not_below(settings.order, accumulation)?;
            settings.accumulation = accumulation;
        }
        settings.shadows = self.shadows.unwrap_or(settings.shadows);
        let half = self.half_resolution;
        settings.half_resolution = half.unwrap_or(settings.half_resolution);
        Ok(settings)
    }
}

fn not_below(order: usize, accumulation: usize) -> Result<(), Error> {
    if accumulation < order {
        return Err(Error::Usage(format!(
            "--accumulation is {accumulation}, but it must not be below the SH order, which is {order}"
        )));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn orders(scene: (usize, usize), overrides: Overrides) -> Result<(usize, usize), String> {
        let (order, accumulation) = scene;
        let scene = Settings {
            accumulation,
            ..Settings::default().with_order(order)
        };
        let settings = overrides.apply(scene).map_err(|error| error.to_string())?;
        assert_eq!(settings.window, None);
        Ok((settings.order, settings.accumulation))
    }

    #[test]
    fn the_scene_gives_way_to_the_quality_and_the_quality_to_orders() {
        let (none, quality) = (Overrides::default(), Quality::Accurate);
        let named = Overrides {
            quality: Some(quality),
            ..none
        };
        let (order, accumulation) = (quality.order(), quality.accumulation());
        assert_eq!(orders((2, 5), none), Ok((2, 5)));
        assert_eq!(orders((2, 5), named), Ok((order, accumulation)));
        let five = Overrides {
            order: Some(5),
            ..named
        };
        // Orders that are equal stay so.
        assert_eq!(orders((2, 2), five), Ok((5, 5)));
        let both = Overrides {
            order: Some(3),
            accumulation: Some(5),
            ..named
        };
        assert_eq!(orders((2, 2), both), Ok((3, 5)));
        let alone = Overrides {
            order: Some(3),
            ..none
        };
        assert_eq!(orders((4, 4), alone), Ok((3, 3)));
        assert_eq!(orders((4, 6), alone), Ok((3, 6)));
        let accumulation = Overrides {
            accumulation: Some(6),
            ..none
        };
        assert_eq!(orders((4, 4), accumulation), Ok((4, 6)));
    }

    #[test]
    fn accumulation_below_the_order_is_refused() {
        let low = Overrides {
            accumulation: Some(3),
            ..Overrides::default()
        };
        assert!(low.check().is_ok(), "the scene's order may be 2");
        let sentence = orders((4, 4), low).unwrap_err();
        assert!(sentence.contains("--accumulation is 3"), "{sentence}");
        assert!(sentence.contains("which is 4"), "{sentence}");
        let with_order = Overrides {
            order: Some(5),
            ..low
        };
        assert!(with_order.check().is_err());
        let with_quality = Overrides {
            quality: Some(Quality::Accurate),
            ..low
        };
        assert!(with_quality.check().is_err());
    }

    #[test]
    fn shadows_are_what_was_asked_for() {
        for shadows in [true, false] {
            let asked = Overrides {
                shadows: Some(shadows),
                ..Overrides::default()
            };
            assert_eq!(asked.apply(Settings::default()).unwrap().shadows, shadows);
        }
    }
}
