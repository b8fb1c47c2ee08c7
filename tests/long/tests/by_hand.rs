//! Hand-written steppers and generated code give the same steps, up to rounding.
//!
//! They round differently by one unit in the last place per operation, and over a few dozen steps an orbit amplifies
//! such a difference by a factor of some hundreds at most. A tolerance of 1e-12 of the largest coordinate is far above
//! that, and far below the effect of a wrong term.
//! above that, and far below a wrong term.

#[cfg(target_arch = "x86_64")]
use integrator_bench::{by_hand::liquid::Liquid, problems::ArgonInBox, starts::liquid};
use integrator_bench::{
    by_hand::{
        carried,
        chain::Chain,
        field::Field,
        law::Law,
        oscillators, plain,
        points::{self, Point},
        row,
        swarm::Swarm,
        tiles::{Attraction, Bodies},
    },
    plan::Plan,
    problems::{Argon, Fput, Phi4, Phi4Plane, Phi4Volume, SineGordon, Toda},
    starts::{Problems, argon, cluster, planes_of_waves, rows_of_waves, waves},
};
use integrator_core::{Coords, prelude::*};

const STEPS: u64 = 40;

#[track_caller]
fn agree(what: &str, ours: &[f64], theirs: &[f64], tolerance: f64) {
    let largest = ours.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    assert_eq!(ours.len(), theirs.len(), "{what}");
    for (i, (a, b)) in ours.iter().zip(theirs).enumerate() {
        assert!((a - b).abs() <= tolerance * largest, "{what}, coordinate {i}: {a} and {b}");
    }
}

fn end<H: Hamiltonian, X: Composition<H>>(
    system: &H,
    start: &Phase<H::Coords>,
    composition: X,
    h: f64,
) -> Phase<H::Coords>
where
    H::Coords: Coords<Leaf = f64>,
{
    let mut run = system.run_with::<f64, X>(composition, start.clone(), h).expect("a start");
    run.advance(STEPS).expect("finite states");
    run.state()
}

fn flat<C: Coords<Leaf = f64>>(state: &Phase<C>) -> Vec<f64> {
    [state.q.flat(), state.p.flat()].concat()
}

#[test]
fn coupled_oscillators_agree_in_compositions_that_begin_with_them() {
    let problem = Problems::default().coupled_oscillators();
    macro_rules! compare {
        ($($composition:ident)*) => {$(
            let ours = flat(&end(&problem.system, &problem.start, $composition, 0.1));
            let by_hand = oscillators::henon_heiles([[0.1, 0.0, 0.0, 0.5]], &Plan::of::<$composition>(0.1), STEPS);
            agree(stringify!($composition), &ours, &by_hand[0], 1e-12);
        )*};
    }
    compare!(Verlet Aba864);
}

#[test]
fn single_trajectories_agree_in_every_composition() {
    let problems = Problems::default();
    let (pendulum, henon, kepler) = (problems.pendulum(), problems.henon_heiles(), problems.kepler());
    macro_rules! compare {
        ($($composition:ident)*) => {$(
            let h = 0.01;
            let plan = Plan::of::<$composition>(h);
            let name = stringify!($composition);
            let ours = flat(&end(&pendulum.system, &pendulum.start, $composition, h));
            let by_hand = flat(&plain::pendulum(&pendulum.system, pendulum.start, &plan, STEPS));
            agree(name, &ours, &by_hand, 1e-12);
            for point in [Point::Pendulum, Point::FastPendulum] {
                let columns = [2.0, 0.0, 1.0, 1.0];
                agree(name, &ours, &points::scalar(point, columns, &plan, STEPS)[..2], 1e-12);
                agree(name, &ours, &points::wide(point, columns, &plan, STEPS)[..2], 1e-12);
            }
            let ours = flat(&end(&henon.system, &henon.start, $composition, h));
            agree(name, &ours, &points::scalar(Point::HenonHeiles, [0.1, 0.0, 0.0, 0.5], &plan, STEPS), 1e-12);
            let ours = flat(&end(&kepler.system, &kepler.start, $composition, h));
            agree(name, &ours, &points::scalar(Point::Kepler, [0.4, 0.0, 0.0, 2.0], &plan, STEPS), 1e-12);
            agree(name, &ours, &points::wide(Point::Kepler, [0.4, 0.0, 0.0, 2.0], &plan, STEPS), 1e-12);
        )*};
    }
    compare!(Verlet VelocityVerlet KahanLi8 SofroniouSpaletta10 Euler);
}

