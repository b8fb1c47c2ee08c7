//! Hamiltonians from the literature, as their users would write them, and what the generated steppers make of them.
//!
//! Every gradient is derived three times: by the macro, by dual numbers through a twin of the formula, and by
//! `reference.py` with fifty digits. The twins and the reference were written from the formulas, not from each other.
//! All of it holds on every instruction set; [`instruction_sets`] starts a process for each of the others.

mod accelerator;
mod central;
mod chains;
mod clusters;
mod galactic;
mod henon_heiles;
#[path = "../support/instruction_sets.rs"]
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

/// One test per system; its name is that of the system in the reference.
macro_rules! corpus {
    ($($name:ident: $system:ty,)*) => {
        $(#[test]
        fn $name() {
            verdict::judge::<$system>(stringify!($name));
        })*

        #[test]
        fn the_reference_knows_the_same_systems() {
            let mut names = [$(stringify!($name)),*];
            names.sort();
            assert_eq!(reference::names(), names);
        }
    };
}

corpus! {
    henon_heiles: henon_heiles::HenonHeiles,

    fput_alpha: chains::FputAlpha,
    fput_beta: chains::FputBeta,
    toda: chains::Toda<5>,
    frenkel_kontorova: chains::FrenkelKontorova,
    peyrard_bishop: chains::PeyrardBishop,
    diatomic: chains::Diatomic,
    hertz_beads: chains::HertzBeads,

    mean_field: rotors::MeanField,
    long_range: rotors::LongRange,
    sine_gordon: rotors::SineGordon,
    geared_pendula: rotors::GearedPendula,
    free_top: rotors::FreeTop,

    phi_four: lattices::PhiFour,
    planar_spins: lattices::PlanarSpins,
    network: lattices::Network,
    dimers: lattices::Dimers<f64>,
    membrane: lattices::Membrane<'static, 4>,

    lennard_jones: clusters::LennardJones,
    morse: clusters::Morse,
    colloids: clusters::Colloids,
    bond_angles: clusters::BondAngles,

    gravity: many_body::Gravity,
    three_bodies: many_body::ThreeBodies,
    coulomb_crystal: many_body::CoulombCrystal,
    calogero_moser: many_body::CalogeroMoser,
    sutherland: many_body::Sutherland<4>,
    sheets: many_body::Sheets,

    kepler: central::Kepler,
    anisotropic_kepler: central::AnisotropicKepler,
    quarkonium: central::Quarkonium,
    kratzer: central::Kratzer,
    fixed_centres: central::FixedCentres,
    spring_pendulum: central::SpringPendulum,
    soft_box: central::SoftBox,

    duffing: wells::Duffing,
    morse_bond: wells::MorseBond,
    rosen_morse: wells::RosenMorse,
    walls: wells::Walls,
    woods_saxon: wells::WoodsSaxon,
    finite_spring: wells::FiniteSpring,
    magnet: wells::Magnet,
    andreev_contact: wells::AndreevContact,
    slow: wells::Slow,
    elliptic: wells::Elliptic,
    tabulated: tabulated::Tabulated,

    logarithmic: galactic::Logarithmic,
    miyamoto_nagai: galactic::MiyamotoNagai,
    plummer: galactic::Plummer,
    hernquist: galactic::Hernquist,
    navarro_frenk_white: galactic::NavarroFrenkWhite,
    isochrone: galactic::Isochrone,
    rotating_bar: galactic::RotatingBar,

    paul_trap: traps::PaulTrap,
    driven_pendulum: traps::DrivenPendulum,
    kapitza: traps::Kapitza,
    two_waves: traps::TwoWaves,
    growing_mass: traps::GrowingMass,
    ramped_lattice: traps::RampedLattice,

    focusing_channel: accelerator::FocusingChannel,
    bucket: accelerator::Bucket,
    exact_drift: accelerator::ExactDrift,
    relativistic: accelerator::Relativistic,
    massless: accelerator::Massless,
    bloch: accelerator::Bloch,
    coupled_rotors: accelerator::CoupledRotors,

    logistic: statistics::Logistic,
    poisson: statistics::Poisson,
    funnel: statistics::Funnel,
    rosenbrock: statistics::Rosenbrock,
    mixture: statistics::Mixture,
    schools: statistics::Schools,
    student: statistics::Student,
    heavy_tails: statistics::HeavyTails,
}
