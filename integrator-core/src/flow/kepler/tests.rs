use super::Kepler;
use crate::{
    error::Unsolved,
    scalar::{
        dual::Dual,
        fma::Fused,
        instruction_set::InstructionSet,
        real::{Kernel, Real},
        simd::lanes::Lanes,
        tolerance::within,
    },
    system::motion::Solver,
};

/// Kepler motion by `orbits.py`: q, p, inverse mass, k, duration; q and p after it; their conditions.
fn orbits() -> Vec<[f64; 15]> {
    let line = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|number| number.parse().expect("a number")).collect();
        numbers.try_into().expect("fifteen numbers")
    };
    include_str!("orbits.csv").lines().map(line).collect()
}

/// The state after a flow of a body with this inverse mass and strength.
fn flown<R: Real>([x, y, px, py]: [R; 4], [inverse_mass, strength]: [R; 2], duration: f64) -> [R; 4] {
    let [mut q, mut p] = [[[x, y]], [[px, py]]];
    Kepler::default().flow([&mut q, &mut p], &inverse_mass, &strength, duration);
    let ([[x, y]], [[px, py]]) = (q, p);
    [x, y, px, py]
}

/// A flow of bodies in space, with the instructions of its numbers.
struct InSpace<'a, R> {
    solver: &'a mut Kepler,
    halves: [&'a mut [[R; 3]]; 2],
    /// Inverse masses and strengths.
    constants: [&'a [R]; 2],
    duration: f64,
}

impl<R: Real> Kernel for InSpace<'_, R> {
    type Out = ();
    #[inline(always)]
    fn call(self) {
        let [inverse_masses, strengths] = self.constants;
        self.solver.flow(self.halves, inverse_masses, strengths, self.duration);
    }
}

/// Compiled once for each kind of numbers, of all that is tested the most expensive to compile.
#[inline(never)]
fn flow_in_space<R: Real>(solver: &mut Kepler, halves: [&mut [[R; 3]]; 2], constants: [&[R]; 2], duration: f64) {
    R::enter(InSpace { solver, halves, constants, duration });
}

/// Twice the size of the energy per mass, with the opposite sign, and the radial velocity times the distance.
fn elements([x, y, px, py]: [f64; 4], [inverse_mass, strength]: [f64; 2]) -> [f64; 2] {
    let velocity = inverse_mass * inverse_mass * (px * px + py * py);
    [2.0 * strength * inverse_mass / x.hypot(y) - velocity, inverse_mass * (x * px + y * py)]
}

/// Returns the factor by which an error grows as the argument of hyperbolic functions is doubled, as the argument does.
fn growth(states: [[f64; 4]; 2], constants: [f64; 2]) -> f64 {
    let anomaly = |state| {
        let [beta, eta] = elements(state, constants);
        (eta.abs() * (-beta).max(0.0).sqrt() / (constants[0] * constants[1]).abs()).asinh()
    };
    1.0 + states.into_iter().map(anomaly).sum::<f64>()
}

/// The number of orbits of the table that begin near the centre; the others fall from far away towards a pericentre.
const NEAR: usize = 213;

#[test]
fn orbits_of_all_kinds_are_those_of_the_table() {
    for [x, y, px, py, inverse_mass, strength, duration, after @ .., cx, cy, cpx, cpy] in
        orbits().into_iter().take(NEAR)
    {
        let (start, constants) = ([x, y, px, py], [inverse_mass, strength]);
        let found = flown(start, constants, duration);
        for (i, condition) in [cx, cy, cpx, cpy].into_iter().enumerate() {
            // Each of some dozen roundings acts as one of the numbers that the orbit follows from; those of the
            // increments and of the sums are of the size of the state.
            let rounding = f64::EPSILON * (condition + after[i].abs() + start[i].abs());
            let error = found[i] - after[i];
            let bound = 8.0 * rounding * growth([start, after], constants);
            assert!(within(error, bound), "coordinate {i} is off by {error:e} of {bound:e}: {start:?} for {duration}");
        }
    }
}

