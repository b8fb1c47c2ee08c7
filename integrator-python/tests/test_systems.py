"""Systems: parameters, equations, certificates, chaos, crossings, type stubs."""

import ast
import inspect
import os
import pathlib
import unittest

import galaxy
import numpy as np

SYSTEM = galaxy.Galaxy(core=0.1, flattening=0.8)
Q, P, H = [1.0, 0.0, 0.0], [0.0, 0.6, 0.4], 0.01


class Parameters(unittest.TestCase):
    def test_fields_are_keyword_arguments_and_attributes(self):
        self.assertEqual(repr(SYSTEM), "Galaxy(core=0.1, flattening=0.8)")
        self.assertEqual((SYSTEM.core, SYSTEM.flattening), (0.1, 0.8))
        self.assertEqual(SYSTEM.replace(core=1).parameters, {"core": 1.0, "flattening": 0.8})
        self.assertIsInstance(SYSTEM, galaxy.System)
        self.assertIsInstance(SYSTEM.replace(), galaxy.Galaxy)
        self.assertIn("flattening", dir(SYSTEM))
        self.assertEqual(str(inspect.signature(galaxy.Galaxy)), "(*, core, flattening)")
        self.assertEqual(repr(galaxy.Rotor()), "Rotor()")
        chain = galaxy.Chain(coupling=0.5, periodic=True, label=None)
        self.assertEqual((chain.coupling, chain.periodic, chain.label), (0.5, True, None))

    def test_arrays_are_parameters(self):
        for mass in [[1.0, 2.0], (1, 2), np.array([1.0, 2.0]), np.array([1, 2]), [np.float32(1), np.int64(2)]]:
            bodies = galaxy.Bodies(mass=mass)
            self.assertEqual((bodies.mass.tolist(), bodies.strength), ([1.0, 2.0], 1.0))
        with self.assertRaises(ValueError):
            bodies.mass[0] = 3.0

    def test_mistakes_say_what_to_write(self):
        for call, error, parts in [
            (lambda: galaxy.Galaxy(core=1, flatening=2), TypeError, ["no parameter `flatening`", "write `flattening`"]),
            (lambda: galaxy.Galaxy(core=1), TypeError, ["Galaxy() requires the parameter `flattening`"]),
            (lambda: galaxy.Galaxy(1, 2), TypeError, ["write `Galaxy(core=..., flattening=...)`"]),
            (lambda: galaxy.Galaxy(core="x", flattening=1), galaxy.InputError, ["the parameter `core`", "not str"]),
            (lambda: galaxy.Bodies(mass=["x"]), galaxy.InputError, ["the parameter `mass`", "not str"]),
            (lambda: galaxy.Rotor(core=1), TypeError, ["Rotor() has no parameter `core`", "no parameters"]),
            (lambda: galaxy.System(), TypeError, ["base of the systems"]),
            (lambda: SYSTEM.cor, AttributeError, ["Galaxy has no attribute `cor`", "write `core`"]),
            (lambda: setattr(SYSTEM, "core", 2.0), AttributeError, ["`system.replace(core=...)`"]),
            (lambda: SYSTEM.circular_velocity("x"), TypeError, ["not str"]),
        ]:
            with self.assertRaises(error) as caught:
                call()
            for part in parts:
                self.assertIn(part, str(caught.exception))

    def test_keywords_of_python_are_no_parameters(self):
        # What the classes are built by, in place of a module that cannot be imported.
        of = {"__name__": "classes"}
        exec((pathlib.Path(__file__).parents[1] / "src/classes.py").read_text(), of)
        kind = type("Kind", (), {"name": "Laser"})
        with self.assertRaises(ImportError) as caught:
            of["system_class"](object, "m", kind, "", "(1,)", ["lambda"], [], [])
        self.assertIn('`#[serde(rename = "lambda_")]`', str(caught.exception))

    def test_functions_are_methods_with_documentation(self):
        self.assertEqual(SYSTEM.circular_velocity(1.0), 1.0 / np.sqrt(0.1**2 + 1.0))
        self.assertEqual(SYSTEM.circular_velocity(radius=0.0), 0.0)
        self.assertIn("circular orbit", galaxy.Galaxy.circular_velocity.__doc__)
        self.assertIn("circular_velocity", dir(SYSTEM))
        with self.assertRaises(galaxy.InputError):
            galaxy.Galaxy.circular_velocity(galaxy.Rotor(), 1.0)

    def test_the_documentation_has_shapes_and_units(self):
        for part in ["logarithmic potential", "core, flattening", "Shape of q and of p: (3,)", "KahanLi8", "Unit of vel"]:
            self.assertIn(part, galaxy.Galaxy.__doc__)
        self.assertIn("(N, 2)", galaxy.Bodies.__doc__)


