#!/usr/bin/env bash
# Builds the module of the tests, and runs them in Python with NumPy. Python packages are installed in target/python; where that
# is impossible, it says so and ends well. `on_python.sh speed` compares the speed with that of Rust instead.
set -euo pipefail
cd "$(dirname "$0")"

environment=$PWD/target/python
python=$environment/bin/python
if ! { [ -x "$python" ] || python3 -m venv "$environment"; } ||
    ! "$python" -m pip install --quiet --disable-pip-version-check "maturin>=1.7,<2" numpy; then
    echo "SKIPPED: Python, maturin or NumPy cannot be installed, so that no module was built and tested"
    exit 0
fi

export VIRTUAL_ENV=$environment
profile=()
if [ "${1-}" = speed ]; then profile=(--release); fi
(cd tests/galaxy && "$environment/bin/maturin" develop --quiet --locked "${profile[@]}")
if [ "${1-}" = speed ]; then
    "$python" tests/speed.py
else
    "$python" -W error -m unittest discover --start-directory tests
fi
