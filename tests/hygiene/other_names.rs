//! Compositions of the user under names that the macro knows from elsewhere: as items of this module, of another one, of a
//! function, and as other names for those of the catalogue.

use integrator_core::{Verlet as StoermerVerlet, prelude::*};
use methods::*;

/// Compositions in a module of their own.
pub mod methods {
    use integrator_core::prelude::*;

    composition! {
        /// Kick, drift.
        pub struct SymplecticEuler: order 1 = V(1) T(1);
    }
}

composition! {
    /// Kick, drift, kick.
    pub struct Leapfrog: order 2 = V(1/2) T(1) V(1/2);
}

/// A name of a type alone.
pub type ForestRuth = Yoshida4;

macro_rules! pendulum {
    ($($visible:vis $name:ident by $compose:ident),*) => {
        $(
            /// A pendulum.
            $visible struct $name;

            #[hamiltonian(compose = $compose)]
            impl $name {
                fn kinetic(&self, p: [f64; 1]) -> f64 {
                    0.5 * p[0] * p[0]
                }
                fn potential(&self, q: [f64; 1]) -> f64 {
                    -q[0].cos()
                }
            }
        )*
    };
}
pendulum!(pub ByItem by Leapfrog, pub ByGlob by SymplecticEuler, pub ByRename by StoermerVerlet, pub ByAlias by ForestRuth);

/// The order of the annotated composition.
fn order<H: Hamiltonian<Compose: Scheme>>() -> u32 {
    H::Compose::ORDER
}

#[test]
fn items_of_the_user_hide_other_names() {
    composition! {
        pub struct RungeKutta4: order 2 = T(1/2) V(1) T(1/2);
    }
    pendulum!(Local by RungeKutta4, OfModule by Leapfrog);
    assert_eq!([order::<ByItem>(), order::<ByGlob>(), order::<ByRename>(), order::<ByAlias>()], [2, 1, 2, 4]);
    assert_eq!([order::<Local>(), order::<OfModule>()], [2, 2]);
}