class Compositions(unittest.TestCase):
    def test_a_module_lists_its_compositions(self):
        self.assertEqual(SYSTEM.compositions[0], "BlanesMoanSrkn11")
        self.assertEqual(galaxy.Bodies(mass=[1]).compositions, ["Verlet", "KahanLi8", "ImplicitMidpoint"])
        self.assertEqual(galaxy.Rotor().compositions, ["Verlet", "Yoshida4", "Taylor"])
        # Compositions for a small second part need parts with names.
        chain = galaxy.Chain(coupling=0.5, periodic=True, label=None)
        self.assertTrue({"KahanLi8", "Abah1064"} <= set(chain.compositions))
        self.assertNotIn("Abah1064", SYSTEM.compositions)

    def test_all_of_them_integrate(self):
        exact = SYSTEM.run(Q, P, H, composition="KahanLi8", scalar="compensated")
        exact.advance(100)
        for composition in SYSTEM.compositions:
            run = SYSTEM.run(Q, P, H, composition=composition)
            run.advance(100)
            self.assertEqual(run.composition, composition)
            # Verlet has errors of the order h² times the time.
            np.testing.assert_allclose(run.q, exact.q, atol=1e-3)
        pendulum = galaxy.Rotor().run([1.0], [0.0], 0.1, composition="Taylor")
        energy = pendulum.energy
        pendulum.advance(100)
        # A thousand roundings.
        self.assertAlmostEqual(pendulum.energy, energy, delta=1e3 * 2.0**-53)

    def test_certificates_are_text(self):
        text = SYSTEM.certify(Q, P, H)
        self.assertTrue(text.startswith("BlanesMoanSrkn11 on galaxy::Galaxy, h = 0.01"), text)
        self.assertTrue(SYSTEM.certify(Q, P, H, composition="Verlet").startswith("Verlet"))


