//! `#[derivative(..)]`: what is said of a wrong one, and that it is gone from the item that is written back.

use proc_macro2::TokenStream;

fn expanded(helpers: &str) -> String {
    let item = format!(
        "impl System {{
            fn kinetic(&self, p: [f64; 1]) -> f64 {{ p[0] * p[0] }}
            fn potential(&self, q: [f64; 1]) -> f64 {{ self.phi(q[0]) }}
            {helpers}
        }}"
    );
    let item: TokenStream = item.parse().expect("tokens");
    integrator_symbolic::hamiltonian(TokenStream::new(), item).to_string()
}

#[test]
fn the_attribute_is_taken_away() {
    let written = expanded(
        "#[inline] #[derivative(slope)] fn phi(&self, r: f64) -> f64 { r.sin() } fn slope(&self, r: f64) -> f64 { r.cos() }",
    );
    assert!(!written.contains("derivative (slope)") && !written.contains("compile_error"), "{written}");
    assert!(written.contains("# [inline] fn phi"), "other attributes stay: {written}");
}

#[test]
fn a_function_may_be_its_own_derivative() {
    let written = expanded("#[derivative(phi)] fn phi(&self, r: f64) -> f64 { r.exp() }");
    assert!(!written.contains("compile_error"), "{written}");
}

#[test]
fn mistakes_are_named() {
    let rows = [
        ("#[derivative(slope)] fn phi(&self, r: f64) -> f64 { r }", "the impl lacks `fn slope(&self, x: f64) -> f64`"),
        ("#[derivative] fn phi(&self, r: f64) -> f64 { r }", "name the method that gives the derivative"),
        ("#[derivative(a, b)] fn phi(&self, r: f64) -> f64 { r }", "name the method that gives the derivative"),
        ("#[derivative(phi)] fn phi(&self, r: f64) -> f32 { r }", "takes one f64 or two"),
        ("#[derivative(phi)] fn phi(&self, r: [f64; 1]) -> f64 { r[0] }", "takes one f64 or two"),
        ("#[derivative(phi)] fn phi(&self, r: f64, s: f64) -> f64 { r }", "`phi` takes 2 arguments, not 1"),
    ];
    for (helpers, message) in rows {
        let written = expanded(helpers);
        assert!(written.contains(message), "{helpers}: {message}\n{written}");
    }
}
