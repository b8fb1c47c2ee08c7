//! Tangents as bytes: they go on bit for bit, and what is no checkpoint of them is refused.

use integrator_core::{CheckpointError, Coords, Memoryless, Tangent, prelude::*};

/// A driven pendulum, whose parameters have derivatives.
struct Pendulum {
    length: f64,
    drive: f64,
}

#[hamiltonian(sensitive(length, drive), compose = Yoshida4)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / (2.0 * self.length * self.length)
    }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 {
        -self.length * (1.0 + self.drive * t.sin()) * q[0].cos()
    }
}

/// A chain on a hill, whose vectors grow beyond all numbers.
struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        let bonds: f64 = q.windows(2).map(|pair| (pair[1] - pair[0]).powi(2) / 2.0).sum();
        bonds - 2.0 * q.iter().map(|q| q * q).sum::<f64>()
    }
}

/// A star and two planets in Jacobi coordinates, which states are mapped to and back from.
struct Planets {
    mass: [f64; 3],
}

#[hamiltonian(coordinates = jacobi(self.mass), split = kepler + interaction, compose = Aba864)]
impl Planets {
    fn kinetic(&self, p: &[[f64; 2]; 3]) -> f64 {
        (0..3).map(|i| (0..2).map(|d| p[i][d].powi(2)).sum::<f64>() / (2.0 * self.mass[i])).sum()
    }
    fn potential(&self, q: &[[f64; 2]; 3]) -> f64 {
        let mut energy = 0.0;
        for i in 0..3 {
            for j in 0..i {
                let square = (0..2).map(|d| (q[i][d] - q[j][d]).powi(2)).sum::<f64>();
                energy -= self.mass[i] * self.mass[j] / square.sqrt();
            }
        }
        energy
    }
}

/// Goes on in portions and from bytes to the same end.
fn holds<C: Coords<Leaf = f64>>(
    mut tangent: Tangent<C>,
    steps: u64,
    resume: impl Fn(&[u8]) -> Result<Tangent<C>, CheckpointError>,
) -> Tangent<C> {
    tangent.advance(steps).expect("finite states");
    let mut resumed = resume(&tangent.checkpoint()).expect("it was just written");
    let all =
        |tangent: &Tangent<C>| (tangent.steps(), tangent.state(), tangent.vectors(), tangent.exponents().to_vec());
    assert_eq!((all(&resumed), resumed.time()), (all(&tangent), tangent.time()));
    tangent.advance(333).and_then(|()| resumed.advance(333)).expect("finite states");
    assert_eq!((all(&resumed), resumed.energy()), (all(&tangent), tangent.energy()));
    tangent
}

fn resumed<H, X>(system: &H, method: X) -> impl Fn(&[u8]) -> Result<Tangent<H::Coords>, CheckpointError>
where
    H: Hamiltonian,
    X: Memoryless<H>,
{
    move |bytes| Tangent::resume(system, method, bytes)
}

#[test]
fn tangents_resume_from_their_bytes() {
    let pendulum = Pendulum { length: 1.2, drive: 0.3 };
    let (start, vector) = (Phase::new([1.0], [0.2]), Phase::new([0.3], [0.4]));
    let tangent = pendulum.tangent(Yoshida4, start, [vector], 0.1).expect("a start").at_time(2.5);
    holds(tangent, 101, resumed(&pendulum, Yoshida4));
    let tangent = pendulum.sensitivities(Yoshida4, start, [vector], 0.1).expect("a start");
    holds(tangent, 101, |bytes| Tangent::resume_sensitivities(&pendulum, Yoshida4, bytes));

    // Six vectors, in two groups, that were divided.
    let chain = Phase::new(vec![0.0; 3], vec![0.0; 3]);
    let unit = |k: usize| Phase::new((0..3).map(|i| f64::from(u8::from(i == k % 3))).collect(), vec![k as f64; 3]);
    let tangent = Chain.tangent(BlanesMoanSrkn11, chain, (0..6).map(unit), 0.5).expect("a start");
    let tangent = holds(tangent, 900, resumed(&Chain, BlanesMoanSrkn11));
    assert!(tangent.exponents().iter().all(|exponent| *exponent > 200), "{:?}", tangent.exponents());

    let planets = Planets { mass: [1.0, 0.1, 0.1] };
    let start = Phase::new([[0.0, 0.0], [1.0, 0.1], [0.0, -4.0]], [[0.0, -0.15], [0.0, 0.1], [0.05, 0.0]]);
    let tangent = planets.tangent(Aba864, start, [start], 0.1).expect("a start");
    holds(tangent, 77, resumed(&planets, Aba864));
}

#[test]
fn other_bytes_than_a_checkpoint_of_a_tangent_are_refused() {
    let pendulum = Pendulum { length: 1.2, drive: 0.3 };
    let start = Phase::new([1.0], [0.2]);
    let run = pendulum.run_with(Yoshida4, start, 0.1).expect("a start").checkpoint();
    let tangent = pendulum.tangent(Yoshida4, start, [start], 0.1).expect("a start").checkpoint();
    let sensitive = pendulum.sensitivities(Yoshida4, start, [], 0.1).expect("a start").checkpoint();
    let refused =
        |bytes: &[u8]| Tangent::<[f64; 1]>::resume(&pendulum, Yoshida4, bytes).expect_err("it is another one");
    assert!(matches!(refused(&run), CheckpointError::Foreign));
    assert!(matches!(Run::<[f64; 1]>::resume(&pendulum, &tangent), Err(CheckpointError::Foreign)));
    let error = refused(&sensitive).to_string();
    assert_eq!(error, "this checkpoint was made with the number of parameters `2`, not `0`");
    let parameters = Tangent::<[f64; 1]>::resume_sensitivities(&pendulum, Yoshida4, &tangent);
    assert!(matches!(parameters, Err(CheckpointError::Other { .. })));
    assert!(matches!(
        Tangent::<[f64; 1]>::resume(&pendulum, Verlet, &tangent),
        Err(CheckpointError::Other { what: "composition", .. })
    ));
    let longer = Pendulum { length: 1.3, ..pendulum };
    let changed = Tangent::<[f64; 1]>::resume(&longer, Yoshida4, &tangent);
    assert!(matches!(changed, Err(CheckpointError::Parameters { .. })));
    for place in 0..tangent.len() {
        let mut other = tangent.clone();
        other[place] ^= 4;
        refused(&other);
        refused(&tangent[..place]);
    }
}
