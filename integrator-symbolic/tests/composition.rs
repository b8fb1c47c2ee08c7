//! `composition!` from tokens to tokens: the text it writes, and the mistakes it names.

use integrator_symbolic::composition;
use proc_macro2::TokenStream;

fn expand(text: &str) -> TokenStream {
    composition(text.parse().expect("tokens"))
}

fn pretty(text: &str) -> String {
    prettyplease::unparse(&syn::parse2(expand(text)).expect("items"))
}

/// The errors in the output, as `line:column message`.
fn errors(text: &str) -> Vec<String> {
    let file: syn::File = syn::parse2(expand(text)).expect("items");
    let mut found = Vec::new();
    for item in file.items {
        let syn::Item::Macro(syn::ItemMacro { mac, .. }) = item else { continue };
        let start = mac.path.segments[0].ident.span().start();
        let message: syn::LitStr = mac.parse_body().expect("a message");
        found.push(format!("{}:{} {}", start.line, start.column, message.value()));
    }
    found
}

/// The sentence of proved facts behind the documentation of each declaration.
fn facts(text: &str) -> Vec<String> {
    assert_eq!(errors(text), [""; 0], "{text}");
    let file: syn::File = syn::parse2(expand(text)).expect("items");
    let structs = file.items.iter().filter_map(|item| match item {
        syn::Item::Struct(item) => item.attrs.iter().rfind(|attribute| attribute.path().is_ident("doc")),
        _ => None,
    });
    structs
        .map(|attribute| {
            let syn::Meta::NameValue(meta) = &attribute.meta else { panic!("a text") };
            let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &meta.value else { panic!("a text") };
            text.value().trim().to_owned()
        })
        .collect()
}

#[test]
fn proved_facts_of_known_methods() {
    const TAKAHASHI_IMADA: &str = "processed(
        V(0.185935399684605464415966643791607204) T(0.874930615595543534033796586897314284)
        V(0.0731969797858114490791129837957051183) T(-0.237106680151021920477108226727481495)
        V(-0.157662426929808107551937572778690459) T(-0.536353982903912807613546305361210926);
        T(1/2) V(1, -1/24) T(1/2))";
    for (sequence, expected) in [
        (
            TAKAHASHI_IMADA,
            "Order 4 for `T` quadratic in `p` (proved), not symmetric, 1 force evaluation (1 with its gradient) a step.",
        ),
        ("V(1) T(1)", "Order 1 for every `T` (proved), not symmetric, 1 force evaluation a step."),
        ("T(1/2) V(1) T(1/2)", "Order 2 for every `T` (proved), symmetric, 1 force evaluation a step."),
        ("compose(Euler, EulerAdjoint)", "Order 2 for every `T` (proved), symmetric, 1 force evaluation a step."),
        (
            "adjoint(V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1))",
            "Order 3 for every `T` (proved), not symmetric, 3 force evaluations a step.",
        ),
        (
            "V(7/24) T(2/3) V(3/4) T(-2/3) V(_) T(_)",
            "Order 3 for every `T` (proved), not symmetric, 3 force evaluations a step.",
        ),
        ("triple_jump(VelocityVerlet)", "Order 4 for every `T` (proved), symmetric, 3 force evaluations a step."),
        ("suzuki(Verlet)", "Order 4 for every `T` (proved), symmetric, 5 force evaluations a step."),
        ("triple_jump(suzuki(Verlet))", "Order 6 for every `T` (proved), symmetric, 15 force evaluations a step."),
        (
            "triple_jump(triple_jump(triple_jump(Verlet)))",
            "Order 8 for every `T` (proved), symmetric, 27 force evaluations a step.",
        ),
        (
            "suzuki(triple_jump(triple_jump(triple_jump(Verlet))))",
            "Order 10 for every `T` (proved), symmetric, 135 force evaluations a step.",
        ),
        (
            "compose(1/(2 - cbrt(2)), -cbrt(2)/(2 - cbrt(2)), 1/(2 - cbrt(2)); Verlet)",
            "Order 4 for every `T` (proved), symmetric, 3 force evaluations a step.",
        ),
        (
            "symmetric(V(1/6) T(1/2) V(2/3, -1/72))",
            "Order 4 for `T` quadratic in `p` (proved), symmetric, 2 force evaluations (1 with its gradient) a step.",
        ),
        // Takahashi and Imada's kernel: of order 2 without its processor.
        (
            "T(1/2) V(1, -1/24) T(1/2)",
            "Order 2 for `T` quadratic in `p` (proved), symmetric, 1 force evaluation (1 with its gradient) a step.",
        ),
        // Yoshida's solution A, by the 15 digits that are often printed.
        (
            "symmetric(0.784513610477557, 0.235573213359358, -1.17767998417887, _; Verlet)",
            "Order 6 for every `T` (proved), symmetric, 7 force evaluations a step.",
        ),
    ] {
        let facts = facts(&format!("struct Probe = {sequence};"));
        assert!(facts[0].starts_with(expected), "{sequence}: {}", facts[0]);
    }
}