#[test]
fn orbits_in_single_precision_are_those_of_the_table() {
    for [x, y, px, py, inverse_mass, strength, duration, after @ .., cx, cy, cpx, cpy] in
        orbits().into_iter().take(NEAR)
    {
        let (start, constants) = ([x, y, px, py], [inverse_mass, strength]);
        let found = flown(start.map(|x| x as f32), constants.map(|x| x as f32), duration);
        for (i, condition) in [cx, cy, cpx, cpy].into_iter().enumerate() {
            let rounding = f64::from(f32::EPSILON) * (condition + after[i].abs() + start[i].abs());
            // Where no digit is correct, the first order of errors is meaningless.
            let lost = rounding > 1e-2 * (after[i].abs() + start[i].abs());
            let bound = 8.0 * rounding * growth([start, after], constants);
            let error = f64::from(found[i]) - after[i];
            assert!(lost || within(error, bound), "{i}: {error:e} of {bound:e}: {start:?} for {duration}");
        }
    }
}

/// Returns the error of the end of a fall, in units of the error that the roundings of the data cause: the larger one
/// of position and momentum. Where no digit is correct, the first order of errors is meaningless.
fn error_of_fall(start: [f64; 4], found: [f64; 4], after: [f64; 4], conditions: [f64; 4], unit: f64) -> f64 {
    let part = |i: usize| {
        let size = |numbers: [f64; 4]| numbers[i].hypot(numbers[i + 1]);
        let rounding = unit * (size(conditions) + size(after) + size(start));
        let error = f64::hypot(found[i] - after[i], found[i + 1] - after[i + 1]);
        if rounding > 1e-2 * (size(after) + size(start)) && error.is_finite() { 0.0 } else { error / rounding }
    };
    // Not a number stays one.
    if part(0) <= part(2) { part(2) } else { part(0) }
}

#[test]
fn falls_from_far_away_end_where_the_table_says() {
    for [x, y, px, py, inverse_mass, strength, duration, after @ .., cx, cy, cpx, cpy] in
        orbits().into_iter().skip(NEAR)
    {
        let (start, constants, conditions) = ([x, y, px, py], [inverse_mass, strength], [cx, cy, cpx, cpy]);
        let found = flown(start, constants, duration);
        // A change of a number by half a unit is one rounding; a dozen of them act as one of the start do.
        let error = error_of_fall(start, found, after, conditions, f64::EPSILON);
        assert!(within(error, 10.0), "{error} for {start:?}, {constants:?} for {duration}: {found:?} and {after:?}");
        let single = flown(start.map(|x| x as f32), constants.map(|x| x as f32), duration);
        let error = error_of_fall(start, single.map(f64::from), after, conditions, f64::from(f32::EPSILON));
        assert!(within(error, 10.0), "{error} for {start:?}, {constants:?} for {duration}: {single:?} and {after:?}");
    }
}

#[test]
fn light_and_heavy_particles_move_as_those_of_mass_one() {
    fn moves_alike<R: Real>(power: i32, unit: f64) {
        // An ellipse and a fall from far away.
        for (start, duration) in [([1.0, 0.2, -0.1, 0.9], 0.3), ([100.0, 0.5, -3.0, 0.0], 40.0)] {
            let mass = 2_f64.powi(power);
            let [x, y, px, py] = start.map(R::of);
            let alone = flown([x, y, px, py], [R::of(1.0); 2], duration);
            let scaled = flown([x, y, px * R::of(mass), py * R::of(mass)], [R::of(1.0 / mass), R::of(mass)], duration);
            for (i, scale) in [1.0, 1.0, mass, mass].into_iter().enumerate() {
                let [alone, scaled] = [alone[i].lane(0), scaled[i].lane(0) / scale];
                // A power of two changes no digit, but for those of the smallest numbers.
                assert!(within(scaled - alone, 2.0 * unit * alone.abs()), "mass 2^{power}: {scaled} and {alone}");
            }
        }
    }
    for power in [-100, -70, 64, 90] {
        moves_alike::<f32>(power, f64::from(f32::EPSILON));
    }
    for power in [-900, -520, 520, 900] {
        moves_alike::<f64>(power, f64::EPSILON);
    }
}

/// Bound orbits without and with a pericentre passage, one that nearly falls into the centre, a hyperbola,
/// one that is followed far out, and a fall from far away past the pericentre.
const STARTS: [([f64; 4], [f64; 2], f64); 6] = [
    ([1.0, 0.2, -0.1, 0.9], [1.0, 1.0], 0.3),
    ([3.0, -1.0, 0.2, 0.5], [0.5, 2.0], -4.0),
    ([0.1, 0.0, 0.0, 4.4], [1.0, 1.0], 2.5),
    ([-4.0, 1.0, 3.0, 0.3], [0.5, 1.5], 7.0),
    ([1.0, 0.2, -0.1, 3.0], [1.0, 1.0], 1000.0),
    ([100.0, 0.5, -3.0, 0.1], [1.0, 1.0], 36.0),
];

