//! What is derived, for people.

use integrator_symbolic::report;
use proc_macro2::TokenStream;

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("tokens")
}

#[test]
fn a_pendulum_is_two_equations_and_few_operations() {
    let pendulum = "impl Pendulum {
        fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.mass) }
        fn potential(&self, q: [f64; 1]) -> f64 { -self.torque * q[0].cos() }
    }";
    let report = report(TokenStream::new(), tokens(pendulum)).expect("no mistake");
    assert_eq!(report.equations, ["dq[0]/dt = 2 / (2.0 * mass) p[0]", "dp[0]/dt = (-torque) sin(q[0])"]);
    assert!(report.quadratic_kinetic && report.autonomous);
    // A product in the drift; a sine and a product in the kick.
    assert_eq!((report.operations_written, report.operations_shared), (3, 3));
    assert!(report.to_string().contains("3 with what is shared computed once"));
}

#[test]
fn sharing_is_counted() {
    let system = "impl Driven {
        fn kinetic(&self, p: [f64; 2]) -> f64 { (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt() }
        fn potential(&self, q: [f64; 2], t: f64) -> f64 { (q[0] * q[1]).exp() * t }
    }";
    let report = report(TokenStream::new(), tokens(system)).expect("no mistake");
    assert!(!report.quadratic_kinetic && !report.autonomous);
    assert!(report.operations_shared < report.operations_written, "{report}");
}

#[test]
fn mistakes_have_no_report() {
    assert_eq!(report(TokenStream::new(), tokens("impl Nothing {}")), None);
}
