//! What is saved of a run reads back equal, and a run that fails leaves all that came before.

use integrator_core::{
    Coords,
    output::{OutputError, csv, csv_with_names, each, npz},
    prelude::*,
};
use npyz::NpyFile;
use std::io::{self, Cursor, Write};
use zip::ZipArchive;

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// Two bodies on springs, in a list, lost when the first comes to `wall`.
struct Springs {
    wall: f64,
}

#[hamiltonian]
impl Springs {
    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..p.len() {
            energy += (p[i][0].powi(2) + p[i][1].powi(2) + p[i][2].powi(2)) / 2.0;
        }
        energy
    }
    fn potential(&self, q: &[[f64; 3]]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() {
            energy += (q[i][0].powi(2) + 2.0 * q[i][1].powi(2) + 3.0 * q[i][2].powi(2)) / 2.0;
            if q[i][0] > self.wall {
                energy += (self.wall - q[i][0]).sqrt();
            }
        }
        energy
    }
}

fn springs(wall: f64) -> Samples<Vec<[f64; 3]>> {
    // Numbers with long and short texts, one that needs an exponent, and a zero with a sign.
    let start = Phase::new(vec![[0.1, 1e-300, -0.0], [1.0 / 3.0, 2.0, 1e17]], vec![[0.7, 0.0, 0.3], [0.0; 3]]);
    Springs { wall }.run(start, 0.05).expect("a start").samples(3)
}

/// One record of a sample, `t, q, p, energy`, as bits.
fn bits<C: Coords<Leaf = f64>>(sample: &Sample<C>) -> Vec<u64> {
    let Phase { q, p } = &sample.state;
    let numbers = [sample.time].into_iter().chain(q.flat().to_vec()).chain(p.flat().to_vec()).chain([sample.energy()]);
    numbers.map(f64::to_bits).collect()
}

fn expected<C: Coords<Leaf = f64>>(samples: Samples<C>, count: usize) -> Vec<Vec<u64>> {
    samples.take(count).map(|sample| bits(&sample.expect("finite states"))).collect()
}

/// The names of the columns, and the rows as bits.
fn read_csv(text: &[u8]) -> (Vec<String>, Vec<Vec<u64>>) {
    let mut reader = ::csv::Reader::from_reader(text);
    let names = reader.headers().expect("a head").iter().map(str::to_owned).collect();
    let number = |field: &str| field.parse::<f64>().expect("a number").to_bits();
    let rows = reader.records().map(|row| row.expect("a row").iter().map(number).collect()).collect();
    (names, rows)
}

/// An array's shape and its numbers.
fn array(archive: &mut ZipArchive<Cursor<Vec<u8>>>, name: &str) -> (Vec<u64>, Vec<f64>) {
    let file = NpyFile::new(archive.by_name(&format!("{name}.npy")).expect("an array")).expect("a head");
    (file.shape().to_vec(), file.into_vec().expect("doubles"))
}

fn archive(samples: impl Iterator<Item = Result<Sample<Vec<[f64; 3]>>, Error>>) -> ZipArchive<Cursor<Vec<u8>>> {
    let mut file = Cursor::new(Vec::new());
    npz(samples, &mut file).expect("an archive");
    ZipArchive::new(file).expect("an archive")
}

#[test]
fn csv_reads_back_equal() {
    let mut text = Vec::new();
    assert_eq!(csv(springs(9.0).take(50), &mut text).expect("a table"), 50);
    let (names, rows) = read_csv(&text);
    let columns = "t q0_0 q0_1 q0_2 q1_0 q1_1 q1_2 p0_0 p0_1 p0_2 p1_0 p1_1 p1_2 energy";
    assert_eq!(names.join(" "), columns);
    assert_eq!(rows, expected(springs(9.0), 50));
    assert_eq!(f64::from_bits(rows[0][3]).to_bits(), (-0.0_f64).to_bits());
}

/// A box of springs, whose sites have three indices.
struct Lattice;

#[hamiltonian]
impl Lattice {
    fn kinetic(&self, p: &[[[f64; 3]; 1]]) -> f64 {
        p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum()
    }
    fn potential(&self, q: &[[[f64; 3]; 1]]) -> f64 {
        q.iter().flatten().flatten().map(|q| 0.5 * q * q).sum()
    }
}

#[test]
fn sites_of_planes_have_three_indices() {
    let start = || Phase::new(vec![[[0.1, 0.2, 0.3]]; 2], vec![[[0.0; 3]]; 2]);
    let samples = || Lattice.run(start(), 0.1).expect("a start").samples(1).take(4);
    let mut text = Vec::new();
    csv(samples(), &mut text).expect("a table");
    let (names, rows) = read_csv(&text);
    assert_eq!(names[1..7].join(" "), "q0_0_0 q0_0_1 q0_0_2 q1_0_0 q1_0_1 q1_0_2");
    assert_eq!(f64::from_bits(rows[0][6]), 0.3);
    let mut text = Vec::new();
    csv_with_names(samples(), ["Sun"], &mut text).expect("a table");
    let (names, named) = read_csv(&text);
    assert_eq!(names[1..7].join(" "), "q_Sun_0_0 q_Sun_0_1 q_Sun_0_2 q1_0_0 q1_0_1 q1_0_2");
    assert_eq!(named, rows);
    let mut file = Cursor::new(Vec::new());
    npz(samples(), &mut file).expect("an archive");
    let mut archive = ZipArchive::new(file).expect("an archive");
    assert_eq!(array(&mut archive, "q").0, [4, 2, 1, 3]);
}

