#!/usr/bin/env bash
# What only a machine with a device can tell: bits, lost members, speed. NVRTC comes with the CUDA toolkit, or with
# `pip install nvidia-cuda-nvrtc-cu12`; then its folder `lib` belongs into LD_LIBRARY_PATH.
set -euo pipefail
cd "$(dirname "$0")"
# A device has the bits of this instruction set.
export INTEGRATOR_ISA=avx2
exec cargo test --locked --release --test on_device -- --nocapture --test-threads 1
