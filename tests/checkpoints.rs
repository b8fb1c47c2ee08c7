//! Checkpoints: a resumed run is the run that was never interrupted, and nothing else passes for a checkpoint.

use integrator_core::{CheckpointError, Coords, prelude::*};
use std::{
    env, fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::Duration,
};

struct Pendulum {
    length: f64,
}

#[hamiltonian(compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

/// A chain whose length is known at run time, driven at one end.
struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += p[i] * p[i] / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[f64], t: f64) -> f64 {
        let mut sum = q[0] * t.sin();
        for i in 0..q.len() - 1 {
            sum += (q[i + 1] - q[i]).powi(4);
        }
        sum
    }
}

/// Points in the plane.
struct Swarm;

#[hamiltonian]
impl Swarm {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            sum += (q[i][0] * q[i][0] + 2.0 * q[i][1] * q[i][1]).powi(2);
        }
        sum
    }
}

/// Discs in a box that push each other where they overlap; so many that neighbours are listed.
struct Crowd;

#[hamiltonian]
impl Crowd {
    fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..p.len() {
            sum += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / 2.0;
        }
        sum
    }
    fn potential(&self, q: &[[f64; 2]]) -> f64 {
        let mut sum = 0.0;
        for i in 0..q.len() {
            for j in 0..i {
                let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]];
                let [x, y] = [x - 32.0 * (x / 32.0).round(), y - 32.0 * (y / 32.0).round()];
                let square = x * x + y * y;
                if square < 1.96 {
                    sum += (1.96 - square).powi(2);
                }
            }
        }
        sum
    }
}

const PENDULUM: Pendulum = Pendulum { length: 0.7 };

fn run() -> Run<[f64; 1]> {
    let mut run = PENDULUM.run(Phase::new([2.0], [0.1]), 0.01).expect("an admissible start").at_time(0.3);
    run.advance(137).expect("finite");
    run
}

/// Stops a run after some steps, and compares what is resumed with what went on.
fn interrupted<H, X, C>(system: &H, composition: X, start: Phase<C>)
where
    H: Hamiltonian,
    H::Coords: Coords<With<C::Leaf> = C>,
    X: Composition<H>,
    C: Coords,
{
    for steps in [0, 1, 137] {
        let mut whole =
            system.run_with::<C::Leaf, X>(composition, start.clone(), 0.01).expect("an admissible start").at_time(0.3);
        whole.advance(steps).expect("finite");
        let mut resumed = Run::<C>::resume_with(system, composition, &whole.checkpoint()).expect("it was just made");
        assert_eq!((resumed.time(), resumed.steps(), resumed.step()), (whole.time(), steps, 0.01));
        assert_eq!(resumed.state(), whole.state());
        whole.advance(863).expect("finite");
        resumed.advance(863).expect("finite");
        assert_eq!(resumed.state(), whole.state(), "{} after {steps} steps", X::NAME);
        assert_eq!(resumed.checkpoint(), whole.checkpoint(), "the unfinished state too");
    }
}

#[test]
fn a_resumed_run_is_the_uninterrupted_one() {
    let (q, p) = ([2.0], [0.1]);
    interrupted(&PENDULUM, Verlet, Phase::new(q, p));
    interrupted(&PENDULUM, VelocityVerlet, Phase::new(q, p));
    interrupted(&PENDULUM, Euler, Phase::new(q, p));
    interrupted(&PENDULUM, BlanesCasasRos6, Phase::new(q, p));
    interrupted(&PENDULUM, KahanLi8, Phase::new([2.0_f32], [0.1]));
    interrupted(&PENDULUM, Yoshida4, Phase::compensated(q, p));
    interrupted(&PENDULUM, Yoshida4, Phase::reversible(q, p, 1.0 / (1_u64 << 44) as f64));
    interrupted(&Chain, Yoshida4, Phase::new(vec![0.1, -0.2, 0.4], vec![0.0, 1.0, 0.5]));
    interrupted(&Swarm, Yoshida4, Phase::new(vec![[0.1, -0.2]; 5], vec![[0.0, 1.0]; 5]));
}

