// A declaration becomes a type and its table.
composition! {
    /// Strang's splitting.
    pub struct Verlet: order 2, symmetric = T(1/2) V(1) T(1/2);
}
