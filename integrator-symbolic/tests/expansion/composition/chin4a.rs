// Gradient kicks bring their own kick.
composition! {
    pub struct Chin4A: order 4 = V(1/6) T(1/2) V(2/3, -1/72) T(1/2) V(1/6);
}