#[test]
fn two_flows_are_one_for_the_sum_of_their_durations() {
    for (start, constants, duration) in STARTS {
        let halves = flown(flown(start, constants, 0.25 * duration), constants, 0.75 * duration);
        let (whole, tangent) = (flown(start, constants, duration), tangent(start, constants, duration));
        for i in 0..4 {
            // The rounding of the state in between is carried along the rest of the way, at most as far as that of the
            // start along all of it, times the change of scale on the way.
            let carried: f64 = (0..4).map(|j| tangent[j][i].abs() * start[j].abs().max(1.0)).sum();
            let error = halves[i] - whole[i];
            assert!(within(error, 100.0 * f64::EPSILON * (carried + 1.0)), "{start:?}: {error:e} {carried}");
        }
    }
}

#[test]
fn the_flow_for_the_opposite_duration_leads_back() {
    for (start, constants, duration) in STARTS {
        let (there, tangent) = (flown(start, constants, duration), tangent(start, constants, duration));
        let back = flown(there, constants, -duration);
        // The inverse of a symplectic matrix has the same entries, up to sign, in other places.
        let carried: f64 = tangent.as_flattened().iter().map(|x| x.abs()).sum();
        let size: f64 = start.iter().chain(&there).map(|x| x.abs()).sum();
        for i in 0..4 {
            let error = back[i] - start[i];
            assert!(within(error, 8.0 * f64::EPSILON * carried * size), "{start:?}: {error:e} {carried}");
        }
    }
}

/// The columns of the tangent map, by duals.
fn tangent(start: [f64; 4], constants: [f64; 2], duration: f64) -> [[f64; 4]; 4] {
    [0, 1, 2, 3].map(|column| {
        let coordinate = |i: usize| <Dual>::state(&|lane| if lane == 0 { start[i] } else { f64::from(i == column) });
        flown([0, 1, 2, 3].map(coordinate), constants.map(<Dual>::of), duration).map(|number| number.lane(1))
    })
}

#[test]
fn tangent_maps_are_symplectic_and_those_of_the_flow() {
    let form = |a: &[f64; 4], b: &[f64; 4]| a[0] * b[2] + a[1] * b[3] - a[2] * b[0] - a[3] * b[1];
    for (start, constants, duration) in STARTS {
        for duration in [duration, 10.0 * duration, -1e-3 * duration] {
            let columns = tangent(start, constants, duration);
            for a in 0..4 {
                for b in 0..4 {
                    let expected = f64::from(i8::from(b == a + 2) - i8::from(a == b + 2));
                    // The terms of the form, each of which carries the roundings of some dozen operations, of two points of
                    // the orbit for a fall.
                    let size: f64 = (0..4).map(|i| columns[a][i].abs() * columns[b][(i + 2) % 4].abs()).sum();
                    let defect = form(&columns[a], &columns[b]) - expected;
                    let bound = 400.0 * f64::EPSILON * (size + 1.0);
                    assert!(
                        within(defect, bound),
                        "columns {a}, {b} of {start:?} for {duration}: {defect:e} of {bound:e}"
                    );
                }
            }
        }
        let columns = tangent(start, constants, duration);
        let size: f64 = columns.as_flattened().iter().map(|x| x * x).sum();
        for column in 0..4 {
            let moved = |by: f64| {
                let mut from = start;
                from[column] += by;
                flown(from, constants, duration)
            };
            let (ahead, behind) = (moved(1e-5), moved(-1e-5));
            for i in 0..4 {
                // Central differences are off by the third derivative times 1e-10 and by rounding over 1e-5.
                let error = columns[column][i] - (ahead[i] - behind[i]) / 2e-5;
                assert!(within(error, 1e-8 * (1.0 + size)), "{start:?} for {duration}: {error:e}");
            }
        }
    }
}

