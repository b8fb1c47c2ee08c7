#!/usr/bin/env bash
# All that only a machine with a device can tell, in less than five minutes: bits, lost members, errors, members × steps per second
# with a picture, the ratio to a kernel by hand, and the share of what the card can do. NVRTC comes with the CUDA toolkit, or
# with `pip install nvidia-cuda-nvrtc-cu12`; then its folder `lib` belongs into LD_LIBRARY_PATH.
set -euo pipefail
cd "$(dirname "$0")"
# A device has the bits of this instruction set.
export INTEGRATOR_ISA=avx2
exec cargo test --locked --release --test on_device -- --nocapture --test-threads 1
