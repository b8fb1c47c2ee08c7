# Reads the table that is kept, then lines of `system capability lines`, writes the new table to `output`, and prints as errors which cells
# are missing, and which have grown, unless the new table is to be kept (`blessed`). The status is 1 if there is an error.
BEGIN { FS = ","; split(small, smalls, " ") }
function grown(what, at_most) {
    print "error: " what ", where " at_most
    failed = 1
}
FNR == NR {
    text[++rows] = $0
    if (FNR == 1) {
        columns = NF
        for (column = 2; column <= NF; column++) capabilities[column] = $column
    }
    for (column = 2; column <= NF; column++) kept[$1, capabilities[column]] = $column
    next
}
{
    split($0, cell, " ")
    lines[cell[1], cell[2]] = cell[3]
}
END {
    for (row = 1; row <= rows; row++) {
        split(text[row], cells, ",")
        system_name = cells[1]
        if (row == 1 || system_name == "bound") {
            print text[row] > output
            continue
        }
        line = system_name
        for (column = 2; column <= columns; column++) {
            now = lines[system_name, capabilities[column]]
            before = kept[system_name, capabilities[column]]
            line = line "," now
            if (now == "" && before != "") {
                print "error: " system_name ", " capabilities[column] " has no lines of LLVM IR"
                failed = 1
            }
            if (!blessed && now > 1.02 * before) {
                grown(system_name ", " capabilities[column] ": " now " lines of LLVM IR", before " are kept (if that is meant: .ci/bless costs)")
            }
        }
        print line > output
    }
    for (column = 2; column <= columns; column++) {
        capability = capabilities[column]
        for (i in smalls) {
            now = lines[smalls[i], capability]
            added = capability == "run" ? now : now - lines[smalls[i], "run"]
            if (now != "" && added > kept["bound", capability]) {
                over = capability == "run" ? "" : " over its run"
                grown(smalls[i] ", " capability ": " added " lines of LLVM IR" over, kept["bound", capability] " are allowed (row `bound`)")
            }
        }
    }
    exit failed
}