/// A row of duals is solved in its own numbers, so that derivatives go through the search.
#[test]
fn derivatives_of_a_root_are_those_through_the_search_for_it() {
    for (start, [inverse_mass, strength], duration) in STARTS {
        let [x, y, px, py] = start;
        let numbers = [x, y, px, py, inverse_mass, strength];
        for direction in 0..6 {
            let coordinate = |i: usize| Dual::along(numbers[i], f64::from(i == direction));
            let row = |i: usize| Lanes::<Dual, 2>::of_parts([coordinate(i); 2]);
            let found = flown([0, 1, 2, 3].map(coordinate), [4, 5].map(coordinate), duration);
            let expected = flown([0, 1, 2, 3].map(row), [4, 5].map(row), duration);
            let size: f64 = expected.iter().map(|number| number.lane(1) * number.lane(1)).sum();
            for i in 0..4 {
                assert_eq!(found[i].lane(0), expected[i].lane(0), "{start:?} for {duration}");
                // Roundings of some dozen numbers move the end by the first derivatives, and these by the second ones,
                // which are of the size of products of two of them.
                let error = found[i].lane(1) - expected[i].lane(1);
                let bound = 1e3 * f64::EPSILON * (1.0 + size);
                assert!(within(error, bound), "{i} by {direction} of {start:?} for {duration}: {error:e} of {bound:e}");
            }
        }
    }
}

/// The relative error of the energy after this number of stages of an orbit, the largest one along them and the mean over
/// the second half.
fn walked<R: Real>(eccentricity: f64, duration: f64, stages: u32) -> [f64; 2] {
    let speed = ((1.0 + eccentricity) / (1.0 - eccentricity)).sqrt();
    let mut q = [[1.0 - eccentricity, 0.0, 0.0].map(R::of)];
    let mut p = [[0.0, 0.8 * speed, 0.6 * speed].map(R::of)];
    let (ones, mut solver) = ([R::of(1.0)], Kepler::default());
    let [mut start, mut worst, mut mean] = [0.0_f64; 3];
    for stage in 0..=stages {
        let square = |x: [R; 3]| x.into_iter().map(|x| x.lane(0) * x.lane(0)).sum::<f64>();
        let energy = 0.5 * square(p[0]) - 1.0 / square(q[0]).sqrt();
        start = if stage == 0 { energy } else { start };
        let error = energy / start - 1.0;
        worst = worst.max(error.abs());
        mean += if 2 * stage < stages { 0.0 } else { error / f64::from(stages / 2) };
        flow_in_space(&mut solver, [&mut q, &mut p], [&ones, &ones], duration);
    }
    [worst, mean]
}

#[test]
fn the_energy_of_a_lone_body_walks_and_does_not_drift() {
    for (eccentricity, duration) in [0.0, 0.01, 0.2, 0.6].into_iter().flat_map(|e| [0.345_678_9, 2.2].map(|t| (e, t))) {
        let stages = 100_000;
        let fused = InstructionSet::available().contains(&InstructionSet::Fused);
        let walked = if fused { walked::<Fused<f64>> } else { walked::<f64> };
        let [worst, mean] = walked(eccentricity, duration, stages);
        // A walk of as many roundings of half a unit, in terms that the energy is a difference of. Without the amendment
        // of the determinant that of the circular orbit drifts a hundred times as far.
        let unit = 0.5 * f64::EPSILON * (1.0 + eccentricity) / (1.0 - eccentricity);
        // The argument of the functions of a long arc is halved twice, and each doubling doubles their roundings.
        let doublings = if duration > 1.0 { 4.0 } else { 1.0 };
        let bound = 4.0 * doublings * unit * f64::from(stages).sqrt();
        assert!(
            !fused || within(worst, bound) && within(mean, bound),
            "e = {eccentricity}: {worst:e}, {mean:e} of {bound:e}"
        );
    }
}

/// Some bodies in space, their masses and strengths: bound, free, on a hyperbola, repelled, and one that revolves often.
fn bodies<R: Real>() -> ([[[R; 3]; 5]; 2], [[R; 5]; 2]) {
    let q = [[1.0, 0.2, 0.1], [0.0, 0.0, 0.0], [-5.0, 0.3, 0.1], [0.5, 0.5, 0.2], [0.01, 0.0, 0.02]];
    let p = [[0.1, 0.9, -0.2], [1.0, 2.0, 3.0], [4.0, 0.1, 0.0], [-1.0, -0.5, 0.1], [0.0, 9.0, 0.1]];
    let [inverse_mass, strength] = [[1.0, 2.0, 0.5, 1.0, 1.0], [1.0, 0.0, 3.0, -1.0, 2.0]];
    ([q, p].map(|half| half.map(|x| x.map(R::of))), [inverse_mass, strength].map(|each| each.map(R::of)))
}

type Pair = Lanes<f64, 2>;

