//! Parts that take inner steps: the compositions around them, the orders of both, and steps that are written by hand.

use crate::many_parts::{TIME, classical, slope_of, twisted};
use integrator_core::{
    __private::{Nested, Scheme},
    Composition, Hamiltonian, InstructionSet, Method, Phase, Visitor,
    prelude::*,
};

/// `½ |p|² + 2 q₀² + ¼ q₁⁴ + cos q₀ + q₀ q₁²`, split in one way or another.
macro_rules! stiff {
    ($name:ident: $($split:tt)*) => {
        struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn well(&self, q: [f64; 2]) -> f64 {
                q[0].cos() + q[0] * q[1] * q[1]
            }
            fn bonds(&self, q: [f64; 2]) -> f64 {
                2.0 * q[0] * q[0] + q[1] * q[1] * q[1] * q[1] / 4.0
            }
            fn kinetic(&self, p: [f64; 2]) -> f64 {
                (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
        }
    };
}

stiff!(OverVerlet: well + 2 * (bonds + kinetic));
stiff!(OverYoshida4: well + 2 * Yoshida4(bonds + kinetic));
stiff!(OverBlanesMoan4: well + 2 * BlanesMoan4(bonds + kinetic));
stiff!(OverAba864: well + 2 * Aba864(bonds + kinetic));
stiff!(OverKahanLi8: well + 2 * KahanLi8(bonds + kinetic));

fn start() -> Phase<[f64; 2]> {
    Phase { q: [0.4, -0.3], p: [0.2, 0.5] }
}

fn numbers(Phase { q: [x, y], p: [u, v] }: Phase<[f64; 2]>) -> [f64; 4] {
    [x, y, u, v]
}

fn reference() -> [f64; 4] {
    classical(numbers(start()), |[x, y, u, v], _| [u, v, x.sin() - y * y - 4.0 * x, -2.0 * x * y - y.powi(3)])
}

/// The end after so many steps.
fn end<H: Hamiltonian<Coords = [f64; 2]>>(system: &H, method: impl Method<H>, steps: u32) -> [f64; 4] {
    let mut run = system.run_with(method, start(), TIME / f64::from(steps)).expect("a start");
    run.advance(u64::from(steps)).expect("finite");
    numbers(run.state())
}

/// The order with a number of inner steps by the slope of errors.
fn slope<H, X>(system: &H, composition: X, inner: u32, exact: [f64; 4]) -> f64
where
    H: Nested<0> + Hamiltonian<Coords = [f64; 2]>,
    X: Composition<H>,
{
    slope_of(X::NAME, exact, |steps| end(system, composition.nested(inner), steps))
}

#[test]
fn the_order_is_the_lesser_of_both() {
    let exact = reference();
    macro_rules! orders {
        ($($system:ident $inner:ident: $($outer:ident)*;)*) => {$($(
            for steps in [1, 2, 3, 8] {
                let found = slope(&$system, $outer, steps, exact);
                let order = f64::from($outer::ORDER.min($inner::ORDER));
                let names = concat!(stringify!($outer), " over ", stringify!($inner));
                // Errors of the next order still show in steps that do not yet reach the rounding.
                assert!(found > order - 0.4, "{names} with {steps} inner steps has order {found}, not {order}");
            }
        )*)*};
    }
    orders! {
        OverVerlet Verlet: Verlet Yoshida4 BlanesMoan4 Aba864;
        OverYoshida4 Yoshida4: Verlet Yoshida4 BlanesMoan4 Aba864;
        OverBlanesMoan4 BlanesMoan4: Verlet Yoshida4 BlanesMoan4 Aba864;
        OverAba864 Aba864: Verlet Yoshida4 BlanesMoan4 Aba864;
    }
}

#[test]
fn every_listed_composition_keeps_its_order() {
    struct Slopes([f64; 4]);
    impl Visitor<OverKahanLi8> for Slopes {
        fn visit<X: Composition<OverKahanLi8>>(&mut self, composition: X) {
            let (slope, order) = (slope(&OverKahanLi8, composition, 1, self.0), f64::from(X::ORDER.min(8)));
            // Errors of the next order still show in steps that do not yet reach the rounding.
            assert!(slope > order - 0.4, "{} has order {slope}, not {order}", X::NAME);
        }
    }
    OverKahanLi8::visit_compositions(&mut Slopes(reference()));
}

/// A step of these is made of symmetric steps of order 2, whose inner steps belong to them.
#[test]
fn compositions_of_whole_steps_keep_their_orders_over_verlet() {
    let exact = reference();
    for steps in [1, 2, 3, 8] {
        for (found, order) in
            [(slope(&OverVerlet, Yoshida4, steps, exact), 4.0), (slope(&OverVerlet, Yoshida6, steps, exact), 6.0)]
        {
            assert!(found > order - 0.4, "order {found} with {steps} inner steps, not {order}");
        }
    }
    let lost = slope(&OverVerlet, Aba864, 1, exact);
    assert!(lost < 2.5, "the errors of the inner steps show: order {lost}");
}

struct Paired;
struct One;
struct Several;

twisted!(Paired: kinetic + (twist + counter + potential));
twisted!(One: kinetic + 1 * (twist + counter + potential));
twisted!(Several: kinetic + 3 * (twist + 2 * BlanesMoan4(counter + potential)));

#[test]
fn one_inner_step_of_verlet_is_a_symmetric_pair() {
    macro_rules! same {
        ($($composition:ident)*) => {$(
            assert_eq!(end(&One, $composition, 64), end(&Paired, $composition, 64), "{}", $composition::NAME);
            assert_eq!(end(&One, $composition.nested(1), 64), end(&One, $composition, 64), "{}", $composition::NAME);
            assert_ne!(end(&One, $composition.nested(2), 64), end(&One, $composition, 64), "{}", $composition::NAME);
        )*};
    }
    same!(Verlet Yoshida4 KahanLi8);
}

/// `c + a·b`, with one rounding or with two as the instruction set has it.
fn fma(a: f64, b: f64, c: f64) -> f64 {
    match InstructionSet::chosen() {
        InstructionSet::Baseline => a * b + c,
        InstructionSet::Fused | InstructionSet::Avx512 => a.mul_add(b, c),
    }
}

/// Springs of three stiffnesses, whose parts are as many linear flows.
macro_rules! springs {
    ($name:ident: $($split:tt)*) => {
        struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn far(&self, q: [f64; 1]) -> f64 {
                0.25 * q[0] * q[0]
            }
            fn near(&self, q: [f64; 1]) -> f64 {
                q[0] * q[0]
            }
            fn bonds(&self, q: [f64; 1]) -> f64 {
                8.0 * q[0] * q[0]
            }
            fn kinetic(&self, p: [f64; 1]) -> f64 {
                p[0] * p[0] / 2.0
            }
        }
    };
}

