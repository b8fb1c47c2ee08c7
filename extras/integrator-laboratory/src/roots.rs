//! Roots of polynomials with complex coefficients, and the polynomials of multistep methods on the oscillator.

use nalgebra::ComplexField;

pub(crate) type Complex = nalgebra::Complex<f64>;

/// The number on the unit circle at an angle.
pub(crate) fn turned(angle: f64) -> Complex {
    Complex::new(angle.cos(), angle.sin())
}

/// The numbers of a curve for a picture.
pub(crate) fn points(numbers: &[Complex]) -> impl Iterator<Item = (f64, f64)> {
    numbers.iter().map(|number| (number.re, number.im))
}

/// The product of polynomials, highest powers first.
fn product(a: &[Complex], b: &[Complex]) -> Vec<Complex> {
    let mut product = vec![Complex::ZERO; a.len() + b.len() - 1];
    for (i, a) in a.iter().enumerate() {
        for (j, b) in b.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// Adds a polynomial, whose last coefficient is that of the same power, times a factor.
fn add(to: &mut [Complex], factor: Complex, polynomial: &[f64]) {
    let first = to.len() - polynomial.len();
    for (to, coefficient) in to[first..].iter_mut().zip(polynomial) {
        *to += factor * *coefficient;
    }
}

/// Rounds of the iteration; it converges within some tens.
const ROUNDS: usize = 200;

/// The roots of a polynomial, highest power first: all at once by the iteration of Weierstrass (1891), Durand and Kerner.
pub(crate) fn roots(polynomial: &[Complex]) -> Vec<Complex> {
    let monic: Vec<Complex> = polynomial.iter().map(|coefficient| coefficient / polynomial[0]).collect();
    let mut roots: Vec<Complex> = Vec::new();
    for _ in 1..monic.len() {
        roots.push(roots.last().copied().unwrap_or(Complex::ONE) * Complex::new(0.4, 0.9));
    }
    for _ in 0..ROUNDS {
        for i in 0..roots.len() {
            let at = roots[i];
            let value = monic.iter().fold(Complex::ZERO, |sum, coefficient| sum * at + coefficient);
            let others = roots.iter().enumerate().filter(|(j, _)| *j != i);
            let slope = others.fold(Complex::ONE, |slope, (_, other)| slope * (at - other));
            if slope.modulus() > 0.0 {
                roots[i] = at - value / slope;
            }
        }
    }
    roots
}

/// The formulas of Adams and Bashforth, and of Störmer, at the latest point first.
const BASHFORTH: [f64; 4] = [55.0, -59.0, 37.0, -9.0];
const STOERMER: [f64; 4] = [14.0, -5.0, 4.0, -1.0];

/// The multistep methods of the picture, by their names in the table of methods.
pub(crate) const METHODS: [&str; 4] = ["Adams–Bashforth 4", "Adams–Bashforth–Moulton 4", "Adams PEC 4", "Störmer 4"];

/// The characteristic polynomial of a method on an oscillator with `hω = x`, whose exact solution is multiplied by `exp(ix)` in each
/// step (Hairer, Nørsett and Wanner 1993, section III.3). With `μ = ix/24`:
///
/// - Adams and Bashforth: `ζ⁴ − ζ³ = μ B(ζ)`;
/// - with Moulton's corrector, evaluated again (PECE): `ζ⁴ − ζ³ = μ (9 (ζ³ + μ B) + 19 ζ³ − 5 ζ² + ζ)`;
/// - with the predicted force (PEC): `(ζ − 1)(ζ⁴ − μ B) = μ ζ (9 ζ³ + 19 ζ² − 5 ζ + 1)`;
/// - Störmer, of `q'' = −ω² q`: `ζ⁴ − 2 ζ³ + ζ² + x²/12 (14 ζ³ − 5 ζ² + 4 ζ − 1) = 0`.
pub(crate) fn characteristic(method: &str, x: f64) -> Option<Vec<Complex>> {
    let real = |numbers: [f64; 5]| numbers.map(Complex::from).to_vec();
    let mu = Complex::new(0.0, x / 24.0);
    let back = -mu;
    let mut polynomial = real([1.0, -1.0, 0.0, 0.0, 0.0]);
    match METHODS.iter().position(|name| *name == method)? {
        0 => add(&mut polynomial, back, &BASHFORTH),
        1 => {
            add(&mut polynomial, back, &[28.0, -5.0, 1.0, 0.0]);
            add(&mut polynomial, back * mu * 9.0, &BASHFORTH);
        }
        2 => {
            let mut predicted = real([1.0, 0.0, 0.0, 0.0, 0.0]);
            add(&mut predicted, back, &BASHFORTH);
            polynomial = product(&[Complex::ONE, -Complex::ONE], &predicted);
            add(&mut polynomial, back, &[9.0, 19.0, -5.0, 1.0, 0.0]);
        }
        _ => {
            polynomial = real([1.0, -2.0, 1.0, 0.0, 0.0]);
            add(&mut polynomial, (x * x / 12.0).into(), &STOERMER);
        }
    }
    Some(polynomial)
}

/// The roots of a method: those that follow the motion first, then the parasitic ones, largest first. Störmer's formula is real and
/// follows the motion in both senses.
pub(crate) fn sorted(method: &str, x: f64) -> Option<(Vec<Complex>, Vec<Complex>)> {
    let mut all = roots(&characteristic(method, x)?);
    let count = if method == METHODS[3] { 2 } else { 1 };
    let away = |root: &Complex| {
        let [there, back] = [x, -x].map(|angle| (root - turned(angle)).modulus());
        if count == 2 { there.min(back) } else { there }
    };
    all.sort_by(|a, b| away(a).total_cmp(&away(b)));
    let mut parasitic = all.split_off(count);
    parasitic.sort_by(|a, b| b.modulus().total_cmp(&a.modulus()));
    Some((all, parasitic))
}

#[cfg(test)]
mod tests {
    use super::{Complex, characteristic, roots, turned};
    use nalgebra::ComplexField;

    #[test]
    fn roots_are_those_of_known_polynomials() {
        // (z - 1)(z - 2)(z - i) = z³ − (3 + i) z² + (2 + 3i) z − 2i.
        let of = |numbers: &[[f64; 2]]| numbers.iter().map(|[re, im]| Complex::new(*re, *im)).collect::<Vec<_>>();
        let found = roots(&of(&[[1.0, 0.0], [-3.0, -1.0], [2.0, 3.0], [0.0, -2.0]]));
        for exact in of(&[[1.0, 0.0], [2.0, 0.0], [0.0, 1.0]]) {
            assert!(found.iter().any(|root| (root - exact).modulus() < 1e-12), "{found:?}");
        }
        // The fifth roots of one.
        let found = roots(&of(&[[1.0, 0.0], [0.0; 2], [0.0; 2], [0.0; 2], [0.0; 2], [-1.0, 0.0]]));
        for k in 0..5 {
            let exact = turned(std::f64::consts::TAU * f64::from(k) / 5.0);
            assert!(found.iter().any(|root| (root - exact).modulus() < 1e-12), "{found:?}");
        }
        assert_eq!(characteristic("Verlet", 0.1), None);
    }
}