#[test]
fn rows_agree() {
    let problems = Problems::default();
    let (solar, chain) = (problems.solar(), problems.chain());
    let plan = Plan::of::<KahanLi8>(100.0);
    let ours = flat(&end(&solar.system, &solar.start, KahanLi8, 100.0));
    for theirs in [plain::solar, row::solar] {
        let theirs = flat(&theirs(&solar.system, solar.start, &plan, STEPS));
        agree("positions", &ours[..18], &theirs[..18], 1e-12);
        agree("momenta", &ours[18..], &theirs[18..], 1e-12);
    }
    let plan = Plan::of::<KahanLi8>(0.1);
    let ours = flat(&end(&chain.system, &chain.start, KahanLi8, 0.1));
    for theirs in [plain::chain, row::chain] {
        agree("chain", &ours, &flat(&theirs(&chain.system, chain.start, &plan, STEPS)), 1e-12);
    }
}

#[test]
fn compensated_trajectories_agree() {
    let (problems, plan) = (Problems::default(), Plan::of::<KahanLi8>(0.1));
    let galaxy = problems.henon_heiles();
    let Phase { q, .. } = end(&galaxy.system, &galaxy.start, KahanLi8, 0.1);
    let ([x, y], [px, py]) = (galaxy.start.q, galaxy.start.p);
    agree("galaxy", &q[..1], &[carried::henon_heiles([x, y, px, py], &plan, STEPS)], 1e-12);

    let chain = problems.chain();
    let Phase { q, .. } = end(&chain.system, &chain.start, KahanLi8, 0.1);
    agree("chain", &q[..8], &carried::chain(&chain.system, chain.start, &plan, STEPS), 1e-12);

    let (solar, plan) = (problems.solar(), Plan::of::<KahanLi8>(100.0));
    let Phase { q, .. } = end(&solar.system, &solar.start, KahanLi8, 100.0);
    agree("solar", &q.map(|body| body[0]), &carried::solar(&solar.system, solar.start, &plan, STEPS)[..6], 1e-12);
}

#[test]
fn swarms_agree_with_single_trajectories() {
    let plan = Plan::of::<Verlet>(0.01);
    let members: Vec<[f64; 4]> = (0..256).map(|i| [0.5 + f64::from(i) / 512.0, 0.2, 1.0, 1.0]).collect();
    for point in [Point::Pendulum, Point::FastPendulum, Point::HenonHeiles, Point::Kepler] {
        let mut swarm = Swarm::<f64>::new(point, &members);
        let mut singles = Swarm::<f32>::new(point, &members);
        swarm.advance(&plan, STEPS);
        singles.advance(&plan, STEPS);
        for member in [0, 77, 255] {
            let alone = points::scalar(point, members[member], &plan, STEPS);
            agree(&format!("{point:?}"), &alone, &swarm.member(member), 1e-12);
            // Forty steps in `f32`: a few dozen rounding errors of 6e-8.
            agree(&format!("{point:?} in f32"), &alone, &singles.member(member), 1e-5);
        }
    }
}

/// Enough sites for several tiles, with a last tile that is not full.
const SITES: usize = 2600;

#[track_caller]
fn compare_chain<H: Hamiltonian<Coords = Vec<f64>>>(system: &H, law: Law) {
    let start = waves(SITES);
    let ours = flat(&end(system, &start, Verlet, 0.05));
    let plan = Plan::of::<Verlet>(0.05);
    for advance in [Chain::skewed, Chain::two_pass] {
        let mut chain = Chain { law, q: start.q.clone(), p: start.p.clone() };
        advance(&mut chain, &plan, STEPS as usize);
        agree(&format!("{law:?}"), &ours, &[chain.q, chain.p].concat(), 1e-12);
    }
}