/// A resumed run makes lists of its own, at another time than the one that went on with its old ones.
#[test]
fn a_run_over_lists_of_neighbours_is_resumed_with_the_same_bits() {
    let place = |n: i32| [f64::from(n % 32), f64::from(n / 32)];
    let q: Vec<_> = (0..1024).map(place).collect();
    let p = q.iter().map(|[x, y]| [(3.0 * x + 7.0 * y).sin(), (5.0 * x - y).cos()]).collect();
    let mut whole = Crowd.run(Phase::new(q, p), 0.02).expect("an admissible start");
    whole.advance(3).expect("finite");
    let mut resumed = Run::<Vec<[f64; 2]>>::resume(&Crowd, &whole.checkpoint()).expect("it was just made");
    for _ in 0..4 {
        whole.advance(2).expect("finite");
        resumed.advance(2).expect("finite");
        assert_eq!(resumed.state(), whole.state());
    }
    assert_eq!(resumed.energy().to_bits(), whole.energy().to_bits());
    assert_eq!(resumed.checkpoint(), whole.checkpoint(), "the unfinished state too");
}

fn resumed(bytes: &[u8]) -> Result<Run<[f64; 1]>, CheckpointError> {
    Run::resume(&PENDULUM, bytes)
}

#[test]
fn no_flipped_bit_is_accepted() {
    let bytes = run().checkpoint();
    assert!(resumed(&bytes).is_ok());
    for bit in 0..8 * bytes.len() {
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let error = resumed(&flipped).expect_err("a bit is wrong");
        let expected = match bit / 8 {
            0..8 => matches!(error, CheckpointError::Foreign),
            8..10 => matches!(
                error,
                CheckpointError::Newer { .. } | CheckpointError::Older { .. } | CheckpointError::Damaged
            ),
            _ => matches!(error, CheckpointError::Damaged),
        };
        assert!(expected, "bit {bit}: {error}");
    }
}

#[test]
fn no_part_of_a_checkpoint_is_accepted() {
    let bytes = run().checkpoint();
    for length in 0..bytes.len() {
        let error = resumed(&bytes[..length]).expect_err("the end is missing");
        assert!(matches!(error, CheckpointError::Foreign | CheckpointError::Damaged), "{length} bytes: {error}");
    }
    let more = [&bytes[..], &[0]].concat();
    assert!(matches!(resumed(&more), Err(CheckpointError::Damaged)));
}

/// The names of a composition that exists twice.
mod early {
    use integrator_core::prelude::*;
    composition! {
        /// Kick in the middle.
        pub struct Mine: order 2 = T(1/2) V(1) T(1/2);
    }
}

mod late {
    use integrator_core::prelude::*;
    composition! {
        /// Two steps in one.
        pub struct Mine: order 2 = T(1/4) V(1/2) T(1/2) V(1/2) T(1/4);
    }
}

#[test]
fn the_checkpoint_of_another_run_is_refused_with_a_reason() {
    let bytes = run().checkpoint();
    let text = |error: CheckpointError| error.to_string();

    assert_eq!(
        text(resumed(b"a letter to a friend").expect_err("no checkpoint")),
        "this is not a checkpoint of the kind that is to be resumed: its first bytes differ"
    );
    let mut newer = bytes.clone();
    newer[8] = 6;
    assert_eq!(
        text(resumed(&newer).expect_err("from the future")),
        "this checkpoint has version 6 of its format, which is newer than this library\nhelp: update integrator-core"
    );
    let mut older = bytes.clone();
    older[8] = 1;
    assert_eq!(
        text(resumed(&older).expect_err("from the past")),
        "this checkpoint has version 1 of its format, which this library does not read\nhelp: integrate again from the start"
    );
    let damaged = text(resumed(&bytes[..20]).expect_err("short"));
    assert!(damaged.starts_with("this checkpoint is damaged\nnote: bytes are missing"), "{damaged}");

    struct Other;
    #[hamiltonian]
    impl Other {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            q[0] * q[0] / 2.0
        }
    }
    let error = text(Run::<[f64; 1]>::resume_with(&Other, Yoshida4, &bytes).expect_err("another system"));
    let stored = "this checkpoint was made with the system `checkpoints::Pendulum`, not `checkpoints::";
    assert!(error.starts_with(stored) && error.ends_with("Other`"), "{error}");

    assert_eq!(
        text(Run::<[f64; 1]>::resume_with(&PENDULUM, Verlet, &bytes).expect_err("another composition")),
        "this checkpoint was made with the composition `Yoshida4`, not `Verlet`"
    );
    let single: Result<Run<[f32; 1]>, _> = Run::resume(&PENDULUM, &bytes);
    assert_eq!(
        text(single.expect_err("another precision")),
        "this checkpoint was made with the precision `f64`, not `f32`"
    );
    let early = PENDULUM.run_with(early::Mine, Phase::new([1.0], [0.0]), 0.1).expect("an admissible start");
    assert_eq!(
        text(Run::<[f64; 1]>::resume_with(&PENDULUM, late::Mine, &early.checkpoint()).expect_err("other stages")),
        "`Mine` has other stages than in this checkpoint\nnote: its declaration was changed, or it is another composition of this name"
    );
}

