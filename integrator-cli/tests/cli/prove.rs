//! `prove`: what is known of sequences, and what is wrong with them.

use super::{answer, json, keys, refusal};

#[test]
fn the_report_on_velocity_verlet_is_complete() {
    let expected = "V(1/2) T(1) V(1/2)
    order            2 for every T(p)
    inner steps      order 2 if any symmetric composition integrates the second part
    symmetric        yes
    class            every T(p)
    stages           V(0.5) T(1) V(0.5)
    forces per step  1
    stable           h ω < 2.000000
    residual         8.3e-2 in the order condition of the word TTV
    leading error    9.316950e-2 h^3, the norm of
                     +8.333333e-2 [T, [T, V]]
                     -4.166667e-2 [[T, V], V]
";
    assert_eq!(answer(&["prove", "V(1/2) T(1) V(1/2)"]), expected);
}

/// A row: what is asked, and lines of the answer.
type Row<'a> = (&'a [&'a str], &'a [&'a str]);

#[test]
fn answers() {
    let rows: &[Row<'_>] = &[
        (&["V(1) T(1)"], &["order            1 for every T(p)", "symmetric        no"]),
        (&["triple_jump(Verlet)", "--order", "4"], &["order            4 for every T(p)", "h ω < 1.573402"]),
        (&["suzuki(VelocityVerlet)"], &["forces per step  5", "leading error    1.838754e-3 h^5"]),
        (&["symmetric(V(1/6) T(1/2) V(2/3, -1/72))"], &["4 for T = ½ pᵀ M⁻¹ p", "2, 1 with its gradient"]),
        (&["compose(Verlet, Verlet)"], &["stages           T(0.25) V(0.5) T(0.5) V(0.5) T(0.25)"]),
        (&["Chin4A"], &["class            T = ½ pᵀ M⁻¹ p alone", "source           Chin 1997"]),
        (&["BlanesCasasMurua6S11"], &["processor        ", "forces per step  11"]),
        (&["BlanesMoanSrkn11", "--order", "6"], &["4 for every T(p), 6 for T = ½ pᵀ M⁻¹ p"]),
        (
            &["Aba864"],
            &[
                "order            4 for every T(p)",
                "small second     (8, 6, 4) where",
                "errors of at most ε^(r+1) h^r for H = A + ε B",
                "stages           A(0.07",
            ],
        ),
        (&["Yoshida6"], &["inner steps      order 6 if any symmetric composition"]),
        (
            &["BlanesMoan6"],
            &[
                "order 2 if a symmetric composition of order 2 integrates",
                ", 4 if of order 4, 6 if of order 6 or higher\n",
            ],
        ),
        (&["KahanLi10"], &["order            10 for every T(p)", "and 180 smaller terms"]),
    ];
    for (arguments, lines) in rows {
        let found = answer(&[&["prove"], *arguments].concat());
        for line in *lines {
            assert!(found.contains(line), "{arguments:?} lacks `{line}`:\n{found}");
        }
    }
}

#[test]
fn a_wrong_order_is_an_error_with_its_reason() {
    let sequence = "V(1/6) T(1/2) V(2/3) T(1/2) V(1/6)";
    let expected = format!(
        "error: declared order 4, but the proof finds order 2
 --> sequence:1:1
  |
1 | {sequence}
  | {}
  |
  = note: the order condition of the word TVV has a residual of 1.4e-2
",
        "^".repeat(sequence.len())
    );
    assert_eq!(refusal(&["prove", sequence, "--order", "4"]), expected);
    answer(&["prove", sequence, "--order", "2"]);
    let message = refusal(&["prove", "Yoshida4", "--order", "6"]);
    assert!(message.contains("declared order 6, but the proof finds order 4\n"), "{message}");
    assert!(message.contains("= note: the order condition of the word "), "{message}");
}

#[test]
fn refusals() {
    for (sequence, expected) in [
        ("", "a sequence has at least one stage"),
        ("   ", "a sequence has at least one stage"),
        ("T(1) V(", "this is not Rust"),
        ("T V", "the stage `T` lacks its coefficient"),
        ("T(1) V(1); T(1)", "unexpected input after the end of the sequence"),
        ("T(1) V(1), T(1)", "unexpected input after the end of the sequence"),
        ("V(1/2) T(0.9) V(1/2)", "the coefficients of `T` sum to 0.9, not to 1"),
        ("Unknown", "unknown composition `Unknown`"),
        ("Yoshda4", "= help: similar names: `Yoshida4`"),
        ("verlet", "`Verlet`"),
        ("Leapfrog", "`Leapfrog` is called `Verlet` here"),
        ("ForwardEuler", "= help: add the crate `extras/integrator-reference`"),
        ("triple_jump(Leapfrog)", "= help: write `Verlet`, drift, kick, drift;"),
        ("KahanLi7", "`KahanLi6`, `KahanLi8`"),
        ("double_jump(Verlet)", "unknown combinator `double_jump`"),
        ("triple_jump(Euler)", "this one is not symmetric"),
        ("T(1/0) V(1)", "error: "),
        ("T(1e400) V(1)", "error: "),
        ("🦀", "this is not Rust"),
        ("compose(Verlet, Verlet", "this is not Rust"),
        (&"triple_jump(".repeat(300), "this is not Rust"),
        (&format!("{}Verlet{}", "triple_jump(".repeat(300), ")".repeat(300)), "nested more than 200 levels deep"),
        (&format!("{}Verlet{}", "triple_jump(".repeat(12), ")".repeat(12)), "at most 1000 are supported"),
    ] {
        let message = refusal(&["prove", sequence]);
        assert!(message.contains(expected), "`{sequence}`: {message}");
    }
}

#[test]
fn json_says_the_same() {
    let found = json(&["prove", "V(1/2) T(1) V(1/2)"]);
    assert_eq!(
        keys(&found),
        [
            "citation",
            "class",
            "error_terms",
            "forces_per_step",
            "general_order",
            "generalised_orders",
            "gradients_per_step",
            "leading_error",
            "order",
            "orders_over_inner",
            "processor",
            "quadratic_order",
            "sequence",
            "stability_limit",
            "stages",
            "symmetric",
            "violation",
        ]
    );
    assert_eq!((&found["order"], &found["class"]), (&2.into(), &"general".into()));
    assert_eq!(json(&["prove", "WisdomHolmanTouma17"])["generalised_orders"], serde_json::json!([18, 2]));
    assert_eq!(json(&["prove", "BlanesMoan4"])["orders_over_inner"], serde_json::json!([2, 4, 4, 4]));
    let third = found["error_terms"][0]["factor"].as_f64().expect("a number");
    assert!((third - 1.0 / 12.0).abs() < 1e-15, "{third}");
    assert_eq!(found["stages"].as_array().expect("a list").len(), 3);
    let gradient = json(&["prove", "Chin4A"]);
    assert_eq!((&gradient["general_order"], &gradient["quadratic_order"]), (&serde_json::Value::Null, &4.into()));
    assert_eq!(gradient["orders_over_inner"], serde_json::Value::Null);
}
