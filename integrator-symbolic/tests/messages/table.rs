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
            "1:0 `composition` is not an argument here; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "Verlet",
        &[
            "1:0 `Verlet` is not an argument here; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "4",
        &[
            "1:0 expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose",
        &[
            "1:0 this lacks its value; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose =",
        &[
            "1:0 this lacks its value; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose = 4",
        &[
            "1:10 a composition is a name or a sequence of stages; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
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
            "1:6 `taylor` takes no tolerance, which each run has for itself: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-12), start, h)` for a run",
        ],
    ),
    (
        "taylor = 1e-9, functions = fast",
        &[
            "1:9 `taylor` takes no tolerance, which each run has for itself: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-9), start, h)` for a run",
        ],
    ),
    (
        "taylor(tolerance = 1e-9)",
        &[
            "1:6 `taylor` takes no tolerance, which each run has for itself: write `taylor` here, and `system.run_with(Taylor::tolerance(1e-12), start, h)` for a run",
        ],
    ),
    (
        "compose = Taylor::tolerance(1e-12)",
        &[
            "1:10 the annotation names a composition, and `Taylor::tolerance(1e-12)` is a method with arguments: give it to the run, `system.run_with(Taylor::tolerance(1e-12), start, h)`",
        ],
    ),
    (
        "compose = Logarithmic(KahanLi8)",
        &[
            "1:10 the annotation names a composition, and `Logarithmic(KahanLi8)` is a method with arguments: give it to the run, `system.run_with(Logarithmic(KahanLi8), start, h)`",
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
            "1:0 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "gpu(functions)",
        &[
            "1:0 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "gpu(native)",
        &[
            "1:4 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "gpu(functions = fast)",
        &[
            "1:16 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "gpu(functions = 4)",
        &[
            "1:16 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "gpu(functions = native, threads)",
        &[
            "1:22 `gpu` takes `gpu(functions = native)`, for the elementary functions of the device, whose bits are others than those of a processor; `gpu` alone has the bits of one",
        ],
    ),
    (
        "functions = quick",
        &["1:12 elementary functions are `fast`, within 4 ulp, or `precise`, within 1 or 2, as they are unasked"],
    ),
    ("crate = a, crate = b", &["1:11 `crate` is given twice"]),
    (
        "crate = 4",
        &[
            "1:8 the runtime is named by a path; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "compose = Verlet, crate",
        &[
            "1:18 this lacks its value; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    ("compose = V(1/2) T(1) V(1/3)", &["1:10 the coefficients of `V` sum to 0.833333333333, not to 1"]),
    (
        "compose = V(1/2) T(1) W(1/2)",
        &[
            "1:22 unknown combinator `W`: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, the combinators `triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`",
        ],
    ),
];

/// Annotated items.
pub(crate) const ITEMS: &[Row] = &[
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn rate(&self, q: [f64; 2]) -> f64 { q[0] } }",
        &[
            "1:120 `rate` is not used: the pace is a function of all positions alone, `fn rate(&self, q: ..) -> f64`. Change its arguments, or rename it",
        ],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { self.rate(q[0]) } fn rate(&self, x: f64) -> f64 { x } }",
        &[],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] } }",
        &[
            "1:120 `hamiltonian` is not used: H is made of `kinetic` and `potential`, and no function calls this one. Remove it, or rename it",
        ],
    ),
    (
        "impl System { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] } fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.kinetic(p) + self.potential(q) } }",
        &[],
    ),
    (
        "impl S { fn kinetic(&self, p: &[f64]) -> f64 { p[0] * p[0] } fn potential(&self, q: &[f64]) -> f64 {\nlet mut a = q.to_vec(); a[0] = 1.0; a[1] } }",
        &[
            "2:24 elements of a copy of coordinates can be assigned where the copy has at most 16 of them: write the new value as a variable",
        ],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &[],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:13 an invariant is a number of positions and momenta: `fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) {} }",
        &["2:13 an invariant is a number of positions and momenta: `fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.c } }",
        &["2:16 `a` reads neither positions nor momenta: it is a constant of any motion"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn energy(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &["2:16 `energy` is a column of all samples that are written: give the invariant another name"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn p0_1(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * q[0] + p[0] * p[0] } }",
        &["2:16 `p0_1` is a column of all samples that are written: give the invariant another name"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] } }",
        &["3:16 there is an invariant `a` already: give this one another name"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * t } }",
        &["2:51 an invariant stays as it is, whatever the time: leave out this argument"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] - q[1] * p[0] } }",
        &["2:18 H has coordinates `[f64; 1]`, and these are `[f64; 2]`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant(of = rotation)] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:0 `#[invariant]` takes no arguments: the function says it all"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] #[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:13 `#[invariant]` is given twice"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, p: [f64; 1], q: [f64; 1]) -> f64 { q[0] * p[0] } }",
        &["2:18 positions come first: `fn a(&self, q, p)`"],
    ),
    (
        "impl S { fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] }\n#[invariant] fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { bessel(q[0]) * p[0] } }",
        &[
            "2:60 `bessel` of a coordinate is not known: the macro sees this impl alone; move the function into it and call `Self::bessel`, or call it from a method with a stated derivative, `#[derivative(slope)]`",
        ],
    ),
    ("struct System;", &["1:0 `#[hamiltonian]` belongs on an `impl` with the functions `kinetic` and `potential`"]),
    ("", &["1:0 `#[hamiltonian]` belongs on an `impl` with the functions `kinetic` and `potential`"]),
    ("impl System { fn }", &["1:17 unexpected end of input, expected identifier"]),
    (
        "impl Trait for System {}",
        &["1:5 `#[hamiltonian]` belongs on an inherent impl, `impl System { ... }`, not on the impl of a trait"],
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
        &["1:5 the impl lacks `fn potential(&self, q: [f64; N]) -> f64`, one of the two parts of H; is it `potental`?"],
    ),
    (
        "impl System { fn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["1:5 the impl lacks `fn kinetic(&self, p: [f64; N]) -> f64`, one of the two parts of H"],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 2]) -> f64 { p[0] }\nfn potential(&self, q: [f64; 3]) -> f64 { q[0] } }",
        &["3:13 every position has its momentum: q is `[f64; 3]` here, but p is `[f64; 2]` in `kinetic`"],
    ),
    (
        "impl System {\nfn kinetic(&self, p: f64) -> f64 { p }\nfn potential(&self, q: f64) -> f64 { q } }",
        &[
            "2:21 a single coordinate is an array, too: `[f64; 1]`, whose number is `[0]`",
            "3:23 a single coordinate is an array, too: `[f64; 1]`, whose number is `[0]`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f32; 1]) -> f64 { p[0] }\nfn potential(&self, q: [[u8; 2]; 1]) -> f64 { 0.0 } }",
        &[
            "2:22 coordinates are written in `f64`; a system runs in single precision where its start has numbers in `f32`",
            "3:25 coordinates are f64 numbers, points or planes: `[f64; N]`, `[[f64; D]; N]`, `[[[f64; L]; M]; N]`, references to them, or slices `&[f64]`, `&[[f64; D]]` and `&[[[f64; L]; M]]`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1]) { p[0] }\nfn potential(&self, q: [f64; 1]) -> f32 { q[0] } }",
        &[
            "2:3 `kinetic` gives an energy: it has to return f64, `-> f64`",
            "3:36 `potential` gives an energy: it has to return f64",
        ],
    ),
    (
        "impl System {\nfn kinetic(&mut self, p: [f64; 1]) -> f64 { p[0] }\nfn potential(self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:11 `kinetic` only looks at the parameters: it has to take `&self`",
            "3:13 `potential` only looks at the parameters: it has to take `&self`",
        ],
    ),
    (
        "impl System {\nasync fn kinetic<T>(&self, p: [f64; 1]) -> f64 { p[0] }\nunsafe fn potential<'q, const N: usize>(&self, q: &'q [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:0 `kinetic` is called as it is, to hold the generated code against it: write a plain `fn`, without `async`",
            "2:17 `kinetic` is called as it is, to hold the generated code against it: write a plain `fn`; what is generic belongs on the impl",
            "3:0 `potential` is called as it is, to hold the generated code against it: write a plain `fn`, without `unsafe`",
            "3:24 `potential` is called as it is, to hold the generated code against it: write a plain `fn`; what is generic belongs on the impl",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self) -> f64 { 0.0 }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:3 `kinetic` has no coordinates: write `fn kinetic(&self, p: [f64; N]) -> f64`"],
    ),
    (
        "impl System {\nfn kinetic(&self, a: [f64; 1], b: [f64; 1], c: [f64; 1]) -> f64 { 0.0 }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:11 `kinetic` takes `&self`, `p` and perhaps the time, `t: f64`"],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1]) -> f64 { q[0] }\nfn potential(&self, p: [f64; 1]) -> f64 { p[0] } }",
        &[
            "2:18 `kinetic` is a function of the momenta: call its argument `p`, not `q`",
            "3:20 `potential` is a function of the positions: call its argument `q`, not `p`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1], q: [f64; 1]) -> f64 { p[0] }\nfn potential(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] + p[0] } }",
        &[
            "2:31 `kinetic` is a function of `p` alone, H = T(p) + V(q): remove this argument",
            "3:62 V(q) may not read the momentum `p`: a term in `p` alone belongs in `kinetic`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &["2:67 T(p) may not read the position `q`: a term in `q` alone belongs in `potential`"],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {\n0.5 * p[0] * p[0] + q[0] * p[1] - q[1].cos() }}",
        &[
            "3:20 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {\n(q[0] + p[0]).powi(2) + (q[0] - p[0]).sin() + 1.0 / (q[0] + p[0]) }}",
        &[
            "3:0 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
            "3:24 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
            "3:46 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { if q[0] > p[0] { p[0] } else { 2.0 * p[0] } } }",
        &[
            "2:3 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, p: [f64; 1], q: [f64; 1]) -> f64 { p[0] + q[0] } }",
        &["2:15 positions come first: `fn hamiltonian(&self, q, p)`"],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "2:15 `hamiltonian` takes the positions, the momenta and perhaps the time: `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`",
        ],
    ),
    (
        "impl System {\nfn hamiltonian(&self, q: [f64; 1], p: [f64; 2]) -> f64 { q[0] + p[0] } }",
        &["2:38 every position has its momentum: q is `[f64; 1]`, but p is `[f64; 2]` here"],
    ),
    (
        "impl System {\nfn kinetic(&self, q: [f64; 1], p: [f64; 1]) -> f64 {\np[0] / q[0] + p[0].powf(q[0]) + p[0].mul_add(q[0], 1.0) }\nfn potential(&self, q: [f64; 1]) -> f64 { q[0] } }",
        &[
            "3:0 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
            "3:24 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
            "3:32 this mixes q and p, so H is not separable: a splitting needs H = T(p) + V(q). Change to coordinates in which T depends on p alone, split H into parts with exact flows, `split = a + b`, leave it in one piece for implicit methods, `split = none`, or couple two copies of the state, `split = symmetric(omega = 20.0)`",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, [a, b]: [f64; 3]) -> f64 { a + b }\nfn potential(&self, Point { x, y }: [f64; 3]) -> f64 { x + y } }",
        &[
            "2:18 the coordinates are `[f64; 3]`: 2 names do not fit",
            "3:20 this pattern is not understood: names, `_`, `&x`, arrays `[x, y]` and tuples `(x, y)` are",
        ],
    ),
    (
        "impl System {\nfn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }\nfn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }\nfn rate(&self, q: [f64; 1], t: f64) -> f64 { 1.0 + t } }",
        &["4:28 the pace depends on the positions alone, since the time is part of the motion: leave it out"],
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
            "2:7 `p` is not known here: V(q) is a function of the positions alone; a term with momenta belongs in `kinetic`",
        ],
    ),
    ("q[0] + x", &["2:7 `x` is not known here"]),
    ("q[2]", &["2:2 index 2 is out of bounds: the coordinates are `[f64; 2]`, the last index here is 1"]),
    ("q[0][1]", &["2:0 a number cannot be indexed"]),
    ("q[0.5]", &["2:2 an index is an integer; this is a number"]),
    ("q[q[0]]", &["2:2 an index is an integer; this is a number"]),
    (
        "let mut v = 0.0; for i in 0..3 { v += q[i]; } v",
        &["2:40 index 2 is out of bounds: the coordinates are `[f64; 2]`, the last index here is 1"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { v += q[i + 1]; } v",
        &["2:40 index 2 is out of bounds: the coordinates are `[f64; 2]`, the last index here is 1"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if i != 0 { v += q[i + 1]; } } v",
        &["2:52 index 2 is out of bounds: the coordinates are `[f64; 2]`, the last index here is 1"],
    ),
    ("q", &["2:0 `potential` has to end in a number, the energy; this is the whole array of coordinates"]),
    ("q[0];", &["2:0 `potential` has to end in a number, the energy; this is nothing"]),
    ("2", &["2:0 `2` is an integer: write `2.0`"]),
    ("q + 1.0", &["2:0 expected a number, found the whole array of coordinates"]),
    ("2 * q[0]", &["2:0 `2` is an integer: write `2.0`"]),
    ("q[0] % 2.0", &[]),
    ("q[0] as f32", &["2:0 a number cannot be cast here: energies are computed in f64"]),
    ("if q[0] > 0.0 { q[0] } else { 0.0 }", &[]),
    ("match q[0] { _ => q[0] }", &["2:0 `match` on coordinates is not understood: write `if ... else if ... else`"]),
    ("while q[0] > 0.0 {} q[0]", &["2:0 `while` has no derivative here: write the sum as `for i in a..b`"]),
    ("loop { q[0]; }", &["2:0 `loop` has no derivative here: write the sum as `for i in a..b`"]),
    ("(|x: f64| x)(q[0])", &[]),
    ("unsafe { q[0] }", &["2:0 `unsafe` code over coordinates is not understood: write it with plain indices"]),
    ("let x = q[0] < 1.0; q[0]", &[]),
    (
        "!q[0]",
        &[
            "2:0 this expression over coordinates is not understood: arithmetic, f64 methods, helper methods of this impl, `let`, `if` and `for i in a..b` are",
        ],
    ),
    (
        "let d = std::array::from_fn(|k| q[k]); d[0]",
        &[
            "2:8 how long this array is cannot be seen here: give it to a variable with its type, `let d: [f64; 3] = std::array::from_fn(|k| ...);`",
        ],
    ),
    ("q[0].div_euclid(2.0)", &["2:5 `div_euclid` of a coordinate is not known: Spelled like it: `rem_euclid`."]),
    (
        "bessel(q[0])",
        &[
            "2:0 `bessel` of a coordinate is not known: the macro sees this impl alone; move the function into it and call `Self::bessel`, or call it from a method with a stated derivative, `#[derivative(slope)]`",
        ],
    ),
    (
        "self.unknown(q[0])",
        &[
            "2:5 `unknown` of a coordinate is not known: the macro sees this impl alone; move the function into it, or call it from a method with a stated derivative, `#[derivative(slope)]`",
        ],
    ),
    ("self.endless(q[0])", &["3:84 `endless` calls itself: recursion has no derivative here; write a loop"]),
    ("self.helper(q[0], q[1])", &["2:5 `helper` takes 1 argument, not 2"]),
    ("q[0].sin(1.0)", &["2:5 `sin` takes 0 arguments, not 1"]),
    ("q[0].powi(q[1])", &["2:10 the exponent of `powi` is an integer that does not depend on coordinates"]),
    ("q[0].powi(-1_073_741_824)", &["2:10 this exponent is too large"]),
    ("(q[0] / 1000.0).powi(150) + ((q[0].powi(400) * q[1]).powi(600) * q[1]).powi(600)", &[]),
    ("q[0].powi(2_000_000_000)", &["2:10 this exponent is too large"]),
    ("q[0].powf(2)", &["2:10 `2` is an integer: write `2.0`"]),
    ("let x; q[0]", &["2:0 a variable needs its value where it is declared: write `let x = ...;`"]),
    (
        "let Some(x) = q[0] else { return 0.0 }; x",
        &["2:0 `let ... else` is understood on values of the system, which read no coordinates"],
    ),
    ("let (a, b, c) = q; a", &["2:4 the coordinates are `[f64; 2]`: 3 names do not fit"]),
    ("let [a, b] = q[0]; a", &["2:4 a number cannot be taken apart into 2 parts"]),
    (
        "let x @ y = q[0]; x",
        &["2:4 this pattern is not understood: names, `_`, `&x`, arrays `[x, y]` and tuples `(x, y)` are"],
    ),
    ("let (a, b) = q[0].sin_cos(); a * b", &[]),
    ("let a = [q[0], q[1]]; a[2]", &["2:24 the index is out of bounds: this array has 2 elements"]),
    ("let a = [q[0], q[1]]; let mut v = 0.0; for i in 0..2 { v += a[i]; } v", &[]),
    ("let a = (q[0], q[1]); a.2", &["2:24 a tuple has no such field"]),
    ("q[0].x", &["2:5 a number has no such field"]),
    ("fn inner() {} q[0]", &[]),
    ("struct Inner; q[0]", &["2:0 an item inside the function: move it out of the impl"]),
    (
        "println!(\"{}\", q[0]); q[0]",
        &["2:0 `println!` cannot be differentiated: only assertions may stand here; write the formula out"],
    ),
    ("assert!(q[0] > 0.0); q[0]", &[]),
    ("q[0] = 1.0; q[0]", &["2:0 `q` are coordinates: the functions only read them"]),
    (
        "let mut v = [0.0; N]; v[0] = 1.0; for n in 1..N { v[n] = q[0] * v[n - 1]; } v[N - 1]",
        &[
            "2:22 how long this array is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    (
        "let mut v = q[0]; for i in 0..N { v = v * v; } v",
        &[
            "2:34 `v` comes from outside this loop, so the loop can only sum it up: write `v += ...` or `v -= ...`. A loop that does more is written out where its bounds are literals, as in `for k in 0..4`, for up to 16 iterations. How much `N` is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    (
        "let mut v = q[0]; for i in 0..N - 1 { v = v * q[i].sin(); v = v + 1.0; } v",
        &[
            "2:38 `v` comes from outside this loop, so the loop can only sum it up: write `v += ...` or `v -= ...`. A loop that does more is written out where its bounds are literals, as in `for k in 0..4`, for up to 16 iterations. How much `N` is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    (
        "let s = [q[0], q[1]]; let mut v = 0.0; for i in 0..N { v += s[i]; } v",
        &[
            "2:62 an array of values is indexed by literals, or in a loop of up to 16 iterations; one that a loop fills, `for k in 0..32 { h[k] = ...; }`, by any index. How much `N` is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    (
        "let mut h = [1.0; 3]; for k in 1..N { h[k] = h[k - 1] * q[0]; } h[1]",
        &[
            "2:40 elements of an array are assigned at literal indices, in a loop of a few iterations, or in a loop whose own index they stand at, `for k in 0..32 { h[k] = ...; }`, with any other loop inside of it. How much `N` is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    (
        "(0..N).fold(1.0, |v, i| v * v + q[i])",
        &[
            "2:7 this `fold` does more than add, multiply or keep the largest item, so it is written out, for up to 16 items whose number is known here: run over literals, as in `(0..4).rev().fold(0.0, |sum, k| sum * x + self.c[k])`, or write a sum. Over any number of items, `sum * x + c` with the same x for all of them is a polynomial, and understood. How much `N` is cannot be seen here, since the macro sees this impl alone: declare `const N: usize = 6;` in this function, or in this impl, as `Self::N`",
        ],
    ),
    ("const N: usize = 3; let mut v = [0.0; N]; v[0] = 1.0; for n in 1..N { v[n] = q[0] * v[n - 1]; } v[N - 1]", &[]),
    // What other languages write.
    ("let mut v = 0; for i in 0..2 { v += q[i]; } v", &["2:12 `0` is an integer: write `0.0`"]),
    ("let mut v = 0; v += q[0]; v", &["2:12 `0` is an integer: write `0.0`"]),
    ("let mut v = 0; v = v + q[0]; v", &["2:12 `0` is an integer: write `0.0`"]),
    ("let mut v: f64 = 0; v += q[0]; v", &["2:17 `0` is an integer: write `0.0`"]),
    ("let k = 2; k * q[0]", &["2:11 `k` is an integer: write `k as f64`, or `2.0` where it is declared"]),
    ("let k = 2; q[k - 1]", &[]),
    ("let mut v = [0; 2]; for i in 0..2 { v[i] += q[i]; } v[0]", &["2:13 `0` is an integer: write `0.0`"]),
    ("let mut v = [0, 0]; v[0] += q[1]; v[0]", &["2:13 `0` is an integer: write `0.0`"]),
    (
        "let (mut v, mut w) = (0, 0); v += q[1]; w += q[0]; v + w",
        &["2:22 `0` is an integer: write `0.0`", "2:25 `0` is an integer: write `0.0`"],
    ),
    ("q.iter().fold(0, |v, x| v + x)", &["2:14 `0` is an integer: write `0.0`"]),
    ("if q[0] > 0 { q[0] } else { 0 }", &["2:10 `0` is an integer: write `0.0`"]),
    ("let x = if q[0] > 0.0 { q[0] } else { 0 }; x", &["2:38 `0` is an integer: write `0.0`"]),
    ("q[0].max(0)", &["2:9 `0` is an integer: write `0.0`"]),
    ("let mut v = 0; if q[0] > 0.0 { v = q[0]; } v", &["2:12 `0` is an integer: write `0.0`"]),
    ("let mut v = 0; for i in 0..2 { if q[i] > 0.0 { v += q[i]; } } v", &["2:12 `0` is an integer: write `0.0`"]),
    ("let mut v = 0; for i in 0..self.n { v += 1; } v as f64 * q[0]", &["2:41 `1` is an integer: write `1.0`"]),
    ("q(0)", &["2:0 `q` is the whole array of coordinates, no function: write `q[0]`"]),
    ("let x = q; x(0)", &["2:11 `x` is the whole array of coordinates, no function: write `x[0]`"]),
    ("let x = q[0]; x(1.0 + q[1])", &["2:14 `x` is a number, no function: write `x * (1.0 + q[1])`"]),
    ("2.0(q[0] + 1.0)", &["2:0 this is a number, no function: write `2.0 * (q[0] + 1.0)`"]),
    ("(q[0] + 1.0)(q[1])", &["2:0 this is a number, no function: write `(q[0] + 1.0) * q[1]`"]),
    ("q[0](1)", &["2:0 this is a number, no function: write `q[0] * 1.0`"]),
    ("q.0 + 1.0", &["2:2 the whole array of coordinates has no such field: write `q[0]`"]),
    ("q[0].powi(2.0)", &["2:10 the exponent of `powi` is an integer: write `powi(2)` or `powf(2.0)`"]),
    ("q[0].powi(1.5)", &["2:10 the exponent of `powi` is an integer: write `powf(1.5)`"]),
    ("q[0].powi(-2.0)", &["2:10 the exponent of `powi` is an integer: write `powi(-2)` or `powf(-2.0)`"]),
    ("let n = 2.0; q[0].powi(n)", &["2:23 the exponent of `powi` is an integer: write `powf(n)`"]),
    ("q[0]**2", &["2:0 `**` is no operator in Rust: write `q[0].powi(2)`"]),
    ("q[0] ** 2.0", &["2:0 `**` is no operator in Rust: write `q[0].powi(2)`"]),
    ("(q[0] + q[1])**2", &["2:0 `**` is no operator in Rust: write `(q[0] + q[1]).powi(2)`"]),
    ("3.0 * q[0]**2 + 1.0", &["2:6 `**` is no operator in Rust: write `q[0].powi(2)`"]),
    ("q[0]**1.5", &["2:0 `**` is no operator in Rust: write `q[0].powf(1.5)`"]),
    ("q[0]**-2", &["2:0 `**` is no operator in Rust: write `q[0].powi(-2)`"]),
    ("q[0] ^ 2", &["2:0 `^` is the exclusive or of bits in Rust: write `q[0].powi(2)`"]),
    (
        "q[0]^2 + q[1]^2",
        &[
            "2:0 `^` is the exclusive or of bits in Rust: write `q[0].powi(2)`",
            "2:9 `^` is the exclusive or of bits in Rust: write `q[1].powi(2)`",
        ],
    ),
    ("q[0] ^ 2.0", &["2:0 `^` is the exclusive or of bits in Rust: write `q[0].powi(2)`"]),
    ("(q[0] + q[1]) ^ 2", &["2:0 `^` is the exclusive or of bits in Rust: write `(q[0] + q[1]).powi(2)`"]),
    ("q[0] ^ self.n", &["2:0 `^` is the exclusive or of bits in Rust: write `q[0].powf(self.n)`"]),
    ("0.5 * q[0] ^ 2", &["2:6 `^` is the exclusive or of bits in Rust: write `q[0].powi(2)`"]),
    ("self.k ^ 2 * q[0]", &["2:0 `^` is the exclusive or of bits in Rust: write `self.k.powi(2)`"]),
    ("self.mass ** 2 * q[0]", &["2:0 `**` is no operator in Rust: write `self.mass.powi(2)`"]),
    ("q(0) + q[1]", &["2:0 `q` is the whole array of coordinates, no function: write `q[0]`"]),
    ("let mut v = [0; 2]; v[1] -= q[1]; v[1]", &["2:13 `0` is an integer: write `0.0`"]),
    ("let mut v = -1; for i in 0..2 { v += q[i]; } v", &["2:13 `1` is an integer: write `1.0`"]),
    ("let x = &q[0]; q[1] * *x", &[]),
    (
        "(q[0] > 0.0) ^ (q[1] > 0.0); q[0]",
        &[
            "2:0 this expression over coordinates is not understood: arithmetic, f64 methods, helper methods of this impl, `let`, `if` and `for i in a..b` are",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { v += q[i | 1]; } v",
        &[
            "2:40 `|` of integers that depend on loops is supported as `<< n`, `>> n`, `& (2^n - 1)` and `^ 1` with a number on the right, for integers that are never negative: write this one with `+`, `-`, `*`, `/` and `%`",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { for j in 0..2 { v += (i ^ j) as f64 * q[i]; } } v",
        &[
            "2:55 `^` of integers that depend on loops is supported as `<< n`, `>> n`, `& (2^n - 1)` and `^ 1` with a number on the right, for integers that are never negative: write this one with `+`, `-`, `*`, `/` and `%`",
        ],
    ),
    ("let v = 2; (v + 1) * q[0]", &["2:11 this is an integer: write `(v as f64 + 1.0)`"]),
    ("for i in 0..2 { q[i] * i; } q[0]", &["2:23 this is an integer: write `i as f64`"]),
    ("sqrt(q[0])", &["2:0 there is no function `sqrt` in Rust: write `q[0].sqrt()`"]),
    ("exp(-q[0] * q[0])", &["2:0 there is no function `exp` in Rust: write `(-q[0] * q[0]).exp()`"]),
    ("abs(q[0] - q[1])", &["2:0 there is no function `abs` in Rust: write `(q[0] - q[1]).abs()`"]),
    ("max(q[0], q[1])", &["2:0 there is no function `max` in Rust: write `q[0].max(q[1])`"]),
    ("pow(q[0], 2)", &["2:0 there is no function `pow` in Rust: write `q[0].powi(2)`"]),
    ("pow(q[0], 1.5)", &["2:0 there is no function `pow` in Rust: write `q[0].powf(1.5)`"]),
    ("log(q[0] + 2.0)", &["2:0 there is no function `log` in Rust: write `(q[0] + 2.0).ln()`"]),
    ("q[0].log()", &["2:5 `log` takes the base as an argument: the natural logarithm is `ln`"]),
    ("sum(q)", &["2:0 there is no function `sum` in Rust: write `q.iter().sum::<f64>()`"]),
    (
        "dot(q, q)",
        &["2:0 there is no function `dot` in Rust: write `q.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>()`"],
    ),
    (
        "q.norm()",
        &["2:2 numbers and arrays have no method `norm`: write `q.iter().map(|x| x * x).sum::<f64>().sqrt()`"],
    ),
    (
        "q.dot(&q)",
        &["2:2 numbers and arrays have no method `dot`: write `q.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>()`"],
    ),
    ("q[0].norm()", &["2:5 numbers and arrays have no method `norm`: write `q[0].abs()`"]),
    ("q[0].square()", &["2:5 numbers and arrays have no method `square`: write `q[0].powi(2)`"]),
    ("q[0].pow(-2)", &["2:5 numbers and arrays have no method `pow`: write `q[0].powi(-2)`"]),
    ("arctan2(q[0], q[1])", &["2:0 there is no function `arctan2` in Rust: write `q[0].atan2(q[1])`"]),
    ("np::sin(q[0])", &["2:0 there is no function `np::sin` in Rust: write `q[0].sin()`"]),
    ("Math::pow(q[0], 2)", &["2:0 there is no function `Math::pow` in Rust: write `q[0].powi(2)`"]),
    ("2.0 * pi * q[0]", &["2:6 `pi` is not known here: write `std::f64::consts::PI`"]),
    ("1 / 2 * q[0]", &["2:0 this is an integer: write `1.0 / 2.0`"]),
    ("q[0] * (1 / 2)", &["2:7 this is an integer: write `(1.0 / 2.0)`"]),
    (
        "let mut v = 0.0; for i in 0..2 { v += (i - 1) / 2 * q[i]; } v",
        &["2:38 this is an integer: write `(i as f64 - 1.0) / 2.0`"],
    ),
    ("q[0] * self.n[0] as f64 * -(2 + 1)", &["2:26 this is an integer: write `-(2.0 + 1.0)`"]),
    ("sqrt(2.0) * q[0]", &[]),
    ("y += q[0]; q[0]", &["2:0 `y` is not known here"]),
    ("let mut v = 1.0; for i in 0..2 { v *= q[i]; } v", &[]),
    (
        "let mut v = 0.0; for i in 0..self.count { v += v * v * q[i]; } v",
        &[
            "2:47 `v` is being summed up by the loop around here: it can be read after the loop",
            "2:51 `v` is being summed up by the loop around here: it can be read after the loop",
        ],
    ),
    ("for i in 0..2 { q[i]; }", &["2:0 `potential` has to end in a number, the energy; this is nothing"]),
    (
        "let mut v = 0.0; for i in 0.. { v += q[i]; } v",
        &["2:26 the range of a loop needs both bounds: write `a..b` or `a..=b`"],
    ),
    ("let mut v = 0.0; for i in q { v += i; } v", &[]),
    (
        "let mut v = 0.0; for i in 0..q[0] { v += t; } v",
        &["2:29 this bound is a number: the range of a loop is made of integers"],
    ),
    ("let mut v = 0.0; for (i, j) in 0..2 { v += q[0]; } v", &["2:21 an integer cannot be taken apart into 2 parts"]),
    ("let mut v = 0.0; for i in 0..2 { for j in 0..self.bonds[i] { v += q[j]; } } v", &[]),
    ("\"text\"", &[]),
    ("q[0] + 1e400", &[]),
    ("q[99999999999999999999999999]", &["2:2 number too large to fit in target type"]),
    (
        "for i in 0..2 { if q[i] > 1.0 { return 0.0; } } q[0]",
        &[
            "2:32 a `return` is understood in branches of the function itself, as in `if r > cutoff { return 0.0; }`: out of a loop, and from inside of an expression, it is not",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if q[i] > 1.0 { break; } v += q[i]; } v",
        &["2:49 `break` is not understood: give the loop its range, or put `if` around what it adds"],
    ),
    (
        "let mut v = 0.0; for i in 0..2 { if q[i] > 1.0 { if q[0] > 2.0 { continue; } v += q[i]; } v += 1.0; } v",
        &[
            "2:65 `continue` is supported as the last statement of an `if` without `else`, in the body of a loop and not further inside: put the condition around what is skipped",
        ],
    ),
    (
        "let mut v = 0.0; 'a: for i in 0..2 { for j in 0..2 { if i == j { continue 'a; } v += q[j]; } } v",
        &[
            "2:65 `continue` is supported as the last statement of an `if` without `else`, in the body of a loop and not further inside: put the condition around what is skipped",
        ],
    ),
    (
        "Some(1.0)? * q[0]",
        &["2:9 `?` leaves the function, and no force tells of that: give the energy unconditionally"],
    ),
    (
        "q[0] * match self.kind { 0 => return 0.0, _ => 1.0 }",
        &[
            "2:30 a `return` is understood in branches of the function itself, as in `if r > cutoff { return 0.0; }`: out of a loop, and from inside of an expression, it is not",
        ],
    ),
    (
        "let mut v = 0.0; let w = &mut v; *w += q[0]; v",
        &["2:25 `&mut` is not understood: assign to the variable itself"],
    ),
    ("let k = loop { break 2.0; }; k * q[0]", &[]),
    (
        "let mut list = self.list.clone(); list.reverse(); list[0] * q[0]",
        &[
            "2:39 `reverse` might change `list`, and only assignments are followed: make values of the system in one expression, or in a method of this impl that takes no coordinates",
        ],
    ),
    (
        "let mut list = self.list.iter(); list.next().unwrap() * q[0]",
        &[
            "2:38 `next` might change `list`, and only assignments are followed: make values of the system in one expression, or in a method of this impl that takes no coordinates",
        ],
    ),
    (
        "let mut list = self.list.clone(); list[0] = 2.0; list[0] * q[0]",
        &[
            "2:34 elements of the system's own lists are not assigned here: make the list in one expression, or in a method of this impl that takes no coordinates",
        ],
    ),
    ("let mut k = self.mass; k = k.sqrt(); k += 1.0; k * q[0]", &[]),
    ("let square = |x: f64| x * x; square(q[0])", &[]),
    ("let double = |x: f64| 2.0 * x; double(self.mass) * q[0]", &[]),
    ("if matches!(self.kind, 1 | 2) { q[0] } else { 0.0 }", &[]),
    (
        "if let Some(x) = Some(q[0]) { x } else { 0.0 }",
        &[
            "2:3 `if let` is understood on values of the system, which read no coordinates: compare numbers, as in `if r < cutoff`",
        ],
    ),
    (
        "q.iter().scan(0.0, |s, x| Some(x)).sum::<f64>()",
        &[
            "2:9 `scan` of a sequence is not understood: iter, map, filter, enumerate, zip, rev, skip, take, step_by, windows, array_windows and chunks_exact are, and `sum` and `fold` at the end",
        ],
    ),
    (
        "q.array_windows().map(|w| w[0] * w[1]).sum::<f64>()",
        &[
            "2:2 how many items a window has is not said here: write `array_windows::<2>()`, or take the window apart where it is used, as in `.map(|[a, b]| ..)`",
        ],
    ),
    ("self.list.iter().copied().reduce(f64::max).unwrap() * q[0]", &[]),
    ("let part = &q[1..]; part[0]", &[]),
    ("fn inner(x: f64) -> f64 { x } inner(q[0])", &[]),
    ("use std::f64::consts::PI; PI * q[0]", &[]),
    (
        "q[0].next_up() +\nq[2] +\nx",
        &[
            "2:5 `next_up` of a coordinate is not known:",
            "3:2 index 2 is out of bounds: the coordinates are `[f64; 2]`, the last index here is 1",
            "4:0 `x` is not known here",
        ],
    ),
];

/// The annotation, ` on `, and the functions of the impl, which begin on line 2.
pub(crate) const SPLITS: &[Row] = &[
    (
        "split = quadratic + rest on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(4) }",
        &[
            "1:8 `quadratic + rest` sorts the terms of one function: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`, the sum of both, in place of `kinetic` and `potential`",
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
            "2:98 `potential` is not used: H is made of `a` and `b`, and no function calls this one. Remove it, or rename it",
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
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p together, but a polynomial of degree 3. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * p[0] * t.cos() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is a quadratic form in q and p, but with coefficients that read the time. Terms that read the time have a flow in a part of q alone or of p alone: move them there",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 9], p: [f64; 9]) -> f64 { let s: f64 = (0..9).map(|i| q[i] + p[i]).sum(); s * s } fn b(&self, q: [f64; 9]) -> f64 { q[0].cos() }",
        &[],
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
            "1:20 every term of `hamiltonian` is a quadratic form in q and p, so that nothing is left for `rest`: the motion is known exactly, and a composition has nothing to compose",
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
            "1:8 no term of `hamiltonian` is a quadratic form in q and p, so that nothing is left for `quadratic`: name parts by functions of their own",
        ],
    ),
    (
        "split = quadratic + rest on fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + py * py + x * x + x * x * px }",
        &[
            "1:20 no exact flow is known for `rest`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p together, but a polynomial of degree 3. Split it into more parts, or write its flow: `#[flow(rest)]`",
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
        "split = a + b on fn a(&self, q: [[f64; 3]; 2], p: [[f64; 3]; 2]) -> f64 { let mut sum = 0.0; for d in 0..3 { sum += p[0][d] * p[0][d] + 2.0 * p[1][d] * p[1][d]; } sum - 1.0 / q[0][0].hypot(q[0][1]).hypot(q[0][2]) } fn b(&self, q: [[f64; 3]; 2]) -> f64 { q[0][0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() - x.powi(4) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:118 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y + 0.01).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + (y * y + self.soft)).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + y * y).sqrt() + self.offset } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x + 2.0 * y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since this term is neither p² of a body times a number nor k/|q|. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) - 1.0 / (x * x).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:87 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since p² or |q| of a body lacks some of its components. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
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
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { 0.5 * px * px * self.a + 0.5 * py * py * (self.a + self.b) - 1.0 / x.hypot(y) } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { px * px + 0.5 * py * py - 1.0 / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since the components of a body may have different masses. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [[f64; 2]; 2], p: [[f64; 2]; 2]) -> f64 { p[0][0].powi(2) + p[0][1].powi(2) - 1.0 / q[1][0].hypot(q[1][1]) - 1.0 / q[0][0].hypot(q[0][1]) } fn b(&self, q: [[f64; 2]; 2]) -> f64 { q[0][0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0][0] and p[0][0] are both in it; it is no quadratic form in q and p; it is no sum of p²/2m - k/|q| over bodies, since a body with k/|q| has no p²/2m. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { sum += 0.5 * (p[i] * p[i] + q[i] * q[i]); sum -= self.quartic(q[i]); } sum } fn quartic(&self, x: f64) -> f64 { 0.1 * x.powi(4) } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:133 no exact flow is known for `a`: it is no shear, since q[i] and p[i] are both in it; it is no quadratic form in q and p together, but a polynomial of degree 4. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 { let tail = self.tail(x); px * px + py * py - tail } fn tail(&self, x: f64) -> f64 { 0.5 * x * x + x.cosh() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:157 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { let mut sum = q[0].powi(4); sum += p[0].powi(4) + q[0] * p[0].cos(); sum } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:97 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0].powi(4) + q[0].powi(4) } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p together, but a polynomial of degree 4. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { sum += self.list.iter().map(|x| x * i as f64).sum::<f64>() * (q[i] + p[i]); } 0.5 * q[0] * q[0] + sum * sum } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:182 no exact flow is known for `a`: it is no shear, since q[i] and p[i] are both in it; it is a quadratic form in q and p, but multiplies a sum over a loop by itself: write it as one sum in two loops, over i and j. Move this term to another part, or write the flow of `a`: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: &[f64], p: &[f64]) -> f64 { let mut sum = 0.0; for i in 0..q.len() { for j in 0..i { sum += q[i] - p[j]; } } sum * sum } fn b(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[i] and p[i] are both in it; it is a quadratic form in q and p, but multiplies a sum over a loop by itself: write it as one sum in two loops, over i and j. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + a on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &["1:12 `a` is a part of H already: each part is named once"],
    ),
    (
        "split = field + flihgt on fn flight(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn field(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:16 the impl lacks `fn flihgt(&self, q: [f64; N], p: [f64; N]) -> f64`, the part of H that `split` names; is it `flight`?",
        ],
    ),
    (
        "split = a on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:8 one part alone is not composed; the parts of H are named by their functions, as in `split = kepler + interaction`",
        ],
    ),
    (
        "split on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:0 this lacks its value; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
        ],
    ),
    (
        "split = 3 on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] }",
        &[
            "1:8 the parts of H are named by their functions, as in `split = kepler + interaction`; expected `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `taylor`, `sensitive(mass, length)`, `gpu` or `crate = path::to::integrator_core`",
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
            "1:8 parts in parentheses are the second part of H, which a composition treats as the small one: `split = kepler + (jump + interaction)`",
        ],
    ),
    (
        "split = a + b + (c + b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:12 parts in parentheses are the second of two parts, and this is another one: put it into the parentheses, or leave these out",
        ],
    ),
    (
        "split = a + (b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:12 one part alone is no pair: leave out the parentheses"],
    ),
    (
        "split = a + (b + c) + b on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:20 parts in parentheses are the last part of H: put what follows before them, or into them"],
    ),
    (
        "split = a + (b + 3) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:17 parentheses hold parts of H by their names, as in `split = kepler + (jump + interaction)`"],
    ),
    (
        "split = a + (b + (c + b)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:17 parentheses hold parts of H by their names, as in `split = kepler + (jump + interaction)`"],
    ),
    (
        "split = a + () on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:13 parentheses hold parts of H by their names, as in `split = kepler + (jump + interaction)`"],
    ),
    (
        "split = a + (b + b) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &["1:17 `b` is a part of H already: each part is named once"],
    ),
    (
        "split = a + (b + d) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:17 the impl lacks `fn d(&self, q: [f64; N], p: [f64; N]) -> f64`, the part of H that `split` names; is it `a`, `b`, `c`?",
        ],
    ),
    (
        "split = a + (b + c), compose = T(1/2) V(1) T(1/2) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = a + (b + c), compose = V(1/2) T(1) V(1/2) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:31 this sequence begins and ends with a kick, and two of them in a row are not one where a part is itself a pair of parts in parentheses: begin with a drift",
        ],
    ),
    (
        "split = a + (b + c), compose = symmetric(T((14 - sqrt(19))/108) V(2/5) T((20 - 7*sqrt(19))/108) V(-1/10) T(_) V(_)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:31 a part that is itself a pair of parts in parentheses errs in the third power of each kick, and these do not cancel in this sequence, so that its order is not 4: use one such as `Abah1064`, `Verlet` or `Yoshida4`",
        ],
    ),
    (
        "split = a + (b + c), compose = symmetric(1/(2 - cbrt(2)), _; Verlet) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[],
    ),
    (
        "split = a + (b + c), compose = symmetric(V(1/6) T(1/2) V(2/3, -1/72) T(_) V(_)) on fn a(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] } fn b(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] } fn c(&self, q: [f64; 2]) -> f64 { q[0].cos() + q[1].cos() }",
        &[
            "1:62 a force-gradient kick needs H = ½ pᵀ M⁻¹ p + V(q), and no pair of parts: use a sequence such as `Abah1064`, `Verlet` or `Yoshida4`",
        ],
    ),
    (
        "split = a + b on fn a(&self, [x, y]: [f64; 2], [px, py]: [f64; 2], t: f64) -> f64 { 0.5 * (px * px + py * py) - t.cos() / (x * x + y * y).sqrt() } fn b(&self, q: [f64; 2]) -> f64 { q[0].cos() }",
        &[
            "2:95 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Terms that read the time have a flow in a part of q alone or of p alone: move them there",
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
        &["1:12 the parts of H are named by their functions, as in `split = kepler + interaction`"],
    ),
    (
        "split = a + b on fn a(&self, x: [f64; 1]) -> f64 { x[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:12 is this the positions or the momenta of `a`? Call it `q` or `p`, or take both: `fn a(&self, q: [f64; N], p: [f64; N]) -> f64`",
        ],
    ),
    (
        "split = a + b on fn a(&self, p: [f64; 1]) -> f64 { 2.0 } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &["2:3 `a` depends on neither q nor p, so nothing moves by it: leave this part out"],
    ),
    (
        "split = a + b on fn a(&self, p: [f64; 2]) -> f64 { p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &["2:46 all parts have the same coordinates: q and p are `[f64; 2]` in the first part, but `[f64; 1]` here"],
    ),
    (
        "split = a + b + c on fn a(&self, p: [f64; 1], t: f64) -> f64 { t * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn c(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Split it into more parts, or write its flow: `#[flow(a)]`",
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
            "3:7 `c` is no part of H: `split` names `a`, `b`",
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "3:0 this names the part of H whose flow the method is: `#[flow(kepler)]`",
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "3:11 a flow moves positions and momenta in place for a duration: `fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64)`",
        ],
    ),
    (
        "split = a + b on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(b)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &[
            "2:3 no exact flow is known for `a`: it is no shear, since q[0] and p[0] are both in it; it is no quadratic form in q and p. Split it into more parts, or write its flow: `#[flow(a)]`",
        ],
    ),
    (
        "compose = Verlet on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].cos() }\n#[flow(a)] fn turn(&self, q: &mut [f64; 1], p: &mut [f64; 1], duration: f64) {}",
        &["3:7 `a` is no part of H: name the parts, `split = a + b`"],
    ),
    (
        "split = none, compose = GaussLegendre4 on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &[],
    ),
    (
        "split = none, compose = V(1/2) T(1) V(1/2) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &[
            "1:24 a sequence composes flows, and `split = none` leaves H in one piece, which has none: name an implicit method, `compose = GaussLegendre4`",
        ],
    ),
    (
        "split = none on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:8 `none` takes H as it is, in one function: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`; implicit methods integrate `kinetic` and `potential` without it",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = none on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }",
        &["1:14 Jacobi coordinates are for bodies whose T and V are known apart, not for `none`"],
    ),
    ("split = none, taylor on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).sin() }", &[]),
    (
        "split = symmetric(omega = 2.0 * self.rate) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[],
    ),
    (
        "split = symmetric on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:8 `symmetric` couples two copies of the state, and how tightly depends on the system: say it, as in `split = symmetric(omega = 20.0)`, where omega is about as large as the fastest angular frequency, or several times that",
        ],
    ),
    (
        "split = symmetric(rate = 3.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:18 `symmetric` couples two copies of the state, and how tightly depends on the system: say it, as in `split = symmetric(omega = 20.0)`, where omega is about as large as the fastest angular frequency, or several times that",
        ],
    ),
    (
        "split = symmetric(omega = 3.0, 4.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &["1:29 the coupling is one number: `symmetric(omega = 20.0)`"],
    ),
    (
        "split = symmetric(omega = 0.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &["1:26 without a coupling above zero, both copies go their own ways"],
    ),
    (
        "split = symmetric(omega = q[0]) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &["1:26 `q` is not known here"],
    ),
    (
        "split = symmetric(omega = 3.0) on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[
            "1:26 `symmetric` takes H as it is, in one function: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`; `kinetic` and `potential` need no copies",
        ],
    ),
    (
        "split = symmetric(omega = 3.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1], t: f64) -> f64 { q[0] * p[0] * t }",
        &[
            "2:3 this reads the time, and compositions know at what time the flows of two parts begin, not those of two copies and their coupling: make the time a coordinate with a momentum of its own",
        ],
    ),
    (
        "split = symmetric(omega = 3.0), taylor on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[],
    ),
    (
        "split = a + b + c, compose = A(1/2) B(1) A(1/2) on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn c(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[],
    ),
    (
        "split = a + b + c, compose = processed(A(1/12) B(1/12) A(-1/12) B(-1/12); Verlet) on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn c(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[
            "1:29 a processor integrates two parts alone: more than two parts take compositions of general class without a processor, such as `Yoshida4`",
        ],
    ),
    (
        "split = a + b + c, compose = B(1/6) A(1/2) B(2/3, -1/72) A(1/2) B(1/6) on fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() } fn c(&self, q: [f64; 1]) -> f64 { q[0] }",
        &[
            "1:50 a force-gradient kick needs H = ½ pᵀ M⁻¹ p + V(q), hence two parts: more than two parts take compositions of general class without a processor, such as `Yoshida4`",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: &[f64]) -> f64 { p[0] * p[0] } fn potential(&self, q: &[f64]) -> f64 { q[0].cos() }",
        &[
            "1:0 a device keeps the state in registers, so that the number of coordinates has to be known here: write an array such as `[f64; 4]` in place of a slice",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 40]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 40]) -> f64 { q[0].cos() }",
        &["1:0 a device keeps the state of a member in registers, 64 numbers at most, and this one has 80"],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; SIZE]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; SIZE]) -> f64 { q[0].cos() }",
        &["1:0 coordinates whose number is a constant have no text for devices yet: write the number"],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 8]) -> f64 { p.iter().map(|p| p * p).sum() } fn potential(&self, q: [f64; 8]) -> f64 { let mut v = 0.0; for i in 0..7 { v += (q[i + 1] - q[i]).powi(4); } v }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 8]; 3]) -> f64 { let mut t = 0.0; for i in 0..3 { for j in 0..8 { t += p[i][j] * p[i][j]; } } t } fn potential(&self, q: [[f64; 8]; 3]) -> f64 { let mut v = 0.0; for i in 0..3 { for j in 0..8 { v += (q[i][(j + 1) % 8] - q[i][j]).powi(4) + (q[(i + 1) % 3][j] - q[i][j]).powi(4); } } v }",
        &[
            "1:0 the sites of a plane are added in an order of their own, which devices do not know yet, as they do that of a line: leave out `gpu`",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 3]; 4]) -> f64 { let mut t = 0.0; for i in 0..4 { for d in 0..3 { t += p[i][d] * p[i][d]; } } t } fn potential(&self, q: [[f64; 3]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { let mut r2 = 0.0; for d in 0..3 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= 1.0 / r2.sqrt(); } } v }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [[f64; 2]; 9]) -> f64 { let mut t = 0.0; for i in 0..9 { for d in 0..2 { t += p[i][d] * p[i][d]; } } t } fn potential(&self, q: [[f64; 2]; 9]) -> f64 { let mut v = 0.0; for i in 0..9 { for j in 0..i { let mut r2 = 0.0; for d in 0..2 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= 1.0 / r2.sqrt(); } } v }",
        &[
            "1:0 9 bodies that act on each other in pairs are added in several rows, an order that devices do not know yet, as they do that of 8 bodies at most: write out the pairs, or leave out `gpu`",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0].tanh() }",
        &[
            "1:0 `cosh`, in H or in a derivative of it, has no kernel of this library's own, so that its bits on a device would be others; write it with functions that have one, such as `exp` and `ln`, or take the device's own, `gpu(functions = native)`",
        ],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 2]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 2]) -> f64 { q[self.first] * q[1].sin() }",
        &[],
    ),
    (
        "gpu on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1], t: f64) -> f64 { if t < self.end { q[0] } else { q[0].cos() } }",
        &["1:0 formulas that change at certain times have no text for devices yet"],
    ),
    (
        "split = a + b, gpu on fn a(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + q[0] * q[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0].cos() }",
        &[
            "1:15 `a`, a quadratic form, whose flow is a matrix, has no text for devices yet: a device knows drifts, kicks and shears",
        ],
    ),
    (
        "split = a + b, gpu on fn a(&self, q: [f64; 3], p: [f64; 3]) -> f64 { let mut t = 0.0; let mut r2 = 0.0; for d in 0..3 { t += p[d] * p[d] / 2.0; r2 += q[d] * q[d]; } t - 1.0 / r2.sqrt() } fn b(&self, q: [f64; 3]) -> f64 { q[0].cos() }",
        &[
            "1:15 `a`, Kepler motion, whose equation is solved, has no text for devices yet: a device knows drifts, kicks and shears",
        ],
    ),
    (
        "split = none, gpu on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:14 H in one piece, which implicit methods integrate, has no text for devices yet: a device knows drifts, kicks and shears",
        ],
    ),
    (
        "split = symmetric(omega = 3.0), gpu on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }",
        &[
            "1:32 the motion of two copies of the state has no text for devices yet: a device knows drifts, kicks and shears",
        ],
    ),
];