#[test]
fn changed_parameters_are_refused_unless_they_are_meant() {
    let bytes = run().checkpoint();
    let longer = Pendulum { length: PENDULUM.length + 0.05 };
    let refused: Result<Run<[f64; 1]>, _> = Run::resume(&longer, &bytes);
    let text = refused.expect_err("another length").to_string();
    assert!(text.starts_with("`checkpoints::Pendulum` has other parameters than in this"), "{text}");
    assert!(text.contains("resume_with_changed_parameters"), "{text}");
    let mut meant: Run<[f64; 1]> = Run::resume_with_changed_parameters(&longer, &bytes).expect("meant");
    assert_eq!((meant.steps(), meant.time()), (run().steps(), run().time()));
    meant.advance(10).expect("bounded");
    // The same parameters are those of the run itself.
    let same: Run<[f64; 1]> = Run::resume_with_changed_parameters(&PENDULUM, &bytes).expect("the same");
    assert_eq!(same.state(), run().state());
    // By another composition as well.
    let bytes = PENDULUM.run_with(Verlet, Phase::new([1.0], [0.0]), 0.1).expect("an admissible start").checkpoint();
    assert!(Run::<[f64; 1]>::resume_with_changed_parameters_with(&longer, Verlet, &bytes).is_ok());
    assert!(Run::<[f64; 1]>::resume_with(&longer, Verlet, &bytes).is_err());
    assert!(Run::<[f64; 1]>::resume_with_changed_parameters(&longer, &bytes).is_err());

    /// A list and a count, of which nothing else is prepared.
    #[derive(Clone)]
    struct Springs {
        stiffness: Vec<f64>,
        bonds: usize,
    }
    #[hamiltonian]
    impl Springs {
        fn kinetic(&self, p: &[f64]) -> f64 {
            p.iter().map(|p| p * p / 2.0).sum()
        }
        fn potential(&self, q: &[f64]) -> f64 {
            let mut sum = 0.0;
            for i in 0..self.bonds {
                sum += self.stiffness[i] * (q[i + 1] - q[i]).powi(2);
            }
            sum
        }
    }
    let springs = Springs { stiffness: vec![1.0, 2.0, 3.0], bonds: 3 };
    let mut run = springs.run(Phase::new(vec![0.0, 1.5, 2.0, 3.0], vec![0.0; 4]), 0.01).expect("a good start");
    run.advance(7).expect("bounded");
    let bytes = run.checkpoint();
    assert!(Run::<Vec<f64>>::resume(&springs, &bytes).is_ok());
    let others = [
        Springs { stiffness: vec![1.0, 2.0, 3.0 + 1e-15], bonds: 3 },
        Springs { stiffness: vec![2.0, 1.0, 3.0], bonds: 3 },
        Springs { stiffness: vec![1.0, 2.0, 3.0], bonds: 2 },
    ];
    for other in others {
        let refused = Run::<Vec<f64>>::resume(&other, &bytes);
        assert!(matches!(refused, Err(CheckpointError::Parameters { .. })), "{refused:?}");
    }
}

/// A rotation by hand and a stated derivative, which read some fields themselves and others by a helper. No formula of `H` reads any.
#[derive(Clone)]
struct Called {
    frequency: f64,
    table: Vec<(usize, f64)>,
    bend: Option<[f32; 2]>,
    depth: Depth,
}

/// Its `Hash` leaves nothing out.
#[derive(Clone, Hash)]
enum Depth {
    Whole(i32),
}

#[hamiltonian(split = oscillator + rest)]
impl Called {
    fn oscillator(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        0.5 * (q[0] * q[0] + p[0] * p[0])
    }
    #[flow(oscillator)]
    fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {
        let (s, c) = (self.frequency * duration).sin_cos();
        (q[0], p[0]) = (c * q[0] + s * p[0], c * p[0] - s * q[0]);
    }
    fn rest(&self, q: [f64; 1]) -> f64 {
        self.curve(q[0])
    }
    #[derivative(slope)]
    fn curve(&self, x: f64) -> f64 {
        self.coefficient() * x.powi(4)
    }
    fn slope(&self, x: f64) -> f64 {
        let Self { depth: Depth::Whole(depth), .. } = self;
        4.0 * self.coefficient() * f64::from(*depth) * x.powi(3)
    }
    fn coefficient(&self) -> f64 {
        self.table[0].1 * f64::from(self.bend.unwrap_or_default()[1])
    }
}

