//! Conducts heat through chains of oscillators between a hot and a cold bath.
//!
//! The rate of the friction is a function of the site: it is zero except at both ends, where the temperatures differ. Independent
//! copies of the chain are an ensemble, so each mean has a standard error. The program prints for two chains the heat current, the
//! conductivity and the largest error of the temperatures:
//!
//! - Springs alone carry heat without resistance. Current and temperatures have a closed form (Rieder, Lebowitz and Lieb, J. Math.
//!   Phys. 8, 1073, 1967). The temperature is constant in the bulk, so there is no conductivity.
//! - With a pinning `q⁴/4` of each site, the temperature falls linearly. The conductivity at a temperature `T` is `2.83 T^-1.35` (Aoki
//!   and Kusnezov, Phys. Lett. A 265, 250, 2000).
//!
//! The picture `heat_conduction.png` shows the temperatures of both chains.

mod conductor;
mod picture;
#[path = "../support/mod.rs"]
#[allow(dead_code, reason = "other examples show how far they are")]
mod support;

use conductor::{Chain, harmonic, stationary};
use integrator_plot::write;
use picture::picture;
use std::error::Error;
use support::folder;

const COPIES: usize = 32;

fn main() -> Result<(), Box<dyn Error>> {
    // Long waves in springs alone hardly reach the baths: they settle in a time that grows with the cube of the length.
    let springs = Chain { sites: 16, pinning: 0.0, rate: 1.0, baths: [1.4, 0.6] };
    let pinned = Chain { sites: 32, pinning: 1.0, ..springs };
    let [without, with] = [springs, pinned].map(|chain| stationary(chain, COPIES, 10_000, 20_000));
    let (without, with, (current, temperatures)) = (without?, with?, harmonic(springs));
    let file = folder().join("heat_conduction");
    write(&file, &picture(&without, &temperatures, &with))?;
    println!("the picture is {}", file.with_extension("png").display());
    println!("current_harmonic={:.4} ± {:.4}", without.current.value, without.current.error);
    println!("current_harmonic_closed_form={current:.4}");
    let errors = without.temperatures.iter().zip(&temperatures).map(|(mean, exact)| (mean.value - exact).abs());
    println!("temperature_error_harmonic_max={:.4}", errors.fold(0.0, f64::max));
    println!("current_pinned={:.4} ± {:.4}", with.current.value, with.current.error);
    println!("conductivity_pinned={:.3} ± {:.3}", with.conductivity.value, with.conductivity.error);
    println!("conductivity_of_Aoki_and_Kusnezov=2.83");
    Ok(())
}
