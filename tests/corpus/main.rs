//! Hamiltonians from the literature, as their users would write them, and what the generated steppers make of them.
//!
//! Every gradient is derived three times: by the macro, by dual numbers through a twin of the formula, and by
//! `reference.py` with fifty digits. The twins and the reference were written from the formulas, not from each other.

mod chains;
mod galactic;
mod henon_heiles;
mod member;
mod reference;
mod verdict;

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

    logarithmic: galactic::Logarithmic,
    miyamoto_nagai: galactic::MiyamotoNagai,
    plummer: galactic::Plummer,
    hernquist: galactic::Hernquist,
    navarro_frenk_white: galactic::NavarroFrenkWhite,
    isochrone: galactic::Isochrone,
    rotating_bar: galactic::RotatingBar,
}
