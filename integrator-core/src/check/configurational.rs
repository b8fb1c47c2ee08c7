//! The configurational temperature: forces and curvatures of a potential.

use crate::{
    hamiltonian::Hamiltonian,
    scalar::dual::Dual,
    state::{coords::Coords, phase::Phase},
    system::motion::Motion,
};

/// The square of the force and the Laplacian of the potential at a state.
///
/// In equilibrium at the temperature `kT`, `⟨|∇V|²⟩ = kT ⟨ΔV⟩`: the ratio of the means is the configurational temperature (H. H.
/// Rugh, Phys. Rev. Lett. 78, 772, 1997). It depends on positions alone, whereas
/// [`Run::kinetic_temperature`](crate::Run::kinetic_temperature) depends on momenta alone. A difference shows the bias of a step
/// that is too large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Configurational {
    /// `|∇V|²`, the sum of the squares of all forces.
    pub squared_force: f64,
    /// `ΔV`, the sum of the second derivatives by each coordinate.
    pub laplacian: f64,
}

/// Computes the square of the force and the Laplacian of the potential at a state, by exact derivatives of the generated forces.
///
/// The cost is that of two force evaluations for each coordinate. Returns `None` if `H` is not `T(p) + V(q)`.
///
/// ```
/// use integrator_core::{check::configurational, prelude::*};
///
/// struct Rotor;
///
/// #[hamiltonian]
/// impl Rotor {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// }
///
/// let found = configurational(&Rotor, &Phase::new([0.5], [0.0]), 0.0).expect("T + V");
/// assert!((found.squared_force - 0.5_f64.sin().powi(2)).abs() < 1e-15);
/// assert!((found.laplacian - 0.5_f64.cos()).abs() < 1e-15);
/// ```
#[must_use]
pub fn configurational<H: Hamiltonian>(system: &H, state: &Phase<H::Coords>, time: f64) -> Option<Configurational> {
    if const { !H::SEPARABLE } {
        return None;
    }
    let parameters = system.parameters(state.q.length());
    let mut start = state.clone();
    start.p.flat_mut().fill(0.0);
    let nothing = Phase { q: start.p.clone(), p: start.p.clone() };
    let mut found = Configurational { squared_force: 0.0, laplacian: 0.0 };
    for coordinate in 0..start.q.flat().len() {
        let mut direction = nothing.clone();
        direction.q.flat_mut()[coordinate] = 1.0;
        // A kick of duration 1 from momenta of zero: they are the forces, and their derivatives along the direction.
        let mut motion = H::Motion::<Dual, f64>::load(&[&parameters; 2], &[&start, &direction]);
        H::kick::<Dual, f64>(&mut motion, 1.0, time);
        let mut end = nothing.clone();
        if coordinate == 0 {
            motion.store(0, &mut end);
            found.squared_force = end.p.flat().iter().map(|force| force * force).sum();
        }
        motion.store(1, &mut end);
        found.laplacian -= end.p.flat()[coordinate];
    }
    Some(found)
}