#[test]
fn fields_that_only_methods_read_are_compared() {
    let own = Called { frequency: 1.0, table: vec![(0, 0.1)], bend: Some([0.0, 1.0]), depth: Depth::Whole(1) };
    let mut run = own.run(Phase::new([1.0], [0.0]), 0.1).expect("a run");
    run.advance(7).expect("finite");
    let bytes = run.checkpoint();
    let resumed = Run::<[f64; 1]>::resume(&own, &bytes).expect("the same fields");
    assert_eq!(resumed.state(), run.state());
    for other in [
        Called { frequency: 2.0, ..own.clone() },
        Called { table: vec![(0, 0.2)], ..own.clone() },
        Called { bend: Some([0.0, 2.0]), ..own.clone() },
        Called { bend: None, ..own.clone() },
        Called { depth: Depth::Whole(2), ..own.clone() },
    ] {
        let refused = Run::<[f64; 1]>::resume(&other, &bytes);
        assert!(matches!(refused, Err(CheckpointError::Parameters { .. })), "{refused:?}");
        Run::<[f64; 1]>::resume_with_changed_parameters(&other, &bytes).expect("they are meant");
    }
    let member = |system: &Called| (system.clone(), Phase::new([1.0], [0.0]));
    let swarm = Ensemble::new(Verlet, [member(&own), member(&own)], 0.1).expect("members");
    let other = Called { frequency: 2.0, ..own.clone() };
    Ensemble::<[f64; 1]>::resume(Verlet, [own.clone(), own.clone()], &swarm.checkpoint()).expect("the same fields");
    let refused = Ensemble::<[f64; 1]>::resume(Verlet, [own, other], &swarm.checkpoint());
    assert!(matches!(refused, Err(CheckpointError::Member { member: 1, .. })), "{refused:?}");
}

/// What is read of it cannot be compared.
#[derive(Clone)]
struct Curve(f64);

#[derive(Clone)]
struct Opaque {
    curve: Curve,
}

#[hamiltonian]
impl Opaque {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.curve(q[0])
    }
    #[derivative(slope)]
    fn curve(&self, x: f64) -> f64 {
        self.curve.0 * x * x
    }
    fn slope(&self, x: f64) -> f64 {
        let curve = &self.curve;
        2.0 * curve.0 * x
    }
}

#[derive(Clone)]
struct Told {
    curve: Curve,
}

#[hamiltonian]
impl Told {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        self.curve(q[0])
    }
    #[derivative(slope)]
    fn curve(&self, x: f64) -> f64 {
        self.curve.0 * x * x
    }
    fn slope(&self, x: f64) -> f64 {
        let curve = &self.curve;
        2.0 * curve.0 * x
    }
    fn fingerprint(&self) -> u64 {
        self.curve.0.to_bits()
    }
}

#[test]
fn a_field_that_cannot_be_compared_needs_a_fingerprint() {
    let (curve, start) = (Curve(1.0), Phase::new([1.0], [0.0]));
    let opaque = Opaque { curve: curve.clone() };
    let bytes = opaque.run(start, 0.1).expect("a run").checkpoint();
    let refused = Run::<[f64; 1]>::resume(&opaque, &bytes);
    assert!(matches!(refused, Err(CheckpointError::Incomparable { field: "self.curve", .. })), "{refused:?}");
    Run::<[f64; 1]>::resume_with_changed_parameters(&opaque, &bytes).expect("nothing is compared");
    let told = Told { curve };
    let bytes = told.run(start, 0.1).expect("a run").checkpoint();
    Run::<[f64; 1]>::resume(&told, &bytes).expect("the same fingerprint");
    let refused = Run::<[f64; 1]>::resume(&Told { curve: Curve(2.0) }, &bytes);
    assert!(matches!(refused, Err(CheckpointError::Parameters { .. })), "{refused:?}");
}

