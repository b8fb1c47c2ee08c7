// Letters that differ at the two ends do not merge.
composition! {
    crate = my::runtime;
    struct Ruth3 = V(7/24) T(2/3) V(3/4) T(-2/3) V(-1/24) T(1);
}
