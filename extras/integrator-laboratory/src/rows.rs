//! The description of each method on the page, one row each, and its colour in all pictures.

use integrator_plot::{Colour, colour::COLOURS};

/// The description of a method on the page.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    pub(crate) name: &'static str,
    /// In the notation of `formula.rs`: `z` is `(q, p)`, `f` its derivative, `a` that of velocities, `S` a step.
    pub(crate) formula: &'static str,
    /// A sentence that describes the method.
    pub(crate) says: &'static str,
    /// The colour of all its curves.
    pub(crate) colour: Colour,
    /// Whether the page requests the longest steps that it can take.
    pub(crate) limit: bool,
}

/// Returns the colour of a method on all pages, for pictures of your own, or `None` for a method that is not on the
/// pages.
#[must_use]
pub fn colour(method: &str) -> Option<Colour> {
    ROWS.iter().find(|row| row.name == method).map(|row| row.colour)
}

macro_rules! rows {
    ($($row:ident $name:literal $colour:expr, $limit:literal, $formula:literal, $says:literal;)*) => {
        $(pub(crate) const $row: Row =
            Row { name: $name, formula: $formula, says: $says, colour: $colour, limit: $limit };)*
        const ROWS: &[Row] = &[$($row),*];
    };
}
rows! {
    FORWARD_EULER "forward Euler" COLOURS[0], false,
        "z_{n+1} = z_n + h f(z_n)",
        "Follows the tangent at the start of the step: outwards on every closed orbit.";
    BACKWARD_EULER "backward Euler" COLOURS[1], false,
        "z_{n+1} = z_n + h f(z_{n+1})",
        "Follows the tangent at the end of the step: inwards on every closed orbit.";
    SYMPLECTIC_EULER "symplectic Euler" COLOURS[5], true,
        "p_{n+1} = p_n − h V'(q_n) ; q_{n+1} = q_n + h T'(p_{n+1})",
        "Kick, then drift with the new momentum: the flow of V, then that of T, each of which preserves areas.";
    LEAPFROG "leapfrog" COLOURS[7], false,
        "p_{n+1/2} = p_{n−1/2} − h V'(q_n) ; q_{n+1} = q_n + h T'(p_{n+1/2})",
        "Momenta half a step apart from positions: Verlet, read at other times.";
    VERLET "Verlet" COLOURS[6], true,
        "S_2(h) = e^{{h}/{2}T} e^{hV} e^{{h}/{2}T}",
        "Half a drift, a kick, half a drift: symplectic, and its own inverse in steps back.";
    EXPLICIT_MIDPOINT "explicit midpoint" COLOURS[2], false,
        "z_{n+1} = z_n + h f(z_n + {h}/{2} f(z_n))",
        "Order 2 like Verlet, but its energy grows.";
    IMPLICIT_MIDPOINT "implicit midpoint" COLOURS[3], true,
        "z_{n+1} = z_n + h f({z_n + z_{n+1}}/{2})",
        "Symplectic for any H without a splitting, but solves an equation in each step.";
    GAUSS_LEGENDRE_4 "Gauss–Legendre 4" Colour(120, 94, 240), true,
        "z_{n+1} = z_n + {h}/{2}(k_1 + k_2) ; k_i = f(z_n + h Σ_j a_{ij} k_j)",
        "Two stages at Gauss's nodes: the implicit midpoint rule of order 4.";
    GAUSS_LEGENDRE_6 "Gauss–Legendre 6" Colour(0, 130, 140), false,
        "z_{n+1} = z_n + {h}/{18}(5 k_1 + 8 k_2 + 5 k_3) ; k_i = f(z_n + h Σ_j a_{ij} k_j)",
        "Three stages: order 6.";
    RUNGE_KUTTA_4 "Runge–Kutta 4" COLOURS[4], true,
        "z_{n+1} = z_n + {h}/{6}(k_1 + 2 k_2 + 2 k_3 + k_4)",
        "The classical method. Its errors are small and always have the same sign.";
    ADAMS_BASHFORTH_4 "Adams–Bashforth 4" Colour(200, 150, 90), false,
        "z_{n+1} = z_n + {h}/{24}(55 f_n − 59 f_{n−1} + 37 f_{n−2} − 9 f_{n−3})",
        "Four past forces instead of stages, with one new force per step. Runge–Kutta computes the first three steps.";
    ADAMS_BASHFORTH_MOULTON_4 "Adams–Bashforth–Moulton 4" Colour(150, 150, 60), false,
        "z_{n+1}^* = z_n + {h}/{24}(55 f_n − 59 f_{n−1} + 37 f_{n−2} − 9 f_{n−3}) ; z_{n+1} = z_n + {h}/{24}(9 f_{n+1}^* + 19 f_n − 5 f_{n−1} + f_{n−2})",
        "Predicts like Adams and Bashforth, evaluates the force, corrects like Adams and Moulton, and evaluates again for later steps (PECE). Heun's method is the pair of order 2: Euler predicts, the trapezoidal rule corrects.";
    ADAMS_PEC_4 "Adams PEC 4" Colour(110, 160, 200), false,
        "z_{n+1}^* = z_n + {h}/{24}(55 f_n^* − 59 f_{n−1}^* + 37 f_{n−2}^* − 9 f_{n−3}^*) ; z_{n+1} = z_n + {h}/{24}(9 f_{n+1}^* + 19 f_n^* − 5 f_{n−1}^* + f_{n−2}^*)",
        "Later steps use the force at the predicted point: half the work, and less stable.";
    STOERMER_4 "Störmer 4" Colour(160, 0, 200), false,
        "q_{n+1} = 2 q_n − q_{n−1} + {h^2}/{12}(14 a_n − 5 a_{n−1} + 4 a_{n−2} − a_{n−3})",
        "For accelerations a(q) that do not depend on the velocity. With one acceleration instead of four it is Verlet's formula, which preserves areas. The other three raise the order to 4 and lose this property.";
    STOERMER_COWELL_4 "Störmer–Cowell 4" Colour(100, 180, 40), false,
        "q_{n+1}^* = 2 q_n − q_{n−1} + {h^2}/{12}(14 a_n − 5 a_{n−1} + 4 a_{n−2} − a_{n−3}) ; q_{n+1} = 2 q_n − q_{n−1} + {h^2}/{12}(a_{n+1}^* + 10 a_n + a_{n−1})",
        "Predicts like Störmer, corrects like Cowell, and evaluates the force after each (PECE). Cowell's formula is symmetric; with a predicted force it is not.";
    GRAGG_BULIRSCH_STOER "Gragg–Bulirsch–Stoer" Colour(220, 38, 127), false,
        "T_{jk} = T_{j,k−1} + {T_{j,k−1} − T_{j−1,k−1}}/{{(n_j/n_{j−k})}^2 − 1}",
        "Modified midpoint steps, extrapolated to step size zero: accurate in long steps, not symplectic.";
    YOSHIDA_4 "Yoshida 4" Colour(0, 90, 60), true,
        "S_4(h) = S_2(w_1 h) S_2(w_0 h) S_2(w_1 h) ; w_1 = {1}/{2 − 2^{1/3}}, w_0 = 1 − 2 w_1",
        "Three steps of Verlet, the middle one backwards in time, so that errors of third order cancel.";
    BLANES_MOAN_6 "Blanes–Moan 6" Colour(90, 90, 200), false,
        "S_6(h) = Π_i e^{a_i h T} e^{b_i h V}",
        "Drifts and kicks whose eleven coefficients were found by search.";
    KAHAN_LI_8 "Kahan–Li 8" Colour(110, 70, 30), false,
        "S_8(h) = Π_{i=1}^{17} S_2(w_i h)",
        "Seventeen steps of Verlet in symmetric order.";
    CHIN_4A "Chin 4A" Colour(230, 110, 90), false,
        "S_4(h) = e^{{h}/{6}V} e^{{h}/{2}T} e^{{2h}/{3}U} e^{{h}/{2}T} e^{{h}/{6}V} ; U = V − {h^2}/{48} (V')^2",
        "A force gradient in the middle kick: order 4 with forward steps only, where Yoshida has to step back.";
    DORMAND_PRINCE_5 "Dormand–Prince 5" Colour(0, 60, 220), false,
        "e_n = h Σ_i (b_i − b_i^*) k_i ; h_{n+1} = h {{tolerance}/{|e_n|}}^{1/5}",
        "Adaptive Runge–Kutta: a pair of orders 5 and 4 shares its stages, and their difference estimates the error, from which the next step follows.";
    DORMAND_PRINCE_8 "Dormand–Prince 8" Colour(110, 110, 110), false,
        "h_{n+1} = h {{tolerance}/{|e_n|}}^{1/8}",
        "The same with order 8: fewer steps for small tolerances.";
    BACKWARD_DIFFERENCES "backward differences" Colour(128, 0, 32), false,
        "Σ_{j=1}^k {1}/{j} ∇^j z_{n+1} = h f(z_{n+1})",
        "Gear's method for stiff systems (BDF), implicit, of orders 1 to 5: it damps fast oscillations, whether they are errors or not.";
    TAYLOR "Taylor" Colour(30, 140, 230), false,
        "z_{n+1} = Σ_{k=0}^K {h^k}/{k!} z^{(k)}(t_n)",
        "Many terms of the series in time by recurrences. The step is a share of the radius of convergence, which the last terms tell.";
}