class Orbits(unittest.TestCase):
    def test_crossings_by_text_and_by_function(self):
        begin = lambda: galaxy.Rotor().run([0.0], [1.0], 0.05)
        rising = begin().crossings("q[0]", n=4)
        falling = begin().crossings("q[0]", direction="falling", n=4)
        both = begin().crossings("q[0]", direction="either", n=8)
        np.testing.assert_array_equal(np.sort(np.concatenate([rising.t, falling.t])), both.t)
        # The period of a pendulum at this energy is 4 K(1/2), and Verlet's error is of the order h².
        np.testing.assert_allclose(np.diff(rising.t), 4 * 1.6857503548, rtol=1e-3)
        # States next to the zero: roundings of the time, which is below 100, times velocities of at most 1.
        self.assertTrue((np.abs(rising.q) < 100 * 2.0**-52).all() and (rising.p > 0).all())
        called = begin().crossings(lambda q, p, t: q[0], n=4)
        np.testing.assert_array_equal(called.t, rising.t)
        shifted = begin().crossings(" p[0] - 0.5 ", direction="falling", n=1)
        self.assertAlmostEqual(shifted.p[0, 0], 0.5, delta=100 * 2.0**-52)
        self.assertEqual(len(begin().crossings("q[0]", n=5, steps=10).t), 0)
        timed = begin().crossings(lambda q, p, t: t - 1.0, n=1)
        self.assertAlmostEqual(timed.t[0], 1.0, delta=2.0**-52)

    def test_points_have_two_indices(self):
        bodies = galaxy.Bodies(mass=[1.0, 1e-3])
        begin = lambda: bodies.run([[0, 0], [1, 0]], [[0, -1e-3], [0, 1e-3]], 0.01)
        found = begin().crossings("q[1, 1]", direction="falling", n=1)
        np.testing.assert_array_equal(found.t, begin().crossings("q[1][1]", direction="falling", n=1).t)
        # Half of a circle later, up to the recoil, a part of the mass ratio 1e-3.
        self.assertAlmostEqual(found.q[0, 1, 0], -1.0, delta=0.01)

    def test_wrong_crossings_say_what_to_write(self):
        run = SYSTEM.run(Q, P, H)
        for function in ["q[3]", "q", "x[0]", "q[0, 0]", "q[0] * 2", "q[-1]", "q[0] - x", "", 3]:
            with self.assertRaises(galaxy.InputError) as caught:
                run.crossings(function)
            self.assertIn("q[0]", str(caught.exception))
        with self.assertRaises(galaxy.InputError):
            run.crossings("q[0]", direction="up")
        with self.assertRaises(IndexError):
            run.crossings(lambda q, p, t: q[7])
        with self.assertRaises(galaxy.RunError) as caught:
            run.crossings(lambda q, p, t: np.nan)
        self.assertIn("the function of the crossing is NaN", str(caught.exception))
        self.assertEqual(run.steps, 0)

    def test_indicators_of_chaos(self):
        exponents, uncertainties = SYSTEM.lyapunov_spectrum(Q, P, 0.05, 20_000)
        self.assertEqual((exponents.shape, uncertainties.shape), ((6,), (6,)))
        # A symplectic map keeps volumes: the sum is rounding, times 20,000 steps over a time of 1,000.
        self.assertAlmostEqual(exponents.sum(), 0.0, delta=20 * 2.0**-53 * 1e3)
        # Librations and rotations of a pendulum are regular: MEGNO approaches 2 like 1 / t, here t = 5,000, times the shear.
        megno = galaxy.Rotor().chaos_map([[1.0], [0.0]], [[0.0], [3.0]], 0.05, 100_000)
        np.testing.assert_allclose(megno, 2.0, atol=0.1)
        for indicator in ["exponent", "fli"]:
            self.assertEqual(galaxy.Rotor().chaos_map([[1.0]], [[0.0]], 0.05, 10_000, indicator=indicator).shape, (1,))
        with self.assertRaises(galaxy.InputError) as caught:
            galaxy.Rotor().chaos_map([[1.0]], [[0.0]], 0.05, 10_000, indicator="megn")
        self.assertIn("help: write `megno`", str(caught.exception))
        with self.assertRaises(galaxy.InputError) as caught:
            SYSTEM.chaos_map([Q, [np.nan, 0, 0]], [P, P], H, 1000)
        self.assertIn("row 1", str(caught.exception))


class Gradients(unittest.TestCase):
    GOAL = np.array([0.5, 0.5, 0.1])

    def loss(self, q, p):
        miss = q - self.GOAL
        return miss @ miss, (2 * miss, np.zeros_like(p))

    def value(self, system, q, p, steps):
        run = system.run(q, p, H)
        run.advance(steps)
        return self.loss(run.q, run.p)[0]

    def test_derivatives_are_those_of_differences(self):
        value, (by_q, by_p, by_parameters) = SYSTEM.value_and_grad(self.loss, Q, P, H, 500)
        self.assertEqual(value, self.value(SYSTEM, Q, P, 500))
        # Central differences have a truncation error of the order d² and rounding of the order 2^-53 / d.
        d = 1e-5
        for index, step in enumerate(d * np.eye(3)):
            difference = self.value(SYSTEM, Q + step, P, 500) - self.value(SYSTEM, Q - step, P, 500)
            self.assertAlmostEqual(by_q[index], difference / (2 * d), delta=1e-6)
            difference = self.value(SYSTEM, Q, P + step, 500) - self.value(SYSTEM, Q, P - step, 500)
            self.assertAlmostEqual(by_p[index], difference / (2 * d), delta=1e-6)
        self.assertEqual(list(by_parameters), ["core", "flattening"])
        for name, derivative in by_parameters.items():
            of = lambda step: SYSTEM.replace(**{name: getattr(SYSTEM, name) + step})
            difference = self.value(of(d), Q, P, 500) - self.value(of(-d), Q, P, 500)
            self.assertAlmostEqual(derivative, difference / (2 * d), delta=1e-6)
        self.assertGreater(np.abs(by_q).max(), 1e-2)

    def test_points_keep_their_shape(self):
        bodies = galaxy.Bodies(mass=[1.0, 1e-3])
        q, p = [[0, 0], [1, 0]], [[0, -1e-3], [0, 1e-3]]
        loss = lambda q, p: (q[1, 0], (np.array([[0, 0], [1, 0]]), np.zeros((2, 2))))
        value, (by_q, by_p, by_parameters) = bodies.value_and_grad(loss, q, p, 0.01, 100)
        self.assertEqual((by_q.shape, by_p.shape, by_parameters), ((2, 2), (2, 2), {}))
        # A shift of all bodies shifts the end, up to the rounding of some hundreds of steps.
        self.assertAlmostEqual(by_q[:, 0].sum(), 1.0, delta=1e3 * 2.0**-53)

    def test_mistakes_of_the_loss_are_errors(self):
        for loss, error, part in [
            (lambda q, p: 1.0, galaxy.InputError, "expected (value, (derivatives by q, derivatives by p))"),
            (lambda q, p: (1.0, (q[:2], p)), galaxy.InputError, "the derivatives by q has the shape (2,): expected (3,)"),
            (lambda q, p: q[7], IndexError, "out of bounds"),
            (lambda q, p: (1.0, (q * np.nan, p)), galaxy.InputError, "not finite"),
        ]:
            with self.assertRaises(error) as caught:
                SYSTEM.value_and_grad(loss, Q, P, H, 10)
            self.assertIn(part, str(caught.exception))