#[test]
fn another_system_of_the_same_name_is_refused() {
    let bytes = {
        struct Well;
        #[hamiltonian]
        impl Well {
            fn kinetic(&self, p: [f64; 1]) -> f64 {
                p[0] * p[0] / 2.0
            }
            fn potential(&self, q: [f64; 1]) -> f64 {
                q[0] * q[0] / 2.0
            }
        }
        let mut run = Well.run(Phase::new([1.0], [0.0]), 0.1).expect("a good start");
        run.advance(3).expect("bounded");
        run.checkpoint()
    };
    struct Well;
    #[hamiltonian]
    impl Well {
        fn kinetic(&self, p: [f64; 1]) -> f64 {
            p[0] * p[0] / 2.0
        }
        fn potential(&self, q: [f64; 1]) -> f64 {
            q[0] * q[0] / 2.0 + q[0].powi(4)
        }
    }
    let refused = Run::<[f64; 1]>::resume(&Well, &bytes);
    assert!(matches!(refused, Err(CheckpointError::Formulas { .. })), "{refused:?}");
    assert!(Run::<[f64; 1]>::resume_with_changed_parameters(&Well, &bytes).is_ok());
}

#[test]
fn a_run_whose_state_was_changed_is_resumed_where_it_was() {
    let mut run = run();
    run.map_state(|state| state.p[0] = 0.5).expect("a finite state");
    for steps in [0, 5] {
        run.advance(steps).expect("bounded");
        let mut again = resumed(&run.checkpoint()).expect("whole");
        let mut first = run.clone();
        assert_eq!((again.state(), again.time()), (first.state(), first.time()));
        again.advance(2_000).expect("bounded");
        first.advance(2_000).expect("bounded");
        assert_eq!(again.state(), first.state());
    }
}

/// A path that no other test uses.
fn scratch(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}-{}", std::process::id()))
}

#[test]
fn a_file_is_resumed_and_a_folder_that_is_not_there_is_an_error() {
    let (path, mut run) = (scratch("file"), run());
    run.checkpoint_to(&path).expect("a writable folder");
    run.advance(10).expect("finite");
    run.checkpoint_to(&path).expect("the file is replaced");
    let bytes = fs::read(&path).expect("the file");
    assert_eq!(resumed(&bytes).expect("whole").state(), run.state());
    fs::remove_file(&path).expect("the file");
    let nowhere = run.checkpoint_to(path.join("below/a/file"));
    assert!(matches!(nowhere, Err(CheckpointError::File(_))));
}

/// Goes on with the run in a file, or begins it, and writes it down again and again until it is killed.
fn work(path: &Path) -> ! {
    let mut run = match fs::read(path) {
        Ok(bytes) => resumed(&bytes).expect("what a killed process leaves is whole"),
        Err(_) => PENDULUM.run(Phase::new([2.0], [0.1]), 0.01).expect("an admissible start"),
    };
    loop {
        run.advance(500).expect("finite");
        run.checkpoint_to(path).expect("a writable folder");
    }
}

#[test]
fn a_run_killed_two_hundred_times_ends_with_the_same_bits() {
    const FILE: &str = "KILLED_RUN";
    if let Some(path) = env::var_os(FILE) {
        work(Path::new(&path));
    }
    let path = scratch("killed");
    let this = env::current_exe().expect("the path of this test");
    let mut steps = 0;
    for attempt in 0..200_u64 {
        let mut child = Command::new(&this)
            .args(["--exact", "a_run_killed_two_hundred_times_ends_with_the_same_bits"])
            .env(FILE, &path)
            .stdout(Stdio::null())
            .spawn()
            .expect("this test can be started again");
        // As soon as there is something new, and then at another moment each time.
        loop {
            let now = fs::read(&path).map_or(0, |bytes| resumed(&bytes).expect("a file is whole at all times").steps());
            assert!(now >= steps, "{now} steps are fewer than {steps}");
            if std::mem::replace(&mut steps, now) < now {
                break;
            }
            let ended = child.try_wait().expect("a child");
            assert!(ended.is_none(), "attempt {attempt} ended by itself: {ended:?}");
        }
        std::thread::sleep(Duration::from_micros(7_919 * attempt % 5_003));
        child.kill().expect("a child");
        assert!(!child.wait().expect("a child").success(), "attempt {attempt} ended by itself");
    }
    let mut resumed = resumed(&fs::read(&path).expect("the file")).expect("whole");
    let mut whole = PENDULUM.run(Phase::new([2.0], [0.1]), 0.01).expect("an admissible start");
    whole.advance(resumed.steps() + 1_000).expect("finite");
    resumed.advance(1_000).expect("finite");
    assert_eq!(resumed.state(), whole.state());
    let _ = fs::remove_file(path.with_extension("partial"));
    fs::remove_file(&path).expect("the file");
}
