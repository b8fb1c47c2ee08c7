// A processor runs once and shifts the times of its kernel.
composition! {
    struct Shifted = processed(V(1/4) T(1/2); T(1/2) V(1) T(1/2));
}