springs!(Twice: far + 3 * (near + 5 * (bonds + kinetic)));
springs!(Once: far + 3 * (near + bonds + kinetic));

/// Springs by hand.
struct Springs {
    q: f64,
    p: f64,
}

impl Springs {
    /// The force of a spring of this stiffness, a power of two: its product is exact.
    fn pull(&mut self, stiffness: f64, t: f64) {
        self.p = fma(-t * stiffness, self.q, self.p);
    }
    fn glide(&mut self, t: f64) {
        self.q = fma(t, self.p, self.q);
    }
    /// Steps of Verlet's method, merged, with this flow in the middle.
    fn steps(&mut self, stiffness: f64, t: f64, steps: u32, middle: impl Fn(&mut Self, f64)) {
        for step in 0..steps {
            self.pull(stiffness, if step == 0 { t * 0.5 } else { t });
            middle(self, t);
        }
        self.pull(stiffness, t * 0.5);
    }
}

/// The reversible reference system propagator algorithm (r-RESPA), with loops within loops.
#[test]
fn hand_written_inner_steps_have_the_same_bits() {
    const STEPS: u32 = 100;
    let h = 0.1;
    let run = |steps: Result<Run<[f64; 1]>, Error>| {
        let mut run = steps.expect("a start");
        run.advance(u64::from(STEPS)).expect("finite");
        let Phase { q: [q], p: [p] } = run.state();
        [q, p]
    };
    let start = || Phase::new([0.7], [-0.2]);
    let by_hand = |inner: u32, innermost: u32| {
        let mut springs = Springs { q: 0.7, p: -0.2 };
        springs.steps(0.5, h, STEPS, |springs, t| {
            springs.steps(2.0, t / f64::from(inner), inner, |springs, t| {
                springs.steps(16.0, t / f64::from(innermost), innermost, Springs::glide);
            });
        });
        [springs.q, springs.p]
    };
    assert_eq!(run(Twice.run_with(Verlet, start(), h)), by_hand(3, 5), "nested twice");
    assert_eq!(run(Twice.run_with(Verlet.nested(7), start(), h)), by_hand(7, 5), "another number outside");
    assert_ne!(by_hand(7, 5), by_hand(3, 5));

    // Neighbouring parts that are functions of positions are one part.
    let mut springs = Springs { q: 0.7, p: -0.2 };
    springs.steps(0.5, h, STEPS, |springs, t| {
        let t = t / 3.0;
        for step in 0..3 {
            springs.p = fma(-(if step == 0 { t * 0.5 } else { t }) * 18.0, springs.q, springs.p);
            springs.glide(t);
        }
        springs.p = fma(-(t * 0.5) * 18.0, springs.q, springs.p);
    });
    assert_eq!(run(Once.run_with(Verlet, start(), h)), [springs.q, springs.p], "parts that commute");
}

