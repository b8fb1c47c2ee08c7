//! `elements`: tables of bodies, elements and samples, and what is wrong with them.

use super::{answer, file, json, refusal};

const SUN_AND_PLANET: &str = "# in units with G = 1
body,mass,x_au,y,z,vx_au_per_day,vy,vz
Sun,1,0,0,0,0,0,0
\"Planet, small\",1e-3,0,2,0,-0.6,0,0.3
";

/// The numbers of a row, without its name.
fn numbers(text: &str, row: usize) -> Vec<f64> {
    let fields = text.lines().nth(row).expect("a row").rsplit(',');
    let mut numbers: Vec<f64> = fields.map_while(|field| field.parse().ok()).collect();
    numbers.reverse();
    numbers
}

/// By the energy, the angular momentum and the directions of this orbit, which crosses the reference plane at its start.
#[test]
fn a_table_of_bodies_has_elements() {
    let path = file("bodies.csv", SUN_AND_PLANET);
    let found = answer(&["elements", &path, "--degrees"]);
    let names = "body,mass,axis,pericentre,eccentricity,inclination,node,argument,mean_anomaly";
    assert_eq!(found.lines().next(), Some(names));
    assert_eq!(found.lines().nth(1), Some("Sun,1.0,,,,,,,"));
    assert!(found.lines().nth(2).is_some_and(|row| row.starts_with("\"Planet, small\",0.001,")), "{found}");
    let axis = 1.0 / (2.0 / 2.0 - (0.36 + 0.09) / 1.001);
    let latus: f64 = 4.0 * 0.45 / 1.001;
    let eccentricity = (1.0 - latus / axis).sqrt();
    let inclination = (0.3_f64 / 0.6).atan().to_degrees();
    // The body is in its apocentre and ascends.
    let expected = [axis, axis * (1.0 - eccentricity), eccentricity, inclination, 90.0, 180.0, 180.0];
    for (found, expected) in numbers(&found, 2).into_iter().skip(1).zip(expected) {
        let error = (found.abs() - expected).abs();
        assert!(error < 1e-12 * expected, "{found}, not {expected}");
    }
}

#[test]
fn elements_and_states_are_read_again() {
    let planets = "examples/data/outer_solar_system.csv";
    for options in
        [&["--gravity", "2.95912208286e-4"][..], &["--gravity", "2.95912208286e-4", "--frame", "jacobi", "--degrees"]]
    {
        let with = |path: &str| answer(&[&["elements", path], options].concat());
        let elements = with(planets);
        let state = with(&file("elements.csv", &elements));
        let again = with(&file("state.csv", &state));
        assert!(state.lines().nth(1).is_some_and(|row| row.starts_with("Sun (with the inner planets),")), "{state}");
        assert_eq!(state.lines().next(), Some("body,mass,x,y,z,vx,vy,vz"));
        for row in 2..7 {
            for (found, expected) in numbers(&again, row).into_iter().zip(numbers(&elements, row)) {
                assert!((found - expected).abs() < 1e-12 * expected.abs().max(0.1), "{found}, not {expected}");
            }
        }
        // Jupiter is 5.2 AU away, also from the barycentre.
        assert!((numbers(&elements, 2)[1] - 5.2).abs() < 0.05);
    }
    assert_ne!(answer(&["elements", planets, "--frame", "jacobi"]), answer(&["elements", planets]));
}

/// A hyperbola has a mean anomaly that is no angle; a time needs the units; a plane has no third column.
#[test]
fn all_conics_and_anomalies_are_read() {
    let table =
        "body,mass,pericentre,eccentricity,inclination,mean_anomaly\nA,1,,,,\nB,1e-9,2,1.5,90,0.5\nC,1e-9,1,1,0,0.7\n";
    let state = answer(&["elements", &file("conics.csv", table), "--degrees"]);
    let again = answer(&["elements", &file("conics_state.csv", state), "--degrees"]);
    let near = |row: usize, column: usize, expected: f64| {
        let found = numbers(&again, row)[column];
        assert!((found - expected).abs() < 1e-7, "{found}, not {expected}: {again}");
    };
    near(2, 1, -4.0);
    near(2, 4, 90.0);
    near(2, 7, 0.5);
    let table = "mass,axis,eccentricity,since_pericentre\n1,,,\n1e-20,1,0,1.5707963267948966\n";
    let state = answer(&["elements", &file("time.csv", table)]);
    assert!((numbers(&state, 2)[3] - 1.0).abs() < 1e-15, "{state}");
    let table = "mass,axis,eccentricity,true_anomaly\n1,,,\n1e-20,1,0,90\n";
    let state = answer(&["elements", &file("true.csv", table), "--degrees"]);
    assert!((numbers(&state, 2)[3] - 1.0).abs() < 1e-15, "{state}");
    let found = answer(&["elements", &file("plane.csv", "mass,x,y,vx,vy\n1,0,0,0,0\n1e-20,1,0,0,1\n")]);
    assert_eq!(found.lines().nth(2), Some("1,1e-20,1.0,1.0,0.0,0.0,0.0,0.0,0.0"));
}

