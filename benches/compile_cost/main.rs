//! What a user does with one system, by features: each is a cell of the table.

#[cfg_attr(feature = "pendulum", path = "pendulum.rs")]
#[cfg_attr(feature = "chain", path = "chain.rs")]
#[cfg_attr(feature = "bodies", path = "bodies.rs")]
#[cfg_attr(feature = "planets", path = "planets.rs")]
#[cfg_attr(feature = "oscillators", path = "oscillators.rs")]
#[cfg_attr(feature = "orbits", path = "orbits.rs")]
#[cfg_attr(feature = "liquid", path = "liquid.rs")]
#[cfg_attr(feature = "molecule", path = "molecule.rs")]
mod user;

use integrator_core::prelude::*;
use user::{start, system};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    macro_rules! run {
        ($($method:expr),*) => {$(
            let mut run = system().run_with($method, start(), 0.01)?;
            run.advance(1000)?;
            println!("{:?} {}", run.state(), run.energy());
        )*};
    }
    #[cfg(not(any(feature = "five", feature = "taylor")))]
    run!(Verlet);
    #[cfg(feature = "five")]
    run!(Verlet, Yoshida4, BlanesMoan6, KahanLi8, Euler);
    #[cfg(feature = "taylor")]
    run!(integrator_core::taylor::Taylor::tolerance(1e-16));
    #[cfg(feature = "certify")]
    println!("{}", certify(&system(), Verlet, start(), 0.01)?);
    #[cfg(feature = "ensemble")]
    {
        let mut ensemble = Ensemble::new(Verlet, [(system(), start()), (system(), start())], 0.01)?;
        ensemble.advance(1000)?;
        println!("{:?}", ensemble.state(1));
    }
    Ok(())
}
