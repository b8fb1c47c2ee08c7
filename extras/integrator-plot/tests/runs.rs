//! Pictures of runs, and the way into Python.

use integrator_core::{output, prelude::*};
use integrator_plot::{self as plot, Canvas, Chart, Picture};
use std::{env, fs, process::Command};

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

/// Two bodies that attract each other, in the plane.
struct Pair;

#[hamiltonian]
impl Pair {
    fn kinetic(&self, p: [[f64; 2]; 2]) -> f64 {
        0.5 * p.iter().map(|[x, y]| x * x + y * y).sum::<f64>()
    }
    fn potential(&self, q: [[f64; 2]; 2]) -> f64 {
        let [dx, dy] = [q[1][0] - q[0][0], q[1][1] - q[0][1]];
        -1.0 / (dx * dx + dy * dy).sqrt()
    }
}

/// Two oscillators of different frequencies.
struct Oscillators;

#[hamiltonian]
impl Oscillators {
    fn kinetic(&self, [a, b]: [f64; 2]) -> f64 {
        0.5 * (a * a + b * b)
    }
    fn potential(&self, [a, b]: [f64; 2]) -> f64 {
        0.5 * (a * a + 2.0 * b * b)
    }
}

fn svg(chart: &Chart) -> String {
    let mut canvas = Canvas::new(chart.size()).expect("fonts");
    chart.draw(&mut canvas);
    canvas.svg()
}

/// The places of the curves of a colour.
fn curve(svg: &str, colour: &str) -> Vec<(f64, f64)> {
    let lines =
        svg.lines().filter(|line| line.starts_with("<polyline") && line.contains(&format!("stroke=\"{colour}\"")));
    let points = lines
        .flat_map(|line| line.split("points=\"").nth(1).expect("points").split('"').next().expect("points").split(' '));
    let number = |text: &str| text.parse::<f64>().expect("a number");
    points.map(|point| point.split_once(',').map(|(x, y)| (number(x), number(y))).expect("two numbers")).collect()
}

fn pendulum(steps: usize) -> Vec<Sample<[f64; 1]>> {
    let run = Pendulum.run(Phase::new([1.0], [0.0]), 0.1).expect("a start");
    run.samples(1).take(steps).collect::<Result<_, _>>().expect("samples")
}

/// The first colour of all curves.
const FIRST: &str = "#1e1e1e";

#[test]
fn an_energy_is_drawn_against_the_time() {
    let samples = pendulum(200);
    let text = svg(&plot::energy(&samples).title("Energy"));
    for word in [">Energy<", ">t<", ">(E − E₀) / |E₀|<", ">20<"] {
        assert!(text.contains(word), "{word} is missing in {text}");
    }
    let curve = curve(&text, FIRST);
    // Verlet's error swings twice in a period of 6.7, which is six times in 20.
    let heights: Vec<f64> = curve.iter().map(|point| point.1).collect();
    let middle =
        0.5 * (heights.iter().copied().fold(f64::INFINITY, f64::min) + heights.iter().copied().fold(0.0, f64::max));
    let crossings = heights.windows(2).filter(|pair| (pair[0] < middle) != (pair[1] < middle)).count();
    assert!((11..=13).contains(&crossings), "{crossings}");
}

#[test]
fn energies_of_any_size_are_visible_in_one_picture() {
    let verlet = pendulum(200);
    let run = Pendulum.run_with(BlanesMoan6, Phase::new([1.0], [0.0]), 0.1).expect("a start");
    let better = run.samples(1).take(200).collect::<Result<Vec<_>, _>>().expect("samples");
    let text = svg(&plot::energies([("Verlet", &verlet), ("Blanes–Moan 6", &better)]));
    assert!(text.contains(">Verlet<") && text.contains(">Blanes–Moan 6<") && text.contains(">0<"), "{text}");
    // Errors of 1e-3 and of 1e-9 fill a good part of the picture both.
    for colour in [FIRST, "#56b4e9"] {
        let heights = curve(&text, colour).into_iter().map(|point| point.1);
        let (least, most) = heights.fold((f64::INFINITY, 0.0_f64), |(least, most), y| (least.min(y), most.max(y)));
        assert!(most - least > 40.0, "{colour} from {least} to {most}");
    }
    // Nothing to compare, and a run without a sample.
    let nothing: [(&str, &[Sample<[f64; 1]>]); 1] = [("none", &[])];
    assert!(svg(&plot::energies(nothing)).contains(">t<"));
}

