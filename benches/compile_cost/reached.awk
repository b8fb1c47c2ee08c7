# Reads LLVM IR of a crate that has a module for each of `capabilities`, and prints for each how many lines have the functions that its
# `perform` reaches, through calls, tables of methods and addresses. Symbols are mangled as v0.
BEGIN { split(capabilities, modules, " ") }
/^define / || /^@/ {
    match($0, /@[^ (]+/)
    symbol = substr($0, RSTART + 1, RLENGTH - 1)
    is_global = /^@/
    is_inside = 1
    for (i in modules) {
        if (symbol ~ "^_RNvNtCs[0-9A-Za-z]+_4user" length(modules[i]) modules[i] "7perform$") root[i] = symbol
    }
}
is_inside {
    if (!is_global) lines[symbol]++
    rest = $0
    while (match(rest, /@[A-Za-z0-9_.$]+/)) {
        other = substr(rest, RSTART + 1, RLENGTH - 1)
        rest = substr(rest, RSTART + RLENGTH)
        if (!((symbol, other) in seen)) {
            seen[symbol, other] = 1
            named[symbol] = named[symbol] " " other
        }
    }
}
/^}/ || is_global { is_inside = 0 }
END {
    for (i in modules) {
        if (!(i in root)) continue
        total = 0
        split("", reached)
        reached[root[i]] = 1
        waiting[1] = root[i]
        for (last = 1; last > 0;) {
            symbol = waiting[last--]
            total += lines[symbol]
            count = split(named[symbol], others, " ")
            for (k = 1; k <= count; k++) {
                if (!(others[k] in reached)) {
                    reached[others[k]] = 1
                    waiting[++last] = others[k]
                }
            }
        }
        print modules[i], total
    }
}