#[test]
fn a_declared_order_chooses_the_class() {
    const MCATE4: &str = "V(0.134496199277431089210659254937312760687) T(0.515352837431122936363778587573609500315) \
        V(-0.22481980307942080594522736361864931224) T(-0.0857820194129736460164250123389618937825) \
        V(0.756320000515668291264290794964469486466) T(0.441583023616466524250195001287251255228) V(_) T(_)";
    let quadratic = pretty(&format!("struct McAte4: order 4 = {MCATE4};"));
    assert!(quadratic.contains("Order 4 where `T` is quadratic in `p` (proved; 3 for every other `T`)"), "{quadratic}");
    assert!(quadratic.contains("__System: ::integrator_core::__private::QuadraticKinetic"), "{quadratic}");
    for declared in [": order 3", ""] {
        let general = pretty(&format!("struct McAte4{declared} = {MCATE4};"));
        assert!(general.contains("Order 3 for every `T`, 4 where `T` is quadratic in `p` (proved)"), "{general}");
        assert!(general.contains("__System: ::integrator_core::__private::System"), "{general}");
        assert!(general.contains("const ORDER: u32 = 3;"), "{general}");
    }
    let found = errors(&format!("struct McAte4: order 5 = {MCATE4};"));
    assert!(
        found[0].contains("finds order 4 where T is quadratic in p (3 for every T)\nnote: the order condition of"),
        "{found:?}"
    );
}