#[test]
fn orbits_are_round() {
    let r = 0.5_f64;
    let start = Phase::new([[-r, 0.0], [r, 0.0]], [[0.0, -r.sqrt()], [0.0, r.sqrt()]]);
    let run = Pair.run_with(BlanesMoan6, start, 0.02).expect("a start");
    let samples = run.samples(1).take(300).collect::<Result<Vec<_>, _>>().expect("samples");
    let text = svg(&plot::orbit(&samples));
    for word in [">x<", ">y<", ">body 1<", ">body 2<"] {
        assert!(text.contains(word), "{word} is missing in {text}");
    }
    let mut path = curve(&text, FIRST);
    // The sign in the legend is a line of two points.
    path.retain(|point| point.0 < 700.0);
    let extent = |of: fn(&(f64, f64)) -> f64| {
        let (least, most) =
            path.iter().map(of).fold((f64::INFINITY, 0.0_f64), |(least, most), x| (least.min(x), most.max(x)));
        most - least
    };
    let (across, down) = (extent(|point| point.0), extent(|point| point.1));
    assert!(across > 200.0 && (across / down - 1.0).abs() < 0.01, "{across} by {down}");
}

#[test]
fn coordinates_have_their_names() {
    let run = Oscillators.run(Phase::new([1.0, 0.5], [0.0, 0.2]), 0.05).expect("a start");
    let samples = run.clone().samples(1).take(100).collect::<Result<Vec<_>, _>>().expect("samples");
    let words = |chart: &Chart, names: [&str; 2]| {
        let text = svg(chart);
        assert!(names.iter().all(|name| text.contains(&format!(">{name}<"))), "{names:?} in {text}");
    };
    words(&plot::phase(&samples), ["q₁", "p₁"]);
    words(&plot::phase_of(&samples, 1), ["q₂", "p₂"]);
    words(&plot::orbit(&samples), ["q₁", "q₂"]);
    words(&plot::phase(&pendulum(10)), ["q", "p"]);
    words(&plot::orbit(&pendulum(10)), ["t", "q"]);
    assert!(curve(&svg(&plot::phase_of(&samples, 2)), FIRST).is_empty(), "there is no third degree of freedom");

    let crossings = run.crossings(2_000, Direction::Rising, |state, _| state.q[0]);
    let crossings = crossings.collect::<Result<Vec<_>, _>>().expect("crossings");
    let chart = plot::section(&crossings);
    words(&chart, ["q₂", "p₂"]);
    assert_eq!(svg(&chart).matches("<circle").count(), crossings.len(), "a dot for each of {}", crossings.len());
    let many = (0..10_000).map(|i| (f64::from(i), f64::from(i)));
    assert!(svg(&plot::section_of(many)).contains("<image"), "many points are a bitmap");
    words(&plot::map(0.0..=1.0, 0.0..=2.0, "what", [[1.0, 2.0], [3.0, 4.0]]), ["what", "1.0"]);
}

/// The script of the page, as it stands there, on a file as the page writes it.
#[test]
fn the_script_for_python_draws_a_run() {
    let page = include_str!("../../../docs/pictures.md");
    let script = page.split("```python\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a script");
    assert!(script.lines().filter(|line| !line.is_empty()).count() <= 10, "{script}");
    let imports = Command::new("python3").args(["-c", "import matplotlib, numpy"]).output();
    if !imports.is_ok_and(|output| output.status.success()) {
        println!("SKIPPED: python3 with numpy and matplotlib is not installed, so that the script was not run");
        return;
    }
    let folder = env::temp_dir().join(format!("integrator-python-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let file = fs::File::create(folder.join("run.npz")).expect("a file");
    let run = Pendulum.run(Phase::new([1.0], [0.0]), 0.1).expect("a start");
    output::npz(run.samples(1).take(200), file).expect("arrays");
    let output = Command::new("python3").current_dir(&folder).env("MPLBACKEND", "agg").args(["-c", script]).output();
    let output = output.expect("python3 runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(fs::read(folder.join("run.pdf")).expect("a picture").starts_with(b"%PDF"));
    fs::remove_dir_all(folder).expect("a folder");
}
