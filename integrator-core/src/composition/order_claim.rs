//! The order that an annotation claims for its steps, which the compiler compares with the proved one.

use crate::{
    composition::{Scheme, inner_steps::order_of_step},
    system::inner_steps::InnerSteps,
};

macro_rules! messages {
    ($why:literal: $($order:literal)*) => {
        [$(concat!("a step of this composition has order ", $order, ", which is lower than the claimed order", $why)),*]
    };
}

/// What is wrong with a claim, by the proved order. No composition has a proof of a higher one.
const WITHOUT_INNER_STEPS: [&str; 17] = messages!("": 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16);

const WITH_INNER_STEPS: [&str; 17] = messages!(
    "; the order is that of the inner composition, if this is lower than that of the outer one": 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16
);

/// Checks, in a constant, that a step has the claimed order, with inner steps at these levels.
///
/// # Panics
/// If the order is lower: a compile error, because the call is in a constant.
pub const fn claims_order<X: Scheme>(claimed: u32, levels: &[InnerSteps]) {
    let order = order_of_step::<X>(levels);
    if order < claimed {
        let messages = if levels.is_empty() { &WITHOUT_INNER_STEPS } else { &WITH_INNER_STEPS };
        let row = if (order as usize) < messages.len() { order as usize } else { messages.len() - 1 };
        panic!("{}", messages[row]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::composition::catalogue::{BlanesMoan4, KahanLi8, Verlet, Yoshida4};

    const VERLET: InnerSteps = InnerSteps::of::<Verlet>(8, &["bonds", "kinetic"]);
    const BLANES_MOAN: InnerSteps = InnerSteps::of::<BlanesMoan4>(4, &["bonds", "kinetic"]);

    #[test]
    fn claims_hold_up_to_the_order_of_the_step() {
        let holds = |check: Check, order: u32, levels: &[InnerSteps]| {
            std::panic::catch_unwind(|| check(order, levels))
                .map_err(|message| *message.downcast::<String>().expect("a text"))
        };
        type Check = fn(u32, &[InnerSteps]);
        let rows: [(Check, &[InnerSteps], u32); 6] = [
            (claims_order::<Verlet>, &[], 2),
            (claims_order::<KahanLi8>, &[], 8),
            (claims_order::<BlanesMoan4>, &[VERLET], 2),
            (claims_order::<BlanesMoan4>, &[BLANES_MOAN], 4),
            (claims_order::<Yoshida4>, &[VERLET], 4),
            (claims_order::<BlanesMoan4>, &[BLANES_MOAN, VERLET], 2),
        ];
        for (check, levels, order) in rows {
            for claimed in 1..=order {
                assert_eq!(holds(check, claimed, levels), Ok(()));
            }
            let message = holds(check, order + 1, levels).expect_err("a claim that is too high");
            assert!(message.contains(&format!(" has order {order}, ")), "{message}");
        }
    }
}