#[test]
fn long_chains_agree() {
    compare_chain(&Fput { alpha: 0.25 }, Law::Fput { alpha: 0.25 });
    compare_chain(&Toda, Law::Toda);
    compare_chain(&SineGordon { stiffness: 0.7 }, Law::SineGordon { stiffness: 0.7 });
    compare_chain(&Phi4 { stiffness: 0.7 }, Law::Phi4 { stiffness: 0.7 });
}

#[test]
fn planes_agree() {
    let stiffness = 0.7;
    for rows in [1, 2, 9, 37] {
        let start = rows_of_waves(rows);
        let ours = flat(&end(&Phi4Plane { stiffness }, &start, Verlet, 0.05));
        let plan = Plan::of::<Verlet>(0.05);
        for advance in [Field::one_pass, Field::two_pass, Field::skewed] {
            let mut plane = Field { stiffness, q: start.q.clone(), p: start.p.clone() };
            advance(&mut plane, &plan, STEPS as usize);
            agree("a plane", &ours, &[plane.q.as_flattened(), plane.p.as_flattened()].concat(), 1e-12);
        }
    }
}

#[test]
fn volumes_agree() {
    let (stiffness, start) = (0.7, planes_of_waves(17));
    let ours = flat(&end(&Phi4Volume { stiffness }, &start, Verlet, 0.05));
    let plan = Plan::of::<Verlet>(0.05);
    for advance in [Field::one_pass, Field::two_pass, Field::skewed] {
        let mut volume = Field { stiffness, q: start.q.clone(), p: start.p.clone() };
        advance(&mut volume, &plan, STEPS as usize);
        let [q, p] = [&volume.q, &volume.p].map(|half| half.as_flattened().as_flattened());
        agree("a volume", &ours, &[q, p].concat(), 1e-12);
    }
}

#[test]
fn tiles_agree_whether_or_not_they_are_full() {
    for count in [16, 37] {
        let (system, start) = cluster(count);
        let plan = Plan::of::<Verlet>(0.5);
        let mut bodies = Bodies::new(Attraction::Gravity, &system.masses, &start.q, &start.p);
        compare_bodies("stars", &end(&system, &start, Verlet, 0.5), &mut bodies, &plan);

        let (system, start) = argon(count);
        let plan = Plan::of::<Verlet>(1e-3);
        let Argon { cutoff } = system;
        let mut bodies = Bodies::new(Attraction::LennardJones { cutoff }, &vec![1.0; count], &start.q, &start.p);
        compare_bodies("atoms", &end(&system, &start, Verlet, 1e-3), &mut bodies, &plan);
    }
}

#[track_caller]
fn compare_bodies(what: &str, ours: &Phase<Vec<[f64; 3]>>, bodies: &mut Bodies, plan: &Plan) {
    bodies.advance(plan, STEPS);
    let theirs: Vec<[[f64; 3]; 2]> = (0..bodies.count()).map(|i| bodies.body(i)).collect();
    let column = |i: usize| theirs.iter().flat_map(|body| body[i]).collect::<Vec<f64>>();
    agree(what, ours.q.flat(), &column(0), 1e-12);
    agree(what, ours.p.flat(), &column(1), 1e-12);
}

/// On machines with AVX-512. The order of atoms differs, so the test compares a sum over all atoms.
#[cfg(target_arch = "x86_64")]
#[test]
fn a_liquid_has_the_same_momenta() {
    let (system, start) = liquid(7);
    if let Some(mut by_hand) = Liquid::new(&start.q, &start.p, system.side, ArgonInBox::CUTOFF) {
        by_hand.advance(STEPS, 0.004);
        let ours: f64 = end(&system, &start, Verlet, 0.004).p.iter().flatten().map(|p| p * p).sum();
        // Twice the tolerance of a coordinate, plus the rounding of a sum over all atoms.
        assert!((by_hand.squares() / ours - 1.0).abs() < 1e-11, "{} and {ours}", by_hand.squares());
    }
}