/// The columns of `integrator_core::output::csv`: momenta in place of velocities, and a row for each time.
#[test]
fn samples_have_elements_at_each_time() {
    let samples = "t,q0_0,q0_1,q1_0,q1_1,p0_0,p0_1,p1_0,p1_1,energy\n0.0,0,0,2,0,0,-0.25,0,0.25,0\n1.5,0,0,0,2,0.25,0,-0.25,0,0\n";
    let path = file("samples.csv", samples);
    let found = answer(&["elements", &path, "--masses", "1,1", "--frame", "jacobi"]);
    assert!(found.starts_with("t,body,mass,axis,"), "{found}");
    assert_eq!(numbers(&found, 1)[..2], [0.0, 1.0]);
    assert_eq!((found.lines().count(), numbers(&found, 2)[0]), (3, 1.5));
    let axis = 1.0 / (1.0 - 0.25 / 2.0);
    assert!((numbers(&found, 2)[3] - axis).abs() < 1e-15, "{found}");
    // With names, as `csv_with_names` writes them.
    let path_of_names = file("names.csv", samples.replace("q1_", "q_Jupiter_").replace("p1_", "p_Jupiter_"));
    let named = answer(&["elements", &path_of_names, "--masses", "1,1", "--frame", "jacobi"]);
    assert_eq!(named.replace("Jupiter", "1"), found);
    assert!(named.contains("0.0,Jupiter,1.0,"), "{named}");
    let message = refusal(&["elements", &path]);
    assert!(message.contains("2 bodies, but there are 0 masses") && message.contains("--masses 1,1e-3"), "{message}");
}

#[test]
fn mistakes_are_shown_in_their_line() {
    let table = "body,mass,axis,eccentricity,mean_anomaly\nSun,1,,,\nMars,1e-7,1.5,-0.1,0\n";
    let path = file("negative.csv", table);
    let expected = format!(
        "error: the eccentricity has to be finite and at least 0, but it is -0.1
 --> {path}:3
  |
3 | Mars,1e-7,1.5,-0.1,0
  |
  = help: 0 is a circle, less than 1 an ellipse, 1 a parabola, more than 1 a hyperbola
"
    );
    assert_eq!(refusal(&["elements", &path]), expected);
    let rows = [
        ("mass,x,y,vx\n1,0,0,0\n", ":1\n", "a table of bodies has the columns `mass`, `x`, `y`"),
        ("x,y,vx,vy\n0,0,0,0\n", ":1\n", "the column `mass` is missing"),
        ("mass,x,y,vx,vy\n1,0,0,0,0\n0,1,0,0,1\n", ":3\n", "the mass of body 1 has to be positive"),
        ("mass,x,y,vx,vy\n1,0,0,0,0\n1,1,0,0,one\n", ":3\n", "`vy` has to be a number, but it is `one`"),
        ("mass,x,y,vx,vy\n1,0,0,0,0\n1,1,0,1,0\n", ":3\n", "the orbit is a straight line through the centre"),
        ("mass,x,y,vx,vy\n1,0,0,0\n", ":2\n", "record"),
        ("mass,axis,eccentricity\n1,,\n1,1,0\n", ":1\n", "the place on the orbit is missing"),
        ("mass,eccentricity,mean_anomaly\n1,,\n1,0,0\n", ":1\n", "has a column `axis` or `pericentre`"),
        ("mass,axis,eccentricity,mean_anomaly\n1,1,0.5,0\n1,1,0,0\n", ":2\n", "the first row is the centre"),
        ("mass,x,y,vx,vy\n", "", "has no rows"),
        ("", "", "has no rows"),
    ];
    for (number, (table, place, wrong)) in rows.into_iter().enumerate() {
        let message = refusal(&["elements", &file(&format!("wrong_{number}.csv"), table)]);
        assert!(message.contains(wrong) && message.contains(place), "{message}");
    }
    let path = file("right.csv", SUN_AND_PLANET);
    let message = refusal(&["elements", &path, "--gravity", "0"]);
    assert!(message.contains("gravitational parameter has to be positive"), "{message}");
}

#[test]
fn programs_get_the_same_numbers() {
    let found = json(&["elements", &file("for_programs.csv", SUN_AND_PLANET)]);
    assert_eq!(found["rows"][0]["axis"], serde_json::Value::Null);
    assert_eq!(found["rows"][1]["body"], "Planet, small");
    assert!((found["rows"][1]["inclination"].as_f64().expect("a number") - 0.5_f64.atan()).abs() < 1e-15);
}
