//! The options of the laboratory, and the files that it writes.

use crate::{
    claims::{Verdict, verdicts},
    page::{Content, Figure},
    pictures,
    plan::Plan,
    problem::{Problem, haste, name, turns},
    study::{Study, measure},
};
use integrator_core::{Coords, prelude::*};
use integrator_plot::{Chart, Outcome, Panels};
use std::{
    error::Error,
    fmt, fs,
    path::{Path, PathBuf},
};

/// Measures a system from a start and writes the page `<folder>/<name of its type>.html` with its pictures.
///
/// `period` is the approximate period of the slowest motion. [`Laboratory`] has more options.
///
/// # Errors
/// The start is invalid for a run, or a file cannot be written.
pub fn report<H: Hamiltonian>(
    system: &H,
    start: Phase<H::Coords>,
    period: f64,
    folder: impl AsRef<Path>,
) -> Result<Report, Box<dyn Error>> {
    Laboratory::new(system, start, period).report(folder)
}

/// A system, the options of its measurements, and additional content of its page.
pub struct Laboratory<'s, H: Hamiltonian> {
    pub(crate) problem: Problem<'s, H>,
    pub(crate) name: String,
    formula: String,
    plan: Plan,
    claims: Vec<Verdict>,
    pictures: Vec<(String, Drawing)>,
}

/// Steps to a period and a fraction, unless something else is said.
const STEPS: u32 = 80;

impl<'s, H: Hamiltonian> Laboratory<'s, H> {
    /// Creates a laboratory for a system, its start and the approximate period of its slowest motion. The name is that
    /// of the type.
    pub fn new(system: &'s H, start: Phase<H::Coords>, period: f64) -> Self {
        // A start that is no start ends the first run.
        let turns = turns(system, &start, period).unwrap_or(0);
        let haste = haste(system, &start, period).unwrap_or(1);
        let (freedom, angles) = (start.q.flat().len(), Vec::new());
        let curvature = "T″ V″".to_owned();
        let symbols = (0..2 * freedom).map(|index| name(index, freedom)).collect();
        let mut problem = Problem {
            system,
            period,
            turns,
            haste,
            step: 0.0,
            blob: None,
            view: [0, 0],
            angles,
            symbols,
            curvature,
            start,
        };
        problem.step = problem.step_of(STEPS);
        // In a plane or in space, the path; of one coordinate, its momentum against it.
        let view = if freedom > 1 { [0, 1] } else { [0, freedom] };
        let name = std::any::type_name::<H>().rsplit("::").next().unwrap_or("system").to_owned();
        Self {
            problem: Problem { view, ..problem },
            name,
            formula: String::new(),
            plan: Plan::WHOLE,
            claims: Vec::new(),
            pictures: Vec::new(),
        }
    }

    /// Sets the name of the page and of its files.
    #[must_use]
    pub fn called(self, name: impl Into<String>) -> Self {
        Self { name: name.into(), ..self }
    }

    /// Sets the description under the name: `H` and the start, for readers.
    #[must_use]
    pub fn formula(self, formula: impl Into<String>) -> Self {
        Self { formula: formula.into(), ..self }
    }

    /// Sets the step for energies and for the set of starts. The default is about 1/80 of a period, or of that of a faster
    /// drive or part of the orbit.
    #[must_use]
    pub fn step(mut self, step: f64) -> Self {
        self.problem.step = step;
        self
    }

    /// Sets the radius of the set of starts in the plane of the first position and its momentum. The default is
    /// an ellipse with 1/50 of the axes of the orbit.
    #[must_use]
    pub fn blob(mut self, radius: f64) -> Self {
        self.problem.blob = Some(radius);
        self
    }

    /// Sets the horizontal and the vertical coordinate of portraits, counted from 0 over all positions and then all
    /// momenta.
    #[must_use]
    pub fn view(mut self, view: [usize; 2]) -> Self {
        self.problem.view = view;
        self
    }

    /// Marks coordinates that are angles, counted from 0 over the positions. Portraits show them between −π and π, so that a
    /// pendulum that turns over stays in the frame.
    #[must_use]
    pub fn angle(mut self, index: usize) -> Self {
        self.problem.angles.push(index);
        self
    }