/// The bits of the coordinates of these bodies after a flow, in the last lane, with `some` of them in a call.
fn flown_by<R: Real>(some: usize) -> Vec<u64> {
    let ([mut q, mut p], [masses, strengths]) = bodies::<R>();
    for first in (0..5).step_by(some) {
        let some = first..5.min(first + some);
        let halves = [&mut q[some.clone()], &mut p[some.clone()]];
        flow_in_space(&mut Kepler::default(), halves, [&masses[some.clone()], &strengths[some]], 1.7);
    }
    q.as_flattened().iter().chain(p.as_flattened()).map(|x| x.lane(R::LANES - 1).to_bits()).collect()
}

#[test]
fn a_body_has_the_same_bits_alone_and_among_others() {
    let alone = flown_by::<f64>(1);
    assert_eq!(flown_by::<f64>(5), alone);
    assert_eq!(flown_by::<f64>(2), alone);
    assert_eq!(flown_by::<Pair>(5), alone);
    if InstructionSet::available().contains(&InstructionSet::Fused) {
        assert_eq!(flown_by::<Fused<f64>>(5), flown_by::<Fused<f64>>(1));
    }
    #[cfg(target_arch = "x86_64")]
    if InstructionSet::available().contains(&InstructionSet::Avx512) {
        use crate::scalar::fma::Avx512;
        assert_eq!(flown_by::<Fused<f64, Avx512>>(5), flown_by::<Fused<f64, Avx512>>(1));
    }
}

#[test]
fn a_body_without_a_force_moves_in_a_straight_line() {
    let [x, y, px, py] = flown([0.0, 0.5, 3.0, -1.0], [0.5, 0.0], 4.0);
    assert_eq!([x, y, px, py], [6.0, -1.5, 3.0, -1.0]);
}

#[test]
fn a_body_in_the_centre_is_reported_in_its_lane_and_the_others_continue() {
    let lanes = |numbers: [f64; 2]| Pair::state(&|lane| numbers[lane]);
    let (one, zero) = (lanes([1.0, 1.0]), lanes([0.0, 0.0]));
    let (mut q, mut p) = ([[lanes([1.0, 0.0]), zero, zero]], [[lanes([0.0, 1.0]), lanes([1.0, 0.0]), zero]]);
    let mut solver = Kepler::default();
    flow_in_space(&mut solver, [&mut q, &mut p], [&[one], &[one]], 0.5);
    let unsolved = |lane| <Kepler as Solver<()>>::unsolved(&solver, lane).cloned();
    let expected = Unsolved::Kepler { body: 0, distance: 0.0, duration: 0.5 };
    assert_eq!([unsolved(0), unsolved(1)], [None, Some(expected)]);
    assert!(q.as_flattened().iter().chain(p.as_flattened()).all(|x| x.lane(0).is_finite() && x.lane(1).is_nan()));
}

/// Arcs past a pericentre for which the series of a short arc goes so far astray that the functions there are no numbers
/// to judge by: they once passed as a solution.
fn follow_astray<R: Real>() {
    for [q, p] in [
        [
            [0.096_968_450_281_213_81, -0.084_011_720_236_881_3, -0.017_030_018_792_371_815],
            [0.909_285_485_307_426_5, 3.617_779_579_482_280_5, 0.733_360_227_020_141_7],
        ],
        [
            [0.057_608_085_619_976_1, -0.077_219_526_663_446_67, 0.086_425_147_649_951_57],
            [-3.800_858_586_521_635_6, 0.053_421_605_714_687_515, -0.059_790_189_878_082_6],
        ],
        [
            [0.097_199_301_543_195_98, 0.075_605_638_733_484_69, -0.040_481_954_765_783_756],
            [3.549_581_217_824_633_8, -1.192_440_821_893_821_8, 0.638_475_333_607_311_5],
        ],
    ] {
        let (mut q, mut p, ones) = ([q.map(R::of)], [p.map(R::of)], [R::of(1.0)]);
        flow_in_space(&mut Kepler::default(), [&mut q, &mut p], [&ones, &ones], 1.5);
        let square = |x: [R; 3]| x.into_iter().map(|x| x.lane(0) * x.lane(0)).sum::<f64>();
        let energy = 0.5 * square(p[0]) - 1.0 / square(q[0]).sqrt();
        // All are on orbits of the half axis 1; roundings act on terms of fifteen times the energy.
        assert!(within(energy + 0.5, 1e-9), "an energy of {energy} instead of -0.5");
    }
}

#[test]
fn a_series_that_does_not_converge_is_rejected() {
    follow_astray::<f64>();
    if InstructionSet::available().contains(&InstructionSet::Fused) {
        follow_astray::<Fused<f64>>();
    }
}
