//! Parts that commute: neighbours in `split` whose flows are that of their sum.

use crate::{
    graph::exact::Exact,
    model::{Reader, system::parts::ExactPart},
};

impl Reader<'_> {
    /// Joins neighbours that commute, but none that takes inner steps with one that does not.
    pub(crate) fn commuting_by_nest(&mut self, mut parts: Vec<ExactPart>) -> Vec<ExactPart> {
        let innermost = self.input.nests.last().map_or(0, |nest| nest.first);
        let innermost = parts.split_off(innermost);
        parts.extend(self.commuting_as_one(innermost));
        parts
    }

    /// Joins neighbours that are functions of positions alone, or of momenta alone: they commute, so their sum is one part. At
    /// least two parts are left.
    fn commuting_as_one(&mut self, parts: Vec<ExactPart>) -> Vec<ExactPart> {
        let is_one = |[first, second]: [&ExactPart; 2]| {
            matches!(first.form, Exact::OfPositions | Exact::OfMomenta) && first.form == second.form
        };
        if parts.windows(2).all(|parts| is_one([&parts[0], &parts[1]])) {
            return parts;
        }
        let mut joined: Vec<ExactPart> = Vec::with_capacity(parts.len());
        for part in parts {
            let is_second = joined.len() == 1;
            match joined.last_mut() {
                Some(last) if is_one([last, &part]) && !(is_second && self.stands_apart([last, &part])) => {
                    last.energy = self.graph.add(last.energy, part.energy);
                    last.functions.extend(part.functions);
                }
                _ => joined.push(part),
            }
        }
        joined
    }

    /// Whether the first part is no sum with the second: stages give it another time than all others, and another
    /// duration than parts in parentheses.
    fn stands_apart(&self, parts: [&ExactPart; 2]) -> bool {
        self.input.paired.is_some() || parts.iter().any(|part| self.graph.reads_time(part.energy))
    }
}

#[cfg(test)]
mod tests {
    use crate::model::{Split, of_annotated_text};

    const FUNCTIONS: &str = "impl System {
        fn drift(&self, p: [f64; 2]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1]) }
        fn wind(&self, p: [f64; 2]) -> f64 { p[0] }
        fn gust(&self, p: [f64; 2], t: f64) -> f64 { t * p[0] }
        fn well(&self, q: [f64; 2]) -> f64 { q[0].cos() }
        fn wall(&self, q: [f64; 2]) -> f64 { q[1].exp() }
        fn wave(&self, q: [f64; 2], t: f64) -> f64 { t.sin() * q[0] }
        fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] }
    }";

    /// What `split` says, the parts that a composition composes, and whether others than the first are a pair.
    const SPLITS: [(&str, &[&str], bool); 12] = [
        ("drift + well", &["drift", "well"], false),
        ("drift + well + wall", &["drift", "well + wall"], false),
        ("drift + wave + well", &["drift", "wave + well"], false),
        ("wind + drift + well", &["wind + drift", "well"], false),
        ("well + wall + drift", &["well + wall", "drift"], false),
        // Only the first part reads the time at the middle of its duration.
        ("gust + drift + well", &["gust", "drift", "well"], false),
        ("drift + gust + well", &["drift", "gust", "well"], false),
        ("well + gust + drift", &["well", "gust + drift"], false),
        // Others than neighbours are applied at other times.
        ("drift + well + twist + wall", &["drift", "well", "twist", "wall"], false),
        ("twist + (well + wall)", &["twist", "well + wall"], false),
        // A pair divides its duration anew.
        ("drift + (wind + well)", &["drift", "wind", "well"], true),
        ("well + wall", &["well", "wall"], false),
    ];

    #[test]
    fn neighbours_that_commute_are_one_part() {
        for (split, expected, is_pair) in SPLITS {
            let model = of_annotated_text(&format!("split = {split}"), FUNCTIONS);
            let names: Vec<_> = model.parts.iter().map(|part| part.name()).collect();
            assert_eq!(names, expected, "{split}");
            assert_eq!(matches!(model.split, Split::Pair), is_pair, "{split}");
        }
    }
}
