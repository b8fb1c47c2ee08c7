//! Methods that the derivative does not look into: a Morse curve and a surface, with their derivatives stated.

use integrator_core::{check::certify, prelude::*};

/// `V = D (1 - e^{-w (r - 1)})² + 0.1 x² y`, once through methods with stated derivatives, once written out.
#[derive(Clone)]
struct Stated {
    depth: f64,
    width: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Stated {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        self.curve(q[0].hypot(q[1])) + self.surface(q[0], q[1])
    }
    #[derivative(slope)]
    fn curve(&self, r: f64) -> f64 {
        // A loop that the language of H refuses: nobody looks inside.
        let mut power = 1.0;
        let mut iterations = 0;
        while iterations < 2 {
            power *= 1.0 - self.fall(r);
            iterations += 1;
        }
        self.depth * power
    }
    #[derivative(bend)]
    fn slope(&self, r: f64) -> f64 {
        2.0 * self.depth * self.width * (1.0 - self.fall(r)) * self.fall(r)
    }
    fn bend(&self, r: f64) -> f64 {
        2.0 * self.depth * self.width.powi(2) * (2.0 * self.fall(r) - 1.0) * self.fall(r)
    }
    fn fall(&self, r: f64) -> f64 {
        (-(r - 1.0) * self.width).exp()
    }
    #[derivative(by_x, by_y)]
    fn surface(&self, x: f64, y: f64) -> f64 {
        0.1 * x * x * y
    }
    #[derivative(by_xx, by_xy)]
    fn by_x(&self, x: f64, y: f64) -> f64 {
        0.2 * x * y
    }
    #[derivative(by_xy, zero)]
    fn by_y(&self, x: f64, _y: f64) -> f64 {
        0.1 * x * x
    }
    fn by_xx(&self, _x: f64, y: f64) -> f64 {
        0.2 * y
    }
    fn by_xy(&self, x: f64, _y: f64) -> f64 {
        0.2 * x
    }
    fn zero(&self, _x: f64, _y: f64) -> f64 {
        0.0
    }
}

struct WrittenOut {
    depth: f64,
    width: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl WrittenOut {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let fall = (-(q[0].hypot(q[1]) - 1.0) * self.width).exp();
        self.depth * (1.0 - fall).powi(2) + 0.1 * q[0] * q[0] * q[1]
    }
}

#[test]
fn a_method_with_a_stated_derivative_is_that_function() {
    let start = Phase::new([1.3_f64, 0.2], [0.1, 0.3]);
    let (mut stated, mut written) = (
        Stated { depth: 1.0, width: 1.5 }.run(start, 0.01).expect("a run"),
        WrittenOut { depth: 1.0, width: 1.5 }.run(start, 0.01).expect("a run"),
    );
    stated.advance(1000).expect("finite");
    written.advance(1000).expect("finite");
    let (a, b) = (stated.state(), written.state());
    for (a, b) in a.q.iter().chain(&a.p).zip(b.q.iter().chain(&b.p)) {
        // The same steps with other roundings: 1000 steps of three kicks, each of some ulp, on a regular orbit.
        assert!((a - b).abs() < 1e-11, "{a} for {b}");
    }
}

#[test]
fn its_second_derivative_certifies_it() {
    let start = Phase::new([1.3_f64, 0.2], [0.1, 0.3]);
    let certificate = certify(&Stated { depth: 1.0, width: 1.5 }, Yoshida4, start, 0.01);
    assert!(certificate.is_ok(), "{certificate:?}");
}

/// The force-gradient kick needs a derivative more than is stated: the certificate must not pass for lack of it.
#[test]
fn a_missing_second_derivative_is_not_certified() {
    let start = Phase::new([1.3_f64, 0.2], [0.1, 0.3]);
    let refused = certify(&Stated { depth: 1.0, width: 1.5 }, Chin4A, start, 0.01);
    assert!(refused.is_err());
}
