//! Methods that the field calls by another name than the catalogue, or that are no compositions.

/// Names of compositions elsewhere, the names of these in the catalogue, and what they are.
const CALLED: [(&str, &str, &str); 13] = [
    ("Leapfrog", "Verlet", LEAPFROG),
    ("LeapFrog", "Verlet", LEAPFROG),
    ("StoermerVerlet", "Verlet", LEAPFROG),
    ("StormerVerlet", "Verlet", LEAPFROG),
    ("PositionVerlet", "Verlet", LEAPFROG),
    ("EulerCromer", "Euler", EULER),
    ("SemiImplicitEuler", "Euler", EULER),
    ("SymplecticEuler", "Euler", EULER),
    ("ForestRuth", "Yoshida4", "the triple jump of `Verlet`"),
    ("ImplicitMidpointRule", "ImplicitMidpoint", "for `split = none`"),
    ("Midpoint", "ImplicitMidpoint", "for `split = none`; `ExplicitMidpoint` is a textbook method"),
    ("WHFast", "Verlet", WISDOM_HOLMAN),
    ("WisdomHolman", "Verlet", WISDOM_HOLMAN),
];

const LEAPFROG: &str = "drift, kick, drift; `VelocityVerlet` is kick, drift, kick";
const EULER: &str = "kick, drift; `EulerAdjoint` is drift, kick";
const WISDOM_HOLMAN: &str = "with `coordinates = jacobi(self.mass), split = kepler + interaction`";

/// Names of textbook methods, and how the crate `integrator-reference` writes them.
const TEXTBOOK: [(&str, &str); 14] = [
    ("AdamsBashforth4", "AdamsBashforth4"),
    ("AdamsBashforthMoulton4", "AdamsBashforthMoulton4"),
    ("BackwardEuler", "BackwardEuler"),
    ("ExplicitEuler", "ForwardEuler"),
    ("ExplicitMidpoint", "ExplicitMidpoint"),
    ("ForwardEuler", "ForwardEuler"),
    ("GraggBulirschStoer", "GraggBulirschStoer"),
    ("ImplicitEuler", "BackwardEuler"),
    ("RK4", "RungeKutta4"),
    ("Rk4", "RungeKutta4"),
    ("RungeKutta", "RungeKutta4"),
    ("RungeKutta4", "RungeKutta4"),
    ("StaggeredLeapfrog", "StaggeredLeapfrog"),
    ("Stoermer4", "Stoermer4"),
];

/// Returns what to say of a method that the catalogue has under another name, or that is no composition: one line, and a line of help.
pub fn named_otherwise(name: &str) -> Option<[String; 2]> {
    let called = CALLED
        .iter()
        .find(|(known, _, _)| *known == name)
        .map(|(_, here, what)| [format!("`{name}` is called `{here}` here"), format!("write `{here}`, {what}")]);
    called.or_else(|| {
        TEXTBOOK.iter().find(|(known, _)| *known == name).map(|(_, there)| {
            [
                format!("`{name}` is a textbook method, not a composition of exact flows"),
                format!(
                    "add the crate `extras/integrator-reference` and pass the method to the run: `system.run_with({there}, start, h)`"
                ),
            ]
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is written instead exists.
    #[test]
    fn methods_are_where_messages_say() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../");
        let text = |path: &str| std::fs::read_to_string(format!("{folder}{path}")).expect("text");
        let catalogue =
            ["basic", "symmetric"].map(|file| text(&format!("integrator-core/src/composition/catalogue/{file}.rs")));
        let catalogue = catalogue.concat() + &text("integrator-core/src/methods/implicit/gauss_legendre.rs");
        for (_, here, _) in CALLED {
            let declared = [format!("{here}:"), format!("pub type {here} =")];
            assert!(declared.iter().any(|declared| catalogue.contains(declared)), "{here}");
        }
        let textbook = text("extras/integrator-reference/src/lib.rs");
        for (_, there) in TEXTBOOK {
            assert!(textbook.contains(&format!("//! | [`{there}`] |")), "{there}");
        }
    }
}
