#!/usr/bin/env bash
# Runs the benches. Their tables go to docs/contributing/performance-notes.md and benches/results, their pictures to docs/pictures.
# The README, docs/performance.md, the guide and paper.md quote these figures; tests/readme.rs compares them.
# With names of benches as arguments, it runs only these. On a quiet machine it takes some ten minutes, most of them to compile.
set -euo pipefail
cd "$(dirname "$0")/.."
page=docs/contributing/performance-notes.md
mkdir -p docs/pictures target/bench

# Puts a file between the markers of its name.
fill() {
    awk -v name="$1" -v file="$2" '
        index($0, "<!-- " name ": end -->") { inside = 0 }
        !inside { print }
        index($0, "<!-- " name ": begin -->") {
            inside = 1
            print "```text"
            while ((getline line < file) > 0) print line
            print "```"
        }
    ' "$page" > target/bench/page.md
    cp target/bench/page.md "$page"
}

if [ $# -eq 0 ]; then
    set -- step throughput work_precision taylor skips
fi
for bench in "$@"; do
    output=target/bench/$bench.txt
    cargo bench -p integrator-bench --features report --bench "$bench" > "$output"
    # Every run of every method is in target/bench/work_precision.csv and taylor.csv; the page has the fastest.
    sed -i -e '/^problem  *method/,/^$/d' -e '/^ratio_\|^rate_\|^speedup_\|^time_ms_/d' "$output"
    fill "$bench" "$output"
    if [ -e "benches/results/$bench.csv" ]; then cp "target/bench/$bench.csv" benches/results/; fi
done
# Of the benches that have run.
for picture in target/bench/{step,throughput,skips,pace,liquid,work_precision_*_energy}.svg; do
    if [ -e "$picture" ]; then cp "$picture" docs/pictures/; fi
done
