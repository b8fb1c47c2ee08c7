//! Symplecticity: whether a step preserves the symplectic form.
//!
//! In: a system, a method, a point, a step. Out: by how much `Mᵀ J M` differs from `J = (0 1; -1 0)`, where `M` is
//! the exact tangent map. Always true: zero up to rounding for every composition of exact flows, whatever its order and
//! however coarse the step; of the size of the step for a map that is not symplectic.

use crate::{
    check::{
        CheckError,
        oracle::tangent::{Tangents, matrix},
        start::{IntoStart, Start},
        statistics::points::begin,
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::largest,
    state::{coords::Coords, flat::flat, precision::Precision},
    system::Shaped,
    trajectory::method::Method,
};
use nalgebra::DMatrix;

/// Returns the symplectic defect of one closed step of size `h` from `start`: the largest entry of `Mᵀ J M - J` for the
/// exact tangent map `M`.
///
/// Entries are measured in units that balance `M`: each pair `(qᵢ, pᵢ)` becomes `(qᵢ/s, s·pᵢ)`. The factor `s` is a
/// power of two for which neither force nor velocity dominates. This change of units is symplectic, so it does not
/// change the conclusion, but large units no longer hide small ones.
///
/// The result is an absolute error without a unit. It is NaN or infinite if the step overflows. For `n` positions the
/// cost is `2n` steps in dual numbers and a product of matrices of that size.
///
/// # Errors
/// The start or the step is invalid for a run.
pub fn symplectic_defect<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
) -> Result<f64, CheckError> {
    symplectic_defect_after::<H, X, K>(system, method, start, h, 1)
}

/// Returns the [`symplectic_defect`] of `steps` consecutive steps. Rounding makes it grow with the number of steps.
///
/// # Errors
/// The errors of [`symplectic_defect`].
pub fn symplectic_defect_after<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<f64, CheckError> {
    Ok(defect::<H, X, K>(system, method, &start.into_start(), h, steps)?.size)
}

/// Returns the Poisson bracket `{qᵢ, pᵢ}` of the state after one closed step of size `h`, with respect to `start`.
///
/// The bracket is `Σₖ ∂qᵢ'/∂qₖ ∂pᵢ'/∂pₖ - ∂qᵢ'/∂pₖ ∂pᵢ'/∂qₖ`, computed from the exact tangent map. It is 1 for a
/// symplectic step, up to rounding. In one degree of freedom it is the factor by which a step changes areas. `i` counts
/// the coordinates in their flattened form.
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The index is out of range.
pub fn poisson_bracket<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    index: usize,
) -> Result<f64, CheckError> {
    let Start { phase: start, time } = begin::<H, X, K>(system, method, &start.into_start(), h)?;
    let coordinates = start.q.flat().len();
    let map = TangentMap(matrix(&Tangents::<H, X>::new(system, method, &start, h), &flat(&start), time, 1));
    map.bracket(index).ok_or(CheckError::NoCoordinate { index, coordinates })
}

/// The tangent map of closed steps: the derivative of the final state by the initial state.
///
/// Rows and columns are all of `q`, then all of `p`, in their flattened form.
#[derive(Clone, Debug, PartialEq)]
pub struct TangentMap(DMatrix<f64>);

impl TangentMap {
    /// Returns the rows of the matrix.
    pub fn matrix(&self) -> Vec<Vec<f64>> {
        self.0.row_iter().map(|row| row.iter().copied().collect()).collect()
    }

    /// Returns the determinant: the factor by which the steps change volumes. It is 1 for a symplectic map, up to
    /// rounding.
    pub fn determinant(&self) -> f64 {
        self.0.determinant()
    }

    /// Returns the Poisson bracket `{qᵢ, pᵢ}` as in [`poisson_bracket`], or `None` if the index is out of range.
    pub fn bracket(&self, index: usize) -> Option<f64> {
        let n = self.0.nrows() / 2;
        let (q, p) = (index < n).then(|| (self.0.row(index), self.0.row(n + index)))?;
        Some((0..n).map(|k| q[k] * p[n + k] - q[n + k] * p[k]).sum())
    }
}

/// Computes the tangent maps of 1, 2, ... `steps` closed steps of size `h` from `start`, exact up to rounding.
///
/// They are the derivatives of the steps of a run. For `n` positions the cost is `2n` times the steps in dual numbers,
/// and `4n²` numbers for each step.
///
/// ```
/// use integrator_core::{check::tangent_maps, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// }
///
/// let maps = tangent_maps(&Pendulum, Verlet, Phase::new([2.0], [0.0]), 0.1, 100)?;
/// for map in &maps {
///     assert!((map.determinant() - 1.0).abs() < 1e-11);
/// }
/// // What has become of a deviation of the position.
/// assert_eq!(maps[99].matrix().len(), 2);
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// The start or the step is invalid for a run. If steps overflow, their maps are not finite; this is not an error.
pub fn tangent_maps<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: usize,
) -> Result<Vec<TangentMap>, CheckError> {
    let Start { phase: start, time } = begin::<H, X, K>(system, method, &start.into_start(), h)?;
    let maps = Tangents::<H, X>::new(system, method, &start, h).matrices(&flat(&start), time, steps);
    Ok(maps.into_iter().map(TangentMap).collect())
}

/// The symplectic defect of a tangent map, and the one that rounding alone explains.
pub(crate) struct Defect {
    pub(crate) size: f64,
    pub(crate) tolerance: f64,
}

