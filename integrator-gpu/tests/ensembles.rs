//! What holds of ensembles on devices where no device is: the text as a program of this machine, the fallback, the errors,
//! and kernels that NVRTC compiles.

use integrator_core::{Ensemble as OnProcessor, InLanes, InstructionSet, prelude::*};
use integrator_gpu::{Device, Ensemble, Error as GpuError, compile};

struct Pendulum {
    length: f64,
}

#[hamiltonian(gpu)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

struct Runaway;

#[hamiltonian(gpu)]
impl Runaway {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].powi(4)
    }
}

struct Native;

#[hamiltonian(gpu(functions = native))]
impl Native {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0].cosh() + p[1].hypot(1.0)
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let single = q[0].sin() + q[0].cos() + q[0].tan() + q[0].asin() + q[0].acos() + q[0].atan() + q[0].tanh();
        let double = q[1].acosh() + q[1].atanh() + q[1].asinh() + q[1].sinh() + q[1].cbrt() + q[1].powf(0.3);
        let powers = q[0].exp() + q[0].exp2() + q[0].exp_m1() + q[0].ln() + q[0].ln_1p() + q[0].log2() + q[0].log10();
        single * double + powers * q[0].atan2(q[1])
    }
}

/// A sum of as many waves as the fields say.
struct Waves {
    count: usize,
    height: Vec<f64>,
}

#[hamiltonian(gpu)]
impl Waves {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        let mut sum = 0.0;
        for i in 0..self.count {
            sum += self.height[i] * ((i as f64 + 1.0) * q[0]).cos();
        }
        sum
    }
}

/// A logistic regression: sums over rows, and over the columns of each.
struct Regression {
    rows: Vec<[f64; 20]>,
}

#[hamiltonian(gpu)]
impl Regression {
    fn kinetic(&self, p: [f64; 20]) -> f64 {
        0.5 * p.iter().map(|p| p * p).sum::<f64>()
    }
    fn potential(&self, q: [f64; 20]) -> f64 {
        let mut sum = 0.0;
        for row in 0..self.rows.len() {
            let mut x = 0.0;
            for column in 0..20 {
                x += self.rows[row][column] * q[column];
            }
            sum += x.exp().ln_1p() + (1.0 + x.exp()).ln();
        }
        sum
    }
}

/// A bond in a soft field, both of which change with time.
struct Molecule {
    stiffness: f64,
}

#[hamiltonian(split = field + 2 * (bend + 3 * Yoshida4(bond + turn + kinetic)), gpu)]
impl Molecule {
    fn field(&self, q: [f64; 2], t: f64) -> f64 {
        t.cos() * (q[0] + q[1])
    }
    fn bend(&self, q: [f64; 2]) -> f64 {
        (q[0] * q[1]).sin()
    }
    fn bond(&self, q: [f64; 2], t: f64) -> f64 {
        self.stiffness * (1.0 + 0.1 * t.sin()) * (q[0] - q[1]).powi(2)
    }
    fn turn(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        0.1 * q[0] * q[0] * p[1]
    }
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        0.5 * (p[0] * p[0] + p[1] * p[1])
    }
}

/// An outer solar system.
struct Planets {
    gravity: f64,
    mass: [f64; 6],
}

#[hamiltonian(gpu)]
impl Planets {
    fn kinetic(&self, p: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for d in 0..3 {
                energy += p[i][d].powi(2) / (2.0 * self.mass[i]);
            }
        }
        energy
    }
    fn potential(&self, q: [[f64; 3]; 6]) -> f64 {
        let mut energy = 0.0;
        for i in 0..6 {
            for j in 0..i {
                let mut r2 = 0.0;
                for d in 0..3 {
                    r2 += (q[i][d] - q[j][d]).powi(2);
                }
                energy -= self.gravity * self.mass[i] * self.mass[j] / r2.sqrt();
            }
        }
        energy
    }
}

