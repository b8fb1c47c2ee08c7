//! What the benches share.

mod counts {
    use integrator_bench::counts::*;

    fn counts(rows: &[(&str, f64)]) -> Counts {
        rows.iter().map(|(problem, count)| ((*problem).to_owned(), *count)).collect()
    }

    #[test]
    fn a_slowdown_fails_and_the_slack_does_not() {
        let kept = counts(&[("faster", 100.0), ("gone", 100.0), ("same", 100.0), ("slack", 100.0), ("slower", 100.0)]);
        let counted = counts(&[("faster", 90.0), ("new", 100.0), ("same", 100.0), ("slack", 101.9), ("slower", 102.1)]);
        let verdicts: Vec<(String, bool, bool)> = compare(&kept, &counted)
            .into_iter()
            .map(|difference| (difference.problem.clone(), difference.holds(), difference.is_outdone()))
            .collect();
        let expected = [
            ("faster", true, true),
            ("gone", false, false),
            ("new", false, false),
            ("same", true, false),
            ("slack", true, false),
            ("slower", false, false),
        ];
        assert_eq!(verdicts, expected.map(|(problem, holds, outdone)| (problem.to_owned(), holds, outdone)));
    }

    #[test]
    fn written_counts_are_read_back() {
        let kept = counts(&[("kepler", 41.5), ("pendulum", 60.0)]);
        assert_eq!(read(&write(&kept)).expect("rows"), kept);
        assert!(read("problem,instructions per step\nkepler,many\n").is_err());
    }

    #[test]
    fn the_total_is_found() {
        assert_eq!(total("version: 1\nevents: Ir\nsummary: 12\n\ntotals: 345\n"), Some(345));
        assert_eq!(total("events: Ir\n"), None);
    }
}

mod functions {
    use integrator_bench::functions::{exponential, sine, sine_fast};
    use integrator_bench::vector::Many;
    use std::f64::consts::{FRAC_1_PI, PI};

    /// Points from -30 to 30, about 1e-3 apart.
    fn points() -> impl Iterator<Item = f64> {
        (-30_000..30_000).map(|i| f64::from(i) * 1.000_000_3e-3)
    }

    /// Returns the largest error over the points, in units in the last place of the exact value. `exact` returns a sum
    /// of two doubles.
    fn worst(of: impl Fn(f64) -> f64, exact: impl Fn(f64) -> (f64, f64)) -> f64 {
        let error = |x: f64| {
            let (high, low) = exact(x);
            ((of(x) - high) - low).abs() / (f64::from_bits(high.abs().to_bits() + 1) - high.abs())
        };
        points().map(error).fold(0.0, f64::max)
    }

    /// Returns the sine as a sum of two doubles, by Taylor's series about the nearest multiple of π.
    fn exact_sine(x: f64) -> (f64, f64) {
        let multiples = (x * FRAC_1_PI).round();
        // π as a sum of three doubles; the products with the first two are exact in doubled precision.
        let parts = [PI, 1.2246467991473532e-16, -2.9947698097183397e-33];
        let r = parts.iter().fold((x, 0.0), |r, part| add(r, multiply((-multiples, 0.0), (*part, 0.0))));
        let square = multiply(r, r);
        let mut sum = (0.0, 0.0);
        for i in (1..16).rev() {
            let divisor = f64::from(2 * i * (2 * i + 1));
            let next = add((1.0, 0.0), sum);
            sum = divide(multiply((-square.0, -square.1), next), divisor);
        }
        let sine = add(r, multiply(r, sum));
        if multiples % 2.0 == 0.0 { sine } else { (-sine.0, -sine.1) }
    }

    fn exact_exponential(x: f64) -> (f64, f64) {
        let r = x / 1024.0;
        let mut sum = (0.0, 0.0);
        for i in (1..14).rev() {
            sum = divide(multiply((r, 0.0), add((1.0, 0.0), sum)), f64::from(i));
        }
        let mut power = add((1.0, 0.0), sum);
        for _ in 0..10 {
            power = multiply(power, power);
        }
        power
    }

