#!/usr/bin/env bash
# What it costs to compile a user's crate, for each system and each capability of benches/compile_cost.
#
#   benches/compile_cost.sh [SYSTEM [CAPABILITY]]  CPU seconds of rustc in release, and lines of LLVM IR before optimisation
#   benches/compile_cost.sh --lines                lines alone, compared with benches/compile_cost.csv
#
# Lines depend on neither the machine nor its load. For them, one crate per capability has all systems, and the lines of a system
# are those of all functions that its module reaches. So they equal the lines of a crate of that system alone.
# It is an error if a cell grows by more than 2 %; .ci/bless costs stores new numbers. It is also an error if a capability adds
# more lines to the run of a small system than the row `bound` allows, or if that run has more lines than its bound. People alone
# change the row `bound`. A system does not support a capability whose cell is empty.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
parts=$root/benches/compile_cost
kept=$root/benches/compile_cost.csv
target=${CARGO_TARGET_DIR:-$root/target}
built=$target/compile_cost
small="pendulum halo"

capabilities=$(head -1 "$kept" | cut -d, -f2- | tr , ' ')
# The systems that have a cell of a capability.
systems_of() {
    awk -F, -v name="$1" '
        NR == 1 { for (i = 2; i <= NF; i++) if ($i == name) column = i; next }
        $1 != "bound" && $column != "" { print $1 }
    ' "$kept"
}

# Writes a crate that uses a capability for systems: a module per system, which ends in the function of the capability.
# The first line of a capability may add arguments to the annotation, for which PARAMETER is the first field that is a number.
write_crate() {
    local crate=$1 capability=$2 system arguments
    shift 2
    rm -rf "$crate"
    mkdir -p "$crate"
    for system in "$@"; do
        echo "mod $system;"
    done > "$crate/main.rs"
    {
        echo "fn main() -> Result<(), Box<dyn std::error::Error>> {"
        printf '    %s::perform()?;\n' "$@"
        echo "    Ok(())"
        echo "}"
    } >> "$crate/main.rs"
    for system in "$@"; do
        arguments=$(sed -n '1s|^// Arguments of the annotation: ||p' "$parts/capabilities/$capability.rs")
        arguments=${arguments//PARAMETER/$(sed -n 's/^ *pub \([a-z]*\): f64,$/\1/p' "$parts/systems/$system.rs" | head -1)}
        cat "$parts/systems/$system.rs" "$parts/capabilities/$capability.rs" |
            sed "${arguments:+s/^#\[hamiltonian(/&$arguments, /; s/^#\[hamiltonian]/#[hamiltonian($arguments)]/}" > "$crate/$system.rs"
    done
}

# Compiles such a crate as cargo does in release, with more flags.
compile() {
    local crate=$1
    shift
    rustc --crate-name user --edition 2024 --cap-lints allow -C opt-level=3 -L dependency="$target/release/deps" \
        --extern integrator_core="$target/release/libintegrator_core.rlib" --out-dir "$crate" "$crate/main.rs" "$@"
}

# Writes the lines of each system of a crate to its file `lines`.
count() {
    local crate=$1
    shift
    compile "$crate" --emit=llvm-ir -C no-prepopulate-passes -C codegen-units=1 -C symbol-mangling-version=v0
    awk -v systems="$*" -f "$parts/reached.awk" "$crate/user.ll" > "$crate/lines"
    rm "$crate/user.ll"
}

cd "$root"
cargo build --release --quiet -p integrator-core

if [ "${1:-}" != --lines ]; then
    TIMEFORMAT='%U %S'
    printf '%-14s %-14s %8s %8s\n' capability system seconds lines
    for capability in ${2:-$capabilities}; do
        for system in $(systems_of "$capability" | grep -x "${1:-.*}" || true); do
            write_crate "$built/one" "$capability" "$system"
            seconds=$({ time compile "$built/one" >&2; } 2>&1 | tail -1 | awk '{ print $1 + $2 }')
            count "$built/one" "$system"
            printf '%-14s %-14s %8.1f %8d\n' "$capability" "$system" "$seconds" "$(cut -d' ' -f2 "$built/one/lines")"
        done
    done
    exit
fi

# All crates, as many at a time as there are processors.
running=0
for capability in $capabilities; do
    mapfile -t systems < <(systems_of "$capability")
    write_crate "$built/$capability" "$capability" "${systems[@]}"
    count "$built/$capability" "${systems[@]}" &
    running=$((running + 1))
    if [ "$running" -ge "$(nproc)" ]; then
        wait -n
        running=$((running - 1))
    fi
done
wait

status=0
for capability in $capabilities; do
    sed "s/^/$capability /" "$built/$capability/lines"
done | awk -v small="$small" -v blessed="${BLESS:-}" -v output="$built/compile_cost.csv" -f "$parts/compared.awk" "$kept" - >&2 || status=$?
column -s, -t "$built/compile_cost.csv"
if [ -n "${BLESS:-}" ]; then cp "$built/compile_cost.csv" "$kept"; fi
exit $status