fn pendulums() -> impl Iterator<Item = (Pendulum, Phase<[f64; 1]>)> {
    (1..=5).map(|i| (Pendulum { length: f64::from(i) / 4.0 }, Phase::new([2.0], [0.1])))
}

/// Whether the program of the text can be held against this machine.
fn can_compare<T>(made: &Result<T, GpuError>) -> bool {
    if InstructionSet::chosen() == InstructionSet::Baseline {
        eprintln!("SKIPPED: this process computes without fused multiply-add");
        return false;
    }
    match made {
        Err(GpuError::Program(reason)) if reason.contains("is installed") => {
            eprintln!("SKIPPED: {reason}");
            false
        }
        _ => true,
    }
}

#[test]
fn the_device_code_has_states_and_energies_of_the_processor() {
    let made = Ensemble::on(Device::Text, Yoshida4, pendulums(), 0.01);
    if !can_compare(&made) {
        return;
    }
    let mut ensemble = made.expect("an ensemble");
    let mut processor = OnProcessor::new(Yoshida4, pendulums(), 0.01).expect("an ensemble");
    assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>());
    for steps in [1, 0, 99] {
        ensemble.advance(steps).expect("finite");
        processor.advance(steps).expect("finite");
        assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>());
        let energies = ensemble.energies().expect("energies");
        let expected = (0..5).map(|member| processor.energy(member).expect("a member"));
        assert_eq!(energies, expected.collect::<Vec<_>>());
    }
    assert_eq!((ensemble.steps(), ensemble.time(), ensemble.len()), (100, processor.time(), 5));
    assert!(ensemble.lost().is_empty() && ensemble.fallback().is_none());
}

/// With `Verlet`, whose steps merge, and with `VelocityVerlet`, whose steps begin and end with inner steps and do not.
#[test]
fn inner_steps_have_the_states_of_the_processor() {
    fn compare<X: Composition<Molecule> + InLanes<Molecule>>(composition: X) {
        let start = |i: u32| Phase::compensated([0.3, 0.1 * f64::from(i)], [0.2, 0.0]);
        let members = || (0..3).map(|i| (Molecule { stiffness: 10.0 + f64::from(i) }, start(i)));
        let made = Ensemble::on(Device::Text, composition, members(), 0.05);
        if !can_compare(&made) {
            return;
        }
        let (mut ensemble, mut processor) =
            (made.expect("an ensemble"), OnProcessor::new(composition, members(), 0.05).expect("an ensemble"));
        for steps in [1, 99] {
            ensemble.advance(steps).expect("finite");
            processor.advance(steps).expect("finite");
            assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>(), "{}", X::NAME);
        }
        let time = processor.time() + 0.02;
        assert_eq!((ensemble.advance_to(time), processor.advance_to(time)), (Ok(()), Ok(())));
        assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>(), "{}", X::NAME);
    }
    compare(Verlet);
    compare(VelocityVerlet);
}

#[test]
fn failed_members_are_named_once() {
    let members = || [1.0, 0.0].map(|q| (Runaway, Phase::new([q], [0.0])));
    let mut processor = OnProcessor::new(Verlet, members(), 0.01).expect("an ensemble");
    let Err(Error::Lost(reports)) = processor.advance(1_000) else { panic!("somebody is lost") };
    let lost = vec![(0, processor.steps_of(0).expect("a member"))];
    for device in [Device::Text, Device::Best] {
        let made = Ensemble::on(device, Verlet, members(), 0.01);
        if device == Device::Text && !can_compare(&made) {
            continue;
        }
        let mut ensemble = made.expect("an ensemble");
        assert_eq!(ensemble.advance(1_000), Err(GpuError::Lost(reports.clone())), "{device:?}");
        assert_eq!(ensemble.advance(10), Ok(()), "{device:?}: the other goes on");
        assert_eq!(ensemble.lost(), lost, "{device:?}");
        assert_eq!(ensemble.states().expect("states")[0], processor.state(0).expect("a member"), "{device:?}");
    }
}

