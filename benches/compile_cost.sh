#!/usr/bin/env bash
# What it costs to compile a user's crate, for each system and each capability of benches/compile_cost.
#
#   benches/compile_cost.sh [SYSTEM [CAPABILITY]]  CPU seconds of rustc in release, and lines of LLVM IR before optimisation
#   benches/compile_cost.sh --lines                lines alone, compared with benches/compile_cost.csv
#
# Lines depend on neither the machine nor its load. For them, one crate has all capabilities of a system that want the same
# arguments of the annotation, and the lines of a capability are those of all functions that it reaches. So they equal the lines of
# a crate of that capability alone, and what several capabilities reach is compiled once.
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
systems=$(cut -d, -f1 "$kept" | grep -vx 'system\|bound')
# Whether a system has a cell of a capability.
supports() {
    awk -F, -v system_name="$1" -v name="$2" '
        NR == 1 { for (i = 2; i <= NF; i++) if ($i == name) column = i }
        $1 == system_name && $column != "" { found = 1 }
        END { exit !found }
    ' "$kept"
}

# The arguments that a capability adds to the annotation; its first line may name them.
arguments_of() {
    sed -n '1s|^// Arguments of the annotation: ||p' "$parts/capabilities/$1.rs"
}

# Writes a crate that uses capabilities of a system, which add the same arguments to the annotation: a module per capability.
# PARAMETER in the arguments is the first field that is a number.
write_crate() {
    local crate=$1 system=$2 capability arguments
    shift 2
    rm -rf "$crate"
    mkdir -p "$crate"
    arguments=$(arguments_of "$1")
    arguments=${arguments//PARAMETER/$(sed -n 's/^ *pub \([a-z]*\): f64,$/\1/p' "$parts/systems/$system.rs" | head -1)}
    {
        sed "${arguments:+s/^#\[hamiltonian(/&$arguments, /; s/^#\[hamiltonian]/#[hamiltonian($arguments)]/}" "$parts/systems/$system.rs"
        for capability in "$@"; do
            echo "mod $capability {"
            echo "    use super::*;"
            cat "$parts/capabilities/$capability.rs"
            echo "}"
        done
        echo "fn main() -> Result<(), Box<dyn std::error::Error>> {"
        printf '    %s::perform()?;\n' "$@"
        echo "    Ok(())"
        echo "}"
    } > "$crate/main.rs"
}

# Compiles such a crate as cargo does in release, with more flags.
compile() {
    local crate=$1
    shift
    rustc --crate-name user --edition 2024 --cap-lints allow -C opt-level=3 -L dependency="$target/release/deps" \
        --extern integrator_core="$target/release/libintegrator_core.rlib" --out-dir "$crate" "$crate/main.rs" "$@"
}

# Writes the lines of each capability of a crate to its file `lines`.
count() {
    local crate=$1
    shift
    compile "$crate" --emit=llvm-ir -C no-prepopulate-passes -C codegen-units=1 -C symbol-mangling-version=v0
    awk -v capabilities="$*" -f "$parts/reached.awk" "$crate/user.ll" > "$crate/lines"
    rm "$crate/user.ll"
}

cd "$root"
# With the features that users have by default: others add lines, `checkpoint` some 2,000 to an ensemble.
cargo build --release --quiet -p integrator-core

if [ "${1:-}" != --lines ]; then
    TIMEFORMAT='%U %S'
    printf '%-14s %-14s %8s %8s\n' capability system seconds lines
    for capability in ${2:-$capabilities}; do
        for system in ${1:-$systems}; do
            if ! supports "$system" "$capability"; then continue; fi
            write_crate "$built/one" "$system" "$capability"
            seconds=$({ time compile "$built/one" >&2; } 2>&1 | tail -1 | awk '{ print $1 + $2 }')
            count "$built/one" "$capability"
            printf '%-14s %-14s %8.1f %8d\n' "$capability" "$system" "$seconds" "$(cut -d' ' -f2 "$built/one/lines")"
        done
    done
    exit
fi

# All crates, as many at a time as there are processors.
running=0
rm -rf "$built"
for system in $systems; do
    for arguments in $(for capability in $capabilities; do arguments_of "$capability"; done | sort -u) ""; do
        cells=()
        for capability in $capabilities; do
            if [ "$(arguments_of "$capability")" = "$arguments" ] && supports "$system" "$capability"; then cells+=("$capability"); fi
        done
        if [ ${#cells[@]} = 0 ]; then continue; fi
        crate=$built/$system-${cells[0]}
        write_crate "$crate" "$system" "${cells[@]}"
        count "$crate" "${cells[@]}" &
        running=$((running + 1))
        if [ "$running" -ge "$(nproc)" ]; then
            wait -n
            running=$((running - 1))
        fi
    done
done
for ((; running > 0; running--)); do wait -n; done

status=0
for system in $systems; do
    sed "s/^/$system /" "$built/$system"-*/lines
done | awk -v small="$small" -v blessed="${BLESS:-}" -v output="$built/compile_cost.csv" -f "$parts/compared.awk" "$kept" - >&2 || status=$?
column -s, -t "$built/compile_cost.csv"
if [ -n "${BLESS:-}" ]; then cp "$built/compile_cost.csv" "$kept"; fi
exit $status
