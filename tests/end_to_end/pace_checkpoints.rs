//! Checkpoints of runs whose time is part of their state.

use integrator_core::{CheckpointError, Method, Resumable, prelude::*};

struct Comet {
    pull: f64,
}

#[hamiltonian]
impl Comet {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.pull / q[0].hypot(q[1])
    }
    fn rate(&self, q: [f64; 2]) -> f64 {
        q[0].hypot(q[1]).powf(-1.5)
    }
}

const COMET: Comet = Comet { pull: 1.0 };

fn comet_by<X: Method<Comet>>(method: X, steps: u64) -> Run<[f64; 2]> {
    let start = Phase::new([0.4, 0.0], [0.0, 2.0]);
    let mut run = COMET.run_with(method, start, 0.01).expect("an admissible start").at_time(0.3);
    run.advance(steps).expect("finite");
    run
}

#[test]
fn a_run_in_fictitious_time_resumes_in_that_time() {
    fn interrupted<X: Resumable<Comet>>(method: X) {
        for steps in [0, 1, 137] {
            for changed in [false, true] {
                let mut whole = comet_by(method, steps);
                if changed {
                    whole.map_state(|state| state.p[1] *= 1.01).expect("a finite state");
                    whole.advance(steps / 2).expect("finite");
                }
                let mut resumed = Run::resume_with(&COMET, method, &whole.checkpoint()).expect("it was just made");
                assert_eq!((resumed.time(), resumed.state()), (whole.time(), whole.state()));
                whole.advance(863).expect("finite");
                resumed.advance(863).expect("finite");
                assert_eq!((resumed.time(), resumed.state()), (whole.time(), whole.state()));
                assert_eq!(resumed.checkpoint(), whole.checkpoint(), "the unfinished state too");
            }
        }
    }
    interrupted(Logarithmic(SofroniouSpaletta8));
    interrupted(Logarithmic(VelocityVerlet));
    interrupted(Power(0.5, Yoshida4));
    interrupted(Paced(KahanLi8));
}

#[test]
fn a_checkpoint_in_fictitious_time_is_refused_elsewhere() {
    let bytes = comet_by(Power(0.5, Yoshida4), 7).checkpoint();
    let refused = |outcome: Result<Run<[f64; 2]>, CheckpointError>| outcome.expect_err("another run").to_string();
    assert_eq!(
        refused(Run::resume_with(&COMET, Power(0.6, Yoshida4), &bytes)),
        "this checkpoint was made with the exponent `0.5`, not `0.6`"
    );
    assert_eq!(
        refused(Run::resume_with(&COMET, Paced(Yoshida4), &bytes)),
        "this checkpoint was made with the composition `Power(Yoshida4)`, not `Paced(Yoshida4)`"
    );
    assert_eq!(
        refused(Run::resume_with(&COMET, Power(0.5, Verlet), &bytes)),
        "this checkpoint was made with the composition `Power(Yoshida4)`, not `Power(Verlet)`"
    );
    assert_eq!(
        refused(Run::resume_with(&COMET, Yoshida4, &bytes)),
        "this checkpoint was made with the composition `Power(Yoshida4)`, not `Yoshida4`"
    );
    for length in 0..bytes.len() {
        assert!(Run::<[f64; 2]>::resume_with(&COMET, Power(0.5, Yoshida4), &bytes[..length]).is_err());
    }
    for bit in 0..8 * bytes.len() {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        assert!(Run::<[f64; 2]>::resume_with(&COMET, Power(0.5, Yoshida4), &flipped).is_err(), "bit {bit}");
    }
}

#[test]
fn other_parameters_have_another_energy_in_fictitious_time() {
    let before = comet_by(Logarithmic(SofroniouSpaletta8), 100);
    let bytes = before.checkpoint();
    let method = Logarithmic(SofroniouSpaletta8);
    let stronger = Comet { pull: 1.5 };
    assert!(matches!(Run::<[f64; 2]>::resume_with(&stronger, method, &bytes), Err(CheckpointError::Parameters { .. })));
    let mut meant: Run<[f64; 2]> = Run::resume_with_changed_parameters_with(&stronger, method, &bytes).expect("meant");
    assert_eq!(meant.steps(), 100);
    let energy = meant.energy();
    meant.advance(10_000).expect("finite");
    // With the energy of the weaker pull, steps would leave the orbit.
    assert!((meant.energy() / energy - 1.0).abs() < 1e-12, "{} instead of {energy}", meant.energy());
    // Nothing was changed, and nothing begins anew.
    let mut same: Run<[f64; 2]> = Run::resume_with_changed_parameters_with(&COMET, method, &bytes).expect("the same");
    let mut before = before;
    same.advance(500).expect("finite");
    before.advance(500).expect("finite");
    assert_eq!((same.time(), same.state()), (before.time(), before.state()));
}