#[test]
fn without_a_driver_there_is_an_error_and_a_fallback_on_request() {
    let reason = match Ensemble::new(Yoshida4, pendulums(), 0.01) {
        Ok(_) => return eprintln!("SKIPPED: this machine has a device"),
        Err(reason) => reason,
    };
    assert!(matches!(reason, GpuError::Driver | GpuError::NoDevice(..) | GpuError::Compiler), "{reason}");
    let mut best = Ensemble::on(Device::Best, Yoshida4, pendulums(), 0.01).expect("the processor");
    assert_eq!(best.fallback(), Some(&reason));
    let mut processor = OnProcessor::new(Yoshida4, pendulums(), 0.01).expect("an ensemble");
    best.advance(50).expect("finite");
    processor.advance(50).expect("finite");
    assert_eq!(best.states().expect("states"), processor.states().collect::<Vec<_>>());
}

#[test]
fn lists_of_the_fields_lengths_have_room_for_some() {
    let waves = |count: usize| Waves { count, height: (0..count).map(|i| 1.0 / (1.0 + i as f64)).collect() };
    let members = |most: usize| (0..3_usize).map(move |i| (waves(most - i), Phase::new([0.5], [0.1 * i as f64])));
    let made = Ensemble::on(Device::Text, Yoshida4, members(16), 0.01);
    if can_compare(&made) {
        let mut ensemble = made.expect("an ensemble");
        let mut processor = OnProcessor::new(Yoshida4, members(16), 0.01).expect("an ensemble");
        ensemble.advance(100).expect("finite");
        processor.advance(100).expect("finite");
        assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>());
    }
    let longer = members(16).chain(members(17));
    assert_eq!(Ensemble::on(Device::Text, Yoshida4, longer, 0.01).err(), Some(GpuError::List(3)));
}

#[test]
fn sums_over_rows_are_added_in_the_order_of_the_processor() {
    for count in [5, 8, 13, 16] {
        let number = |row: usize, column: usize| ((row * 20 + column) as f64 * 0.7).sin();
        let rows = (0..count).map(|row| std::array::from_fn(|column| number(row, column))).collect();
        let start = Phase::new(std::array::from_fn(|i| 0.1 * (i as f64).cos()), [0.3; 20]);
        let members = || [(Regression { rows: Vec::clone(&rows) }, start)];
        let made = Ensemble::on(Device::Text, Yoshida4, members(), 0.01);
        if can_compare(&made) {
            let mut ensemble = made.expect("an ensemble");
            let mut processor = OnProcessor::new(Yoshida4, members(), 0.01).expect("an ensemble");
            ensemble.advance(20).expect("finite");
            processor.advance(20).expect("finite");
            assert_eq!(ensemble.states().expect("states"), processor.states().collect::<Vec<_>>(), "{count} rows");
        }
    }
}

#[test]
fn members_and_steps_are_judged_before_any_device() {
    let refused = Ensemble::new(Yoshida4, pendulums(), 0.0).err();
    assert!(matches!(refused, Some(GpuError::Core(_))), "{refused:?}");
    let nobody = Ensemble::new(Yoshida4, pendulums().take(0), 0.01).err();
    assert_eq!(nobody, Some(GpuError::Core(Error::NoMembers)));
}

#[test]
fn kernels_compile_where_nvrtc_is() {
    let kernels = [compile::<Pendulum>(), compile::<Runaway>(), compile::<Native>(), compile::<Planets>()];
    for compiled in kernels.into_iter().chain([compile::<Molecule>()]) {
        match compiled {
            Ok(assembly) => {
                assert!(assembly.contains(".entry advance") && assembly.contains(".entry show"), "{assembly}")
            }
            Err(GpuError::Compiler) => eprintln!("SKIPPED: NVRTC is not installed, so that no kernel was compiled"),
            Err(other) => panic!("{other}"),
        }
    }
}