class Equations(unittest.TestCase):
    def test_equations_are_text_and_latex(self):
        equations = SYSTEM.equations()
        self.assertIn("dq[0]/dt = p[0]", str(equations))
        latex = equations._repr_latex_()
        self.assertTrue(latex.startswith("$$\\begin{aligned}\n") and latex.endswith("\n\\end{aligned}$$"))
        for line in [
            r"T &= \left(p_{0}^{2} + p_{1}^{2} + p_{2}^{2}\right) / 2 \\",
            r"\dot p_{2} &= -q_{2} / \left(\mathrm{flattening}^{2} \, r^{2}\right) \\",
            r"\text{ where } \, r &= \sqrt{q_{0}^{2} + q_{1}^{2} + q_{2}^{2} / \mathrm{flattening}^{2} + \mathrm{core}^{2}}",
        ]:
            self.assertIn(line, latex)
        self.assertEqual(latex.count("{"), latex.count("}"))
        latex = galaxy.Bodies(mass=[1.0]).equations()._repr_latex_()
        self.assertIn(r"\sum_{k \, \text{ in } \, 0 \ldots n}", latex)
        self.assertIn(r"\dot p_{j,0} &\mathrel{+}=", latex)


class Stubs(unittest.TestCase):
    STORED = pathlib.Path(__file__).with_name("galaxy.pyi")

    def test_they_are_those_that_are_stored(self):
        if os.environ.get("BLESS"):
            self.STORED.write_text(galaxy.stubs())
        self.assertEqual(galaxy.stubs(), self.STORED.read_text(), "BLESS=1 stores them")

    def test_they_have_the_names_and_arguments_of_the_module(self):
        classes = {node.name: node for node in ast.parse(galaxy.stubs()).body if isinstance(node, ast.ClassDef)}
        compared = 0
        for name in ["Run", "Ensemble", "System", "Equations", "Galaxy"]:
            found = getattr(galaxy, name)
            public = {entry for entry in vars(found) if not entry.startswith("_")}
            functions = [node for node in classes[name].body if isinstance(node, ast.FunctionDef)]
            fields = {"core", "flattening"} if name == "Galaxy" else set()
            self.assertEqual({node.name for node in functions if not node.name.startswith("_")} - fields, public)
            for node in functions:
                if node.name.startswith("_") or any(ast.unparse(mark) == "property" for mark in node.decorator_list):
                    continue
                arguments = node.args
                expected = [argument.arg for argument in arguments.args[1:] + arguments.kwonlyargs]
                expected += [argument.arg for argument in [arguments.kwarg] if argument]
                defaults = [ast.unparse(default) for default in arguments.defaults + arguments.kw_defaults if default]
                actual = list(inspect.signature(getattr(found, node.name)).parameters.values())[1:]
                self.assertEqual([parameter.name for parameter in actual], expected, node.name)
                values = [repr(parameter.default) for parameter in actual if parameter.default is not parameter.empty]
                self.assertEqual(values, defaults, node.name)
                compared += 1
        self.assertGreater(compared, 15)


if __name__ == "__main__":
    unittest.main()
