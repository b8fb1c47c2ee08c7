//! Every message about a Hamiltonian, with what it is about.

use crate::Row;

/// Arguments of the attribute, on an impl without mistakes.
pub(crate) const ARGUMENTS: &[Row] = &[
    ("compose = Verlet", &[]),
    ("compose = my::Composition, crate = runtime,", &[]),
    ("compose = V(1/2) T(1) V(1/2), crate = runtime", &[]),
    (
        "composition = Verlet",
        &[
            "1:0 unknown argument `composition`\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "Verlet",
        &[
            "1:0 unknown argument `Verlet`\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "4",
        &[
            "1:0 expected an argument\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose",
        &[
            "1:0 this argument lacks its value\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose =",
        &[
            "1:0 this argument lacks its value\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose = 4",
        &[
            "1:10 expected the name of a composition or a sequence of stages\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    ("compose = Verlet compose = Verlet", &["1:17 expected `,`"]),
    ("compose = Verlet, compose = Euler", &["1:18 `compose` is given twice"]),
    ("functions = fast, functions = precise", &["1:18 `functions` is given twice"]),
    ("taylor, functions = fast", &[]),
    ("taylor, taylor", &["1:8 `taylor` is given twice"]),
    (
        "taylor(1e-12)",
        &[
            "1:6 `taylor` takes no tolerance\nhelp: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-12), start, h)` for a run",
        ],
    ),
    (
        "taylor = 1e-9, functions = fast",
        &[
            "1:9 `taylor` takes no tolerance\nhelp: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-9), start, h)` for a run",
        ],
    ),
    (
        "taylor(tolerance = 1e-9)",
        &[
            "1:6 `taylor` takes no tolerance\nhelp: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-12), start, h)` for a run",
        ],
    ),
    (
        "compose = Taylor::tolerance(1e-12)",
        &[
            "1:10 `compose` does not support `Taylor::tolerance(1e-12)`, a method with arguments\nhelp: pass it to the run, `system.run_with(Taylor::tolerance(1e-12), start, h)`",
        ],
    ),
    ("order = 2", &[]),
    ("order = 0", &["1:8 the order has to be a positive integer\nhelp: write, for example, `order = 4`"]),
    ("order = 4.0", &["1:8 the order has to be a positive integer\nhelp: write, for example, `order = 4`"]),
    ("order = -4", &["1:8 the order has to be a positive integer\nhelp: write, for example, `order = 4`"]),
    ("order = 99999999999", &["1:8 the order has to be a positive integer\nhelp: write, for example, `order = 4`"]),
    ("order = 4, order = 4", &["1:11 `order` is given twice"]),
    (
        "compose = Logarithmic(KahanLi8)",
        &[
            "1:10 `compose` does not support `Logarithmic(KahanLi8)`, a method with arguments\nhelp: pass it to the run, `system.run_with(Logarithmic(KahanLi8), start, h)`",
        ],
    ),
    ("compose = my::Composition::<8>", &[]),
    ("gpu, functions = fast", &[]),
    ("gpu, gpu", &["1:5 `gpu` is given twice"]),
    ("gpu(functions = native), functions = fast", &[]),
    ("gpu(functions = native), gpu", &["1:25 `gpu` is given twice"]),
    (
        "gpu()",
        &[
            "1:0 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu(functions)",
        &[
            "1:0 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu(native)",
        &[
            "1:4 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu(functions = fast)",
        &[
            "1:16 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu(functions = 4)",
        &[
            "1:16 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu(functions = native, threads)",
        &[
            "1:22 unknown argument of `gpu`\nhelp: write `gpu` or `gpu(functions = native)`\nnote: `native` selects the elementary functions of the device, which are not bitwise identical to those of the processor",
        ],
    ),
    (
        "functions = quick",
        &[
            "1:12 expected `fast` or `precise`\nnote: errors of elementary functions are at most 4 ulp if `fast`, and 1 or 2 ulp if `precise`, the default",
        ],
    ),
    ("crate = a, crate = b", &["1:11 `crate` is given twice"]),
    (
        "crate = 4",
        &[
            "1:8 expected the path of `integrator_core`\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose = Verlet, crate",
        &[
            "1:18 this argument lacks its value\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    ("compose = V(1/2) T(1) V(1/3)", &["1:10 the coefficients of `V` sum to 0.833333333333, not to 1"]),
    (
        "compose = V(1/2) T(1) W(1/2)",
        &[
            "1:22 unknown combinator `W`\nnote: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` for friction; the combinators are `triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`",
        ],
    ),
];

/// Annotated items.
pub(crate) const ITEMS: &[Row] = &[
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn rate(&self, q: [f64; 2]) -> f64 { q[0] } }",
        &[
            "1:120 `rate` is not a function of all positions\nhelp: write `fn rate(&self, q: ..) -> f64`, or rename it\nnote: `rate` controls the step size by time transformation",
        ],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { self.rate(q[0]) } fn rate(&self, x: f64) -> f64 { x } }",
        &[],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] } }",
        &[
            "1:120 `hamiltonian` is not used\nhelp: remove it, or rename it\nnote: H is the sum of `kinetic` and `potential`, which do not call it",
        ],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.kinetic(p) + self.potential(q) } }",
        &[],
    ),
    (
        "impl S { fn kinetic(&self, p: &[f64]) -> f64 { p[0] * p[0] } fn potential(&self, q: &[f64]) -> f64 {\nlet mut a = q.to_vec(); a[0] = 1.0; a[1] } }",
        &[
            "2:24 assigning to an element of a copy of the coordinates is not supported for more than 16 elements\nhelp: write the new value as a variable",
        ],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &[],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:13 an invariant has to be a function of positions and momenta\nhelp: write `fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64`",
        ],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) {} }",
        &[
            "2:13 an invariant has to be a function of positions and momenta\nhelp: write `fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64`",
        ],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.c } }",
        &["2:16 the invariant `a` depends on neither positions nor momenta"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn energy(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &["2:16 `energy` is the name of a column in output files\nhelp: rename the invariant"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn p0_1(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &["2:16 `p0_1` is the name of a column in output files\nhelp: rename the invariant"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] } }",
        &["3:16 the invariant `a` is defined twice\nhelp: rename this function"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * t } }",
        &["2:51 an invariant does not depend on time\nhelp: remove this argument"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] - q[1] * p[0] } }",
        &["2:18 H has the coordinates `[f64; 1]`, and these are `[f64; 2]`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant(of = rotation)] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:0 `#[invariant]` takes no arguments"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] #[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:13 `#[invariant]` is given twice"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, p: [f64; 1], q: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:18 positions have to come before momenta\nhelp: write `fn a(&self, q, p)`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { bessel(q[0]) * p[0] } }",
        &[
            "2:60 no derivative of `bessel` is known\nhelp: move the function into this impl and call `Self::bessel`, or call it in a method with a stated derivative, `#[derivative(slope)]`\nnote: the macro sees only the functions of this impl",
        ],
    ),
    ("struct System;", &["1:0 `#[hamiltonian]` requires an `impl` with the functions `kinetic` and `potential`"]),
    ("", &["1:0 `#[hamiltonian]` requires an `impl` with the functions `kinetic` and `potential`"]),
    ("impl System { fn }", &["1:17 unexpected end of input, expected identifier"]),
    (
        "impl Trait for System {}",
        &[
            "1:5 `#[hamiltonian]` does not support the impl of a trait\nhelp: write an inherent impl, `impl System { ... }`",
        ],
    ),
    (
        "impl System {}",
        &[
            "1:5 the impl lacks `fn kinetic(&self, p: [f64; N]) -> f64`, one of the two parts of H",
            "1:5 the impl lacks `fn potential(&self, q: [f64; N]) -> f64`, one of the two parts of H",
        ],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] } }",
        &["1:5 the impl lacks `fn potential(&self, q: [f64; N]) -> f64`, one of the two parts of H"],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] } fn potental(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "1:5 the impl lacks `fn potential(&self, q: [f64; N]) -> f64`, one of the two parts of H\nhelp: similar names: `potental`",
        ],
    ),
    (
        "impl System { fn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["1:5 the impl lacks `fn kinetic(&self, p: [f64; N]) -> f64`, one of the two parts of H"],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 2]) -> f64 { p[0] }\nfn potential(&self, q: [f64; 3]) -> f64 { q[0] } }",
        &["3:13 positions and momenta have different types: q is `[f64; 3]` here, but p is `[f64; 2]` in `kinetic`"],
    ),
    (
        "impl System {\nfn kinetic(&self, p: f64) -> f64 { p }\nfn potential(&self, q: f64) -> f64 { q } }",
        &[
            "2:21 a single coordinate has to be an array\nhelp: write `[f64; 1]`, and `[0]` for the number",
            "3:23 a single coordinate has to be an array\nhelp: write `[f64; 1]`, and `[0]` for the number",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f32; 1]) -> f64 { p[0] }\nfn potential(&self, q: [[u8; 2]; 1]) -> f64 { 0.0 } }",
        &[
            "2:22 coordinates have to be written in `f64`\nnote: a run is in single precision if its initial state is in `f32`",
            "3:25 this type of coordinates is not supported\nhelp: write `[f64; N]`, `[[f64; D]; N]`, `[[[f64; L]; M]; N]`, a reference to one of them, or a slice `&[f64]`, `&[[f64; D]]` or `&[[[f64; L]; M]]`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1]) { p[0] }\nfn potential(&self, q: [f64; 1]) -> f32 { q[0] } }",
        &[
            "2:3 `kinetic` has to return an energy\nhelp: write `-> f64`",
            "3:36 `potential` has to return an energy of type `f64`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&mut self, p: [f64; 1]) -> f64 { p[0] }\nfn potential(self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:11 `kinetic` has to take `&self`", "3:13 `potential` has to take `&self`"],
    ),
    (
        "impl System {\nasync fn kinetic<T>(&self, p: [f64; 1]) -> f64 { p[0] }\nunsafe fn potential<'q, const N: usize>(&self, q: &'q [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:0 `kinetic` may not be `async`\nnote: the macro calls it, to compare its values with those of the generated code",
            "2:17 `kinetic` may not be generic\nhelp: move the parameter to the impl\nnote: the macro calls it, to compare its values with those of the generated code",
            "3:0 `potential` may not be `unsafe`\nnote: the macro calls it, to compare its values with those of the generated code",
            "3:24 `potential` may not be generic\nhelp: move the parameter to the impl\nnote: the macro calls it, to compare its values with those of the generated code",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self) -> f64 { 0.0 }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:3 `kinetic` has no coordinates\nhelp: write `fn kinetic(&self, p: [f64; N]) -> f64`"],
    ),
    (
        "impl System {\nfn kinetic(&self, a: [f64; 1], b: [f64; 1], c: [f64; 1]) -> f64 { 0.0 }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:11 `kinetic` has to take `&self`, `p` and optionally the time, `t: f64`"],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1]) -> f64 { q[0] }\nfn potential(&self, p: [f64; 1]) -> f64 { p[0] } }",
        &[
            "2:18 `kinetic` is a function of the momenta, and its argument is named `q`\nhelp: name it `p`",
            "3:20 `potential` is a function of the positions, and its argument is named `p`\nhelp: name it `q`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1], q: [f64; 1]) -> f64 { p[0] }\nfn potential(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] + p[0] } }",
        &[
            "2:31 `kinetic` takes only `p` as coordinates, since H = T(p) + V(q)\nhelp: remove this argument",
            "3:62 V(q) may not depend on the momentum `p`\nhelp: move the terms in `p` to `kinetic`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:67 T(p) may not depend on the position `q`\nhelp: move the terms in `q` to `potential`"],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {\n0.5 * p[0] * p[0] + q[0] * p[1] - q[1].cos() }}",
        &[
            "3:20 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {\n(q[0] + p[0]).powi(2) + (q[0] - p[0]).sin() + 1.0 / (q[0] + p[0]) }}",
        &[
            "3:0 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
            "3:24 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
            "3:46 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { if q[0] > p[0] { p[0] } else { 2.0 * p[0] } } }",
        &[
            "2:3 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, p: [f64; 1], q: [f64; 1]) -> f64 { p[0] + q[0] } }",
        &["2:15 positions have to come before momenta\nhelp: write `fn hamiltonian(&self, q, p)`"],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:15 `hamiltonian` has to take the positions, the momenta and optionally the time\nhelp: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 2]) -> f64 { q[0] + p[0] } }",
        &["2:38 positions and momenta have different types: q is `[f64; 1]`, but p is `[f64; 2]` here"],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1], p: [f64; 1]) -> f64 {\np[0] / q[0] + p[0].powf(q[0]) + p[0].mul_add(q[0], 1.0) }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "3:0 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
            "3:24 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
            "3:32 this term mixes q and p, so H is not separable into T(p) + V(q)\nhelp: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`\nhelp: or keep it in one piece for implicit methods, `split = none`\nhelp: or couple two copies of the state, `split = symmetric(omega = 20.0)`\nhelp: or change to coordinates in which T depends on p only",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, [a, b]: [f64; 3]) -> f64 { a + b }\nfn potential(&self, Point { x, y }: [f64; 3]) -> f64 { x + y } }",
        &[
            "2:18 2 names do not match the coordinates `[f64; 3]`",
            "3:20 this pattern is not supported\nnote: supported are names, `_`, `&x`, arrays `[x, y]` and tuples `(x, y)`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }\nfn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }\nfn rate(&self, q: [f64; 1], t: f64) -> f64 { 1.0 + t } }",
        &[
            "4:28 `rate` does not depend on time\nhelp: remove this argument\nnote: time transformation integrates the time along with the motion",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }\nfn potential(&self, q: [f64; 1]) -> f64 { self.rate(q[0]) }\nfn rate(&self, x: f64) -> f64 { x.cos() } }",
        &[],
    ),
];

