"""Runs and ensembles: arrays, bits, failures, interrupts."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest

import galaxy
import numpy as np

Q, P, H = [1.0, 0.0, 0.0], [0.0, 0.6, 0.4], 0.01
SYSTEM = galaxy.Galaxy(core=0.1, flattening=0.8)
SUN = galaxy.Bodies(mass=np.array([1.0, 1e-3]))
# A circular orbit of two bodies.
SUN_Q, SUN_P = [[0, 0], [1, 0]], [[0, -1e-3], [0, 1e-3]]


def same_bits(a, b):
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()


class Bits(unittest.TestCase):
    def test_samples_are_those_of_rust(self):
        run = SYSTEM.run(Q, P, H, composition="KahanLi8", scalar="compensated")
        t, q, p, energy, invariants = run.samples(200, every=7)
        ours = [t, q.ravel(), p.ravel(), energy]
        for column, expected in zip(ours, SYSTEM.in_rust(Q, P, H, 200, 7)):
            self.assertTrue(same_bits(column, np.array(expected)))
        self.assertEqual((q.shape, p.shape, t.shape), ((200, 3), (200, 3), (200,)))
        # Compensated steps leave the roundings of the two products and their difference.
        np.testing.assert_allclose(invariants["angular_momentum"], 0.6, rtol=1e3 * 2.0**-53)
        # Compensation counts: a plain run differs.
        plain = SYSTEM.run(Q, P, H, composition="KahanLi8").samples(200, every=7)
        self.assertFalse(same_bits(plain.q, q))

    def test_many_steps_between_samples_are_the_same_steps(self):
        one, other = SYSTEM.run(Q, P, H), SYSTEM.run(Q, P, H)
        samples = one.samples(3, every=1000)
        other.advance(700)
        other.advance(300)
        self.assertTrue(same_bits(samples.q[1], other.q) and same_bits(samples.p[1], other.p))
        self.assertEqual((one.steps, one.time, samples.t[1]), (2000, 20.0, other.time))

    def test_members_are_runs(self):
        q, p = np.array(Q) + np.linspace(0, 1, 11)[:, None] * [1, 0, 0], np.tile(P, (11, 1))
        cores = np.linspace(0.1, 0.3, 11)
        swarm = SYSTEM.ensemble(q, p, H, composition="Yoshida4", core=cores)
        swarm.advance(300)
        for member in [0, 4, 10]:
            run = SYSTEM.replace(core=cores[member]).run(q[member], p[member], H, composition="Yoshida4")
            run.advance(300)
            self.assertTrue(same_bits(swarm.q[member], run.q) and same_bits(swarm.p[member], run.p))
            self.assertEqual(swarm.energy[member], run.energy)
            self.assertTrue(same_bits(swarm.run_of(member).q, run.q))
        self.assertEqual((len(swarm), swarm.active, swarm.steps, swarm.time), (11, 11, 300, 3.0))
        self.assertTrue(same_bits(swarm.steps_of_members, np.full(11, 300, dtype=np.uint64)))

    def test_the_arrays_of_a_state_are_copies(self):
        run = SYSTEM.run(Q, P, H)
        run.q[0] = 7.0
        self.assertEqual(run.q[0], 1.0)


class Arrays(unittest.TestCase):
    def test_points_have_two_axes(self):
        run = SUN.run(SUN_Q, SUN_P, H)
        self.assertEqual(run.q.shape, (2, 2))
        self.assertEqual(run.samples(5).q.shape, (5, 2, 2))
        swarm = SUN.ensemble(np.tile(SUN_Q, (3, 1, 1)), np.tile(SUN_P, (3, 1, 1)), H)
        self.assertEqual(swarm.q.shape, (3, 2, 2))

    def test_numbers_in_any_order_and_type_are_the_same_numbers(self):
        q, p = np.random.default_rng(1).uniform(0.5, 1.5, (2, 4, 3))
        expected = SYSTEM.ensemble(q, p, H).q
        strided = np.zeros((4, 6))
        strided[:, ::2] = q
        for other in [np.asfortranarray(q), strided[:, ::2], q.astype(">f8"), q.tolist(), q[::-1][::-1]]:
            self.assertTrue(same_bits(SYSTEM.ensemble(other, p, H).q, expected))
        whole = SYSTEM.run(np.array([1, 2, 3], dtype=np.int32), np.array(P, dtype=np.float32), H)
        self.assertTrue(same_bits(whole.q, np.array([1.0, 2.0, 3.0])))

    def test_wrong_arrays_say_what_is_expected(self):
        ones = np.ones
        for call, parts in [
            (lambda: SYSTEM.run([1, 0], P, H), ["q has the shape (2,): expected (3,)"]),
            (lambda: SYSTEM.run(Q, 1.0, H), ["p has the shape (): expected (3,)"]),
            (lambda: SYSTEM.run([Q], [P], H), ["(1, 3): expected (3,)", "`ensemble`"]),
            (lambda: SYSTEM.ensemble(Q, P, H), ["(3,): expected (n, 3)", "`q[None]`"]),
            (lambda: SYSTEM.ensemble(ones((3, 9)), ones((3, 9)), H), ["(3, 9): expected (n, 3)", "`q.T`"]),
            (lambda: SYSTEM.ensemble(ones((9, 3)), ones((8, 3)), H), ["q has 9 rows, but p has 8"]),
            (lambda: SUN.run(ones((2, 3)), ones((2, 3)), H), ["(2, 3): expected (N, 2)"]),
            (lambda: SUN.ensemble(ones((2, 3)), ones((2, 3)), H), ["(2, 3): expected (n, N, 2)"]),
            (lambda: SYSTEM.run([1j, 0, 0], P, H), ["dtype complex128: expected real numbers"]),
            (lambda: SYSTEM.run(["a", 0, 0], P, H), ["expected real numbers"]),
            (lambda: SYSTEM.run([True, False, True], P, H), ["dtype bool: expected real numbers"]),
            (lambda: SYSTEM.run([1, [0], 0], P, H), ["q is not an array: expected numbers of shape (3,)"]),
            (lambda: SYSTEM.ensemble(np.empty((0, 3)), np.empty((0, 3)), H), ["at least one member"]),
        ]:
            with self.assertRaises(galaxy.InputError) as caught:
                call()
            for part in parts:
                self.assertIn(part, str(caught.exception))
        self.assertTrue(issubclass(galaxy.InputError, ValueError))


class Failures(unittest.TestCase):
    def test_messages_of_the_library_are_exceptions(self):
        for call, error, part in [
            (lambda: SYSTEM.run([np.nan, 0, 0], P, H), galaxy.InputError, "q[0] is NaN"),
            (lambda: SYSTEM.run(Q, P, 0.0), galaxy.InputError, "the step h has to be finite and not zero"),
            (lambda: SYSTEM.run(Q, P, H).samples(3, every=0), galaxy.InputError, "the interval between samples is 0"),
            (lambda: SYSTEM.run(Q, P, H, composition="KahanLi9"), galaxy.InputError, "help: write `KahanLi8`"),
            (lambda: SYSTEM.run(Q, P, H, scalar="f46"), galaxy.InputError, "help: write `f64`"),
            (lambda: SYSTEM.run(Q, P, H).advance(-5), galaxy.InputError, "is -5: expected an integer"),
            (lambda: SYSTEM.run(Q, P, H).samples(1.5), galaxy.InputError, "is 1.5: expected an integer"),
            (lambda: SYSTEM.run(Q, P, H).invariant("energy"), galaxy.InputError, "angular_momentum"),
            (lambda: SYSTEM.run(Q, P, H).watch_energy(-1.0), galaxy.InputError, "has to be positive"),
            (lambda: SYSTEM.run(Q, P, H).advance_to(-1.0), galaxy.InputError, "lead away"),
            (lambda: SYSTEM.ensemble([Q], [P], H).run_of(1), galaxy.InputError, "member 1 is not active"),
            (lambda: SYSTEM.ensemble([Q, Q], [P, P], H, core=[0.1]), galaxy.InputError, "expected one for each of 2"),
            (lambda: SYSTEM.certify(Q, P, 5.0), galaxy.RunError, "no certificate for"),
        ]:
            with self.assertRaises(error) as caught:
                call()
            self.assertIn(part, str(caught.exception))

    def test_a_run_that_fails_keeps_its_last_state_and_its_samples(self):
        # The second step is beyond the largest double.
        run = SYSTEM.run(Q, [0, 0, 1e150], 1e158)
        with self.assertRaises(galaxy.RunError) as caught:
            run.samples(1000)
        samples = caught.exception.samples
        self.assertEqual(len(samples.t), run.steps + 1)
        self.assertTrue(np.isfinite(run.q).all() and np.isfinite(samples.q).all())
        self.assertTrue(same_bits(samples.q[-1], run.q))
        before = run.q
        with self.assertRaises(galaxy.RunError):
            run.advance(10)
        self.assertTrue(same_bits(run.q, before))

    def test_members_that_fail_are_listed_and_the_others_go_on(self):
        # Steps of a hundredth are short for the outer orbits, whose periods are thousands.
        q, p = [[1e3, 0, 0], Q, [1e3, 0, 0]], [[0, 1, 0], P, [0, 1, 0]]
        swarm = SYSTEM.ensemble(q, p, H, composition="Verlet")
        swarm.watch_energy(1e-7)
        with self.assertRaises(galaxy.RunError) as caught:
            swarm.advance(1000)
        self.assertEqual([member for member, _ in caught.exception.members], [1])
        self.assertIn("deviates", caught.exception.members[0][1])
        self.assertEqual((swarm.active, swarm.steps), (2, 1000))
        self.assertLess(swarm.steps_of_members[1], 1000)
        self.assertTrue(np.isfinite(swarm.q).all())

    def test_an_energy_that_strays_stops_the_run(self):
        run = SYSTEM.run(Q, P, 0.5, composition="Verlet")
        run.watch_energy(1e-6)
        with self.assertRaises(galaxy.RunError):
            run.advance(1000)
        self.assertLess(run.steps, 1000)


class Noise(unittest.TestCase):
    def test_a_seed_determines_the_path(self):
        bath = galaxy.Bath(temperature=0.5)

        def end(seed, composition=None):
            run = bath.run([1.0], [0.0], 0.1, composition=composition, seed=seed)
            run.advance(100)
            return run.q[0]

        self.assertEqual(end(7), end(7))
        self.assertEqual(len({end(0), end(7), end(8), end(7, "Obabo")}), 4)
        swarm = bath.ensemble([[1.0]] * 20, [[0.0]] * 20, 0.1, seed=7)
        swarm.advance(100)
        self.assertEqual(swarm.q[0, 0], end(7))
        self.assertEqual(len(set(swarm.q[:, 0])), 20)

    def test_the_mean_square_is_the_temperature(self):
        swarm = galaxy.Bath(temperature=0.5).ensemble(np.zeros((4000, 1)), np.zeros((4000, 1)), 0.2, seed=1)
        swarm.advance(100)
        # The mean of the squares of n normal numbers deviates by sqrt(2 / n) of itself; Baoab has no bias in q.
        self.assertLess(abs(np.mean(swarm.q**2) / 0.5 - 1.0), 5.0 * (2.0 / 4000) ** 0.5)

    def test_compositions_without_friction_are_not_listed(self):
        self.assertEqual(galaxy.Bath(temperature=0.5).compositions, ["Baoab", "Obabo"])


def interrupted_after(seconds):
    """Sends Ctrl-C to this process."""
    timer = threading.Timer(seconds, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    return timer


# A minute of steps: where Ctrl-C has no effect, a test ends and fails.
MANY = 5 * 10**7


class Interrupts(unittest.TestCase):
    def setUp(self):
        # Jobs in the background of a shell ignore Ctrl-C, and Python leaves it so.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)

    def interrupt(self, call):
        timer = interrupted_after(0.3)
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt) as caught:
            call()
        timer.join()
        # Checks are 50 to 200 ms apart; calls that nothing stops take a minute.
        self.assertLess(time.monotonic() - begin, 20.0)
        return caught.exception

    def test_ctrl_c_stops_a_run_after_a_whole_step(self):
        run, other = SYSTEM.run(Q, P, H), SYSTEM.run(Q, P, H)
        self.interrupt(lambda: run.advance(MANY))
        self.assertGreater(run.steps, 0)
        other.advance(run.steps)
        self.assertTrue(same_bits(run.q, other.q))

    def test_ctrl_c_stops_all_members_after_the_same_step(self):
        swarm = SYSTEM.ensemble([Q] * 20, [P] * 20, H)
        self.interrupt(lambda: swarm.advance(MANY))
        self.assertGreater(swarm.steps, 0)
        self.assertTrue((swarm.steps_of_members == swarm.steps).all())
        swarm.advance(10)

    def test_ctrl_c_keeps_the_samples(self):
        # Signals are looked for between samples; only after the steps before a sample; and within these steps.
        for count, every in [(10**7, 1), (10**6, 300), (100, 10**6)]:
            run = SYSTEM.run(Q, P, H)
            samples = self.interrupt(lambda: run.samples(count, every=every)).samples
            self.assertGreater(len(samples.t), 0)
            self.assertTrue((samples.t == 0.01 * every * np.arange(len(samples.t))).all())

    def test_ctrl_c_stops_crossings_and_maps(self):
        run = SYSTEM.run(Q, P, H)
        self.interrupt(lambda: run.crossings("q[0] - 1e9", steps=MANY))
        self.interrupt(lambda: run.crossings(lambda q, p, t: q[0] - 1e9, steps=MANY))
        self.interrupt(lambda: SYSTEM.chaos_map([Q] * 8, [P] * 8, H, 10**7))

    def test_other_threads_run_meanwhile(self):
        run, counted, goes_on = SYSTEM.run(Q, P, H), [0], [True]

        def count():
            while goes_on[0]:
                counted[0] += 1
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = counted[0]
        self.interrupt(lambda: run.advance(MANY))
        after = counted[0]
        goes_on[0] = False
        thread.join()
        # 300 in 0.3 s; without the GIL released it would count once for each check of signals.
        self.assertGreater(after - before, 30)

    def test_progress_is_a_bar_on_stderr(self):
        program = (
            "import galaxy; galaxy.Rotor().run([1.0], [0.0], 0.1).advance(1000, progress=True);"
            "galaxy.Rotor().ensemble([[1.0]], [[0.0]], 0.1).advance(1000, progress=True)"
        )
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "")
        self.assertEqual(done.stderr.count("[" + "#" * 30 + "] 100 %"), 2)


class Pickles(unittest.TestCase):
    def test_systems_can_be_sent_to_other_processes(self):
        for system in [SYSTEM, SUN, galaxy.Rotor()]:
            self.assertEqual(repr(pickle.loads(pickle.dumps(system))), repr(system))


if __name__ == "__main__":
    unittest.main()