#[test]
fn npz_reads_back_equal() {
    let mut archive = archive(springs(9.0).take(50));
    let [t, q, p, energy] = ["t", "q", "p", "energy"].map(|name| array(&mut archive, name));
    assert_eq!((&t.0[..], &q.0[..], &p.0[..], &energy.0[..]), (&[50][..], &[50, 2, 3][..], &[50, 2, 3][..], &[50][..]));
    let rows: Vec<Vec<u64>> = (0..50)
        .map(|n| {
            let (q, p) = (&q.1[6 * n..][..6], &p.1[6 * n..][..6]);
            [&t.1[n..=n], q, p, &energy.1[n..=n]].concat().into_iter().map(f64::to_bits).collect()
        })
        .collect();
    assert_eq!(rows, expected(springs(9.0), 50));
}

/// Numbers and not points; and crossings instead of samples.
#[test]
fn sections_are_saved_like_samples() {
    let run = || Pendulum.run(Phase::new([2.0], [0.0]), 0.1).expect("a start");
    let section = || run().crossings(1_000, Direction::Rising, |state, _| state.q[0]);
    let mut text = Vec::new();
    let count = csv(section(), &mut text).expect("a table");
    let (names, rows) = read_csv(&text);
    assert_eq!(names, ["t", "q0", "p0", "energy"]);
    let found: Vec<_> = section().map(|sample| bits(&sample.expect("finite states"))).collect();
    assert!(count > 5 && rows == found, "{rows:?}");
    let mut file = Cursor::new(Vec::new());
    npz(run().samples(1).take(7), &mut file).expect("an archive");
    assert_eq!(array(&mut ZipArchive::new(file).expect("an archive"), "p").0, [7, 1]);
}

/// Whatever they are kept in, numbers are doubles in a file.
#[test]
fn every_scalar_type_can_be_saved() {
    macro_rules! times_and_positions {
        ($start:expr) => {{
            let mut text = Vec::new();
            csv(Pendulum.run($start, 0.25).expect("a start").samples(1).take(3), &mut text).expect("a table");
            let (_, rows) = read_csv(&text);
            rows.iter().map(|row| (f64::from_bits(row[0]), f64::from_bits(row[1]))).collect::<Vec<_>>()
        }};
    }
    let single = times_and_positions!(Phase::new([0.1_f32], [0.0]));
    assert_eq!(single[0], (0.0, f64::from(0.1_f32)));
    assert!(single.iter().all(|(_, q)| f64::from(*q as f32) == *q));
    assert_eq!(times_and_positions!(Phase::compensated([0.1], [0.0]))[0].1, 0.1);
    let grid = 1.0 / f64::from(1 << 20);
    assert!(times_and_positions!(Phase::reversible([0.1], [0.0], grid)).iter().all(|(_, q)| (q / grid).fract() == 0.0));
}

#[test]
fn a_run_that_fails_keeps_the_samples_before() {
    let good: Vec<_> = springs(0.4).map_while(Result::ok).map(|sample| bits(&sample)).collect();
    assert!(good.len() > 2 && good.len() < 40, "{} samples before the wall", good.len());
    let mut text = Vec::new();
    let failed = csv(springs(0.4).take(100), &mut text);
    assert!(
        matches!(failed, Err(OutputError::Run { written, error: Error::Diverged(_) }) if written == good.len() as u64)
    );
    assert_eq!(read_csv(&text).1, good);
    let mut file = Cursor::new(Vec::new());
    let failed = npz(springs(0.4).take(100), &mut file);
    assert!(matches!(failed, Err(OutputError::Run { written, .. }) if written == good.len() as u64));
    let (shape, t) = array(&mut ZipArchive::new(file).expect("an archive"), "t");
    assert_eq!((shape, t.last().map(|t| t.to_bits())), (vec![good.len() as u64], good.last().map(|row| row[0])));
}

#[test]
fn no_samples_are_files_too() {
    assert_eq!(csv(springs(9.0).take(0), io::sink()).expect("nothing to write"), 0);
    let mut archive = archive(springs(9.0).take(0));
    assert_eq!(array(&mut archive, "t"), (vec![0], vec![]));
    assert_eq!(array(&mut archive, "q"), (vec![0, 0], vec![]));
}

/// A disk that is full after some bytes.
struct Full {
    left: usize,
}

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.left = self.left.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
        Ok(bytes.len())
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_failed_write_reports_the_reason() {
    for left in [0, 100_000] {
        let full = csv(springs(9.0).take(10_000), Full { left });
        let storage = |error: &io::Error| error.kind() == io::ErrorKind::StorageFull;
        assert!(matches!(&full, Err(OutputError::Write { error, .. }) if storage(error)), "{full:?}");
    }
    let chain = |count: usize| {
        let start = Phase::new(vec![[0.1; 3]; count], vec![[0.0; 3]; count]);
        Springs { wall: 9.0 }.run(start, 0.05).expect("a start").samples(1).take(5)
    };
    let of_two_sizes = || chain(2).chain(chain(3));
    assert!(matches!(csv(of_two_sizes(), io::sink()), Err(OutputError::Write { written: 5, .. })));
    let refused = npz(of_two_sizes(), Cursor::new(Vec::new()));
    assert!(matches!(refused, Err(OutputError::Write { written: 5, .. })));
}

#[test]
fn a_callback_sees_every_sample_until_it_refuses() {
    let mut times = Vec::new();
    let count = each(springs(9.0).take(4), |sample| {
        times.push(sample.time);
        Ok(())
    });
    assert_eq!((count.expect("four samples"), times.len()), (4, 4));
    let refused = each(springs(9.0), |sample| if sample.step < 6 { Ok(()) } else { Err(io::ErrorKind::Other.into()) });
    assert!(matches!(refused, Err(OutputError::Write { written: 2, .. })));
}