/// Bodies of `potential`, beginning on line 2, with `q: [f64; 2]`, `t: f64` and two helper methods in reach.
pub(crate) const BODIES: &[Row] = &[
    ("q[0] + self.helper(q[1]) + Self::helper(self, t) + f64::sin(q[0])", &[]),
    (
        "q[0] + p[1]",
        &[
            "2:7 `p` is not known here\nhelp: move the terms with momenta to `kinetic`\nnote: V(q) is a function of the positions",
        ],
    ),
    (
        "{ let d = [q[0], q[1]]; let e = d - self.centre; (d * 2.0)[0] }",
        &[
            "2:32 Rust has no `-` for arrays, such as points\nhelp: write the components, `[d[0] - self.centre[0], d[1] - self.centre[1]]`",
            "2:50 Rust has no `*` for arrays, such as points\nhelp: write the components, `[d[0] * 2.0, d[1] * 2.0]`",
        ],
    ),
    ("q[0] + x", &["2:7 `x` is not known here"]),
    ("q[2]", &["2:2 index 2 is out of bounds for the coordinates `[f64; 2]`\nnote: the last index here is 1"]),
    ("q[0][1]", &["2:0 an `f64` cannot be indexed"]),
    ("q[0.5]", &["2:2 an index has to be an integer, and this is an `f64`"]),
    ("q[q[0]]", &["2:2 an index has to be an integer, and this is an `f64`"]),
    (
        "let mut v = 0.0; for i in 0..3 { v += q[i]; } v",
        &["2:40 index 2 is out of bounds for the coordinates `[f64; 2]`\nnote: the last index here is 1"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { v += q[i + 1]; } v",
        &["2:40 index 2 is out of bounds for the coordinates `[f64; 2]`\nnote: the last index here is 1"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if i != 0 { v += q[i + 1]; } } v",
        &["2:52 index 2 is out of bounds for the coordinates `[f64; 2]`\nnote: the last index here is 1"],
    ),
    ("q", &["2:0 `potential` has to return an energy, but ends in the whole array of coordinates"]),
    ("q[0];", &["2:0 `potential` has to return an energy, but ends in nothing"]),
    ("2", &["2:0 expected an `f64`, found the integer `2`\nhelp: write `2.0`"]),
    ("q + 1.0", &["2:0 expected an `f64`, found the whole array of coordinates"]),
    ("2 * q[0]", &["2:0 expected an `f64`, found the integer `2`\nhelp: write `2.0`"]),
    ("q[0] % 2.0", &[]),
    ("q[0] as f32", &["2:0 an `f64` cannot be cast here\nnote: energies are computed in `f64`"]),
    ("if q[0] > 0.0 { q[0] } else { 0.0 }", &[]),
    (
        "match q[0] { _ => q[0] }",
        &["2:0 `match` on coordinates is not supported\nhelp: write `if ... else if ... else`"],
    ),
    ("while q[0] > 0.0 {} q[0]", &["2:0 `while` loops are not supported\nhelp: write the sum as `for i in a..b`"]),
    ("loop { q[0]; }", &["2:0 `loop` is not supported\nhelp: write the sum as `for i in a..b`"]),
    ("(|x: f64| x)(q[0])", &[]),
    ("unsafe { q[0] }", &["2:0 `unsafe` code with coordinates is not supported\nhelp: write plain indices"]),
    ("let x = q[0] < 1.0; q[0]", &[]),
    (
        "!q[0]",
        &[
            "2:0 this expression with coordinates is not supported\nnote: supported are arithmetic, methods of `f64`, helper methods of this impl, `let`, `if` and `for i in a..b`",
        ],
    ),
    (
        "let d = std::array::from_fn(|k| q[k]); d[0]",
        &[
            "2:8 the length of this array is not known\nhelp: declare a variable with its type, `let d: [f64; 3] = std::array::from_fn(|k| ...);`",
        ],
    ),
    ("q[0].div_euclid(2.0)", &["2:5 no derivative of `div_euclid` is known\nhelp: similar names: `rem_euclid`"]),
    (
        "bessel(q[0])",
        &[
            "2:0 no derivative of `bessel` is known\nhelp: move the function into this impl and call `Self::bessel`, or call it in a method with a stated derivative, `#[derivative(slope)]`\nnote: the macro sees only the functions of this impl",
        ],
    ),
    (
        "self.unknown(q[0])",
        &[
            "2:5 no derivative of `unknown` is known\nhelp: move the function into this impl, or call it in a method with a stated derivative, `#[derivative(slope)]`\nnote: the macro sees only the functions of this impl",
        ],
    ),
    ("self.endless(q[0])", &["3:84 `endless` calls itself, and recursion is not supported\nhelp: write a loop"]),
    ("self.helper(q[0], q[1])", &["2:5 `helper` takes 1 argument, not 2"]),
    ("q[0].sin(1.0)", &["2:5 `sin` takes 0 arguments, not 1"]),
    (
        "q[0].powi(q[1])",
        &[
            "2:10 the exponent of `powi` has to be an integer that does not depend on coordinates\nhelp: write `powf` for other exponents",
        ],
    ),
    ("q[0].powi(-1_073_741_824)", &["2:10 this exponent is too large"]),
    ("(q[0] / 1000.0).powi(150) + ((q[0].powi(400) * q[1]).powi(600) * q[1]).powi(600)", &[]),
    ("q[0].powi(2_000_000_000)", &["2:10 this exponent is too large"]),
    ("q[0].powf(2)", &["2:10 expected an `f64`, found the integer `2`\nhelp: write `2.0`"]),
    ("let x; q[0]", &["2:0 a variable without a value is not supported\nhelp: write `let x = ...;`"]),
    (
        "let Some(x) = q[0] else { return 0.0 }; x",
        &[
            "2:0 `let ... else` on coordinates is not supported\nnote: it is supported on values of the system that do not depend on coordinates",
        ],
    ),
    ("let (a, b, c) = q; a", &["2:4 3 names do not match the coordinates `[f64; 2]`"]),
    ("let [a, b] = q[0]; a", &["2:4 an `f64` cannot be destructured into 2 parts"]),
    (
        "let x @ y = q[0]; x",
        &[
            "2:4 this pattern is not supported\nnote: supported are names, `_`, `&x`, arrays `[x, y]` and tuples `(x, y)`",
        ],
    ),
    ("let (a, b) = q[0].sin_cos(); a * b", &[]),
    ("let a = [q[0], q[1]]; a[2]", &["2:24 the index is out of bounds for this array of 2 elements"]),
    ("let a = [q[0], q[1]]; let mut v = 0.0; for i in 0..2 { v += a[i]; } v", &[]),
    ("let a = (q[0], q[1]); a.2", &["2:24 a tuple has no such field"]),
    ("q[0].x", &["2:5 an `f64` has no such field"]),
    ("fn inner() {} q[0]", &[]),
    ("struct Inner; q[0]", &["2:0 items inside the function are not supported\nhelp: move it out of the impl"]),
    (
        "println!(\"{}\", q[0]); q[0]",
        &[
            "2:0 `println!` is not supported\nhelp: write the formula without a macro\nnote: assertions are the only macros that H may call",
        ],
    ),
    ("assert!(q[0] > 0.0); q[0]", &[]),
    ("q[0] = 1.0; q[0]", &["2:0 the coordinates `q` cannot be assigned to"]),
    (
        "let mut v = [0.0; N]; v[0] = 1.0; for n in 1..N { v[n] = q[0] * v[n - 1]; } v[N - 1]",
        &[
            "2:22 the length `N` of this array is not known\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl",
        ],
    ),
    (
        "let mut v = q[0]; for i in 0..N { v = v * v; } v",
        &[
            "2:34 a loop may only add to `v`, which is declared outside of it\nhelp: write `v += ...` or `v -= ...`\nnote: loops with literal bounds, as in `for k in 0..4`, support any assignment for up to 16 iterations\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl, where the value of `N` is not declared",
        ],
    ),
    (
        "let mut v = q[0]; for i in 0..N - 1 { v = v * q[i].sin(); v = v + 1.0; } v",
        &[
            "2:38 a loop may only add to `v`, which is declared outside of it\nhelp: write `v += ...` or `v -= ...`\nnote: loops with literal bounds, as in `for k in 0..4`, support any assignment for up to 16 iterations\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl, where the value of `N` is not declared",
        ],
    ),
    (
        "let s = [q[0], q[1]]; let mut v = 0.0; for i in 0..N { v += s[i]; } v",
        &[
            "2:62 this array of values does not support this index\nhelp: index it by literals, or in a loop of at most 16 iterations\nnote: an array filled by a loop, `for k in 0..32 { h[k] = ...; }`, supports any index\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl, where the value of `N` is not declared",
        ],
    ),
    (
        "let mut h = [1.0; 3]; for k in 1..N { h[k] = h[k - 1] * q[0]; } h[1]",
        &[
            "2:40 this assignment to an element of an array is not supported\nhelp: assign at literal indices, in a loop of a few iterations, or at the index of the loop, `for k in 0..32 { h[k] = ...; }`\nnote: the loop over the elements may contain other loops\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl, where the value of `N` is not declared",
        ],
    ),
    (
        "(0..N).fold(1.0, |v, i| v * v + q[i])",
        &[
            "2:7 this `fold` is not supported over more than 16 items, or over a number that is not known here\nhelp: use literal bounds, as in `(0..4).rev().fold(0.0, |sum, k| sum * x + self.c[k])`, or write a sum\nnote: sums, products, maxima, minima and polynomials `sum * x + c` with one `x` are supported over any number of items\nhelp: declare `const N: usize = 6;` in this function, or in this impl and write `Self::N`\nnote: the macro sees only this impl, where the value of `N` is not declared",
        ],
    ),
    ("const N: usize = 3; let mut v = [0.0; N]; v[0] = 1.0; for n in 1..N { v[n] = q[0] * v[n - 1]; } v[N - 1]", &[]),
    // What other languages write.
    (
        "let mut v = 0; for i in 0..2 { v += q[i]; } v",
        &["2:12 expected an `f64`, found the integer `0`\nhelp: write `0.0`"],
    ),
    ("let mut v = 0; v += q[0]; v", &["2:12 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    ("let mut v = 0; v = v + q[0]; v", &["2:12 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    ("let mut v: f64 = 0; v += q[0]; v", &["2:17 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    (
        "let k = 2; k * q[0]",
        &["2:11 expected an `f64`, found the integer `k`\nhelp: write `k as f64`, or `2.0` where it is declared"],
    ),
    ("let k = 2; q[k - 1]", &[]),
    (
        "let mut v = [0; 2]; for i in 0..2 { v[i] += q[i]; } v[0]",
        &["2:13 expected an `f64`, found the integer `0`\nhelp: write `0.0`"],
    ),
    ("let mut v = [0, 0]; v[0] += q[1]; v[0]", &["2:13 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    (
        "let (mut v, mut w) = (0, 0); v += q[1]; w += q[0]; v + w",
        &[
            "2:22 expected an `f64`, found the integer `0`\nhelp: write `0.0`",
            "2:25 expected an `f64`, found the integer `0`\nhelp: write `0.0`",
        ],
    ),
    ("q.iter().fold(0, |v, x| v + x)", &["2:14 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    ("if q[0] > 0 { q[0] } else { 0 }", &["2:10 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    (
        "let x = if q[0] > 0.0 { q[0] } else { 0 }; x",
        &["2:38 expected an `f64`, found the integer `0`\nhelp: write `0.0`"],
    ),
    ("q[0].max(0)", &["2:9 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    (
        "let mut v = 0; if q[0] > 0.0 { v = q[0]; } v",
        &["2:12 expected an `f64`, found the integer `0`\nhelp: write `0.0`"],
    ),
    (
        "let mut v = 0; for i in 0..2 { if q[i] > 0.0 { v += q[i]; } } v",
        &["2:12 expected an `f64`, found the integer `0`\nhelp: write `0.0`"],
    ),
    (
        "let mut v = 0; for i in 0..self.n { v += 1; } v as f64 * q[0]",
        &["2:41 expected an `f64`, found the integer `1`\nhelp: write `1.0`"],
    ),
    ("q(0)", &["2:0 `q` is the whole array of coordinates, not a function\nhelp: write `q[0]`"]),
    ("let x = q; x(0)", &["2:11 `x` is the whole array of coordinates, not a function\nhelp: write `x[0]`"]),
    ("let x = q[0]; x(1.0 + q[1])", &["2:14 `x` is an `f64`, not a function\nhelp: write `x * (1.0 + q[1])`"]),
    ("2.0(q[0] + 1.0)", &["2:0 this is an `f64`, not a function\nhelp: write `2.0 * (q[0] + 1.0)`"]),
    ("(q[0] + 1.0)(q[1])", &["2:0 this is an `f64`, not a function\nhelp: write `(q[0] + 1.0) * q[1]`"]),
    ("q[0](1)", &["2:0 this is an `f64`, not a function\nhelp: write `q[0] * 1.0`"]),
    ("q.0 + 1.0", &["2:2 the whole array of coordinates has no such field\nhelp: write `q[0]`"]),
    ("q[0].powi(2.0)", &["2:10 the exponent of `powi` has to be an integer\nhelp: write `powi(2)` or `powf(2.0)`"]),
    ("q[0].powi(1.5)", &["2:10 the exponent of `powi` has to be an integer\nhelp: write `powf(1.5)`"]),
    ("q[0].powi(-2.0)", &["2:10 the exponent of `powi` has to be an integer\nhelp: write `powi(-2)` or `powf(-2.0)`"]),
    ("let n = 2.0; q[0].powi(n)", &["2:23 the exponent of `powi` has to be an integer\nhelp: write `powf(n)`"]),
    ("q[0]**2", &["2:0 `**` is no operator in Rust\nhelp: write `q[0].powi(2)`"]),
    ("q[0] ** 2.0", &["2:0 `**` is no operator in Rust\nhelp: write `q[0].powi(2)`"]),
    ("(q[0] + q[1])**2", &["2:0 `**` is no operator in Rust\nhelp: write `(q[0] + q[1]).powi(2)`"]),
    ("3.0 * q[0]**2 + 1.0", &["2:6 `**` is no operator in Rust\nhelp: write `q[0].powi(2)`"]),
    ("q[0]**1.5", &["2:0 `**` is no operator in Rust\nhelp: write `q[0].powf(1.5)`"]),
    ("q[0]**-2", &["2:0 `**` is no operator in Rust\nhelp: write `q[0].powi(-2)`"]),
    ("q[0] ^ 2", &["2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `q[0].powi(2)`"]),
    (
        "q[0]^2 + q[1]^2",
        &[
            "2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `q[0].powi(2)`",
            "2:9 `^` is the bitwise exclusive or in Rust\nhelp: write `q[1].powi(2)`",
        ],
    ),
    ("q[0] ^ 2.0", &["2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `q[0].powi(2)`"]),
    ("(q[0] + q[1]) ^ 2", &["2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `(q[0] + q[1]).powi(2)`"]),
    ("q[0] ^ self.n", &["2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `q[0].powf(self.n)`"]),
    ("0.5 * q[0] ^ 2", &["2:6 `^` is the bitwise exclusive or in Rust\nhelp: write `q[0].powi(2)`"]),
    ("self.k ^ 2 * q[0]", &["2:0 `^` is the bitwise exclusive or in Rust\nhelp: write `self.k.powi(2)`"]),
    ("self.mass ** 2 * q[0]", &["2:0 `**` is no operator in Rust\nhelp: write `self.mass.powi(2)`"]),
    ("q(0) + q[1]", &["2:0 `q` is the whole array of coordinates, not a function\nhelp: write `q[0]`"]),
    ("let mut v = [0; 2]; v[1] -= q[1]; v[1]", &["2:13 expected an `f64`, found the integer `0`\nhelp: write `0.0`"]),
    (
        "let mut v = -1; for i in 0..2 { v += q[i]; } v",
        &["2:13 expected an `f64`, found the integer `1`\nhelp: write `1.0`"],
    ),
    ("let x = &q[0]; q[1] * *x", &[]),
    (
        "(q[0] > 0.0) ^ (q[1] > 0.0); q[0]",
        &[
            "2:0 this expression with coordinates is not supported\nnote: supported are arithmetic, methods of `f64`, helper methods of this impl, `let`, `if` and `for i in a..b`",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { v += q[i | 1]; } v",
        &[
            "2:40 this use of `|` on an integer that depends on a loop is not supported\nhelp: use `+`, `-`, `*`, `/` and `%`\nnote: `<< n`, `>> n`, `& (2^n - 1)` and `^ 1` are supported if the right side is a literal and the integer is never negative",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { for j in 0..2 { v += (i ^ j) as f64 * q[i]; } } v",
        &[
            "2:55 this use of `^` on an integer that depends on a loop is not supported\nhelp: use `+`, `-`, `*`, `/` and `%`\nnote: `<< n`, `>> n`, `& (2^n - 1)` and `^ 1` are supported if the right side is a literal and the integer is never negative",
        ],
    ),
    ("let v = 2; (v + 1) * q[0]", &["2:11 expected an `f64`, found an integer\nhelp: write `(v as f64 + 1.0)`"]),
    ("for i in 0..2 { q[i] * i; } q[0]", &["2:23 expected an `f64`, found an integer\nhelp: write `i as f64`"]),
    ("sqrt(q[0])", &["2:0 Rust has no function `sqrt`\nhelp: write `q[0].sqrt()`"]),
    ("exp(-q[0] * q[0])", &["2:0 Rust has no function `exp`\nhelp: write `(-q[0] * q[0]).exp()`"]),
    ("abs(q[0] - q[1])", &["2:0 Rust has no function `abs`\nhelp: write `(q[0] - q[1]).abs()`"]),
    ("max(q[0], q[1])", &["2:0 Rust has no function `max`\nhelp: write `q[0].max(q[1])`"]),
    ("pow(q[0], 2)", &["2:0 Rust has no function `pow`\nhelp: write `q[0].powi(2)`"]),
    ("pow(q[0], 1.5)", &["2:0 Rust has no function `pow`\nhelp: write `q[0].powf(1.5)`"]),
    ("log(q[0] + 2.0)", &["2:0 Rust has no function `log`\nhelp: write `(q[0] + 2.0).ln()`"]),
    ("q[0].log()", &["2:5 `log` takes the base as an argument\nhelp: write `ln` for the natural logarithm"]),
    ("sum(q)", &["2:0 Rust has no function `sum`\nhelp: write `q.iter().sum::<f64>()`"]),
    ("dot(q, q)", &["2:0 Rust has no function `dot`\nhelp: write `q.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>()`"]),
    (
        "q.norm()",
        &["2:2 numbers and arrays have no method `norm`\nhelp: write `q.iter().map(|x| x * x).sum::<f64>().sqrt()`"],
    ),
    (
        "q.dot(&q)",
        &[
            "2:2 numbers and arrays have no method `dot`\nhelp: write `q.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>()`",
        ],
    ),
    ("q[0].norm()", &["2:5 numbers and arrays have no method `norm`\nhelp: write `q[0].abs()`"]),
    ("q[0].square()", &["2:5 numbers and arrays have no method `square`\nhelp: write `q[0].powi(2)`"]),
    ("q[0].pow(-2)", &["2:5 numbers and arrays have no method `pow`\nhelp: write `q[0].powi(-2)`"]),
    ("arctan2(q[0], q[1])", &["2:0 Rust has no function `arctan2`\nhelp: write `q[0].atan2(q[1])`"]),
    ("np::sin(q[0])", &["2:0 Rust has no function `np::sin`\nhelp: write `q[0].sin()`"]),
    ("Math::pow(q[0], 2)", &["2:0 Rust has no function `Math::pow`\nhelp: write `q[0].powi(2)`"]),
    ("2.0 * pi * q[0]", &["2:6 `pi` is not known here\nhelp: write `std::f64::consts::PI`"]),
    ("1 / 2 * q[0]", &["2:0 expected an `f64`, found an integer\nhelp: write `1.0 / 2.0`"]),
    ("q[0] * (1 / 2)", &["2:7 expected an `f64`, found an integer\nhelp: write `(1.0 / 2.0)`"]),
    (
        "let mut v = 0.0; for i in 0..2 { v += (i - 1) / 2 * q[i]; } v",
        &["2:38 expected an `f64`, found an integer\nhelp: write `(i as f64 - 1.0) / 2.0`"],
    ),
    ("q[0] * self.n[0] as f64 * -(2 + 1)", &["2:26 expected an `f64`, found an integer\nhelp: write `-(2.0 + 1.0)`"]),
    ("sqrt(2.0) * q[0]", &[]),
    ("y += q[0]; q[0]", &["2:0 `y` is not known here"]),
    ("let mut v = 1.0; for i in 0..2 { v *= q[i]; } v", &[]),
    (
        "let mut v = 0.0; for i in 0..self.count { v += v * v * q[i]; } v",
        &[
            "2:47 `v` is read in the loop that sums it\nhelp: read it after the loop",
            "2:51 `v` is read in the loop that sums it\nhelp: read it after the loop",
        ],
    ),
    ("for i in 0..2 { q[i]; }", &["2:0 `potential` has to return an energy, but ends in nothing"]),
    (
        "let mut v = 0.0; for i in 0.. { v += q[i]; } v",
        &["2:26 the range of a loop requires both bounds\nhelp: write `a..b` or `a..=b`"],
    ),
    ("let mut v = 0.0; for i in q { v += i; } v", &[]),
    (
        "let mut v = 0.0; for i in 0..q[0] { v += t; } v",
        &[
            "2:29 the bounds of a loop have to be integers, and this one is an `f64`\nhelp: loop over integers, and write `i as f64` for the number",
        ],
    ),
    ("let mut v = 0.0; for (i, j) in 0..2 { v += q[0]; } v", &["2:21 an integer cannot be destructured into 2 parts"]),
    ("let mut v = 0.0; for i in 0..2 { for j in 0..self.bonds[i] { v += q[j]; } } v", &[]),
    ("\"text\"", &[]),
    ("q[0] + 1e400", &[]),
    ("q[99999999999999999999999999]", &["2:2 number too large to fit in target type"]),
    (
        "for i in 0..2 { if q[i] > 1.0 { return 0.0; } } q[0]",
        &[
            "2:32 this `return` is not supported\nhelp: return in a branch of the function body, as in `if r > cutoff { return 0.0; }`\nnote: `return` inside a loop or an expression is not supported",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if q[i] > 1.0 { break; } v += q[i]; } v",
        &["2:49 `break` is not supported\nhelp: shorten the range of the loop, or wrap the added term in `if`"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if q[i] > 1.0 { if q[0] > 2.0 { continue; } v += q[i]; } v += 1.0; } v",
        &[
            "2:65 `continue` is not supported here\nhelp: wrap the skipped statements in an `if`\nnote: it may be the last statement of an `if` without `else`, directly in the body of a loop",
        ],
    ),
    (
        "let mut v = 0.0; 'a: for i in 0..2 { for j in 0..2 { if i == j { continue 'a; } v += q[j]; } } v",
        &[
            "2:65 `continue` is not supported here\nhelp: wrap the skipped statements in an `if`\nnote: it may be the last statement of an `if` without `else`, directly in the body of a loop",
        ],
    ),
    (
        "Some(1.0)? * q[0]",
        &[
            "2:9 `?` is not supported\nhelp: return an energy in every case\nnote: the force of an early exit is not defined",
        ],
    ),
    (
        "q[0] * match self.kind { 0 => return 0.0, _ => 1.0 }",
        &[
            "2:30 this `return` is not supported\nhelp: return in a branch of the function body, as in `if r > cutoff { return 0.0; }`\nnote: `return` inside a loop or an expression is not supported",
        ],
    ),
    (
        "let mut v = 0.0; let w = &mut v; *w += q[0]; v",
        &["2:25 `&mut` is not supported\nhelp: assign to the variable itself"],
    ),
    ("let k = loop { break 2.0; }; k * q[0]", &[]),
    (
        "let mut list = self.list.clone(); list.reverse(); list[0] * q[0]",
        &[
            "2:39 `reverse` may modify `list`, which is not supported\nhelp: compute the value in one expression, or in a method of this impl that takes no coordinates\nnote: the macro follows only assignments",
        ],
    ),
    (
        "let mut list = self.list.iter(); list.next().unwrap() * q[0]",
        &[
            "2:38 `next` may modify `list`, which is not supported\nhelp: compute the value in one expression, or in a method of this impl that takes no coordinates\nnote: the macro follows only assignments",
        ],
    ),
    (
        "let mut list = self.list.clone(); list[0] = 2.0; list[0] * q[0]",
        &[
            "2:34 assigning to an element of a list of the system is not supported\nhelp: write the list as one expression, or as a method of this impl that takes no coordinates",
        ],
    ),
    ("let mut k = self.mass; k = k.sqrt(); k += 1.0; k * q[0]", &[]),
    ("let square = |x: f64| x * x; square(q[0])", &[]),
    ("let double = |x: f64| 2.0 * x; double(self.mass) * q[0]", &[]),
    ("if matches!(self.kind, 1 | 2) { q[0] } else { 0.0 }", &[]),
    (
        "if let Some(x) = Some(q[0]) { x } else { 0.0 }",
        &[
            "2:3 `if let` on coordinates is not supported\nhelp: compare numbers, as in `if r < cutoff`\nnote: `if let` is supported on values of the system that do not depend on coordinates",
        ],
    ),
    (
        "q.iter().scan(0.0, |s, x| Some(x)).sum::<f64>()",
        &[
            "2:9 `scan` of a sequence is not supported\nnote: the supported adaptors are iter, map, filter, enumerate, zip, rev, skip, take, step_by, windows, array_windows and chunks_exact, followed by `sum` or `fold`",
        ],
    ),
    (
        "q.array_windows().map(|w| w[0] * w[1]).sum::<f64>()",
        &[
            "2:2 the length of these windows is not known\nhelp: write `array_windows::<2>()`, or a pattern where the window is used, as in `.map(|[a, b]| ..)`",
        ],
    ),
    ("self.list.iter().copied().reduce(f64::max).unwrap() * q[0]", &[]),
    ("let part = &q[1..]; part[0]", &[]),
    ("fn inner(x: f64) -> f64 { x } inner(q[0])", &[]),
    ("use std::f64::consts::PI; PI * q[0]", &[]),
    (
        "q[0].next_up() +\nq[2] +\nx",
        &[
            "2:5 no derivative of `next_up` is known",
            "3:2 index 2 is out of bounds for the coordinates `[f64; 2]`\nnote: the last index here is 1",
            "4:0 `x` is not known here",
        ],
    ),
];

/// The annotation, ` on `, and the functions of the impl, which begin on line 2.
pub(crate) const SPLITS: &[Row] = &[
    (
        "split = none, order = 2 on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:22 `order` claims the order of a composition, and `split = none` leaves H in one piece\nhelp: leave out `order`",
        ],
    ),
    (
        "split = quadratic + rest on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(4) }",
        &[
            "1:8 `split = quadratic + rest` requires H in one function\nhelp: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64` in place of `kinetic` and `potential`",
        ],
    ),
    (
        "split = a + b on fn a(&self, _q: [f64; 1]) -> f64 { _q[0].cos() } fn b(&self, _p: [f64; 1]) -> f64 { _p[0] * _p[0] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, _q: [f64; 2], [x, y]: [f64; 2]) -> f64 { x * x + y } fn b(&self, q: [f64; 2]) -> f64 { q[0] * q[1] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn b(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[
            "2:98 `potential` is not used\nhelp: remove it, or rename it\nnote: H is the sum of `a` and `b`, which do not call it",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn b(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.a(q) + self.b(p) }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = b + a on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * q[0] * p[0] } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 3",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * p[0] * t.cos() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: move the terms that depend on time to a part of q only, or of p only\nnote: it is not a shear, since it depends on q[0] and p[0]; it is a quadratic form in q and p with coefficients that depend on time",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 9], p: [f64; 9]) -> f64 { let s: f64 = (0..9).map(|i| q[i] + p[i]).sum(); s * s } fn b(&self, q: [f64; 9]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - self.e * q[0] * q[1]).powi(2) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (self.e * (q[0] + q[1]).sin() - p[0]).powi(4) / self.m + 3.0 * q[1] * (p[0] - self.e * (q[1] + q[0]).sin()) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1] - q[0].tanh()).powi(2) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:69 no exact flow is known for `a`\nhelp: use a gauge in which p[0] is added to a polynomial in q[0], or to a sine, cosine or exponential of a linear function of q[0], or keep H in one piece, `split = none`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it depends on p[0] by p[0] - a(q), but no antiderivative of this term with respect to q[0] is known",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * p[1]).powi(2) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 4",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 4], p: [f64; 4]) -> f64 { let mut sum = 0.0; for i in 0..4 { for j in 0..i { sum += (p[j] - self.m[i] * q[j].powi(2)).powi(2); } } sum } fn b(&self, q: [f64; 4]) -> f64 { q[0].cos() }",
        &[
            "2:105 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[i] and p[i]; it is not a quadratic form in q and p, but a polynomial of degree 4",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 4], p: [f64; 4]) -> f64 { let mut sum = 0.0; for i in 0..4 { for j in 0..4 { sum += self.m[i] * (p[j] - q[j].powi(2)).powi(4); } } sum } fn b(&self, q: [f64; 4]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 4], p: [f64; 4]) -> f64 { (p[0] - q[0] * q[1]).powi(2) + (p[2] - q[2] * q[3]).powi(2) } fn b(&self, q: [f64; 4]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1]).powi(2) + (p[1] - q[0] * q[1]).powi(2) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: write one part for each kinetic momentum\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 4; it depends on p[1] by p[1] - a(q), but the canonical shift that removes a(q) also moves p[0]",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1]).powi(2) + q[0].powi(4) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 4; a canonical shift that removes a(q) from a kinetic momentum leaves q[0] and p[0]",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1]).powi(2) + p[0] * q[1] } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:47 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 4; a canonical shift that removes a(q) from a kinetic momentum leaves q[0] and p[0]",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (0..2).map(|i| (p[i] - q[i].powi(2)).powi(2)).sum::<f64>() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 { (0..q.len()).map(|i| (p[i][0] - q[i][0] * q[i][1]).powi(2) * self.m[i]).sum::<f64>() } fn b(&self, p: &[[f64; 2]]) -> f64 { p[0][1] * p[0][1] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { (1..q.len()).map(|i| (p[i] - q[i] * q[i - 1]).powi(2) * self.m[i]).sum::<f64>() } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:72 no exact flow is known for `a`\nhelp: use a gauge in which p[i] is added to a polynomial in q[i], or to a sine, cosine or exponential of a linear function of q[i], or keep H in one piece, `split = none`\nnote: it is not a shear, since it depends on q[i] and p[i]; it is not a quadratic form in q and p, but a polynomial of degree 4; it depends on p[i] by p[i] - a(q), but no antiderivative of this term with respect to q[i] is known",
        ],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + py * py + x * py - y * px + x * x * y }",
        &[],
    ),
    (
        "split = rest + quadratic on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + py * py + x * py - y * px + x * x * y }",
        &[],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + py * py + x * py - y * px }",
        &[
            "1:20 `rest` is empty, since every term of `hamiltonian` is a quadratic form in q and p\nnote: the flow of H is known exactly, without a composition",
        ],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, q: [f64; 9], p: [f64; 9]) -> f64 { let (mut sum, mut all) = (0.0, 0.0); for i in 0..9 { sum += p[i] * p[i] + q[i] * q[i]; all += q[i]; } sum + all * all }",
        &[],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, q: [f64; 9], p: [f64; 9]) -> f64 { let (mut sum, mut all) = (0.0, 0.0); for i in 0..9 { sum += p[i] * p[i] + q[i].cosh(); all += q[i]; } for i in 0..9 { sum += 0.5 * (q[i] - all / 9.0).powi(2); } sum }",
        &[],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, q: [f64; 9], p: [f64; 9]) -> f64 { let (mut sum, mut all) = (0.0, 0.0); for i in 0..9 { sum += p[i] * p[i] + q[i] * q[i] + q[i].cosh(); all += p[i]; } sum + all * all }",
        &[],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px.cosh() + py.cosh() - x.cos() * y.cos() }",
        &[
            "1:8 `quadratic` is empty, since no term of `hamiltonian` is a quadratic form in q and p\nhelp: write one function for each part",
        ],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + py * py + x * x + x * x * px }",
        &[
            "1:20 no exact flow is known for `rest`\nhelp: split it into more parts, or write its flow by hand, `#[flow(rest)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 3",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px.powi(2) / (2.0 * self.m) + py.powi(2) / (2.0 * self.m) - self.k * (x * x + y.powi(2)).powf(-0.5) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { let r = x.hypot(y); (px * px + py * py) * self.inverse_mass / 2.0 + 3.0 - self.k * r.recip() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: &[[f64; 2]], p: &[[f64; 2]]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { sum += self.kinetic_of(p[i], self.m[i]); } for i in 0..q.len() { sum -= self.g * self.m[i] / self.length(q[i]); } sum } fn kinetic_of(&self, p: [f64; 2], m: f64) -> f64 { p.iter().map(|x| x * x).sum::<f64>() / (2.0 * m) } fn length(&self, q: [f64; 2]) -> f64 { q.iter().map(|x| x * x).sum::<f64>().sqrt() } fn b(&self, q: &[[f64; 2]]) -> f64 { q[0][0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, p: [[f64; 3]; 2]) -> f64 { p[0][0] * p[0][0] + p[1][0] * p[1][0] } fn b(&self, q: [[f64; 3]; 2]) -> f64 { let d = q[1] - q[0]; d[0].cos() }",
        &[
            "2:126 Rust has no `-` for arrays, such as points\nhelp: write the components, `[q[1][0] - q[0][0], q[1][1] - q[0][1], q[1][2] - q[0][2]]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [[f64; 3]; 2], p: [[f64; 3]; 2]) -> f64 { let mut sum = 0.0; for d in 0..3 { sum += p[0][d] * p[0][d] + 2.0 * p[1][d] * p[1][d]; } sum - 1.0 / q[0][0].hypot(q[0][1]).hypot(q[0][2]) } fn b(&self, q: [[f64; 3]; 2]) -> f64 { q[0][0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() - x.powi(4) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:118 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y + 0.01).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + (y * y + self.soft)).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() + self.offset } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + 2.0 * y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since p² or |q| of a body lacks some of its components",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px / (2.0 * self.m) + 0.5 * py * py / self.m - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px / self.m / 2.0 + 0.5 / self.m * py * py - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { self.a * px.powi(2) / 3.0 * self.b + self.b * py.powi(2) * (self.a / 3.0) - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * px * px / (self.m * self.n) + py * py / (self.n * 2.0 * self.m) - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * px * px / self.m.sqrt() + 0.5 * py * py / self.m - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * px * px * self.a + 0.5 * py * py * (self.a + self.b) - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + 0.5 * py * py - 1.0 / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 { p[0][0].powi(2) + p[0][1].powi(2) - 1.0 / q[1][0].hypot(q[1][1]) - 1.0 / q[0][0].hypot(q[0][1]) } fn b(&self, q: [[f64; 2]; 2]) -> f64 { q[0][0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0][0] and p[0][0]; it is not a quadratic form in q and p; it is not a sum of p²/2m - k/|q| over bodies, since a body with k/|q| has no p²/2m",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { sum += 0.5 * (p[i] * p[i] + q[i] * q[i]); sum -= self.quartic(q[i]); } sum } fn quartic(&self, x: f64) -> f64 { 0.1 * x.powi(4) } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:133 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[i] and p[i]; it is not a quadratic form in q and p, but a polynomial of degree 4",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { let tail = self.tail(x); px * px + py * py - tail } fn tail(&self, x: f64) -> f64 { 0.5 * x * x + x.cosh() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:157 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { let mut sum = q[0].powi(4); sum += p[0].powi(4) + q[0] * p[0].cos(); sum } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:97 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0].powi(4) + q[0].powi(4) } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p, but a polynomial of degree 4",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { sum += self.list.iter().map(|x| x * i as f64).sum::<f64>() * (q[i] + p[i]); } 0.5 * q[0] * q[0] + sum * sum } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:182 no exact flow is known for `a`\nhelp: move this term to another part, or write the flow of `a` by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[i] and p[i]; it is a quadratic form in q and p that multiplies a sum over a loop by itself; write it as one sum in two loops, over i and j",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { for j in 0..i { sum += q[i] - p[j]; } } sum * sum } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[i] and p[i]; it is a quadratic form in q and p that multiplies a sum over a loop by itself; write it as one sum in two loops, over i and j",
        ],
    ),
    ("split = a + a on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }", &["1:12 the part `a` is named twice"]),
    (
        "split = field + flihgt on fn flight(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn field(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:16 the impl lacks `fn flihgt(&self, q: [f64; N], p: [f64; N]) -> f64`, which `split` names\nhelp: similar names: `flight`",
        ],
    ),
    (
        "split = a on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &["1:8 a splitting requires at least two parts\nhelp: write, for example, `split = kepler + interaction`"],
    ),
    (
        "split on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:0 this argument lacks its value\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "split = 3 on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:8 expected the names of functions for the parts of H\nhelp: write, for example, `split = kepler + interaction`\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`",
        ],
    ),
    (
        "split = a + (b + c) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = a + (b + c), compose = Yoshida4 on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = (a + b) + c on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:8 parts in parentheses have to be the second part of H\nhelp: write, for example, `split = kepler + (jump + interaction)`\nnote: a composition treats the second part as the small one",
        ],
    ),
    (
        "split = a + b + (c + b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:12 parts in parentheses have to be the second of two parts\nhelp: move this part into the parentheses, or remove them",
        ],
    ),
    (
        "split = a + (b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:12 parentheses require at least two parts\nhelp: remove the parentheses"],
    ),
    (
        "split = a + (b + c) + b on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:22 parts in parentheses have to be the last part of H\nhelp: move the parts that follow into the parentheses",
        ],
    ),
    (
        "split = a + (b + 3) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:17 expected names of parts of H in the parentheses\nhelp: write, for example, `split = kepler + (jump + interaction)`",
        ],
    ),
    (
        "split = a + (b + (c + b)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:22 the part `b` is named twice"],
    ),
    (
        "split = a + () on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:13 expected names of parts of H in the parentheses\nhelp: write, for example, `split = kepler + (jump + interaction)`",
        ],
    ),
    (
        "split = a + (b + b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:17 the part `b` is named twice"],
    ),
    (
        "split = a + (b + d) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:17 the impl lacks `fn d(&self, q: [f64; N], p: [f64; N]) -> f64`, which `split` names\nhelp: similar names: `a`, `b`, `c`",
        ],
    ),
    (
        "split = a + (b + c), compose = T(1/2) V(1) T(1/2) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = a + (b + c), compose = V(1/2) T(1) V(1/2) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:31 this sequence begins and ends with a kick, which a pair of parts in parentheses does not support\nhelp: begin with a drift\nnote: two kicks in a row do not merge into one if the kicked part is a pair of parts",
        ],
    ),
    (
        "split = a + (b + c), compose = symmetric(T((14 - sqrt(19))/108) V(2/5) T((20 - 7*sqrt(19))/108) V(-1/10) T(_) V(_)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:31 this sequence does not have order 4 with a pair of parts in parentheses\nhelp: use a composition such as `Abah1064`, `Verlet` or `Yoshida4`\nnote: such a pair has an error in the third power of each kick, and these errors do not cancel here",
        ],
    ),
    (
        "split = a + (b + c), compose = symmetric(1/(2 - cbrt(2)), _; Verlet) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = a + (b + c), compose = symmetric(V(1/6) T(1/2) V(2/3, -1/72) T(_) V(_)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:62 a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), without a pair of parts in parentheses\nhelp: use a composition such as `Abah1064`, `Verlet` or `Yoshida4`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2], t: f64) -> f64 { 0.5 * (px * px + py * py) - t.cos() / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:95 no exact flow is known for `a`\nhelp: move the terms that depend on time to a part of q only, or of p only\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2], t: f64) -> f64 { q[0] * t.cos() }",
        &[],
    ),
    (
        "split = a + b + c on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[0] } fn b(&self, q: [f64; 2], t: f64) -> f64 { t.sin() * q[0].sin() } fn c(&self, p: [f64; 2]) -> f64 { p[0] * p[0] }",
        &[],
    ),
    (
        "split = a + 3 on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:12 expected the names of functions for the parts of H\nhelp: write, for example, `split = kepler + interaction`",
        ],
    ),
    (
        "split = a + b on fn a(&self, x: [f64; 1]) -> f64 { x[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:12 this argument of `a` may be the positions or the momenta\nhelp: name it `q` or `p`, or write `fn a(&self, q: [f64; N], p: [f64; N]) -> f64`",
        ],
    ),
    (
        "split = a + b on fn a(&self, p: [f64; 1]) -> f64 { 2.0 } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &["2:3 the part `a` depends on neither q nor p\nhelp: leave it out"],
    ),
    (
        "split = a + b on fn a(&self, p: [f64; 2]) -> f64 { p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:46 the coordinates are `[f64; 2]` in the first part, but `[f64; 1]` here\nhelp: write the same type in all parts",
        ],
    ),
    (
        "split = a + b + c on fn a(&self, p: [f64; 1], t: f64) -> f64 { t * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn c(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b, taylor on fn a(&self, q: [f64; 1]) -> f64 { q[0].sin() } fn b(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[],
    ),
    (
        "split = a + b, taylor on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(c)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "3:7 `c` is not a part of H\nnote: `split` names `a`, `b`",
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "3:0 `#[flow]` lacks the name of a part of H\nhelp: write, for example, `#[flow(kepler)]`",
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "3:11 a flow has to take positions and momenta by `&mut`, and a duration\nhelp: write `fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64)`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(b)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "2:3 no exact flow is known for `a`\nhelp: split it into more parts, or write its flow by hand, `#[flow(a)]`\nnote: it is not a shear, since it depends on q[0] and p[0]; it is not a quadratic form in q and p",
        ],
    ),
    (
        "compose = Verlet on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &["3:7 `a` is not a part of H\nhelp: name the parts, `split = a + b`"],
    ),
    (
        "split = none, compose = GaussLegendre4 on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &[],
    ),
    (
        "split = none, compose = V(1/2) T(1) V(1/2) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &[
            "1:24 `split = none` does not support a sequence of stages\nhelp: name an implicit method, `compose = GaussLegendre4`\nnote: a sequence composes the flows of parts, and H is in one piece",
        ],
    ),
    (
        "split = none on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:8 `split = none` requires H in one function\nhelp: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`\nnote: implicit methods integrate `kinetic` and `potential` without `split = none`",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = none on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &["1:14 Jacobi coordinates do not support `split = none`\nhelp: write T and V as `kinetic` and `potential`"],
    ),
    ("split = none, taylor on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }", &[]),
    (
        "split = symmetric(omega = 2.0 * self.rate) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[],
    ),
    (
        "split = symmetric on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:8 `split = symmetric` lacks its coupling\nhelp: write, for example, `split = symmetric(omega = 20.0)`\nnote: omega is one to several times the largest angular frequency of the system",
        ],
    ),
    (
        "split = symmetric(rate = 3.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:18 `split = symmetric` lacks its coupling\nhelp: write, for example, `split = symmetric(omega = 20.0)`\nnote: omega is one to several times the largest angular frequency of the system",
        ],
    ),
    (
        "split = symmetric(omega = 3.0, 4.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &["1:29 the coupling has to be one number\nhelp: write, for example, `symmetric(omega = 20.0)`"],
    ),
    (
        "split = symmetric(omega = 0.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:26 the coupling `omega` has to be greater than zero\nnote: without it, the two copies of the state drift apart",
        ],
    ),
    (
        "split = symmetric(omega = q[0]) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &["1:26 `q` is not known here"],
    ),
    (
        "split = symmetric(omega = 3.0) on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[
            "1:26 `split = symmetric` requires H in one function\nhelp: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`\nnote: `kinetic` and `potential` already have exact flows, without copies of the state",
        ],
    ),
    (
        "split = symmetric(omega = 3.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * p[0] * t }",
        &[
            "2:3 `split = symmetric` does not support an H that depends on time\nhelp: make the time a coordinate with a conjugate momentum",
        ],
    ),
    (
        "split = symmetric(omega = 3.0), taylor on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[],
    ),
    (
        "split = a + b + c, compose = A(1/2) B(1) A(1/2) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0] }",
        &[],
    ),
    (
        "split = a + b + c, compose = processed(A(1/12) B(1/12) A(-1/12) B(-1/12); Verlet) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0] }",
        &[
            "1:29 a processor supports exactly two parts of H\nhelp: use a composition of general class without a processor, such as `Yoshida4`",
        ],
    ),
    (
        "split = a + b + c, compose = B(1/6) A(1/2) B(2/3, -1/72) A(1/2) B(1/6) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0] }",
        &[
            "1:50 a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), in two parts\nhelp: use a composition of general class without a processor, such as `Yoshida4`",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: &[f64]) -> f64 { p[0] * p[0] } fn potential(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "1:0 `gpu` does not support slices of coordinates\nhelp: write an array such as `[f64; 4]`\nnote: a device keeps the state in registers, so the number of coordinates has to be a literal",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 40]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 40]) -> f64 { q[0].cos() }",
        &[
            "1:0 the state has 80 numbers, and `gpu` supports at most 64\nnote: a device keeps the state of a member in registers",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; SIZE]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; SIZE]) -> f64 { q[0].cos() }",
        &[
            "1:0 `gpu` does not support a named constant as the number of coordinates\nhelp: write the number as a literal",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 8]) -> f64 { p.iter().map(|p| p * p).sum() } fn potential(&self, q: [f64; 8]) -> f64 { let mut v = 0.0; for i in 0..7 { v += (q[i + 1] - q[i]).powi(4); } v }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 8]; 3]) -> f64 { let mut t = 0.0; for i in 0..3 { for j in 0..8 { t += p[i][j] * p[i][j]; } } t } fn potential(&self, q: [[f64; 8]; 3]) -> f64 { let mut v = 0.0; for i in 0..3 { for j in 0..8 { v += (q[i][(j + 1) % 8] - q[i][j]).powi(4) + (q[(i + 1) % 3][j] - q[i][j]).powi(4); } } v }",
        &[
            "1:0 `gpu` supports lattices along a line, and this one is a plane\nhelp: leave out `gpu`\nnote: the sites of a plane are summed in an order that devices do not reproduce",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 3]; 4]) -> f64 { let mut t = 0.0; for i in 0..4 { for d in 0..3 { t += p[i][d] * p[i][d]; } } t } fn potential(&self, q: [[f64; 3]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { let mut r2 = 0.0; for d in 0..3 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= 1.0 / r2.sqrt(); } } v }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 2]; 9]) -> f64 { let mut t = 0.0; for i in 0..9 { for d in 0..2 { t += p[i][d] * p[i][d]; } } t } fn potential(&self, q: [[f64; 2]; 9]) -> f64 { let mut v = 0.0; for i in 0..9 { for j in 0..i { let mut r2 = 0.0; for d in 0..2 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= 1.0 / r2.sqrt(); } } v }",
        &[
            "1:0 `gpu` supports pair sums over at most 8 bodies, and this one has 9\nhelp: write out the pairs, or leave out `gpu`\nnote: more bodies are summed in an order that devices do not reproduce",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].tanh() }",
        &[
            "1:0 `gpu` has no kernel for `cosh`, which H or one of its derivatives calls\nhelp: use other functions, such as `exp` and `ln`, or the device's own, `gpu(functions = native)`\nnote: the device's own functions are not bitwise identical to those of the processor",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 2]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 2]) -> f64 { q[self.first] * q[1].sin() }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1], t: f64) -> f64 { if t < self.end { q[0] } else { q[0].cos() } }",
        &["1:0 `gpu` does not support formulas that change at certain times"],
    ),
    (
        "split = a + b, gpu on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] * q[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:15 `gpu` does not support `a`, a quadratic form whose flow is a matrix\nnote: devices integrate drifts, kicks, shears and canonical shifts",
        ],
    ),
    (
        "split = a + b, gpu on fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1]).powi(2) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b, gpu on fn a(&self, q: [f64; 3], p: [f64; 3]) -> f64 { let mut t = 0.0; let mut r2 = 0.0; for d in 0..3 { t += p[d] * p[d] / 2.0; r2 += q[d] * q[d]; } t - 1.0 / r2.sqrt() } fn b(&self, q: [f64; 3]) -> f64 { q[0].cos() }",
        &[
            "1:15 `gpu` does not support `a`, a Kepler motion whose flow solves Kepler's equation\nnote: devices integrate drifts, kicks, shears and canonical shifts",
        ],
    ),
    (
        "split = b + 4 * (a + c), gpu on fn b(&self, q: [f64; 3]) -> f64 { q[0].cos() } fn a(&self, q: [f64; 3], p: [f64; 3]) -> f64 { let mut t = 0.0; let mut r2 = 0.0; for d in 0..3 { t += p[d] * p[d] / 2.0; r2 += q[d] * q[d]; } t - 1.0 / r2.sqrt() } fn c(&self, q: [f64; 3]) -> f64 { q[1].cos() }",
        &[
            "1:25 `gpu` does not support `a`, a Kepler motion whose flow solves Kepler's equation\nnote: devices integrate drifts, kicks, shears and canonical shifts",
        ],
    ),
    (
        "split = c + 4 * BlanesMoan4(a + b), gpu on fn c(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn a(&self, q: [f64; 1], t: f64) -> f64 { q[0] * t.cos() } fn b(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[],
    ),
    (
        "split = none, gpu on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:14 `gpu` does not support H in one piece, `split = none`\nnote: devices integrate drifts, kicks, shears and canonical shifts",
        ],
    ),
    (
        "split = symmetric(omega = 3.0), gpu on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:32 `gpu` does not support `split = symmetric`, which evolves two copies of the state\nnote: devices integrate drifts, kicks, shears and canonical shifts",
        ],
    ),
];