    /// Sets the symbols of the positions and then of the momenta, such as `["θ", "ω"]`.
    #[must_use]
    pub fn symbols(mut self, symbols: impl IntoIterator<Item = impl Into<String>>) -> Self {
        let given = symbols.into_iter().map(Into::into);
        self.problem.symbols.iter_mut().zip(given).for_each(|(symbol, given)| *symbol = given);
        self
    }

    /// Sets the text of `T'' V''` in these symbols, such as `"cos θ"`, for the bracket of forward Euler.
    #[must_use]
    pub fn curvature(mut self, text: impl Into<String>) -> Self {
        self.problem.curvature = text.into();
        self
    }

    /// Sets the amount of measurements.
    #[must_use]
    pub fn plan(self, plan: Plan) -> Self {
        Self { plan, ..self }
    }

    /// Adds a claim about this system to the page.
    #[must_use]
    pub fn claim(mut self, claim: Verdict) -> Self {
        self.claims.push(claim);
        self
    }

    /// Adds a picture at the end of the page. The name is that of its files.
    #[must_use]
    pub fn picture(mut self, name: impl Into<String>, picture: impl Into<Drawing>) -> Self {
        self.pictures.push((name.into(), picture.into()));
        self
    }

    pub(crate) fn study(&self) -> Result<Study, Box<dyn Error>> {
        measure(self.name.clone(), &self.problem, &self.plan)
    }

    /// Measures the system and writes the page and its pictures into a folder.
    ///
    /// # Errors
    /// - The start or the step is invalid for a run.
    /// - The view names a coordinate that does not exist.
    /// - A file cannot be written.
    pub fn report(mut self, folder: impl AsRef<Path>) -> Result<Report, Box<dyn Error>> {
        let study = self.study()?;
        let mut pictures = pictures::all(&study);
        pictures.append(&mut self.pictures);
        let mut claims = verdicts(&study);
        claims.append(&mut self.claims);
        files(folder.as_ref(), &self.name, &self.formula, Some(&study), claims, pictures)
    }
}

/// Writes a page of given claims and pictures.
///
/// # Errors
/// A file cannot be written.
pub fn write(
    folder: impl AsRef<Path>,
    name: &str,
    formula: &str,
    claims: Vec<Verdict>,
    pictures: Vec<(String, Drawing)>,
) -> Result<Report, Box<dyn Error>> {
    files(folder.as_ref(), name, formula, None, claims, pictures)
}

fn files(
    folder: &Path,
    name: &str,
    formula: &str,
    study: Option<&Study>,
    claims: Vec<Verdict>,
    pictures: Vec<(String, Drawing)>,
) -> Result<Report, Box<dyn Error>> {
    let mut figures = Vec::new();
    for (picture, drawing) in pictures {
        let file = folder.join(name).join(&picture);
        drawing.write(&file)?;
        figures.push(Figure { name: picture, drawing });
    }
    fs::create_dir_all(folder)?;
    let html = folder.join(format!("{name}.html"));
    let content = Content { name, formula, study, verdicts: &claims, figures: &figures };
    fs::write(&html, content.page()?)?;
    Ok(Report { page: html, claims })
}

/// A picture: one chart or several.
#[derive(Clone, Debug)]
pub enum Drawing {
    /// One chart.
    Chart(Box<Chart>),
    /// Several charts.
    Panels(Panels),
}

impl From<Chart> for Drawing {
    fn from(chart: Chart) -> Self {
        Self::Chart(Box::new(chart))
    }
}

impl From<Panels> for Drawing {
    fn from(panels: Panels) -> Self {
        Self::Panels(panels)
    }
}

impl Drawing {
    /// Writes both files.
    fn write(&self, file: &Path) -> Outcome {
        match self {
            Self::Chart(chart) => integrator_plot::write(file, chart.as_ref()),
            Self::Panels(panels) => integrator_plot::write(file, panels),
        }
    }
}

/// The written page and the results of its claims.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Report {
    /// The path of the page.
    pub page: PathBuf,
    /// The claims of the page with their results.
    pub claims: Vec<Verdict>,
}

impl Report {
    /// Whether all claims hold.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.claims.iter().all(Verdict::holds)
    }
}

/// The page, then a line for each claim.
impl fmt::Display for Report {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(to, "{}", self.page.display())?;
        for claim in &self.claims {
            writeln!(to, "claim_{}={} value={:.3e}", claim.name, claim.word(), claim.measured)?;
        }
        Ok(())
    }
}
