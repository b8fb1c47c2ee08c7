//! `docs/compositions.md` says what the catalogue holds, and what its entries cost.
//!
//! `.ci/bless docs` writes the tables.

use integrator_core::{
    Class, Coords, Visitor,
    check::{Goal, Ranking, choose},
    prelude::*,
};
use std::{fs, path::PathBuf};

#[path = "../examples/choose/systems.rs"]
mod systems;

use systems::{Pendulum, Problem, fput, henon_heiles, kepler, pendulum};

const TOLERANCES: [f64; 3] = [1e-3, 1e-6, 1e-9];
const PROBLEMS: [&str; 4] = ["pendulum", "Hénon-Heiles", "Kepler", "FPUT"];

#[path = "../integrator-core/src/composition/catalogue_list.rs"]
mod catalogue;

use catalogue::for_each_composition;

/// One composition: what rows are sorted by, and its row of facts.
struct Facts(Vec<((u32, usize, &'static str), String)>);

impl<H: Hamiltonian> Visitor<H> for Facts {
    fn visit<X: Composition<H>>(&mut self, _: X) {
        let kinetic = if X::CLASS == Class::General { "any" } else { "quadratic" };
        let (symmetric, evaluations) = (symmetric::<X>(), evaluations::<X>());
        let leading = X::LEADING_ERROR.map_or("-".to_owned(), |error| format!("{error:.1e}"));
        let (name, order, limit, citation) = (X::NAME, X::ORDER, X::STABILITY_LIMIT, X::CITATION);
        let row = format!(
            "| `{name}` | {kinetic} | {order} | {symmetric} | {evaluations} | {limit:.2} | {leading} | {citation} |\n"
        );
        self.0.push(((order, X::FORCE_EVALUATIONS + X::GRADIENT_EVALUATIONS, name), row));
    }
}

fn symmetric<X: Scheme>() -> &'static str {
    if X::SYMMETRIC { "yes" } else { "no" }
}

/// Force evaluations of a step, and how many of them also take the gradient of the squared force.
fn evaluations<X: Scheme>() -> String {
    match X::GRADIENT_EVALUATIONS {
        0 => X::FORCE_EVALUATIONS.to_string(),
        gradients => format!("{} + {gradients}", X::FORCE_EVALUATIONS),
    }
}

/// The catalogue, lowest order first and in each order the cheapest step.
fn facts() -> Vec<((u32, usize, &'static str), String)> {
    let mut facts = Facts(Vec::new());
    Pendulum::visit_compositions(&mut facts);
    facts.0.sort();
    facts.0
}

fn table_of_facts() -> String {
    let head = "| composition | `T` | order | symmetric | evaluations | stable | leading error | source |\n\
                |---|---|---|---|---|---|---|---|\n";
    facts().into_iter().fold(head.to_owned(), |table, (_, row)| table + &row)
}

/// The compositions for a small second part, in the order of the list.
fn table_of_near_integrable() -> String {
    let mut table = "| composition | `A` | orders | symmetric | evaluations | stable | source |\n\
                     |---|---|---|---|---|---|---|\n"
        .to_owned();
    macro_rules! row {
        ($($name:ident)*) => {$(
            let orders: Vec<String> = $name::GENERALISED_ORDERS.iter().map(u32::to_string).collect();
            let class = if $name::CLASS == Class::General { "any" } else { "quadratic in p" };
            table += &format!(
                "| `{}` | {class} | {} | {} | {} | {:.2} | {} |\n",
                $name::NAME, orders.join(", "), symmetric::<$name>(), evaluations::<$name>(), $name::STABILITY_LIMIT,
                $name::CITATION
            );
        )*};
    }
    for_each_composition!(near_integrable: row!);
    table
}

fn rank<H: Hamiltonian>(problem: Problem<H>, goal: Goal) -> Ranking
where
    H::Coords: Coords<Leaf = f64>,
{
    choose::<H, f64>(&problem.system, problem.start, problem.span, goal).expect("a ranking")
}

/// One ranking for each problem and tolerance, in the order of columns.
fn columns(goal: fn(f64) -> Goal) -> Vec<Ranking> {
    let of = |rank: &dyn Fn(Goal) -> Ranking| TOLERANCES.map(|tolerance| rank(goal(tolerance)));
    [
        of(&|goal| rank(pendulum(), goal)),
        of(&|goal| rank(henon_heiles(), goal)),
        of(&|goal| rank(kepler(), goal)),
        of(&|goal| rank(fput(), goal)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The work of a composition relative to the best of a ranking.
fn relative(ranking: &Ranking, composition: &str) -> Option<f64> {
    let choice = ranking.choices().iter().find(|choice| choice.composition == composition)?;
    Some(choice.evaluations as f64 / ranking.best().evaluations as f64)
}

fn table_of_work(columns: &[Ranking]) -> String {
    let titles = PROBLEMS.iter().flat_map(|problem| TOLERANCES.map(|tolerance| format!(" {problem} {tolerance:e} |")));
    let best = columns.iter().map(|ranking| format!(" {} |", ranking.best().evaluations));
    let head = [
        "| composition |".to_owned() + &titles.collect::<String>(),
        "|---".repeat(1 + columns.len()) + "|",
        "| evaluations of the best |".to_owned() + &best.collect::<String>(),
    ];
    let rows = facts().into_iter().map(|((_, _, name), _)| {
        let cells = columns.iter().map(|ranking| match relative(ranking, name) {
            Some(1.0) => " **1** |".to_owned(),
            Some(work) => format!(" {work:.2} |"),
            None => " - |".to_owned(),
        });
        format!("| `{name}` |{}", cells.collect::<String>())
    });
    head.into_iter().chain(rows).map(|row| row + "\n").collect()
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/compositions.md")
}

fn page() -> String {
    fs::read_to_string(path()).expect("the page")
}

/// What stands before, between and after the marks of a table.
fn around<'p>(page: &'p str, table: &str) -> [&'p str; 3] {
    let (begin, end) = (format!("<!-- {table}: begin -->\n"), format!("<!-- {table}: end -->"));
    let start = page.find(&begin).expect("where the table begins") + begin.len();
    let stop = page.find(&end).expect("where the table ends");
    [&page[..start], &page[start..stop], &page[stop..]]
}

#[test]
fn the_facts_are_those_of_the_proof() {
    if std::env::var_os("BLESS").is_some() {
        return update();
    }
    let page = page();
    for (name, table) in [("facts", table_of_facts()), ("near_integrable", table_of_near_integrable())] {
        let [_, shown, _] = around(&page, name);
        assert!(shown == table, "`.ci/bless docs` writes the table, which should be\n{table}");
    }
}

fn update() {
    let mut page = page();
    let tables = [
        ("facts", table_of_facts()),
        ("near_integrable", table_of_near_integrable()),
        ("trajectory", table_of_work(&columns(Goal::Trajectory))),
        ("energy", table_of_work(&columns(Goal::Energy))),
    ];
    for (name, table) in tables {
        let [before, _, after] = around(&page, name);
        page = [before, &table, after].concat();
    }
    fs::write(path(), page).expect("a page to write");
}

/// One column of the page, measured again. Other instruction sets round differently, which may move a step of the search
/// by one place of its bisection, 2 %, on either side of the ratio, and a doubled error of a coefficient by far more.
#[test]
fn the_work_is_measured() {
    if std::env::var_os("BLESS").is_some() {
        return;
    }
    let ranking = rank(pendulum(), Goal::Trajectory(TOLERANCES[1]));
    let page = page();
    let [_, shown, _] = around(&page, "trajectory");
    for ((_, _, name), _) in facts() {
        let row = shown.lines().find(|row| row.starts_with(&format!("| `{name}` |"))).expect("a row");
        let cell = row.split('|').nth(3).expect("the second column of the pendulum").trim();
        let written = cell.trim_matches('*').parse::<f64>().ok();
        let agree = match (written, relative(&ranking, name)) {
            (Some(written), Some(measured)) => (written / measured - 1.0).abs() < 0.06,
            // What stands at sixteen times the best may be ranked or not.
            (Some(alone), None) | (None, Some(alone)) => alone > 15.0,
            (None, None) => true,
        };
        assert!(agree, "{name}: {cell} on the page, {:?} measured", relative(&ranking, name));
    }
}
