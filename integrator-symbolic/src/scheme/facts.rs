//! The properties of a composition in the generated code. In: a scheme. Out: its properties and their description.

use super::{
    inner_errors::{OverInner, lower_bounds},
    prove::{Class, Scheme},
    stability,
    table::Table,
};

/// The facts that become constants.
pub(super) struct Facts {
    pub(super) class: Class,
    /// The proved order for the class.
    pub(super) order: u32,
    pub(super) symmetric: bool,
    pub(super) table: Table,
    pub(super) stability_limit: f64,
    pub(super) leading_error: Option<f64>,
    /// The generalised orders that are claimed; mostly none.
    pub(super) generalised: Vec<u32>,
    /// Its orders if the second part has no exact flow.
    pub(super) over_inner: OverInner,
    /// The proved orders for every `T`, if the composition is defined there, and for quadratic `T`.
    orders: (Option<u32>, u32),
}

impl Facts {
    pub(super) fn of(scheme: &Scheme) -> Self {
        Self {
            class: scheme.class,
            order: scheme.order,
            symmetric: scheme.proof.symmetric,
            table: Table::of(scheme),
            stability_limit: stability::limit(&scheme.stages),
            leading_error: scheme.leading_error(),
            generalised: scheme.generalised.clone(),
            over_inner: OverInner::of(scheme),
            orders: (scheme.proof.general.map(|general| general.order), scheme.proof.quadratic.order),
        }
    }

    /// For a declaration with errors: its users still type-check.
    pub(super) fn stub() -> Self {
        Self {
            class: Class::General,
            order: 0,
            symmetric: false,
            table: Table::stub(),
            stability_limit: 0.0,
            leading_error: None,
            generalised: Vec::new(),
            over_inner: OverInner { orders: lower_bounds(0), keeps_pairs: true },
            orders: (Some(0), 0),
        }
    }

    /// Whether some kick goes along the gradient of the squared force.
    pub(super) fn has_gradients(&self) -> bool {
        self.orders.0.is_none()
    }

    /// The facts as the documentation has them.
    pub(super) fn prose(&self, citation: &str) -> String {
        let order = self.order;
        let orders = match (self.class, self.orders) {
            (Class::General, (_, quadratic)) if quadratic > order => {
                format!("Order {order} for every `T`, {quadratic} where `T` is quadratic in `p` (proved)")
            }
            (Class::General, _) => format!("Order {order} for every `T` (proved)"),
            (Class::QuadraticKinetic, (Some(general), _)) => {
                format!("Order {order} where `T` is quadratic in `p` (proved; {general} for every other `T`)")
            }
            (Class::QuadraticKinetic, (None, _)) => format!("Order {order} for `T` quadratic in `p` (proved)"),
        };
        let generalised = match &self.generalised[..] {
            [] => String::new(),
            orders => {
                let orders: Vec<String> = orders.iter().map(u32::to_string).collect();
                format!("Order ({}) where the part of the kicks is small (proved). ", orders.join(", "))
            }
        };
        let symmetric = if self.symmetric { "symmetric" } else { "not symmetric" };
        let evaluations = match self.table.force_evaluations() {
            1 => "1 force evaluation".to_owned(),
            many => format!("{many} force evaluations"),
        };
        let gradients = match self.table.gradient_evaluations() {
            0 => String::new(),
            some => format!(" ({some} with its gradient)"),
        };
        let limit = self.stability_limit;
        let error = self.leading_error.map(|norm| format!(", leading error {norm:.1e}")).unwrap_or_default();
        let source = match citation.trim_end_matches('.') {
            "" => String::new(),
            citation => format!(" Source: {citation}."),
        };
        format!(
            "{generalised}{orders}, {symmetric}, {evaluations}{gradients} a step. Stable up to `h ω = {limit:.3}`{error}.{source}"
        )
    }
}