/// One row per mistake: what is typed, and every message about it at its line and column.
#[test]
fn every_mistake_has_one_message_on_its_token() {
    let rows: &[(&str, &[&str])] = &[
        (
            "struct A: order 4 = T(1/2) V(1) T(1/2);",
            &[
                "1:16 declared order 4, but the proof finds order 2\nnote: the order condition of the word TVV has a residual of 8.3e-2",
            ],
        ),
        (
            "struct A: order 4 = symmetric(V(1/6) T(1/2) V(2/3, 1/72));",
            &[
                "1:16 declared order 4, but the proof finds order 2\nnote: the order condition of the word TVV has a residual of 2.8e-2",
            ],
        ),
        (
            "struct A: order 12 = triple_jump(triple_jump(triple_jump(triple_jump(Verlet))));",
            &["1:16 declared order 12, but no order above 10 is proved"],
        ),
        ("struct A: order 0 = Verlet;", &["1:16 an order has to be an integer of at least 1"]),
        ("struct A: symmetric = Euler;", &["1:10 declared symmetric, but the sequence is not a palindrome"]),
        ("struct A: order 2, order 2 = Verlet;", &["1:19 `order` is claimed twice"]),
        (
            "struct A: oder 2 = Verlet;",
            &[
                "1:10 unknown claim `oder`\nhelp: the claims are `order 4`, `order (8, 2)`, `symmetric` and `citation \"..\"`",
            ],
        ),
        (
            "struct A: order (6, 2) = A(1/2) B(1) A(1/2);",
            &[
                "1:16 declared order 6 for words with one B, but the proof finds order 2\nnote: the order condition of the word AAB has a residual of 2.5e-1",
            ],
        ),
        (
            "struct A: order (4, 4) = symmetric(B(1/6) A(1/2) B(_));",
            &[
                "1:16 declared order 4, but the proof finds order 2\nnote: the order condition of the word ABB has a residual of 1.4e-2",
            ],
        ),
        (
            "struct A: order (2, 4) = Verlet;",
            &[
                "1:16 generalised orders have to decrease\nhelp: write, for example, `order (8, 4)`\nnote: the numbers are the orders in increasing powers of the small part",
            ],
        ),
        (
            "struct A: order (4) = Verlet;",
            &[
                "1:16 expected several orders in parentheses\nhelp: write, for example, `order (8, 2)`, one for each power of the small second part",
            ],
        ),
        (
            "struct A: order (40, 2) = Verlet;",
            &[
                "1:16 declared order 40 for words with one V, but the proof finds order 2\nnote: the order condition of the word TTV has a residual of 2.5e-1",
            ],
        ),
        ("struct A = A(1/2) V(1) A(1/2);", &["1:18 a sequence cannot mix the stages `T` and `V` with `A` and `B`"]),
        ("struct A = V(1/2) T(1) V(1/3);", &["1:11 the coefficients of `V` sum to 0.833333333333, not to 1"]),
        ("struct A = V(1) T(0.999);", &["1:11 the coefficients of `T` sum to 0.999, not to 1"]),
        ("struct A = T(1);", &["1:11 the coefficients of `V` sum to 0, not to 1"]),
        (
            "struct A = ;",
            &[
                "1:9 a sequence has at least one stage\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction",
            ],
        ),
        ("struct A = Verlet", &["1:11 expected `;` at the end of a declaration"]),
        ("struct A = Verlet, Euler;", &["1:17 expected `;` at the end of a declaration"]),
        ("struct A;", &["1:8 expected `=`"]),
        ("pub fn a() {} struct B = Verlet;", &["1:4 expected `struct`"]),
        (
            "struct A = W(1) T(1);",
            &[
                "1:11 unknown combinator `W`\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction; the combinators are `triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`",
            ],
        ),
        ("struct A = V T(1);", &["1:11 the stage `V` lacks its coefficient\nhelp: write, for example, `V(1/2)`"]),
        (
            "struct A = V() T(1);",
            &["1:11 a kick takes one number or two\nhelp: write, for example, `V(1/2)` or `V(2/3, -1/72)`"],
        ),
        ("struct A = V(1) T(1, 2);", &["1:16 a drift takes one number\nhelp: write, for example, `T(1/2)`"]),
        (
            "struct A = V(1, 2, 3) T(1);",
            &["1:11 a kick takes one number or two\nhelp: write, for example, `V(1/2)` or `V(2/3, -1/72)`"],
        ),
        ("struct A = V(1 T) T(1);", &["1:15 expected `,`"]),
        (
            "struct A = 1/2 V(1);",
            &[
                "1:11 expected a stage, a combinator or the name of a composition\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction",
            ],
        ),
        ("struct A = V(1/0) T(1);", &["1:15 division by zero"]),
        (
            "struct A = V(sqrt(-1)) T(a);",
            &[
                "1:18 the root of a negative number is not supported\nhelp: move the sign outside, `-cbrt(x)`",
                "1:25 expected a number\nnote: coefficients may contain numbers, `+`, `-`, `*`, `/`, parentheses, `sqrt(x)`, `cbrt(x)` and `root(n, x)`",
            ],
        ),
        ("struct A = V(1e999) T(1);", &["1:13 this coefficient is not finite"]),
        (
            "struct A = V(_) T(1) V(_);",
            &["1:23 `_` may occur only once\nnote: it is what the other coefficients leave of the step"],
        ),
        (
            "struct A = V(1 - _) T(1);",
            &[
                "1:17 `_` has to be a whole coefficient\nhelp: write `T(_)`, which is what the other drifts leave of the step",
            ],
        ),
        (
            "struct A = Verlt;",
            &[
                "1:11 unknown composition `Verlt`\nnote: known compositions are `Euler`, `EulerAdjoint`, `Verlet`, `VelocityVerlet`; the combinators are `triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`",
            ],
        ),
        (
            "struct A = Leapfrog;",
            &[
                "1:11 `Leapfrog` is called `Verlet` here\nhelp: write `Verlet`, drift, kick, drift; `VelocityVerlet` is kick, drift, kick",
            ],
        ),
        (
            "struct A = triple_jump(Euler);",
            &["1:23 `triple_jump` requires a symmetric composition, and this one is not symmetric"],
        ),
        (
            "struct A = triple_jump;",
            &["1:11 `triple_jump` lacks its composition\nhelp: write, for example, `triple_jump(Verlet)`"],
        ),
        (
            "struct A = triple_jump();",
            &[
                "1:11 a sequence has at least one stage\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction",
            ],
        ),
        ("struct A = suzuki(Verlet, Verlet);", &["1:11 `suzuki` takes one composition"]),
        (
            "struct A = suzuki(1/2; Verlet);",
            &[
                "1:18 expected a stage, a combinator or the name of a composition\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction",
            ],
        ),
        (
            "struct A = compose(Verlet);",
            &[
                "1:11 `compose` takes compositions, or weights and a base\nhelp: write `compose(A, B, ..)` for equal parts of the step, or `compose(w1, w2, ..; Base)` for weighted ones",
            ],
        ),
        ("struct A = symmetric(; Verlet);", &["1:21 expected weights before the `;`"]),
        ("struct A = symmetric(1/2 1/2; Verlet);", &["1:25 expected `,`"]),
        (
            "struct A = symmetric(1, _, _; Verlet);",
            &["1:27 `_` may occur only once\nnote: it is what the other coefficients leave of the step"],
        ),
        (
            "struct A = suzuki(suzuki(suzuki(suzuki(Verlet))));",
            &["1:11 the sequence has 1251 stages, and at most 1000 are supported"],
        ),
        ("struct A = Verlet; struct A = Euler;", &["1:26 `A` is declared twice in this block"]),
        ("crate = ; struct A = Verlet;", &["1:8 expected identifier"]),
        ("struct A: citation 1990 = Verlet;", &["1:19 expected string literal"]),
        (
            "struct A = processed(Verlet);",
            &["1:11 `processed` takes two sequences\nhelp: write `processed(pre; kernel)`"],
        ),
        (
            "struct A = processed(Euler; Verlet; Verlet);",
            &["1:11 `processed` takes two sequences\nhelp: write `processed(pre; kernel)`"],
        ),
        ("struct A = processed(T(1/2); T(1/2) V(1));", &["1:11 the coefficients of `T` sum to 0.5, not to 1"]),
        (
            "struct A = triple_jump(processed(T(1/2); Verlet));",
            &["1:23 `triple_jump` requires a symmetric composition, and this one is not symmetric"],
        ),
        (
            "struct A = T(1/2) processed(T(1/2); Verlet);",
            &["1:28 `processed(..)` cannot be part of another composition"],
        ),
        (
            "struct A = processed(T(1/2); Verlet); struct B = adjoint(A); struct C = A T(1);",
            &[
                "1:57 a processed composition cannot be a part of another one",
                "1:72 a processed composition cannot be a part of another one",
            ],
        ),
        (
            "struct A: symmetric = processed(T(1/2); Verlet);",
            &["1:10 declared symmetric, but the sequence is not a palindrome"],
        ),
        // Friction.
        ("struct A = V(1/2) T(1/2) O(1) T(1/2) V(1/2);", &[]),
        ("struct A: order 2, symmetric = A(1/2) B(1/2) O(_) B(1/2) A(1/2);", &[]),
        ("struct A = V(1/2) T(1) O(1/2) V(1/2);", &["1:11 the coefficients of `O` sum to 0.5, not to 1"]),
        ("struct A: order 3 = O(1/2) Verlet O(1/2);", &["1:16 declared order 3, but no order above 2 is proved"]),
        (
            "struct A: order (4, 2) = O(1/2) Verlet O(1/2);",
            &["1:16 generalised orders do not support friction `O`\nhelp: claim one order, `order 2`"],
        ),
        ("struct A = O T(1) V(1);", &["1:11 the stage `O` lacks its coefficient\nhelp: write, for example, `O(1/2)`"]),
        ("struct A = T(1) V(1) O(1, 2);", &["1:21 friction takes one number\nhelp: write, for example, `O(1)`"]),
        (
            "struct A = T(1/2) V(1, 1/8) T(1/2) O(1);",
            &["1:11 a composition with friction `O` does not support force gradients\nhelp: use kicks `V(b)`"],
        ),
        (
            "struct A = processed(O(1/2); Verlet);",
            &["1:11 a processor cannot contain friction `O`, which has no inverse if there is noise"],
        ),
        (
            "struct A = processed(T(1/2); O(1/2) Verlet O(1/2));",
            &["1:11 `processed(..)` does not support friction `O`"],
        ),
        // Two mistakes, two messages; users of what was refused are not told again.
        (
            "struct A: order 3 = Verlet;\nstruct B = adjoint(A);\nstruct C = D;",
            &[
                "1:16 declared order 3, but the proof finds order 2\nnote: the order condition of the word TVV has a residual of 8.3e-2",
                "3:11 unknown composition `D`\nnote: known compositions are `Euler`, `EulerAdjoint`, `Verlet`, `VelocityVerlet`, `A`, `B`; the combinators are `triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`",
            ],
        ),
    ];
    let mut wrong = String::new();
    for (text, expected) in rows {
        let found = errors(text);
        if found != *expected {
            wrong += &format!("        ({text:?},\n         &{found:?}),\n");
        }
    }
    assert!(wrong.is_empty(), "found:\n{wrong}");
}

