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
fn a_gradient_in_an_array_is_read_by_its_elements() {
    let written = expanded(
        "fn phi(&self, r: f64) -> f64 { self.field(r, 1.0, r) }
        #[derivative(slopes)] fn field(&self, x: f64, y: f64, z: f64) -> f64 { x * y * z }
        #[derivative(bends)] fn slopes(&self, x: f64, y: f64, z: f64) -> [f64; 3] { [y * z, x * z, x * y] }
        fn bends(&self, x: f64, y: f64, z: f64) -> [[f64; 3]; 3] { [[0.0, z, y], [z, 0.0, x], [y, x, 0.0]] }",
    );
    assert!(!written.contains("compile_error"), "{written}");
    for (method, element) in [("slopes", "[0]"), ("slopes", "[1]"), ("slopes", "[2]"), ("bends", "[0] [2]")] {
        let call = format!("system . {method} (argument_0 , argument_1 , argument_2) {element})");
        assert!(written.contains(&call), "{call}\n{written}");
    }
}

#[test]
fn mistakes_are_named() {
    let rows = [
        ("#[derivative(slope)] fn phi(&self, r: f64) -> f64 { r }", "the impl lacks `fn slope(&self, x: f64) -> f64`"),
        ("#[derivative] fn phi(&self, r: f64) -> f64 { r }", "`#[derivative]` lacks the method that returns the derivative"),
        ("#[derivative(a, b)] fn phi(&self, r: f64) -> f64 { r }", "`#[derivative]` lacks the method that returns the derivative"),
        ("#[derivative(phi)] fn phi(&self, r: f64) -> f32 { r }", "between one and 8 arguments"),
        ("#[derivative(phi)] fn phi(&self, r: [f64; 1]) -> f64 { r[0] }", "between one and 8 arguments"),
        ("#[derivative(phi)] fn phi(&self, r: f64, s: f64) -> f64 { r }", "`phi` takes 2 arguments, not 1"),
        (
            "fn phi(&self, r: f64) -> f64 { self.field(r, 1.0, r) } #[derivative(a, b)] fn field(&self, x: f64, y: f64, z: f64) -> f64 { x }",
            "lacks the methods that return the 3 derivatives",
        ),
        (
            "fn phi(&self, r: f64) -> f64 { self.field(r, 1.0) } #[derivative(slopes)] fn field(&self, x: f64, y: f64) -> f64 { x }",
            "the impl lacks `fn slopes(&self, x: f64, y: f64) -> [f64; 2]`, the derivative of `field`",
        ),
        (
            "fn phi(&self, r: f64) -> f64 { self.field(r, 1.0) } #[derivative(slopes)] fn field(&self, x: f64, y: f64) -> f64 { x }
            fn slopes(&self, x: f64, y: f64) -> [f64; 3] { [1.0, 0.0, 0.0] }",
            "`slopes` has to return the derivatives as `[f64; 2]`",
        ),
        (
            "fn phi(&self, r: f64) -> f64 { self.field(r, 1.0) } #[derivative(slopes)] fn field(&self, x: f64, y: f64) -> f64 { x }
            #[derivative(a, b)] fn slopes(&self, x: f64, y: f64) -> [f64; 2] { [1.0, 0.0] }",
            "lacks the method that returns the second derivatives",
        ),
    ];
    for (helpers, message) in rows {
        let written = expanded(helpers);
        assert!(written.contains(message), "{helpers}: {message}\n{written}");
    }
}
