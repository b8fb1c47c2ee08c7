"""The programs of the guide's page on Python, one after the other, in a folder of their own."""

import contextlib
import importlib.util
import io
import os
import pathlib
import re
import tempfile
import unittest

PAGE = pathlib.Path(__file__).parents[2] / "docs/guide/src/python.md"


class Guide(unittest.TestCase):
    def test_programs_run(self):
        names, skipped = {}, []
        programs = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(), flags=re.MULTILINE | re.DOTALL)
        self.assertEqual(len(programs), 5)
        here = os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            self.addCleanup(os.chdir, here)
            os.environ["MPLBACKEND"] = "Agg"
            for program in programs:
                wanted = re.findall(r"^(?:import|from) (\w+)", program, flags=re.MULTILINE)
                missing = [name for name in wanted if not importlib.util.find_spec(name)]
                if missing:
                    skipped += missing
                    continue
                with contextlib.redirect_stdout(io.StringIO()):
                    exec(program, names)
        # What the first two programs computed. Energies of compensated steps have their own roundings.
        self.assertLess(names["np"].ptp(names["samples"].energy), 1e3 * 2.0**-53)
        self.assertEqual(names["megno"].shape, (100,))
        if skipped:
            print(f"SKIPPED: {', '.join(skipped)} are not installed, so that their programs in the guide did not run")


if __name__ == "__main__":
    unittest.main()
