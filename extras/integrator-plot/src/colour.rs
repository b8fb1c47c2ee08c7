//! Colours of ink, grid and curves, and those of maps.

/// A colour by red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

/// The colour of text and axes.
pub const INK: Colour = Colour(40, 40, 40);
/// The colour of grid lines.
pub const PALE: Colour = Colour(226, 226, 226);
/// The colour of secondary items: walks, references.
pub const GREY: Colour = Colour(150, 150, 150);
/// The background.
pub const WHITE: Colour = Colour(255, 255, 255);

/// Colours that are distinguishable with any colour vision (Okabe and Ito), without yellow, which is too pale on white.
pub const COLOURS: [Colour; 8] = [
    Colour(30, 30, 30),
    Colour(86, 180, 233),
    Colour(230, 159, 0),
    Colour(213, 94, 0),
    Colour(204, 121, 167),
    Colour(0, 158, 115),
    Colour(0, 114, 178),
    Colour(140, 86, 60),
];

impl Colour {
    /// Interpolates between this colour, at 0, and another one, at 1.
    #[must_use]
    pub fn towards(self, other: Self, share: f64) -> Self {
        let part = |from: u8, to: u8| (f64::from(from) + share * (f64::from(to) - f64::from(from))).round() as u8;
        Self(part(self.0, other.0), part(self.1, other.1), part(self.2, other.2))
    }

    /// Returns the colour as it is written in SVG.
    pub(crate) fn hexadecimal(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// Equal distances along the scale of a map, from little to much: their lightness grows evenly, so that a map is read as
/// well in grey.
const SCALE: [Colour; 6] = [
    Colour(44, 17, 95),
    Colour(114, 31, 129),
    Colour(183, 55, 121),
    Colour(241, 96, 93),
    Colour(254, 175, 119),
    Colour(252, 253, 191),
];

/// The colour of a share of the scale of a map.
pub(crate) fn of_share(share: f64) -> Colour {
    let place = share.clamp(0.0, 1.0) * (SCALE.len() - 1) as f64;
    let below = (place as usize).min(SCALE.len() - 2);
    SCALE[below].towards(SCALE[below + 1], place - below as f64)
}

#[cfg(test)]
mod tests {
    use super::{Colour, SCALE, of_share};

    #[test]
    fn the_scale_of_maps_grows_lighter() {
        let lightness =
            |Colour(red, green, blue)| 0.299 * f64::from(red) + 0.587 * f64::from(green) + 0.114 * f64::from(blue);
        let steps: Vec<f64> = (0..=100).map(|share| lightness(of_share(f64::from(share) / 100.0))).collect();
        assert!(steps.windows(2).all(|pair| pair[0] < pair[1]), "{steps:?}");
        assert_eq!((of_share(-1.0), of_share(2.0)), (SCALE[0], SCALE[5]));
    }
}
