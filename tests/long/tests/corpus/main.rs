//! Hamiltonians from the literature, as users would write them, and tests of the code generated for them.
//!
//! Every gradient is computed three times: by the macro, by dual numbers applied to a second version of the formula,
//! and by `reference.py` with fifty digits. The second version and the reference were written independently. With the
//! feature `long`, tests run on every instruction set: `instruction_sets` starts a process for each of the others. Certificates
//! are measured on one set.

mod accelerator;
mod central;
mod chains;
mod clusters;
mod galactic;
mod henon_heiles;
#[cfg(feature = "long")]
#[path = "../../../support/instruction_sets.rs"]
mod instruction_sets;
mod lattices;
mod many_body;
mod member;
mod reference;
mod rotors;
mod statistics;
mod tabulated;
mod traps;
mod verdict;
mod wells;

use integrator_core::prelude::{Chin4A, Verlet, Yoshida4};

/// Two tests per system, named like the system in the reference: one of the generated code and one of its certificate.
///
/// The method after a system is the one that `certify` is tested with. For a quadratic `T` this is mostly `Chin4A`,
/// which has order 4 only if the generated second derivatives are right. Systems below the line repeat a layout and a
/// kind of function from above it; they need the feature `long`.
macro_rules! corpus {
    ($($name:ident: $system:ty, $method:ident;)* --- $($more:ident: $more_system:ty, $more_method:ident;)*) => {
        $(#[test]
        fn $name() {
            verdict::judge::<$system>(stringify!($name));
        })*

        $(#[cfg(feature = "long")]
        #[test]
        fn $more() {
            verdict::judge::<$more_system>(stringify!($more));
        })*

        /// The name is one of those that `instruction_sets` leaves out.
        mod certified {
            use super::*;

            $(#[test]
            fn $name() {
                verdict::certified::<$system, _>(stringify!($name), $method);
            })*

            $(#[cfg(feature = "long")]
            #[test]
            fn $more() {
                verdict::certified::<$more_system, _>(stringify!($more), $more_method);
            })*
        }

        #[test]
        fn the_reference_knows_the_same_systems() {
            let mut names = [$(stringify!($name),)* $(stringify!($more),)*];
            names.sort();
            assert_eq!(reference::names(), names);
        }
    };
}

corpus! {
    henon_heiles: henon_heiles::HenonHeiles, Yoshida4;
    fput_alpha: chains::FputAlpha, Chin4A;
    toda: chains::Toda<5>, Yoshida4;
    // The third derivative of the contact law is infinite where beads separate.
    hertz_beads: chains::HertzBeads, Verlet;
    mean_field: rotors::MeanField, Yoshida4;
    free_top: rotors::FreeTop, Yoshida4;
    planar_spins: lattices::PlanarSpins, Chin4A;
    network: lattices::Network, Yoshida4;
    membrane: lattices::Membrane<'static, 4>, Chin4A;
    lennard_jones: clusters::LennardJones, Yoshida4;
    bond_angles: clusters::BondAngles, Chin4A;
    gravity: many_body::Gravity, Chin4A;
    three_bodies: many_body::ThreeBodies, Yoshida4;
    coulomb_crystal: many_body::CoulombCrystal, Chin4A;
    sheets: many_body::Sheets, Yoshida4;
    kepler: central::Kepler, Chin4A;
    // The slope of the force jumps at the walls.
    soft_box: central::SoftBox, Verlet;
    duffing: wells::Duffing, Yoshida4;
    // The second derivative of the spline jumps between cells.
    tabulated: tabulated::Tabulated, Verlet;
    rotating_bar: galactic::RotatingBar, Chin4A;
    growing_mass: traps::GrowingMass, Yoshida4;
    // The second derivative of the ramp jumps at its end.
    ramped_lattice: traps::RampedLattice, Verlet;
    exact_drift: accelerator::ExactDrift, Yoshida4;
    massless: accelerator::Massless, Yoshida4;
    logistic: statistics::Logistic, Yoshida4;
    funnel: statistics::Funnel, Chin4A;
    mixture: statistics::Mixture, Chin4A;
    ---
    fput_beta: chains::FputBeta, Chin4A;
    frenkel_kontorova: chains::FrenkelKontorova, Chin4A;
    peyrard_bishop: chains::PeyrardBishop, Chin4A;
    diatomic: chains::Diatomic, Chin4A;
    long_range: rotors::LongRange, Chin4A;
    sine_gordon: rotors::SineGordon, Chin4A;
    geared_pendula: rotors::GearedPendula, Chin4A;
    phi_four: lattices::PhiFour, Chin4A;
    dimers: lattices::Dimers<f64>, Chin4A;
    morse: clusters::Morse, Chin4A;
    // The slope of the force jumps at the cutoff.
    colloids: clusters::Colloids, Verlet;
    calogero_moser: many_body::CalogeroMoser, Chin4A;
    sutherland: many_body::Sutherland<4>, Chin4A;
    anisotropic_kepler: central::AnisotropicKepler, Chin4A;
    quarkonium: central::Quarkonium, Chin4A;
    kratzer: central::Kratzer, Chin4A;
    fixed_centres: central::FixedCentres, Chin4A;
    spring_pendulum: central::SpringPendulum, Chin4A;
    morse_bond: wells::MorseBond, Chin4A;
    rosen_morse: wells::RosenMorse, Chin4A;
    walls: wells::Walls, Chin4A;
    woods_saxon: wells::WoodsSaxon, Chin4A;
    finite_spring: wells::FiniteSpring, Chin4A;
    magnet: wells::Magnet, Chin4A;
    andreev_contact: wells::AndreevContact, Chin4A;
    slow: wells::Slow, Chin4A;
    elliptic: wells::Elliptic, Chin4A;
    logarithmic: galactic::Logarithmic, Chin4A;
    miyamoto_nagai: galactic::MiyamotoNagai, Chin4A;
    plummer: galactic::Plummer, Chin4A;
    hernquist: galactic::Hernquist, Chin4A;
    navarro_frenk_white: galactic::NavarroFrenkWhite, Chin4A;
    isochrone: galactic::Isochrone, Chin4A;
    paul_trap: traps::PaulTrap, Chin4A;
    driven_pendulum: traps::DrivenPendulum, Chin4A;
    kapitza: traps::Kapitza, Chin4A;
    two_waves: traps::TwoWaves, Chin4A;
    focusing_channel: accelerator::FocusingChannel, Chin4A;
    bucket: accelerator::Bucket, Chin4A;
    relativistic: accelerator::Relativistic, Yoshida4;
    bloch: accelerator::Bloch, Yoshida4;
    coupled_rotors: accelerator::CoupledRotors, Yoshida4;
    poisson: statistics::Poisson, Chin4A;
    rosenbrock: statistics::Rosenbrock, Chin4A;
    schools: statistics::Schools, Chin4A;
    student: statistics::Student, Chin4A;
    heavy_tails: statistics::HeavyTails, Chin4A;
}
