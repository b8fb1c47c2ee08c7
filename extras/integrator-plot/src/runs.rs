//! Pictures of runs, one line each.

use crate::{axis::Axis, chart::Chart, colour::COLOURS, series::Mark};
use integrator_core::{Coords, Phase, Sample};
use std::ops::RangeInclusive;

/// Plots the relative change of the energy since the first sample against time. If that energy is zero, it plots the
/// absolute change.
pub fn energy<'s, C: Coords>(samples: impl IntoIterator<Item = &'s Sample<C>>) -> Chart {
    let (points, relative) = changes(samples);
    over_time().up(Axis::linear(name_of_change(relative))).line("", points)
}

/// Plots the relative energy changes of several named runs on a signed logarithmic axis.
///
/// Growing, decaying and small changes are hence visible in one chart. The linear band around zero extends to about a
/// tenth of the largest change of the most accurate run, but not below rounding.
pub fn energies<'s, C: Coords, S: IntoIterator<Item = &'s Sample<C>>>(
    runs: impl IntoIterator<Item = (impl Into<String>, S)>,
) -> Chart {
    let runs: Vec<_> = runs.into_iter().map(|(name, samples)| (name.into(), changes(samples))).collect();
    let relative = runs.iter().all(|(_, (_, relative))| *relative);
    let largest = |points: &[(f64, f64)]| {
        points.iter().map(|(_, change)| change.abs()).filter(|change| change.is_finite()).fold(0.0, f64::max)
    };
    let least = runs.iter().map(|(_, (points, _))| largest(points)).fold(f64::INFINITY, f64::min);
    // A decade below the run that is kept best, so that its shape is seen; energies are rounded to about ε.
    let smallest = 10.0_f64.powf((0.1 * least).max(f64::EPSILON).log10().floor()).min(1.0);
    let chart = over_time().up(Axis::signed_logarithmic(name_of_change(relative), smallest)).with_names_at_ends();
    runs.into_iter().fold(chart, |chart, (name, (points, _))| chart.line(name, points))
}

/// Plots the first momentum against the first position: a closed curve for an oscillation, a spiral if energy is gained
/// or lost.
pub fn phase<'s, C: Coords>(samples: impl IntoIterator<Item = &'s Sample<C>>) -> Chart {
    phase_of(samples, 0)
}

/// Plots as [`phase`] for the degree of freedom `degree`, counted from 0 over all bodies and their components.
///
/// The chart is empty if there is no such degree of freedom.
pub fn phase_of<'s, C: Coords>(samples: impl IntoIterator<Item = &'s Sample<C>>, degree: usize) -> Chart {
    let mut freedom = 0;
    let mut points = Vec::new();
    for sample in samples {
        freedom = freedom.max(sample.state.q.flat().len());
        points.extend(plane(&sample.state, degree));
    }
    let [q, p] = ["q", "p"].map(|letter| numbered(letter, degree, freedom));
    Chart::new("").along(Axis::linear(q)).up(Axis::linear(p)).line("", points).sized(760, 640)
}

/// Plots the orbit with equal units on both axes, in a picture of matching shape.
///
/// - Bodies in a plane or in space: `x` and `y` of each body.
/// - Plain coordinates: the second against the first.
/// - A single coordinate: the coordinate against time.
///
/// [`Chart::names`] gives the bodies names: `orbit(&samples).names(["Sun", "Jupiter"])`.
pub fn orbit<'s, C: Coords>(samples: impl IntoIterator<Item = &'s Sample<C>>) -> Chart {
    let mut paths: Vec<Vec<(f64, f64)>> = Vec::new();
    let mut alone = false;
    for sample in samples {
        let Phase { q, .. } = sample.state.to_f64();
        let numbers = q.flat();
        let step = if C::COMPONENTS > 1 { C::COMPONENTS } else { numbers.len() };
        for (body, place) in numbers.chunks(step.max(1)).enumerate() {
            if paths.len() <= body {
                paths.push(Vec::new());
            }
            alone = place.len() == 1;
            paths[body].push(if alone { (sample.time, place[0]) } else { (place[0], place[1]) });
        }
    }
    let names = match C::COMPONENTS {
        _ if alone => ["t", "q"],
        1 => ["q₁", "q₂"],
        _ => ["x", "y"],
    };
    let [along, up] = names.map(Axis::linear);
    let chart = Chart::new("").along(along).up(up);
    let chart = if alone {
        chart.sized(900, 520)
    } else {
        let [width, height] = shape(paths.iter().flatten()).map(|part| (600.0 * part) as u32);
        chart.with_equal_units().sized(220 + width, 120 + height)
    };
    let (few, width) = (paths.len() <= COLOURS.len(), if paths.len() <= COLOURS.len() { 1.75 } else { 1.0 });
    paths.into_iter().zip(1..).fold(chart, |chart, (path, body)| {
        // More bodies than colours have no names that help.
        let name = if few { format!("body {body}") } else { String::new() };
        chart.line(name, path).wide(width)
    })
}

