//! The generated code is held against the user's own functions, whose text may have been misread and whose stated
//! derivatives may be wrong.

use crate::systems::{Misread, MisreadWhole};
use integrator_core::{
    Error,
    check::{Certificate, CertifyError, Shortfall, certify},
    prelude::*,
};

/// A pendulum whose cosine comes with stated derivatives, which may be a little wrong.
#[derive(Clone)]
struct Tabulated {
    slope: f64,
    curvature: f64,
    inertia: f64,
}

#[hamiltonian]
impl Tabulated {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        self.speed(p[0]) + 0.5 * p[1] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        self.table(q[0]) + 0.5 * q[1] * q[1] + 0.1 * q[0] * q[1]
    }
    #[derivative(table_slope)]
    fn table(&self, x: f64) -> f64 {
        -x.cos()
    }
    #[derivative(table_curvature)]
    fn table_slope(&self, x: f64) -> f64 {
        self.slope * x.sin()
    }
    fn table_curvature(&self, x: f64) -> f64 {
        self.curvature * x.cos()
    }
    #[derivative(velocity)]
    fn speed(&self, p: f64) -> f64 {
        (1.0 + p * p).sqrt()
    }
    #[derivative(compliance)]
    fn velocity(&self, p: f64) -> f64 {
        self.inertia * p / (1.0 + p * p).sqrt()
    }
    fn compliance(&self, p: f64) -> f64 {
        self.inertia / (1.0 + p * p).powf(1.5)
    }
}

fn outcome(slope: f64, curvature: f64, inertia: f64) -> Result<Certificate, CertifyError> {
    certify(&Tabulated { slope, curvature, inertia }, Verlet, Phase::new([0.7, 0.2], [0.3, 0.1]), 0.05)
}

#[test]
fn stated_derivatives_are_checked_against_differences() {
    let certificate = outcome(1.0, 1.0, 1.0).unwrap_or_else(|error| panic!("{error}"));
    let agreement = certificate.agreement.expect("as it is stated");
    // Five states; for each function an energy, and for each coordinate a slope and its tangent.
    assert_eq!((agreement.energies, agreement.derivatives, agreement.left_out), (10, 40, 0), "{certificate}");
    for sign in [1e-4, -1e-4, 1e-6] {
        let wrong = 1.0 + sign;
        for (of, name, at, outcome) in [
            ("the slope of V", "potential", 1, outcome(wrong, wrong, 1.0)),
            ("the curvature of V", "potential", 2, outcome(1.0, wrong, 1.0)),
            ("the slope of T", "kinetic", 1, outcome(1.0, 1.0, wrong)),
        ] {
            let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("{of}: {outcome:?}") };
            let found = shortfalls.iter().any(|shortfall| {
                matches!(shortfall, Shortfall::Derivative { function, order, .. } if (*function, *order) == (name, at))
            });
            assert!(found, "{of} is off by {sign}: {shortfalls:?}");
        }
    }
}

/// A map of a field in space, whose derivatives come as arrays, which may be a little wrong in one element each.
#[derive(Clone)]
struct Mapped {
    slope: f64,
    curvature: f64,
}

#[hamiltonian]
impl Mapped {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        self.field(q[0], q[1], q[2]) + 0.5 * (q[0] * q[0] + q[1] * q[1] + q[2] * q[2])
    }
    #[derivative(gradient)]
    fn field(&self, x: f64, y: f64, z: f64) -> f64 {
        0.1 * x * y * z.sin()
    }
    #[derivative(hessian)]
    fn gradient(&self, x: f64, y: f64, z: f64) -> [f64; 3] {
        [0.1 * y * z.sin(), 0.1 * x * z.sin(), self.slope * 0.1 * x * y * z.cos()]
    }
    fn hessian(&self, x: f64, y: f64, z: f64) -> [[f64; 3]; 3] {
        let (xy, yz, xz) = (0.1 * z.sin(), self.curvature * 0.1 * x * z.cos(), 0.1 * y * z.cos());
        [[0.0, xy, xz], [xy, 0.0, yz], [self.slope * xz, self.slope * yz, -self.slope * 0.1 * x * y * z.sin()]]
    }
}

