use super::{Chart, Series};
use crate::{Axis, drawn};

#[test]
fn a_chart_has_its_words_curves_and_dots() {
    let points = || (1..=9).map(|i| (f64::from(i), 10.0_f64.powi(-i)));
    let chart = Chart::new("Errors")
        .claim("They fall")
        .measured("order 2.00")
        .along(Axis::linear("step"))
        .up(Axis::logarithmic("error"))
        .line("first", points())
        .line("second", points().map(|(x, y)| (x, y / 2.0)))
        .dashed()
        .dots("third", points());
    let (text, png) = drawn(&chart);
    for word in ["Errors", "They fall", "order 2.00", "step", "error", "first", "second", "third", ">10⁻⁸<", ">4<"]
    {
        assert!(text.contains(word), "{word} is missing in {text}");
    }
    assert_eq!(text.matches("<circle").count(), 9 + 1, "the dots, and one in the legend");
    assert!(png.len() > 1_000);
}

#[test]
fn a_million_points_are_a_small_picture() {
    let spiral = (0..1_000_000).map(|i| f64::from(i) * 1e-3).map(|t| (t.sin() * t, t.cos() * t));
    let (text, png) = drawn(&Chart::new("Spiral").cloud("", spiral).with_equal_units());
    assert!(text.contains("<image"), "points are a bitmap");
    assert!(text.len() < 2_000_000 && png.len() < 2_000_000, "{} and {} bytes", text.len(), png.len());
}

#[test]
fn a_line_of_a_million_points_is_a_small_picture() {
    let noise = (0..1_000_000).map(|i| (f64::from(i), (f64::from(i) * 1e3).sin()));
    let (text, _) = drawn(&Chart::new("Noise").line("", noise));
    assert!(text.len() < 200_000, "{} bytes", text.len());
}

#[test]
fn one_named_series_needs_no_legend() {
    let chart = |names: &[&str]| {
        names.iter().fold(Chart::new("Legend"), |chart, name| chart.line(*name, [(0.0, 0.0), (1.0, 1.0)]))
    };
    assert!(!drawn(&chart(&["alone"])).0.contains("alone"));
    for chart in [chart(&["alone", "other"]), chart(&["alone", "other"]).with_names_at_ends()] {
        assert!(drawn(&chart).0.contains(">alone<"));
    }
}

/// The heights at which a text of the SVG stands.
fn height(svg: &str, text: &str) -> f64 {
    let before = svg.split(&format!(">{text}<")).next().expect("a beginning");
    let number = before.rsplit("y=\"").next().and_then(|rest| rest.split('"').next());
    number.and_then(|number| number.parse().ok()).expect("a height")
}

#[test]
fn an_embedded_chart_has_axes_and_no_head_and_optional_series_can_be_hidden() {
    let series = |chart: Chart, name: &str| chart.line(name, [(0.0, 0.0), (1.0, 1.0)]);
    let chart = series(series(Chart::new("Title").claim("Claim").along(Axis::linear("axis")), "one"), "two");
    let chart = series(chart, "three & more").optional();
    let embedded = chart.embedded((720, 460)).expect("fonts");
    for part in [">axis<", ">one</text>", "<g class=\"more\"><title>three &amp; more</title>", "<g><title>one</title>"]
    {
        assert!(embedded.contains(part), "{part} is missing in {embedded}");
    }
    assert!(!embedded.contains("Title") && !embedded.contains("Claim") && !embedded.contains("more</text>"));
    assert_eq!(embedded.matches("<g").count(), embedded.matches("</g>").count());
    let narrow = chart.embedded((320, 300)).expect("fonts");
    assert!(narrow.contains("<title>one</title>") && !narrow.contains(">one</text>"), "no room for names");
    assert!(drawn(&chart).0.contains(">three &amp; more</text>"), "a file has all names");
    assert_eq!(chart.words(), ["Title", "Claim", ""]);
}

#[test]
fn more_lines_than_colours_differ_in_their_dashes() {
    let count = 4 * crate::colour::COLOURS.len();
    let chart = (0..count).fold(Chart::new("Many"), |chart, i| chart.line("", [(0.0, 0.0), (1.0, i as f64)]));
    let style = |series: &Series| (series.colour, series.dashes);
    assert!((0..count).all(|i| (0..i).all(|j| style(&chart.series[i]) != style(&chart.series[j]))));
}

#[test]
fn names_at_ends_are_clear_of_each_other() {
    let names = ["one", "two", "three"];
    let chart = names
        .iter()
        .fold(Chart::new("Ends").with_names_at_ends(), |chart, name| chart.line(*name, [(0.0, 0.0), (1.0, 1.0)]));
    let (svg, _) = drawn(&chart);
    let mut heights = names.map(|name| height(&svg, name));
    heights.sort_by(f64::total_cmp);
    assert!(heights.windows(2).all(|pair| pair[1] - pair[0] > 15.0), "{heights:?}");
}

#[test]
fn a_field_has_a_bar_and_leaves_cells_without_a_number_white() {
    let rows = [vec![1.0, 2.0], vec![f64::NAN, 4.0], vec![3.0]];
    let chart = Chart::new("Field").field([0.0..=1.0, 0.0..=3.0], Axis::linear("height"), rows);
    let (svg, _) = drawn(&chart);
    assert_eq!(svg.matches("<image").count(), 2, "the field and its bar");
    assert!(svg.contains(">height<") && svg.contains(">1.5<"), "{svg}");
    let nothing: [Vec<f64>; 0] = [];
    let (svg, _) = drawn(&Chart::new("Nothing").field([0.0..=1.0, 0.0..=1.0], Axis::linear(""), nothing));
    assert!(!svg.contains("<image"));
}

#[test]
fn series_have_the_names_of_a_list_as_far_as_it_goes() {
    let chart =
        ["a", "b", "c"].into_iter().fold(Chart::new(""), |chart, name| chart.line(name, [(0.0, 0.0), (1.0, 1.0)]));
    let (svg, _) = drawn(&chart.names(["Sun", "Jupiter"]));
    assert!([">Sun<", ">Jupiter<", ">c<"].iter().all(|name| svg.contains(name)) && !svg.contains(">a<"), "{svg}");
}
