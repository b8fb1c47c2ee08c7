//! `elements`: orbital elements of the bodies of a table, or of the samples of a run; and back.
//!
//! Comes in: a table of positions and velocities, of elements, or of the samples that `integrator_core::output::csv` writes. Goes
//! out: elements, or for a table of elements a table of positions and velocities, which the command reads as well.

use crate::{answer::Answer, mistake::Mistake, source::Source, table::Table};
use integrator_core::{
    Phase,
    orbit::{self, Anomaly, Elements, Frame, OrbitError},
};
use serde_json::{Map, Value, json};

/// Options of the command.
#[derive(clap::Args)]
pub(crate) struct Options {
    /// The gravitational constant, in the units of the table
    #[arg(long, value_name = "G", default_value_t = 1.0)]
    gravity: f64,
    /// The centre that elements refer to: the first body, or the barycentre of all bodies before
    #[arg(long, value_enum, default_value_t = Centre::Heliocentric)]
    frame: Centre,
    /// Angles in degrees, also those that are read
    #[arg(long)]
    degrees: bool,
    /// The masses of the bodies, for the samples of a run
    #[arg(long, value_name = "M0,M1,..", value_delimiter = ',')]
    masses: Vec<f64>,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Centre {
    Heliocentric,
    Jacobi,
}

impl Centre {
    fn frame(self) -> Frame {
        match self {
            Self::Heliocentric => Frame::Heliocentric,
            Self::Jacobi => Frame::Jacobi,
        }
    }
}

/// Positions or momenta.
type Bodies = Vec<[f64; 3]>;

const POSITION: [&str; 3] = ["x", "y", "z"];
const VELOCITY: [&str; 3] = ["vx", "vy", "vz"];
const ANGLES: [&str; 3] = ["inclination", "node", "argument"];
const ANOMALIES: [&str; 3] = ["mean_anomaly", "true_anomaly", "since_pericentre"];

/// A row of an answer: names of columns, and what they contain.
type Row = Vec<(&'static str, Cell)>;

enum Cell {
    Text(String),
    Number(f64),
    Empty,
}

/// The answer for a table.
pub(crate) fn elements(source: &Source, options: &Options) -> Result<Answer, Mistake> {
    let table = Table::read(source)?;
    let rows = if !table.bodies().is_empty() {
        of_samples(&table, options)?
    } else if table.column("eccentricity").is_some() {
        states(&table, options)?
    } else {
        of_bodies(&table, options)?
    };
    Ok(Answer { text: text(&rows)?, json: json!({ "file": source.name, "rows": values(&rows) }) })
}

/// Elements of each body of a table with positions and velocities.
fn of_bodies(table: &Table<'_>, options: &Options) -> Result<Vec<Row>, Mistake> {
    let columns = |names: [&str; 3]| -> Result<[Option<usize>; 3], Mistake> {
        let [x, y, z] = names.map(|name| table.column(name));
        match (x, y) {
            (Some(_), Some(_)) => Ok([x, y, z]),
            _ => Err(table.wrong_names(
                "a table of bodies has the columns `mass`, `x`, `y`, `vx`, `vy`, and also `z`, `vz` in space\nhelp: or \
                 `mass`, `eccentricity` and `axis` or `pericentre`, for orbital elements\nhelp: or the columns that \
                 `integrator_core::output::csv` writes, with `--masses`\nnote: a name may have a unit after an \
                 underscore, such as `x_au`",
            )),
        }
    };
    let halves = [columns(POSITION)?, columns(VELOCITY)?];
    let masses = masses(table)?;
    let mut state = Phase { q: Bodies::new(), p: Bodies::new() };
    for (row, mass) in masses.iter().enumerate() {
        let mut numbers = [[0.0; 3]; 2];
        for (half, columns) in numbers.iter_mut().zip(halves) {
            for (number, column) in half.iter_mut().zip(columns) {
                *number = column.map_or(Ok(0.0), |column| table.number(row, column))?;
            }
        }
        state.q.push(numbers[0]);
        state.p.push(numbers[1].map(|velocity| mass * velocity));
    }
    let found = orbit::elements(options.frame.frame(), options.gravity, &masses, &state);
    let found = found.map_err(|error| of_row(table, error))?;
    let orbits = [None].into_iter().chain(found.into_iter().map(Some));
    let rows = masses.iter().zip(orbits).enumerate();
    Ok(rows.map(|(row, (mass, orbit))| elements_row(name(table, row), *mass, orbit, options)).collect())
}

/// Elements of each body in each sample of a run.
fn of_samples(table: &Table<'_>, options: &Options) -> Result<Vec<Row>, Mistake> {
    let masses = &options.masses;
    let bodies = table.bodies();
    if masses.len() != bodies.len() {
        let message = format!(
            "the samples have {} bodies, but there are {} masses\nhelp: write them in the order of the bodies, such \
             as `--masses 1,1e-3`",
            bodies.len(),
            masses.len()
        );
        return Err(table.wrong_names(&message));
    }
    let mut rows = Vec::new();
    for row in 0..table.length() {
        let half = |letter: char| -> Result<Bodies, Mistake> {
            let number = |body: &str, axis: usize| match table.column(&format!("{letter}{body}_{axis}")) {
                Some(column) => table.number(row, column),
                None if axis == 2 => Ok(0.0),
                None => Err(table.wrong_names(&format!("the column `{letter}{body}_{axis}` is missing"))),
            };
            bodies.iter().map(|body| Ok([number(body, 0)?, number(body, 1)?, number(body, 2)?])).collect()
        };
        let state = Phase { q: half('q')?, p: half('p')? };
        let found = orbit::elements(options.frame.frame(), options.gravity, masses, &state);
        let found = found.map_err(|error| table.wrong(row, &error.to_string()))?;
        let time = table.column("t").map(|column| table.number(row, column)).transpose()?;
        for ((body, mass), orbit) in bodies.iter().zip(masses).skip(1).zip(found) {
            let name = body.strip_prefix('_').unwrap_or(body).to_owned();
            let mut shown = elements_row(name, *mass, Some(orbit), options);
            shown.insert(0, ("t", time.map_or(Cell::Empty, Cell::Number)));
            rows.push(shown);
        }
    }
    Ok(rows)
}

/// Positions and velocities of each body of a table of elements.
fn states(table: &Table<'_>, options: &Options) -> Result<Vec<Row>, Mistake> {
    let masses = masses(table)?;
    if table.column("eccentricity").is_some_and(|column| !table.is_empty(0, column)) {
        let message =
            "the first row is the centre, which has no elements\nhelp: leave these fields empty, as in `Sun,1,,,,`";
        return Err(table.wrong(0, message));
    }
    let orbits = (1..table.length()).map(|row| read_orbit(table, row, options)).collect::<Result<Vec<_>, _>>()?;
    let state = orbit::state::<Bodies>(options.frame.frame(), options.gravity, &masses, &orbits);
    let Phase { q, p } = state.map_err(|error| of_row(table, error))?;
    let rows = masses.iter().zip(q.into_iter().zip(p)).enumerate();
    let shown = rows.map(|(row, (mass, (position, momentum)))| {
        let velocity = momentum.map(|p| p / mass);
        let numbers = POSITION.into_iter().zip(position).chain(VELOCITY.into_iter().zip(velocity));
        let numbers = numbers.map(|(name, number)| (name, Cell::Number(number)));
        [("body", Cell::Text(name(table, row))), ("mass", Cell::Number(*mass))].into_iter().chain(numbers).collect()
    });
    Ok(shown.collect())
}

/// The elements in a row.
fn read_orbit(table: &Table<'_>, row: usize, options: &Options) -> Result<Elements, Mistake> {
    let number = |name: &str| table.column(name).map(|column| table.number(row, column)).transpose();
    let angle = |name: &str| -> Result<f64, Mistake> {
        let value = number(name)?.unwrap_or_default();
        Ok(if options.degrees { value.to_radians() } else { value })
    };
    let eccentricity = number("eccentricity")?.unwrap_or_default();
    let orbit = match (number("pericentre")?, number("axis")?) {
        (Some(distance), _) => Elements::with_pericentre(distance, eccentricity),
        (None, Some(axis)) => Elements::with_axis(axis, eccentricity),
        (None, None) => return Err(table.wrong_names("a table of elements has a column `axis` or `pericentre`")),
    };
    let given = ANOMALIES.into_iter().find(|name| table.column(name).is_some());
    let anomaly = match given {
        Some("true_anomaly") => Anomaly::True(angle("true_anomaly")?),
        Some("since_pericentre") => Anomaly::SincePericentre(number("since_pericentre")?.unwrap_or_default()),
        // That of a parabola or a hyperbola is no angle.
        Some(name) if eccentricity >= 1.0 => Anomaly::Mean(number(name)?.unwrap_or_default()),
        Some(name) => Anomaly::Mean(angle(name)?),
        None => {
            let names = ANOMALIES.map(|name| format!("`{name}`")).join(", ");
            return Err(
                table.wrong_names(&format!("the place on the orbit is missing\nhelp: add one of the columns {names}"))
            );
        }
    };
    let [inclination, node, argument] = ANGLES.map(angle);
    Ok(Elements { inclination: inclination?, node: node?, argument: argument?, anomaly, ..orbit })
}

/// The row of a body; that of the centre has no elements.
fn elements_row(name: String, mass: f64, orbit: Option<Elements>, options: &Options) -> Row {
    let angle = |value: f64| if options.degrees { value.to_degrees() } else { value };
    let numbers = orbit.map(|orbit| {
        let Elements { pericentre, eccentricity, inclination, node, argument, anomaly } = orbit;
        let (Anomaly::Mean(mean) | Anomaly::True(mean) | Anomaly::SincePericentre(mean)) = anomaly;
        let mean = if eccentricity < 1.0 { angle(mean) } else { mean };
        [orbit.axis(), pericentre, eccentricity, angle(inclination), angle(node), angle(argument), mean]
    });
    let names = ["axis", "pericentre", "eccentricity", ANGLES[0], ANGLES[1], ANGLES[2], ANOMALIES[0]];
    let cells = names
        .into_iter()
        .enumerate()
        .map(|(at, name)| (name, numbers.map_or(Cell::Empty, |all| Cell::Number(all[at]))));
    [("body", Cell::Text(name)), ("mass", Cell::Number(mass))].into_iter().chain(cells).collect()
}

/// The masses of all rows.
fn masses(table: &Table<'_>) -> Result<Vec<f64>, Mistake> {
    let column = table.column("mass").ok_or_else(|| {
        table.wrong_names("the column `mass` is missing\nhelp: give a test particle a tiny mass, such as `1e-30`")
    })?;
    (0..table.length()).map(|row| table.number(row, column)).collect()
}

/// The name of a body, or its index.
fn name(table: &Table<'_>, row: usize) -> String {
    table.column("body").map_or_else(|| format!("{row}"), |column| table.text(row, column).to_owned())
}

/// The error of a body, in its row.
fn of_row(table: &Table<'_>, error: OrbitError) -> Mistake {
    match error {
        OrbitError::Body { body, error } => table.wrong(body, &error.to_string()),
        OrbitError::Mass { body, .. } => table.wrong(body, &error.to_string()),
        error => table.wrong_names(&error.to_string()),
    }
}

/// Rows as comma-separated text.
fn text(rows: &[Row]) -> Result<String, Mistake> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = rows.iter().take(1).map(|row| row.iter().map(|(name, _)| (*name).to_owned()).collect());
    let cells = rows.iter().map(|row| {
        let shown = row.iter().map(|(_, cell)| match cell {
            Cell::Text(text) => text.clone(),
            // The shortest text that reads back as the same number.
            Cell::Number(number) => format!("{number:?}"),
            Cell::Empty => String::new(),
        });
        shown.collect::<Vec<String>>()
    });
    for record in names.chain(cells) {
        writer.write_record(record).map_err(|error| Mistake::plain(error.to_string()))?;
    }
    let bytes = writer.into_inner().map_err(|error| Mistake::plain(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Mistake::plain(error.to_string()))
}

/// Rows as objects; a number that is not finite is null.
fn values(rows: &[Row]) -> Vec<Value> {
    let value = |cell: &Cell| match cell {
        Cell::Text(text) => json!(text),
        Cell::Number(number) => json!(number),
        Cell::Empty => Value::Null,
    };
    let object = |row: &Row| row.iter().map(|(name, cell)| ((*name).to_owned(), value(cell))).collect::<Map<_, _>>();
    rows.iter().map(|row| Value::Object(object(row))).collect()
}