#[test]
fn arrays_of_stated_derivatives_are_checked_against_differences() {
    let outcome = |slope, curvature| {
        let start = Phase::new([0.7, 0.5, 0.9], [0.3, 0.1, -0.2]);
        certify(&Mapped { slope, curvature }, Verlet, start, 0.05)
    };
    let certificate = outcome(1.0, 1.0).unwrap_or_else(|error| panic!("{error}"));
    assert!(certificate.agreement.is_some_and(|agreement| agreement.left_out == 0), "{certificate}");
    for wrong in [1.0 + 1e-4, 1.0 - 1e-4] {
        for (of, at, outcome) in
            [("the slope by z", 1, outcome(wrong, 1.0)), ("the mixed slope", 2, outcome(1.0, wrong))]
        {
            let Err(CertifyError::Refused { shortfalls, .. }) = outcome else { panic!("{of}: {outcome:?}") };
            let found = shortfalls.iter().any(|shortfall| {
                matches!(shortfall, Shortfall::Derivative { function: "potential", order, .. } if *order == at)
            });
            assert!(found, "{of}: {shortfalls:?}");
        }
    }
}

#[test]
fn misread_code_is_reported_at_the_function() {
    // From the axis, where the square of the square is none, so that only the orbit shows it.
    let start = Phase::new([0.0, 0.5], [1.0, 0.0]);
    let outcome = certify(&Misread {}, Verlet, start, 0.01);
    let Err(error @ CertifyError::Refused { .. }) = &outcome else { panic!("{outcome:?}") };
    let CertifyError::Refused { shortfalls, certificate } = error else { panic!("{error}") };
    let misread = shortfalls.iter().find_map(|shortfall| match shortfall {
        Shortfall::Misread(misread) => Some(misread),
        _ => None,
    });
    let misread = misread.unwrap_or_else(|| panic!("{error}"));
    assert_eq!(misread.function, "potential");
    let (sum, square) = (misread.q.iter().map(|x| x * x).sum::<f64>(), misread.q[0].powi(2));
    assert_eq!((misread.generated, misread.stated), (sum, square * square + misread.q[1].powi(2)), "{misread}");
    assert!(certificate.agreement.is_none(), "{certificate}");
    assert!(error.to_string().contains("`potential` returns"), "{error}");
}

/// All of H in one function, with a stated derivative that may be wrong.
#[derive(Clone)]
struct InOne {
    slope: f64,
}

#[hamiltonian]
impl InOne {
    fn hamiltonian(&self, [x, y]: [f64; 2], p: [f64; 2]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum::<f64>() + self.table(x) + 0.5 * y * y
    }
    #[derivative(table_slope)]
    fn table(&self, x: f64) -> f64 {
        -x.cos()
    }
    #[derivative(table_curvature)]
    fn table_slope(&self, x: f64) -> f64 {
        self.slope * x.sin()
    }
    fn table_curvature(&self, x: f64) -> f64 {
        x.cos()
    }
}

