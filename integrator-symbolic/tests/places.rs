//! Where a panic of prepared code is located: at the expression of the user that it is a copy of.

use proc_macro2::{Delimiter, LineColumn, TokenStream, TokenTree};

/// Reads of lists that may be out of bounds, each the only one in square brackets on its line.
const READS: [&str; 5] = [
    "let x = self.table[self.count + 1];",
    "let y = self.rows[self.count][2];",
    "for i in 0..4 { v += self.table[i + 2] * q[0]; }",
    "for i in 0..4 { v += (self.table[2 * i] + 1.0) * (self.bonds[i].0 as f64) * q[0]; }",
    "let list = &self.table; for i in 0..4 { v += list[i + self.count] * q[0]; }",
];

/// The places of the square brackets behind a name or behind others, in the text itself or in what is written from it.
fn brackets(text: TokenStream, found: &mut Vec<LineColumn>) {
    let mut behind_list = false;
    for token in text {
        let mut list = matches!(&token, TokenTree::Ident(_));
        if let TokenTree::Group(group) = &token {
            if group.delimiter() == Delimiter::Bracket && behind_list {
                found.push(group.span().start());
                list = true;
            }
            brackets(group.stream(), found);
        }
        behind_list = list;
    }
}

#[test]
fn reads_of_lists_are_located_where_the_user_wrote_them() {
    for read in READS {
        let item = format!(
            "impl System {{\n fn kinetic(&self, p: [f64; 1]) -> f64 {{ 0.0 }}\n fn potential(&self, q: [f64; 1]) -> f64 {{\n \
             let (mut v, x, y) = (0.0, 1.0, 1.0);\n {read}\n v + x * y * q[0]\n }}\n }}"
        );
        let item: TokenStream = item.parse().expect("tokens");
        let mut typed = Vec::new();
        brackets(item.clone(), &mut typed);
        // The impl itself is given back in front of what is generated.
        let written = integrator_symbolic::hamiltonian(TokenStream::new(), item).into_iter();
        let generated: TokenStream = written.skip_while(|token| token.to_string() != "const").collect();
        let prepared = function_body(generated, "parameters");
        let mut copies = Vec::new();
        brackets(prepared, &mut copies);
        let on_the_line: Vec<LineColumn> = typed.into_iter().filter(|place| place.line == 5).collect();
        let lists = on_the_line.iter().filter(|place| copies.contains(place)).count();
        assert!(lists > 0, "{read}: {copies:?} for {on_the_line:?}");
        assert!(copies.iter().all(|place| place.line == 5), "{read}: {copies:?}");
    }
}

/// The body of a function of this name.
fn function_body(text: TokenStream, name: &str) -> TokenStream {
    let mut tokens = text.into_iter();
    let mut body = TokenStream::new();
    while let Some(token) = tokens.next() {
        match &token {
            TokenTree::Ident(word) if word == "fn" && tokens.next().is_some_and(|found| found.to_string() == name) => {
                let brace = tokens.by_ref().find_map(|token| match token {
                    TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
                    _ => None,
                });
                body.extend(brace.map(|brace| brace.stream()));
            }
            TokenTree::Group(group) => body.extend(function_body(group.stream(), name)),
            _ => {}
        }
    }
    body
}
