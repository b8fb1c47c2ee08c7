//! Compares figures in pages with the tables of the benches, which are in `docs/contributing/performance-notes.md` and
//! `benches/results`.

use super::text;

/// A number in a page, with half a unit of its last digit.
#[derive(Debug)]
struct Quoted {
    value: f64,
    half: f64,
}

impl Quoted {
    /// Parses a word such as `12.3`, `**0.67**`, `2.4e9` or `1.18·10¹¹`.
    fn of(word: &str) -> Option<Self> {
        let word = word.trim_matches('*');
        let (digits, power) = match word.split_once("·10").or(word.split_once('e')) {
            Some((digits, power)) => (digits, power.chars().map(plain).collect::<String>().parse().ok()?),
            None => (word, 0),
        };
        let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
        let value = format!("{digits}e{power}").parse().ok()?;
        Some(Self { value, half: 0.5 * 10_f64.powi(power - decimals) })
    }

    fn all(text: &str) -> Vec<Self> {
        text.split_whitespace().filter_map(Self::of).collect()
    }

    /// Returns whether the number rounds to this one. The small excess accounts for the rounding of numbers in tables.
    fn is(&self, number: f64) -> bool {
        (self.value - number).abs() <= 1.02 * self.half
    }
}

/// Returns a digit without its superscript form.
fn plain(letter: char) -> char {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip('0'..='9').find(|(raised, _)| *raised == letter).map_or(letter, |(_, digit)| digit)
}

/// Returns the text after the first cells of a row.
fn rest_of<'p>(page: &'p str, row: &str) -> &'p str {
    page.lines().find_map(|line| line.strip_prefix(row)).unwrap_or_else(|| panic!("no row {row:?}"))
}

fn row_of(page: &str, row: &str) -> Vec<f64> {
    Quoted::all(rest_of(page, row)).iter().map(|number| number.value).collect()
}

/// Compares all numbers of a row.
fn compare(page: &str, row: &str, expected: &[f64]) {
    let quoted = Quoted::all(&rest_of(page, &format!("| {row} |")).replace(';', " "));
    let agree =
        quoted.len() == expected.len() && quoted.iter().zip(expected).all(|(quoted, number)| quoted.is(*number));
    assert!(agree, "{row}: {quoted:?} for {expected:?}");
}

/// Compares the cells of a row; a cell without a number is empty or a dash.
fn compare_cells(page: &str, row: &str, expected: &[Option<f64>]) {
    let rest = rest_of(page, &format!("| {row} |"));
    let cells: Vec<_> = rest.trim_end_matches('|').split('|').map(|cell| Quoted::all(cell).pop()).collect();
    let same = |(cell, number): (&Option<Quoted>, &Option<f64>)| match (cell, number) {
        (Some(cell), Some(number)) => cell.is(*number),
        (cell, number) => cell.is_none() && number.is_none(),
    };
    let agree = cells.len() == expected.len() && cells.iter().zip(expected).all(same);
    assert!(agree, "{row}: {cells:?} for {expected:?}");
}

/// Returns the text from a heading to the next one.
fn section<'p>(page: &'p str, heading: &str) -> &'p str {
    let (_, rest) = page.split_once(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no section {heading:?}"));
    rest.split("\n## ").next().unwrap_or(rest)
}

/// A table of `benches/results`.
struct Stored(Vec<Vec<String>>);

impl Stored {
    fn of(name: &str) -> Self {
        let text = text(format!("benches/results/{name}.csv"));
        let mut reader = ::csv::ReaderBuilder::new().has_headers(false).from_reader(text.as_bytes());
        let rows = reader.records().map(|row| row.expect("a row").iter().map(str::to_owned).collect());
        Self(rows.collect())
    }

    /// Returns the cells of the column `column` in the rows that begin with `keys`.
    fn cells(&self, keys: &[&str], column: &str) -> Vec<Option<f64>> {
        let place = self.0[0].iter().position(|name| name == column).unwrap_or_else(|| panic!("no column {column:?}"));
        let rows = self.0[1..].iter().filter(|row| row.iter().zip(keys).all(|(cell, key)| cell == key));
        rows.map(|row| row[place].parse().ok()).collect()
    }

