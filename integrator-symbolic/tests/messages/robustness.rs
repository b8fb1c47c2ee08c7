//! The macro returns for every input, says the same about the same, and names no other runtime than it is told.

use crate::{
    mutate::{Sample, annotated, arbitrary, expanded, mutated},
    tokens,
};
use integrator_symbolic::hamiltonian;
use proptest::{prelude::*, test_runner::RngSeed};
use std::{env, path::Path, sync::LazyLock};

#[test]
fn equal_tokens_give_equal_code() {
    for (arguments, item) in SAMPLES {
        let expand = || hamiltonian(tokens(arguments), tokens(item)).to_string();
        assert_eq!(expand(), expand(), "{item}");
    }
}

#[test]
fn a_renamed_runtime_is_the_only_one_named() {
    for (arguments, item) in SAMPLES {
        let text = hamiltonian(tokens(&format!("crate = my::runtime, {arguments}")), tokens(item)).to_string();
        assert!(text.contains("my :: runtime :: __private") && !text.contains("integrator_core"), "{text}");
    }
}

/// Systems that between them use most of the language.
const SAMPLES: [(&str, &str); 4] = [
    (
        "compose = Yoshida4",
        "impl Pendulum { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.mass) } \
         fn potential(&self, q: [f64; 1]) -> f64 { -self.mass * self.gravity * q[0].cos() } }",
    ),
    (
        "compose = V(1/2) T(1) V(1/2)",
        "impl Bodies { fn kinetic(&self, p: &[[f64; 3]; 4]) -> f64 { let mut t = 0.0; for i in 0..4 { for d in 0..3 { \
         t += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } t } \
         fn potential(&self, q: &[[f64; 3]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { \
         let mut r2 = 0.0; for d in 0..3 { let dx = q[i][d] - q[j][d]; r2 += dx * dx; } \
         v -= self.mass[i] * self.mass[j] / r2.sqrt(); } } v } }",
    ),
    (
        "",
        "impl<const N: usize> Chain<N> { fn kinetic(&self, p: [f64; N]) -> f64 { let mut t = 0.0; for i in 0..N { \
         t += 0.5 * p[i] * p[i]; } t } fn potential(&self, q: [f64; N]) -> f64 { let mut v = self.spring(q[0]); \
         for i in 1..N { v += self.spring(q[i] - q[i - 1]); } v } \
         fn spring(&self, d: f64) -> f64 { let (s, c) = d.sin_cos(); d * d / 2.0 + self.alpha * s * c } }",
    ),
    (
        "",
        "impl Driven { fn kinetic(&self, p: [f64; 2], t: f64) -> f64 { (1.0 + p[0] * p[0]).sqrt() + p[1] * t.sin() } \
         fn potential(&self, [x, y]: [f64; 2], t: f64) -> f64 { const C: f64 = 2.0; \
         x.powi(2) / C - self.amplitude * x * (self.omega * t).cos() + y.exp().ln_1p() } }",
    ),
];

/// The samples here, and the systems of the corpus.
fn samples() -> &'static [Sample] {
    static ALL: LazyLock<Vec<Sample>> = LazyLock::new(|| {
        let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/long/tests/corpus");
        let mut all = annotated(&corpus);
        assert!(all.len() > 30, "the corpus is found: {}", all.len());
        all.extend(SAMPLES.map(|(arguments, item)| Sample::new(arguments, item)));
        all
    });
    &ALL
}

/// So many cases, or as many as the variable `PROPTEST_CASES` says: before a change is merged they are many more.
fn cases(count: u32) -> ProptestConfig {
    // The same cases every time: a build does not fail for what it did not change. New cases are for the fuzz targets.
    let rng_seed = RngSeed::Fixed(2027);
    let default = ProptestConfig::default();
    let cases = if env::var_os("PROPTEST_CASES").is_some() { default.cases } else { count };
    ProptestConfig { failure_persistence: None, rng_seed, cases, ..default }
}

proptest! {
    #![proptest_config(cases(500))]

    /// Where tokens are lost, doubled, exchanged or replaced, the macro returns the item, and code or messages.
    #[test]
    fn mutated_systems_return_the_item(bytes in prop::collection::vec(any::<u8>(), 24)) {
        let case = mutated(&bytes, samples());
        expanded(&case).map_err(|wrong| TestCaseError::fail(format!("{case:?}: {wrong}")))?;
    }
}

proptest! {
    #![proptest_config(cases(3_000))]

    /// So it does for bodies that nobody would write.
    #[test]
    fn arbitrary_bodies_return_the_item(bytes in prop::collection::vec(any::<u8>(), 64)) {
        let case = arbitrary(&bytes);
        expanded(&case).map_err(|wrong| TestCaseError::fail(format!("{case:?}: {wrong}")))?;
    }
}
