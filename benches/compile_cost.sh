#!/usr/bin/env bash
# What systems cost to compile: a crate of a user's with one system, rebuilt in release with the library built before. For
# each system of benches/compile_cost and each use of it: CPU seconds of cargo and rustc, and lines of LLVM IR before any
# optimisation, which no other load on the machine changes. More than 2 % more lines than benches/compile_cost.csv has is an
# error; .ci/bless costs writes that file. With --lines, nothing is optimised and no seconds are taken.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
crate=$root/target/compile_cost
kept=$root/benches/compile_cost.csv
seconds=true
if [ "${1:-}" = --lines ]; then seconds=false; fi

mkdir -p "$crate/src"
cp "$root"/benches/compile_cost/*.rs "$crate/src"
cp "$root/Cargo.lock" "$root/rust-toolchain.toml" "$crate"
cat > "$crate/Cargo.toml" << END
[package]
name = "user"
version = "0.0.0"
edition = "2024"

[features]
pendulum = []
chain = []
bodies = []
planets = []
orbits = []
oscillators = []
liquid = []
molecule = []
run = []
certify = []
ensemble = []
taylor = []
five = []

[dependencies]
integrator-core = { path = "$root/integrator-core" }

[workspace]
END
unset CARGO_TARGET_DIR
cd "$crate"

# The CPU seconds of a build of the user's crate alone.
cpu() {
    local TIMEFORMAT='%U %S'
    { time cargo rustc --release --quiet --features "$1" >&2; } 2>&1 | tail -1 | awk '{ print $1 + $2 }'
}

rows=target/compile_cost.csv
mkdir -p target
echo system,use,lines > "$rows"
failed=0
printf '%-12s %-10s %10s %10s %10s\n' system use seconds lines kept
uses() {
    case $1 in
        planets | orbits) echo run ensemble five ;;
        oscillators | liquid | molecule) echo run five ;;
        *) echo run certify ensemble taylor five ;;
    esac
}
for system in pendulum chain bodies planets orbits oscillators liquid molecule; do
    for use in $(uses "$system"); do
        taken=-
        if $seconds; then
            cargo build --release --quiet --features "$system,$use"
            touch src/main.rs
            taken=$(cpu "$system,$use")
        fi
        rm -f target/release/deps/user-*.ll
        touch src/main.rs
        cargo rustc --release --quiet --features "$system,$use" -- --emit=llvm-ir -C no-prepopulate-passes -C codegen-units=1
        lines=$(cat target/release/deps/user-*.ll | wc -l)
        before=$(awk -F, -v row="$system,$use" '$1 "," $2 == row { print $3 }' "$kept")
        printf '%-12s %-10s %10s %10s %10s\n' "$system" "$use" "$taken" "$lines" "${before:--}"
        echo "$system,$use,$lines" >> "$rows"
        if [ -z "$before" ] || awk "BEGIN { exit !($lines > 1.02 * $before) }"; then failed=1; fi
    done
done
if [ -n "${BLESS:-}" ]; then
    cp "$rows" "$kept"
elif [ $failed = 1 ]; then
    echo "Some uses take over 2 % more lines of LLVM IR than $kept has. If that is meant: .ci/bless costs" >&2
    exit 1
fi
