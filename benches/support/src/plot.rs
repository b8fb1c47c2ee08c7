//! The pictures of the benches, each as SVG and as PNG.

mod dots;
mod growth;
mod work_precision;

pub use dots::{Dots, Row, dots};
pub use growth::{Growing, growth};
pub use work_precision::work_precision;

#[cfg(test)]
mod tests {
    use super::{Dots, Growing, Row, dots, growth};
    use std::{env, fs};

    #[test]
    fn a_picture_has_its_words_and_its_ticks() {
        let file = env::temp_dir().join(format!("integrator-dots-{}", std::process::id()));
        let picture = Dots {
            title: "Ratios".to_owned(),
            series: vec!["generated".to_owned()],
            asked: [0.9, 1.1],
            rows: vec![Row { name: "pendulum".to_owned(), values: vec![3.2] }],
            ..Dots::default()
        };
        dots(&file, &picture).expect("two files");
        let text = fs::read_to_string(file.with_extension("svg")).expect("text");
        for word in ["Ratios", "generated", "pendulum", "3.20", "\n1\n", "\n2\n"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        assert!(fs::metadata(file.with_extension("png")).expect("a picture").len() > 1_000);
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
        for word in ["Errors", "pendulum", "solar", "steps", "\n10⁵\n"] {
            assert!(text.contains(word), "{word} is missing in {text}");
        }
        let (curves, points) = (text.matches("<polyline").count(), text.matches("<circle").count());
        assert_eq!(points, 16, "a dot for every look");
        assert!(curves >= 4, "{curves} lines: a curve and a walk for each problem");
        for extension in ["svg", "png"] {
            fs::remove_file(file.with_extension(extension)).expect("a file");
        }
    }
}