/// The defect of `steps` steps and its tolerance.
///
/// Each flow is a shear `1 + S` whose entries come out with a relative error of a few ε, 4 with the chain rule of the
/// elementary functions. To first order the errors of all `f` flows of the steps add up, each carried to the end by the
/// flows that follow, so that `|δM| ≤ 4 f ε |M|` as long as no part of a step stretches tangents more than the whole of
/// it, and `|δ(Mᵀ J M)| ≤ 8 f ε |M|ᵀ |J| |M|`. The scalar products of length 2n add `2n ε` of the same matrix. Parts of
/// a step do stretch more where a composition goes forth and back inside of it, which a further factor 4 allows for:
/// over the whole catalogue and up to h·ω = 4 no defect reached a thirtieth of the tolerance.
pub(crate) fn defect<H: Hamiltonian, X: Method<H>, K: Precision>(
    system: &H,
    method: X,
    start: &Start<Shaped<H, K>>,
    h: f64,
    steps: u64,
) -> Result<Defect, CheckError> {
    let Start { phase: start, time } = begin::<H, X, K>(system, method, start, h)?;
    let map = matrix(&Tangents::<H, X>::new(system, method, &start, h), &flat(&start), time, steps);
    Ok(defect_of(map, method.facts().roundings_in(steps.max(1)) * H::TANGENT_ERROR))
}

/// The defect of a tangent map whose steps round the state so often.
pub(crate) fn defect_of(mut map: DMatrix<f64>, roundings: f64) -> Defect {
    balance(&mut map);
    let n = map.nrows() / 2;
    let size = largest((form(&map) - form(&DMatrix::identity(2 * n, 2 * n))).iter().copied());
    let amplification = largest(absolute_form(&map).iter().copied());
    Defect { size, tolerance: (32.0 * roundings + 2.0 * n as f64) * f64::EPSILON * amplification }
}

/// `Mᵀ J M`: with the rows of `M` split into those of `q` and those of `p`, `Qᵀ P` less its transpose.
fn form(map: &DMatrix<f64>) -> DMatrix<f64> {
    let n = map.nrows() / 2;
    let half = map.rows(0, n).tr_mul(&map.rows(n, n));
    &half - half.transpose()
}

/// `|M|ᵀ |J| |M|`, the sizes of the terms that cancel in [`form`].
fn absolute_form(map: &DMatrix<f64>) -> DMatrix<f64> {
    let map = map.abs();
    let n = map.nrows() / 2;
    let half = map.rows(0, n).tr_mul(&map.rows(n, n));
    &half + half.transpose()
}

/// Measures each pair `(q, p)` as `(q/s, s·p)`, so that the largest entry of `∂q/∂p` in a row equals the largest entry
/// of `∂p/∂q` in its partner row, within the powers of two that keep this free of rounding.
fn balance(map: &mut DMatrix<f64>) {
    // A row depends on the units of its partners in other pairs, so that a few sweeps are needed; what is left after
    // four of them only makes the tolerance wider than it has to be.
    const SWEEPS: usize = 4;
    let n = map.nrows() / 2;
    for _ in 0..SWEEPS {
        for pair in 0..n {
            let velocity = largest(map.view((pair, n), (1, n)).iter().copied());
            let force = largest(map.view((n + pair, 0), (1, n)).iter().copied());
            let exponent = (velocity / force).log2() / 4.0;
            if exponent.is_finite() {
                let unit = exponent.round().exp2();
                map.row_mut(pair).unscale_mut(unit);
                map.column_mut(n + pair).unscale_mut(unit);
                map.row_mut(n + pair).scale_mut(unit);
                map.column_mut(pair).scale_mut(unit);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::tolerance::within;

    fn rows<const N: usize>(rows: [[f64; N]; N]) -> DMatrix<f64> {
        DMatrix::from_row_slice(N, N, rows.as_flattened())
    }

    /// The defect of a map, in balanced units.
    fn size(mut map: DMatrix<f64>) -> f64 {
        balance(&mut map);
        let identity = DMatrix::identity(map.nrows(), map.nrows());
        largest((form(&map) - form(&identity)).iter().copied())
    }

    #[test]
    fn a_shear_is_symplectic_and_a_stretch_is_not() {
        assert_eq!(size(rows([[1.0, 0.5], [0.0, 1.0]]) * rows([[1.0, 0.0], [-0.25, 1.0]])), 0.0);
        assert_eq!(size(rows([[2.0, 0.0], [0.0, 1.0]])), 1.0);
        assert!(size(rows([[1.0, f64::NAN], [0.0, 1.0]])).is_nan());
    }

    #[test]
    fn units_neither_make_a_defect_nor_hide_one() {
        // Two bodies, a light and a heavy one, that pull on each other: q gains p/m, then p gains the force.
        let (light, heavy, stiffness) = (1e-9, 1e3, 3e-7);
        let drift = |m: f64| 0.1 / m;
        let drift = rows([
            [1.0, 0.0, drift(light), 0.0],
            [0.0, 1.0, 0.0, drift(heavy)],
            [0.0, 0.0, 1.0, 0.0],
            [0.0, 0.0, 0.0, 1.0],
        ]);
        let kick = |on_light: f64| {
            let force = 0.1 * stiffness;
            rows([
                [1.0, 0.0, 0.0, 0.0],
                [0.0, 1.0, 0.0, 0.0],
                [-force, on_light * force, 1.0, 0.0],
                [force, -force, 0.0, 1.0],
            ])
        };
        // A hundredth is the square of the step, 0.1, times that of a frequency of about one.
        assert!(within(size(&kick(1.0) * &drift), 8.0 * f64::EPSILON));
        assert!(size(&kick(1.01) * &drift) > 1e-9, "a force without its reaction is no gradient");
    }
}