#[test]
fn a_hamiltonian_in_one_function_is_checked_against_that_function() {
    let outcome = |slope| certify(&InOne { slope }, Verlet, Phase::new([0.7, 0.2], [0.3, 0.1]), 0.05);
    let certificate = outcome(1.0).unwrap_or_else(|error| panic!("{error}"));
    let agreement = certificate.agreement.expect("as it is written");
    assert_eq!((agreement.energies, agreement.derivatives, agreement.left_out), (10, 40, 0), "{certificate}");
    for wrong in [1.0 + 1e-4, 1.0 - 1e-6] {
        let Err(CertifyError::Refused { shortfalls, .. }) = outcome(wrong) else { panic!("{wrong} passes") };
        let found = shortfalls
            .iter()
            .any(|shortfall| matches!(shortfall, Shortfall::Derivative { function: "hamiltonian", order: 1, .. }));
        assert!(found, "{shortfalls:?}");
    }
    // Where debug assertions are on, the start is refused, and else the certificate.
    let misread = match certify(&MisreadWhole {}, Verlet, Phase::new([0.7], [0.3]), 0.05) {
        Err(CertifyError::Run(Error::Misread(misread))) => misread,
        Err(CertifyError::Refused { shortfalls, .. }) => match &shortfalls[..] {
            [Shortfall::Misread(misread), ..] => misread.clone(),
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    assert_eq!((misread.function, misread.stated - misread.generated), ("hamiltonian", 1.0));
}

#[test]
#[cfg(debug_assertions)]
fn a_debug_build_checks_every_start_against_the_functions() {
    let start = Phase::new([2.0, 3.0], [1.0, 0.0]);
    let misread = |outcome: Result<(), Error>| match outcome {
        Err(Error::Misread(misread)) => (misread.function, misread.stated, misread.generated),
        other => panic!("{other:?}"),
    };
    let run = Misread {}.run(start, 0.01).map(drop);
    assert_eq!(misread(run), ("potential", 25.0, 13.0));
    let single = Misread {}.run_with(Yoshida4, Phase::new([2.0_f32, 3.0], [1.0, 0.0]), 0.01).map(drop);
    assert_eq!(misread(single), ("potential", 25.0, 13.0));
    let members = [Phase::new([0.0, 1.0], [0.0, 0.0]), start].map(|start| (Misread {}, start));
    match Ensemble::new(Verlet, members, 0.01).map(drop) {
        Err(Error::Member { member: 1, error }) => assert_eq!(misread(Err(*error)), ("potential", 25.0, 13.0)),
        other => panic!("{other:?}"),
    }
    let certified = certify(&Misread {}, Verlet, start, 0.01);
    assert!(matches!(certified, Err(CertifyError::Run(Error::Misread(_)))), "{certified:?}");
}

/// Next to nothing, far away.
struct Gaussian;

#[hamiltonian]
impl Gaussian {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -(-q[0] * q[0]).exp()
    }
}

#[test]
fn an_energy_without_significant_digits_is_no_mistake() {
    // From 26.6 on, it has fewer than all digits, and from 27.3 on none.
    for tenths in 0..40 {
        Gaussian.run(Phase::new([25.0 + 0.1 * f64::from(tenths)], [0.0]), 0.01).expect("the same");
    }
}

/// The sum over a ring of what nearly cancels, of bodies that a branch leaves out, and of a kink on the way.
struct Rough {
    offset: f64,
}

#[hamiltonian]
impl Rough {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        p.iter().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let mut sum = 0.0;
        for i in 0..3 {
            let x = q[i] + self.offset;
            sum += x * x - 2.0 * self.offset * x + self.offset * self.offset;
            if q[i] > 0.25 {
                sum += (q[i] - 0.25).powi(3);
            }
        }
        sum + (q[0] - q[1]).abs()
    }
}

#[test]
fn rounding_errors_of_a_function_are_no_mistake() {
    for offset in [0.0, 1.0, 1e3, 1e6] {
        // At the kink between the first two, no difference tells a slope.
        let mut run = Rough { offset }.run(Phase::new([0.3, 0.3, 0.25], [0.1, 0.1, -0.2]), 0.01).expect("the same");
        run.advance(100).expect("finite");
        let outcome = certify(&Rough { offset }, Verlet, Phase::new([0.3, 0.3, 0.25], [0.1, 0.1, -0.2]), 0.01);
        let certificate = match &outcome {
            Ok(certificate) => certificate,
            Err(CertifyError::Refused { certificate, shortfalls }) => {
                let misread =
                    |shortfall: &Shortfall| matches!(shortfall, Shortfall::Misread(_) | Shortfall::Derivative { .. });
                assert!(!shortfalls.iter().any(misread), "{shortfalls:?}");
                certificate
            }
            Err(error) => panic!("{error}"),
        };
        if let Some(agreement) = certificate.agreement {
            assert!(agreement.left_out > 0, "{certificate}");
        }
    }
}