#[test]
fn a_refused_declaration_is_still_defined() {
    let text = pretty("pub struct A: order 3 = Verlet;");
    assert!(text.contains("pub struct A;") && text.contains("Scheme for A") && text.contains("> for A {}"), "{text}");
}

#[test]
fn wrong_coefficients_are_refused() {
    const YOSHIDA6: &str = "0.784513610477557263819497633866349876, 0.235573213359358133684793182978534602, \
        -1.17767998417887100694641568096431573, _";
    let declare = |weights: &str| format!("struct A: order 6 = symmetric({weights}; Verlet);");
    assert_eq!(errors(&declare(YOSHIDA6)), [""; 0]);
    let twentieth = YOSHIDA6.replace("0.7845136104775572638", "0.7845136104775572639");
    let found = errors(&declare(&twentieth));
    assert!(found[0].contains("wrong or missing digits"), "{found:?}");
    let exchanged = "0.235573213359358133684793182978534602, 0.784513610477557263819497633866349876, \
        -1.17767998417887100694641568096431573, _";
    let found = errors(&declare(exchanged));
    assert!(found[0].contains("the proof finds order 4"), "{found:?}");
    let found = errors("struct A: order 8 = compose(0.1, 0.05, 0.053; Verlet);");
    assert!(found[0].contains("sum to 0.203, not to 1"), "{found:?}");
    let found = errors("struct A: order 2 = compose(Euler, Euler);");
    assert!(found[0].contains("the proof finds order 1"), "the adjoint in the wrong place: {found:?}");
}

#[test]
fn equal_tokens_give_equal_code() {
    let text = "struct A = suzuki(triple_jump(Verlet));";
    assert_eq!(expand(text).to_string(), expand(text).to_string());
}
