//! Quadrature of Gauss and Legendre, exact for polynomials of degree 15.

/// The positive ones of eight nodes in (-1, 1), and their weights (Abramowitz and Stegun, table 25.4).
const HALF: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_27],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
];

/// The nodes between two numbers, and the weights that their values have in the integral.
pub(crate) fn nodes([from, to]: [f64; 2]) -> [(f64, f64); 8] {
    let (middle, half) = (f64::midpoint(from, to), (to - from) / 2.0);
    core::array::from_fn(|index| {
        let [place, weight] = HALF[index / 2];
        let side = if index % 2 == 0 { -half } else { half };
        (middle + side * place, half * weight)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of x^15 and of the exponential, whose integral is exact up to the 16th derivative over 16!.
    #[test]
    fn polynomials_of_degree_fifteen_are_exact() {
        let integral =
            |function: fn(f64) -> f64, ends| nodes(ends).map(|(at, weight)| weight * function(at)).iter().sum::<f64>();
        // Eight terms of size up to 2^15, each rounded a few times, of which fewer than 64 in all.
        assert!((integral(|x| x.powi(15), [1.0, 2.0]) - 65_535.0 / 16.0).abs() < 64.0 * f64::EPSILON * 65_536.0 / 16.0);
        assert!((integral(f64::exp, [0.0, 1.0]) - (1.0_f64.exp() - 1.0)).abs() < 64.0 * f64::EPSILON);
    }
}