#[test]
fn steps_back_undo_steps() {
    fn back<H: Hamiltonian<Coords = [f64; 2]>>(system: &H, method: impl Method<H>) -> f64 {
        let mut run = system.run_with(method, start(), 0.1).expect("a start");
        run.advance(15).expect("finite");
        let mut back = system.run_with(method, run.state(), -0.1).expect("a start");
        back.advance(15).expect("finite");
        let off = numbers(back.state()).into_iter().zip(numbers(start())).map(|(one, other)| (one - other).abs());
        off.fold(0.0, f64::max)
    }
    // A few thousand flows of numbers about one, each with a few roundings.
    for off in [
        back(&OverVerlet, Verlet.nested(3)),
        back(&OverBlanesMoan4, Aba864.nested(8)),
        back(&Several, Yoshida4),
        back(&Several, Verlet.nested(7)),
    ] {
        assert!(off < 1e4 * f64::EPSILON, "off by {off:e}");
    }
    assert!(back(&OverVerlet, Euler) > 1e-4, "Euler's method is not its own adjoint");
}

#[test]
fn steps_back_on_a_grid_undo_steps_to_the_bit() {
    fn back<H: Hamiltonian<Coords = [f64; 2]>>(system: &H, method: impl Method<H>) {
        let start = Phase::reversible([0.4, -0.3], [0.2, 0.5], 2.0_f64.powi(-40));
        let mut run = system.run_with(method, start, 0.1).expect("a start");
        run.advance(15).expect("finite");
        let mut back = system.run_with(method, run.state(), -0.1).expect("a start");
        back.advance(15).expect("finite");
        assert!(back.state() == start, "{:?}", back.state());
    }
    back(&OverVerlet, Verlet.nested(3));
    back(&OverAba864, Suzuki4.nested(8));
    back(&Several, KahanLi8.nested(7));
}

/// A slow force with a slow drive, and fast bonds with a fast one, over the two.
macro_rules! driven {
    ($name:ident: $($split:tt)*) => {
        struct $name;

        #[hamiltonian(split = $($split)*)]
        impl $name {
            fn well(&self, q: [f64; 2], t: f64) -> f64 {
                (q[0] - t).cos() + q[0] * q[1] * q[1]
            }
            fn bonds(&self, q: [f64; 2], t: f64) -> f64 {
                (2.0 + (3.0 * t).sin()) * q[0] * q[0] + q[1] * q[1] * q[1] * q[1] / 4.0
            }
            fn kinetic(&self, p: [f64; 2], t: f64) -> f64 {
                (1.0 + 0.3 * t.sin()) * (p[0] * p[0] + p[1] * p[1]) / 2.0
            }
        }
    };
}

driven!(DrivenVerlet: well + 2 * (bonds + kinetic));
driven!(DrivenBlanesMoan4: well + 2 * BlanesMoan4(bonds + kinetic));

#[test]
fn parts_that_read_the_time_keep_the_order() {
    let exact = classical(numbers(start()), |[x, y, u, v], t| {
        let (mass, stiffness) = (1.0 + 0.3 * t.sin(), 2.0 + (3.0 * t).sin());
        [mass * u, mass * v, (x - t).sin() - y * y - 2.0 * stiffness * x, -2.0 * x * y - y.powi(3)]
    });
    for steps in [1, 3, 8] {
        for (found, order) in [
            (slope(&DrivenVerlet, Verlet, steps, exact), 2.0),
            (slope(&DrivenBlanesMoan4, Aba864, steps, exact), 4.0),
            (slope(&DrivenBlanesMoan4, Yoshida4, steps, exact), 4.0),
        ] {
            assert!(found > order - 0.4, "order {found} with {steps} inner steps, not {order}");
        }
    }
}