/// Returns the width and the height of points, in units of the larger of both; neither is shown as less than two fifths
/// of the other.
fn shape<'p>(points: impl Iterator<Item = &'p (f64, f64)>) -> [f64; 2] {
    let finite = points.filter(|(x, y)| x.is_finite() && y.is_finite());
    let ends = finite.fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |[x, y], point| {
        [(x, point.0), (y, point.1)].map(|([least, most], number)| [least.min(number), most.max(number)])
    });
    let [across, up] = ends.map(|[least, most]| most - least);
    // Of a point, or of none, nothing is known.
    let part = |length: f64, other: f64| if other > 0.0 { (length / other).clamp(0.4, 1.0) } else { 1.0 };
    [part(across, up), part(up, across)]
}

/// Plots a surface of section from crossings: the second momentum against the second position.
///
/// These remain if the surface fixes the first position. With one degree of freedom, it plots that one.
pub fn section<'s, C: Coords>(crossings: impl IntoIterator<Item = &'s Sample<C>>) -> Chart {
    let crossings: Vec<_> = crossings.into_iter().collect();
    let freedom = crossings.first().map_or(0, |crossing| crossing.state.q.flat().len());
    let degree = freedom.min(2).saturating_sub(1);
    let points: Vec<_> = crossings.iter().filter_map(|crossing| plane(&crossing.state, degree)).collect();
    let [q, p] = ["q", "p"].map(|letter| numbered(letter, degree, freedom));
    section_of(points).along(Axis::linear(q)).up(Axis::linear(p))
}

/// Plots as [`section`] for points chosen by the caller: one or several orbits, any two coordinates.
pub fn section_of(points: impl IntoIterator<Item = (f64, f64)>) -> Chart {
    let points: Vec<_> = points.into_iter().collect();
    // So many circles are an SVG of some hundred kilobytes; more points are a bitmap.
    let mark = if points.len() <= 4_000 { Mark::Dots } else { Mark::Cloud };
    Chart::new("").series(mark, "", points).wide(0.25).sized(760, 720)
}

/// Plots a number for each point of a plane as colours: rows from the lowest one up, each from left to right. `name` is
/// the name of the quantity.
pub fn map<R: AsRef<[f64]>>(
    along: RangeInclusive<f64>,
    up: RangeInclusive<f64>,
    name: impl Into<String>,
    rows: impl IntoIterator<Item = R>,
) -> Chart {
    Chart::new("").field([along, up], Axis::linear(name), rows).sized(900, 720)
}

/// Changes of the energy, and whether they are relative.
fn changes<'s, C: Coords>(samples: impl IntoIterator<Item = &'s Sample<C>>) -> (Vec<(f64, f64)>, bool) {
    let mut energies = samples.into_iter().map(|sample| (sample.time, sample.energy())).peekable();
    let first = energies.peek().map_or(0.0, |(_, energy)| *energy);
    let relative = first != 0.0;
    let unit = if relative { first.abs() } else { 1.0 };
    (energies.map(|(time, energy)| (time, (energy - first) / unit)).collect(), relative)
}

fn name_of_change(relative: bool) -> &'static str {
    if relative { "(E − E₀) / |E₀|" } else { "E − E₀" }
}

fn over_time() -> Chart {
    Chart::new("").along(Axis::linear("t")).sized(960, 540)
}

/// A position and its momentum.
fn plane<C: Coords>(state: &Phase<C>, degree: usize) -> Option<(f64, f64)> {
    let Phase { q, p } = state.to_f64();
    Some((*q.flat().get(degree)?, *p.flat().get(degree)?))
}

/// The name of a coordinate, with its number where there are several.
fn numbered(letter: &str, degree: usize, freedom: usize) -> String {
    if freedom <= 1 {
        return letter.to_owned();
    }
    let lowered = |digit: char| char::from_u32('₀' as u32 + digit as u32 - '0' as u32).unwrap_or(digit);
    format!("{letter}{}", (degree + 1).to_string().chars().map(lowered).collect::<String>())
}