    /// Returns the number in the only row that begins with `keys`.
    fn at(&self, keys: &[&str], column: &str) -> Option<f64> {
        let cells = self.cells(keys, column);
        assert_eq!(cells.len(), 1, "rows {keys:?}");
        cells[0]
    }

    /// Returns the numbers of a row after its first `keys` cells.
    fn numbers(row: &[String], keys: usize) -> Vec<f64> {
        row[keys..].iter().map(|cell| cell.parse().expect("a number")).collect()
    }

    fn number(&self, keys: &[&str], column: &str) -> f64 {
        self.at(keys, column).unwrap_or_else(|| panic!("no number for {keys:?} in {column:?}"))
    }
}

/// The README and the user page quote the tables in the notes for contributors.
#[test]
fn figures_are_those_of_the_benches() {
    let notes = text("docs/contributing/performance-notes.md");
    let measured = |scene: &str, unit: &str| row_of(&notes, &format!("{scene:<25}{unit}"));
    // Generated, hand-written, and their ratio; some rows have a column of plain loops.
    let step = |scene: &str, composition: &str| {
        let row = measured(scene, composition);
        vec![row[0], row[row.len() - 2], row[row.len() - 1]]
    };
    // The rate, its ratio to the hand-written code, and the speedup with a second thread.
    let rate = |scene: &str, unit: &str| {
        let row = measured(scene, unit);
        vec![row[0], row[row.len() - 2], row[row.len() - 1]]
    };
    let chain = measured("fput_1e7", "site-steps/s");
    let of_ensemble = rate("pendulum", "trajectory-steps/s");
    let of_pendulum = step("pendulum", "verlet");
    let solar = row_of(&notes, "solar_energy_1e-8");
    let crates = |scene: &str| {
        let row = row_of(&notes, &format!("{scene}_energy_1e-8"));
        vec![row[0], row[1], row[1] / row[0]]
    };
    let taylor = |scene: &str| row_of(&notes, &format!("{scene}_1e-8       "));
    let (readme, page) = (text("README.md"), text("docs/performance.md"));
    let (beside_crates, by_hand) = page.split_once("\n## Against hand-written code\n").expect("the section");
    let beside_crates = beside_crates.split_once("\n## Against Rust crates\n").expect("the section").1;
    let (steps, rates) = by_hand.split_once("\nThroughput per second").expect("the table");
    /// First cell of a row, and the expected numbers of the row.
    type Rows<'a> = &'a [(&'a str, Vec<f64>)];
    let pages: [(&str, Rows); 4] = [
        (
            &readme,
            &[
                ("pendulum, one force evaluation", vec![of_pendulum[0], of_pendulum[2]]),
                ("ensemble of pendulums, steps per second", vec![of_ensemble[0], of_ensemble[1]]),
                ("chain of 10⁷ sites, site-steps per second", vec![chain[0], chain[0] / chain[1]]),
                ("outer solar system, energy error 10⁻⁸", solar),
            ],
        ),
        (
            beside_crates,
            &[
                ("pendulum", crates("pendulum")),
                ("Hénon–Heiles", crates("henon")),
                ("Kepler, eccentricity 0.6", crates("kepler")),
                ("outer solar system", crates("solar")),
                ("FPUT-32", crates("fput")),
            ],
        ),
        (
            steps,
            &[
                ("pendulum", of_pendulum),
                ("Hénon–Heiles", step("henon", "verlet")),
                ("Hénon–Heiles, quadratic + rest", step("henon_parts", "aba864")),
                ("Kepler", step("kepler", "verlet")),
                ("outer solar system, six bodies", step("solar", "verlet")),
                ("FPUT-32", step("fput", "verlet")),
                ("FPUT, 10⁶ sites", step("fput_1e6", "verlet")),
                ("Toda, 10⁴ sites", step("toda_1e4", "verlet")),
                ("sine-Gordon, 10⁴ sites", step("sine_gordon_1e4", "verlet")),
                ("φ⁴ plane, 256 × 256 sites", step("phi4_2d", "verlet")),
                ("1,000 bodies", step("nbody_1000", "verlet")),
            ],
        ),
        (
            rates,
            &[
                ("pendulum ensemble, steps", of_ensemble),
                ("pendulum ensemble, `functions = fast`", rate("pendulum_fast", "trajectory-steps/s")),
                ("pendulum ensemble, `f32`", rate("pendulum_f32", "trajectory-steps/s")),
                ("Hénon–Heiles ensemble, steps", rate("henon", "trajectory-steps/s")),
                ("Kepler ensemble, steps", rate("kepler", "trajectory-steps/s")),
                ("Kepler ensemble, `f32`", rate("kepler_f32", "trajectory-steps/s")),
                ("FPUT, 10⁷ sites, site-steps", rate("fput_1e7", "site-steps/s")),
                ("φ⁴, 4096 × 4096 sites, site-steps", rate("phi4_4096x4096", "site-steps/s")),
                ("φ⁴, 128³ sites, site-steps", rate("phi4_128x128x128", "site-steps/s")),
                ("1,000 bodies, pairs", rate("nbody_1000", "pairs/s")),
                ("Taylor's method, pendulum to 10⁻⁸", taylor("pendulum")),
                ("Taylor's method, outer solar system to 10⁻⁸", taylor("solar")),
            ],
        ),
    ];
    for (page, rows) in pages {
        for (row, expected) in rows {
            compare(page, row, expected);
        }
    }
}

const SMALL_ERRORS: [&str; 5] = ["1e-4", "1e-6", "1e-8", "1e-10", "1e-12"];

const ERRORS: [&str; 5] = ["1e-2", "1e-4", "1e-6", "1e-8", "1e-10"];

#[test]
fn figures_of_other_scenes_are_stored() {
    let page = text("docs/performance.md");
    let by_hand = section(&page, "Against hand-written code");
    let [liquid, molecule, kepler, tangent] = ["liquid", "molecule", "kepler", "tangent"].map(Stored::of);
    let row = |table: &Stored, key: &str, ratio: &str| {
        ["generated", "by hand", ratio].map(|column| table.number(&[key], column))
    };
    compare(by_hand, "liquid argon, 4,000 atoms, per atom and step", &row(&liquid, "argon_4000", "to hand"));
    compare(by_hand, "liquid argon, 10⁶ atoms", &row(&liquid, "argon_1000188", "to hand"));
    let bonds = "molecule of 10,000 bonds, angles and dihedrals, per bond and step";
    compare(by_hand, bonds, &row(&molecule, "terms_10000", "ratio"));
    compare(by_hand, "Kepler flow of five planets", &row(&kepler, "five planets", "ratio"));
    for (name, key) in [("outer solar system", "solar"), ("FPUT-32", "fput")] {
        let expected = ["one", "by hand", "one/hand"].map(|column| tangent.number(&[key, "KahanLi8"], column));
        compare(by_hand, &format!("one deviation vector, {name}, `KahanLi8`, per force"), &expected);
    }
    let splittings = Stored::of("splitting_ratios");
    for (name, key) in [
        ("outer solar system, Jacobi coordinates", "solar"),
        ("Hénon–Heiles, E = 0.13, quadratic + rest", "henon_0.13"),
        ("Hénon–Heiles, E = 5·10⁻⁴, quadratic + rest", "henon_5e-4"),
        ("oscillators, coupling 10⁻², quadratic + rest", "oscillators_1e-2"),
        ("oscillators, coupling 10⁻⁴, quadratic + rest", "oscillators_1e-4"),
    ] {
        let expected = SMALL_ERRORS.map(|error| splittings.number(&[key], error));
        compare(section(&page, "Splittings"), name, &expected);
    }
    // The notes show the same tables as text.
    let notes = text("docs/contributing/performance-notes.md");
    for table in [&liquid, &molecule] {
        for row in &table.0[1..] {
            let quoted = row_of(&notes, &format!("{:<25}{:<25}", row[0], row[1]));
            assert_eq!(quoted, Stored::numbers(row, 2), "{}", row[0]);
        }
    }
}

#[test]
fn figures_of_other_libraries_are_stored() {
    let page = text("docs/performance.md");
    let page = section(&page, "Against heyoka, REBOUND, odeint and LAMMPS");
    let peers = Stored::of("peers");
    let errors = ["1e-4", "1e-6", "1e-8", "1e-12"];
    for (name, key) in [
        ("pendulum", "pendulum"),
        ("Hénon–Heiles", "henon"),
        ("Kepler, eccentricity 0.6", "kepler"),
        ("outer solar system, `T + V`", "solar"),
        ("outer solar system, Jacobi coordinates", "solar_jacobi"),
        ("FPUT chain of 32 sites", "fput"),
        ("two bodies, `Logarithmic`, eccentricity 0.6", "logarithmic_0.6"),
        ("two bodies, `Logarithmic`, eccentricity 0.9", "logarithmic_0.9"),
        ("two bodies, `Logarithmic`, eccentricity 0.99", "logarithmic_0.99"),
    ] {
        let of = |kind: &str| {
            errors.map(
                |error| if key.starts_with("log") && kind == "energy" { None } else { peers.at(&[key, kind], error) },
            )
        };
        compare_cells(page, name, &[of("energy"), of("position")].concat());
    }
    let times = Stored::of("peers_times");
    let time = |key: &str, column: &str| times.number(&[key], column);
    let (ours, first, second) = ("generated", "peer's time", "second peer's time");
    let solar = ["solar_position_1e-6"].map(|key| [time(key, ours), time(key, first), time(key, second)])[0];
    let with_ratios = [&solar[..], &[solar[1] / solar[0], solar[2] / solar[0]]].concat();
    compare(page, "outer solar system to a position error of 10⁻⁶", &with_ratios);
    for (name, key) in [
        ("liquid argon, 4,000 atoms, per atom and step", "argon_4000"),
        ("liquid argon, 32,000 atoms", "argon_32000"),
        ("ensemble of 4,096 pendulums to 10⁻⁴, per member", "pendulums_1e-4"),
        ("ensemble of 4,096 pendulums to 10⁻⁸, per member", "pendulums_1e-8"),
    ] {
        let [ours, theirs] = [ours, first].map(|column| time(key, column));
        compare(page, name, &[ours, theirs, theirs / ours]);
    }
    let taylor = Stored::of("peers_taylor");
    for (name, kind) in [
        ("Taylor's method at equal tolerance, five scenes | | heyoka", "run"),
        ("Taylor's method, ensembles, four scenes | | heyoka, batches of 8", "ensemble"),
    ] {
        let rows = || taylor.0[1..].iter().filter(|row| row[1] == kind);
        let numbers = |column: usize| rows().map(move |row| row[column].parse::<f64>().expect("a number"));
        let ends = [numbers(2).fold(f64::INFINITY, f64::min), numbers(3).fold(0.0, f64::max)];
        compare(page, name, &ends);
    }
    // Numbers in the running text.
    let joined = |page: &str| text(page).split_whitespace().collect::<Vec<_>>().join(" ");
    let says = |page: &str, sentence: &str| assert!(joined(page).contains(sentence), "{page}: {sentence}");
    for column in ["by hand", ours] {
        says("docs/performance.md", &format!(" {} µs", time("pendulums_1e-4", column)));
    }
    let energies = ["pendulum", "henon", "kepler", "solar", "fput"]
        .map(|key| SMALL_ERRORS.map(|error| peers.number(&[key, "energy"], error)));
    let energies = energies.as_flattened();
    let ends = [energies.iter().copied().fold(f64::INFINITY, f64::min), energies.iter().copied().fold(0.0, f64::max)];
    says("paper.md", &format!("was {} to {} times as fast as", ends[0], ends[1]));
    says("paper.md", &format!("it took {} ns per atom and step", time("argon_32000", ours)));
    says("paper.md", &format!("INTEL package) {} ns", time("argon_32000", first)));
    says("paper.md", &format!("by a factor of {:.1}", 1.0 / peers.number(&["solar", "position"], "1e-6")));
}

#[test]
fn figures_of_devices_are_stored() {
    let (page, devices) = (text("docs/performance.md"), Stored::of("devices"));
    let columns = ["exact functions", "native functions", "hand-written kernel", "two CPU threads"];
    for (name, key) in [("1,000", "1000"), ("100,000", "100000"), ("4,000,000", "4000000")] {
        compare(section(&page, "Devices"), name, &columns.map(|column| devices.number(&[key], column)));
    }
    let million = devices.number(&["1000000"], columns[0]);
    assert!(text("docs/guide/src/gpus.md").contains(&format!("take {million:.1e} steps per second")));
    let notes = text("docs/contributing/performance-notes.md");
    for row in &devices.0[1..] {
        let quoted = row_of(section(&notes, "Devices"), &format!("{:<13}", row[0]));
        assert_eq!([&quoted[..3], &quoted[4..]].concat(), Stored::numbers(row, 1), "{}", row[0]);
    }
}

#[test]
fn compile_times_are_stored() {
    let page = text("docs/performance.md");
    let (page, stored) = (section(&page, "Compile time"), Stored::of("compile_time"));
    let rows = [
        ("`run` by `Verlet`", "run"),
        ("five compositions", "five"),
        ("`Taylor`", "taylor"),
        ("`Ensemble`", "ensemble"),
        ("one deviation vector", "tangent"),
        ("`certify`", "certify"),
        ("`choose`", "choose"),
    ];
    for (row, capability) in rows {
        compare(page, row, &["pendulum", "halo", "planets"].map(|system| stored.number(&[capability], system)));
    }
}

#[test]
fn figures_of_time_transformations_are_stored() {
    let (page, pace) = (text("docs/performance.md"), Stored::of("pace"));
    let page = section(&page, "Time transformations");
    // Least time of all methods of a kind.
    let kind = |method: &str| {
        ["Logarithmic", "Paced", "Taylor"].into_iter().find(|kind| method.starts_with(kind)).unwrap_or("fixed steps")
    };
    let best = |orbit: &str, of: &str, error: &str| {
        let rows = pace.0[1..].iter().filter(|row| row[0] == orbit && kind(&row[1]) == of);
        let column = 2 + ERRORS.iter().position(|known| *known == error).expect("an error");
        rows.filter_map(|row| row[column].parse().ok()).reduce(f64::min)
    };
    let one = |orbit: &str, method: &str| ERRORS.map(|error| pace.at(&[orbit, method], error));
    let of_kind = |orbit: &str, kind: &str| ERRORS.map(|error| best(orbit, kind, error));
    let [eighth, tenth] = [8, 10].map(|order| format!("Logarithmic(SofroniouSpaletta{order})"));
    let paced = "Paced(SofroniouSpaletta8)";
    compare_cells(page, &format!("0.6 | `{eighth}`"), &one("0.6", &eighth));
    compare_cells(page, &format!("0.6 | `{paced}`, rate `1/r`"), &one("0.6", paced));
    compare_cells(page, "0.6 | fixed steps", &of_kind("0.6", "fixed steps"));
    compare_cells(page, "0.6 | `Taylor`", &of_kind("0.6", "Taylor"));
    compare_cells(page, &format!("0.99 | `{tenth}`"), &one("0.99", &tenth));
    compare_cells(page, "0.99 | `Taylor`", &of_kind("0.99", "Taylor"));

    let notes = text("docs/contributing/performance-notes.md");
    let notes = section(&notes, "Time transformation");
    compare_cells(notes, &format!("0.99 | `{eighth}`"), &one("0.99", &eighth));
    compare_cells(notes, &format!("0.99 | `{paced}`, `1/r`"), &one("0.99", paced));
    compare_cells(notes, &format!("0.6, `+ 0.005/r³` | `{tenth}`"), &one("0.6, twisted", &tenth));
    compare_cells(notes, "0.6, `+ 0.005/r³` | Taylor", &of_kind("0.6, twisted", "Taylor"));

    for (name, orbit) in [("0.6", "0.6"), ("0.9", "0.9"), ("0.99", "0.99"), ("0.6, with `-0.005/r³`", "0.6, twisted")]
    {
        for error in ["1e-4", "1e-8"] {
            let kinds = ["fixed steps", "Logarithmic", "Paced", "Taylor"].map(|kind| best(orbit, kind, error));
            compare_cells(page, &format!("{name} | {error}"), &kinds);
        }
    }
    let of = |kind: &str| best("0.9", kind, "1e-4").expect("a time");
    let [logarithmic, paced, taylor, fixed] = ["Logarithmic", "Paced", "Taylor", "fixed steps"].map(of);
    let sentence = format!(
        "`Logarithmic` takes {logarithmic:.1} ms, `Paced` {paced:.1} ms, Taylor's method {taylor:.1} ms, and fixed steps \
         {fixed:.0} ms."
    );
    let guide = text("docs/guide/src/pace.md").split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(guide.contains(&sentence), "{sentence}");
}