    fn two_sum(a: f64, b: f64) -> (f64, f64) {
        let sum = a + b;
        let other = sum - a;
        (sum, (a - (sum - other)) + (b - other))
    }
    fn add(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
        let (high, low) = two_sum(a.0, b.0);
        two_sum(high, low + a.1 + b.1)
    }
    fn multiply(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
        let high = a.0 * b.0;
        two_sum(high, a.0.mul_add(b.0, -high) + a.0 * b.1 + a.1 * b.0)
    }
    fn divide(a: (f64, f64), b: f64) -> (f64, f64) {
        let high = a.0 / b;
        two_sum(high, ((-high).mul_add(b, a.0) + a.1) / b)
    }

    fn scalar(of: impl Fn(Many<f64, 1>) -> Many<f64, 1>) -> impl Fn(f64) -> f64 {
        move |x| of(Many([x])).0[0]
    }

    #[test]
    fn errors_are_those_stated() {
        let careful = worst(scalar(sine), exact_sine);
        let fast = worst(scalar(sine_fast), exact_sine);
        let exponential = worst(scalar(exponential), exact_exponential);
        assert!(careful < 1.0 && fast < 4.0 && exponential < 1.0, "{careful}, {fast}, {exponential}");
        // The test detects a sine that is wrong by some units.
        assert!(worst(|x| x.sin() * (1.0 + 2e-15), exact_sine) > 4.0);
    }

    #[test]
    fn singles_err_as_little() {
        let error = |of: fn(Many<f32, 1>) -> Many<f32, 1>, x: f64| {
            let x = x as f32;
            let exact = f64::from(x).sin();
            let unit = f64::from(f32::from_bits((exact.abs() as f32).to_bits() + 1)) - f64::from(exact.abs() as f32);
            (f64::from(of(Many([x])).0[0]) - exact).abs() / unit
        };
        let worst = |of: fn(_) -> _| points().map(|x| error(of, x)).fold(0.0, f64::max);
        let (careful, fast) = (worst(sine), worst(sine_fast));
        assert!(careful < 1.0 && fast < 4.0, "{careful}, {fast}");
    }
}

mod plot {
    use integrator_bench::plot::{Dots, Growing, Row, dots, growth, work_precision};
    use integrator_bench::precision::{Curve, Kind, Point};
    use std::{env, fs};

    #[test]
    fn a_picture_has_its_words_and_its_ticks() {
        let file = env::temp_dir().join(format!("integrator-dots-{}", std::process::id()));
        let picture = Dots {
            title: "Ratios".to_owned(),
            series: vec!["generated".to_owned()],
            band: [0.9, 1.1],
            rows: vec![Row { name: "pendulum".to_owned(), values: vec![3.2] }],
            ..Dots::default()
        };
        dots(&file, &picture).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Ratios", "generated", "pendulum", "3.20", ">1<", ">2<"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert!(fs::metadata(file.with_extension("png")).expect("a picture").len() > 1_000);
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }

    /// Every curve has a label, even if there are more curves than colours, and curves of other crates are
    /// distinguishable.
    #[test]
    fn curves_of_other_crates_have_distinct_names_and_styles() {
        let file = env::temp_dir().join(format!("integrator-work-{}", std::process::id()));
        let curve = |i: i32| {
            let points = [1.0, 2.0].map(|t| Point { milliseconds: t, energy: 1e-3 / t, global: 1e-3 / t });
            Curve { method: format!("method {i}"), ours: i == 0, points: points.to_vec() }
        };
        work_precision(&file, "Work", &(0..10).map(curve).collect::<Vec<_>>(), Kind::Energy).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for i in 0..10 {
            assert!(text.contains(&format!(">method {i}<")), "method {i} is missing in {text}");
        }
        let strokes = text.split("stroke=\"").skip(1).filter_map(|rest| Some(rest.split_once('"')?.0));
        let colours: std::collections::BTreeSet<_> = strokes.collect();
        // Eight colours of other crates (the ninth curve reuses one), one of this library, the grid and the axes.
        assert_eq!(colours.len(), 8 + 1 + 2, "{colours:?}");
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }

    #[test]
    fn a_growth_has_a_curve_and_a_walk_for_each_problem() {
        let file = env::temp_dir().join(format!("integrator-growth-{}", std::process::id()));
        let problem = |name: &str, size: f64| {
            let points = (0..8).map(|i| (10.0_f64.powi(i), size * 3.0_f64.powi(i))).collect();
            Growing { name: name.to_owned(), points }
        };
        growth(&file, "Errors", &[problem("pendulum", 1e-16), problem("solar", 1e-15)]).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Errors", "pendulum", "solar", "steps", ">10⁵<"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        let [curves, discs, squares] = ["<polyline", "<circle", "<polygon"].map(|shape| text.matches(shape).count());
        assert_eq!((discs, squares), (8, 8), "a marker for every point");
        assert!(curves >= 4, "{curves} lines: a curve and a walk for each problem");
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }
}

mod precision {
    use integrator_bench::precision::*;

    fn curve(points: &[(f64, f64)]) -> Curve {
        let point = |&(milliseconds, energy): &(f64, f64)| Point { milliseconds, energy, global: 1.0 };
        Curve { method: "some".to_owned(), ours: true, points: points.iter().map(point).collect() }
    }

    #[test]
    fn times_lie_on_the_lines_of_the_picture() {
        // Order 2: a hundredth of the error for ten times the work.
        let second = curve(&[(1.0, 1e-2), (10.0, 1e-4), (100.0, 1e-6)]);
        let close = |time: Option<f64>, expected: f64| assert!((time.expect("a time") - expected).abs() < 1e-9);
        close(second.time_to(Kind::Energy, 1e-4), 10.0);
        close(second.time_to(Kind::Energy, 1e-5), 1000.0_f64.sqrt());
        close(second.time_to(Kind::Energy, 0.1), 1.0);
        assert_eq!(second.time_to(Kind::Energy, 1e-7), None);
        assert_eq!(second.time_to(Kind::Global, 1e-3), None);
    }

    #[test]
    fn the_fastest_is_found_among_those_that_arrive() {
        let (fast, slow) = (curve(&[(1.0, 1e-3)]), curve(&[(5.0, 1e-9)]));
        assert_eq!(best([&fast, &slow], Kind::Energy, 1e-2).map(|best| best.0), Some(1.0));
        assert_eq!(best([&fast, &slow], Kind::Energy, 1e-6).map(|best| best.0), Some(5.0));
        assert_eq!(best([&fast, &slow], Kind::Energy, 1e-12), None);
    }

    #[test]
    fn a_curve_ends_where_rounding_rules() {
        let errors = [[1e-2, 1e-1], [2e-9, 2e-8], [1e-12, 1e-11], [2e-12, 2e-11], [3e-12, 3e-11], [1e-20, 1e-20]];
        let curve = Curve::measure("some".to_owned(), true, 0..6, |level| Some(errors[level as usize]), |_| ());
        assert_eq!(curve.points.len(), 5);
    }
}

mod race {
    use integrator_bench::race::*;

    #[test]
    fn the_best_of_the_others_counts() {
        let times = Times {
            names: vec!["ours", "slow", "fast"],
            rounds: vec![vec![2.0; 3], vec![4.0; 3], vec![1.0, 1.5, 2.0]],
        };
        assert_eq!(times.ratio(0, 1), 0.5);
        assert_eq!(times.ratio_to_best(), 2.0 / 1.5);
        assert_eq!(times.best_other(), 1.5);
    }

    #[test]
    fn every_racer_takes_every_turn() {
        let (mut first, mut second) = (0, 0);
        let times = race(5, 1.0, vec![Racer::new("first", || first += 1), Racer::new("second", || second += 1)]);
        assert_eq!(times.names(), ["first", "second"]);
        assert!(times.rounds.iter().all(|rounds| rounds.len() == 5));
        assert_eq!((first, second), (6, 6));
    }
}

mod table {
    use integrator_bench::table::shown;

    #[test]
    fn numbers_have_four_digits() {
        let cases = [(12.3456, "12.35"), (0.0123456, "0.01235"), (1234.5, "1234"), (3.2e9, "3.200e9"), (f64::NAN, "")];
        for (number, text) in cases {
            assert_eq!(shown(number), text);
        }
    }
}
