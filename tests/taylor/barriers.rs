//! Barriers whose force is tiny where the motion begins: steps are not so long that they pass it.

use integrator_core::{Error, prelude::*, taylor::Taylor};

macro_rules! barriers {
    ($($name:ident: |$x:ident| $energy:expr;)*) => {
        $(
            struct $name;

            #[hamiltonian(taylor)]
            impl $name {
                fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }
                fn potential(&self, [$x]: [f64; 1]) -> f64 { $energy }
            }
        )*

        /// The speed of a reflected particle is that of the incoming one, as the energy is.
        #[test]
        fn a_barrier_reflects_what_comes_from_afar() -> Result<(), Error> {
            $(
                for from in [5.0, 10.0, 15.0, 20.0, 25.0, 26.5] {
                    for intervals in [1_u32, 100] {
                        let start = Phase::new([from], [-0.5]);
                        let mut run = $name.run_with(Taylor::tolerance(1e-16), start, 4.0 * from / f64::from(intervals))?;
                        run.advance(u64::from(intervals))?;
                        let Phase { q: [q], p: [p] } = run.state();
                        let speed = (0.25 + 2.0 * ($name.potential(start.q) - $name.potential([q]))).sqrt();
                        // Errors are within a hundred tolerances.
                        assert!(q > 0.0 && (p - speed).abs() < 1e-14, "{} from {from}: {q}, {p}", stringify!($name));
                    }
                }
            )*
            Ok(())
        }
    };
}

barriers! {
    Gaussian: |x| (-x * x).exp();
    Secant: |x| 1.0 / x.cosh().powi(2);
    Step: |x| 2.0 / (1.0 + x.exp());
    PowerLaw: |x| 1.0 / x.powi(12);
    BesideAnotherForce: |x| (-x * x).exp() + 1e-3 * x;
}
