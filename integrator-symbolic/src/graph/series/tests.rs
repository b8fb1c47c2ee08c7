//! Series as loops, compared with the sums that were written out.

use super::*;
use crate::{
    differentiate::gradient,
    graph::{Comparison, Element, Part, evaluate::Point},
};

/// A number of a term, from 0 on: no power of two, and different for each.
fn number(at: usize, seed: f64) -> f64 {
    1.25 + ((at as f64 + 1.0) * seed).fract()
}

fn positions(graph: &mut Graph) -> [NodeId; 2] {
    [0, 1].map(|position| {
        let index = graph.loops.intern(Index::Literal(position));
        graph.coordinate(Element { part: Part::Position, index, component: None })
    })
}

/// `± c exp(± w x - a) / (1 + w y²)`, and with a sine for the exponential; the first `w` is one, which is not written.
fn term(graph: &mut Graph, [x, y]: [NodeId; 2], at: usize, function: &str) -> NodeId {
    let [c, a] = [0.61, 0.83].map(|seed| graph.constant(number(at, seed)));
    let [w, one] = [if at == 0 { 1.0 } else { number(at, 0.37) }, 1.0].map(|number| graph.constant(number));
    let (phase, square) = (graph.mul(w, x), graph.power(y, 4));
    let phase = if at == 1 { graph.neg(phase) } else { phase };
    let phase = graph.sub(phase, a);
    let value = graph.call(function, phase);
    let value = graph.mul(c, value);
    let square = graph.mul(w, square);
    let divisor = graph.add(square, one);
    let value = graph.div(value, divisor);
    if at.is_multiple_of(3) { graph.neg(value) } else { value }
}

fn written(graph: &mut Graph, terms: usize) -> NodeId {
    let positions = positions(graph);
    let mut sum = graph.power(positions[0], 4);
    for at in 0..terms {
        for function in ["exp", "sin"] {
            let term = term(graph, positions, at, function);
            sum = graph.add(sum, term);
        }
    }
    sum
}

/// What a value becomes, with the tables that it reads; nothing if it stays as it is.
fn looped(graph: &mut Graph, value: NodeId, kept: &[NodeId]) -> Option<(NodeId, Vec<Vec<f64>>)> {
    let mut tables: Vec<Vec<f64>> = Vec::new();
    let mut table = |graph: &mut Graph, by: LoopId, numbers: &[f64]| {
        let known = tables.iter().position(|table| table == numbers);
        let id = ParameterId(known.unwrap_or(tables.len()) as u32);
        if known.is_none() {
            tables.push(numbers.to_vec());
        }
        graph.loops.declare_parameter(id, LoopSet::of(by));
        id
    };
    let known = graph.with_series_as_loops(&[value], kept, &mut table);
    known.get(&value).map(|new| (*new, tables))
}

#[test]
fn a_series_is_a_loop_with_the_same_value_and_gradient() {
    const TERMS: usize = 40;
    let mut graph = Graph::default();
    let value = written(&mut graph, TERMS);
    let (new, tables) = looped(&mut graph, value, &[]).expect("a series");
    // Numbers that both functions share are one table, and their sums one loop.
    assert_eq!((tables.len(), graph.loops.count()), (4, 1), "{tables:?}");
    assert!(graph.operations([new]) < 20 && graph.operations([value]) > 9 * TERMS);
    let look_up = |id: ParameterId, running: &HashMap<LoopId, i64>| {
        tables[id.0 as usize][running.values().copied().next().expect("in the loop") as usize]
    };
    let gradients = [value, new].map(|value| gradient(&mut graph, value, Part::Position));
    for q in [[0.3_f64, -0.7], [-1.2, 0.1], [2.5, 1.4]] {
        // No term or slope of one is larger than its numbers, at most 2.25 each, times the exponential of its argument.
        // Each of the additions of either order rounds once, and each term a few times.
        let largest = 2.25_f64.powi(3) * (2.25 * q[0].abs()).exp();
        let count = 2.0 * TERMS as f64;
        let bound = (2.0 * count + 40.0) * f64::EPSILON * count * largest;
        let at = |graph: &Graph, id| Point { look_up: Some(&look_up), ..Point::new(&q, &[]) }.value(graph, id);
        let [written, looped] = [value, new].map(|id| at(&graph, id));
        assert!((written - looped).abs() <= bound, "{written} and {looped}");
        for position in 0..2 {
            let slopes = gradients.each_ref().map(|contributions| {
                let own = contributions
                    .iter()
                    .filter(|contribution| graph.loops.literal(contribution.element.index) == Some(position as u64));
                own.map(|contribution| at(&graph, contribution.value)).sum::<f64>()
            });
            assert!((slopes[0] - slopes[1]).abs() <= bound, "{slopes:?}");
        }
    }
}

#[test]
fn other_sums_stay_as_they_are() {
    let mut graph = Graph::default();
    let few = written(&mut graph, FEWEST - 1);
    assert_eq!(looped(&mut graph, few, &[]), None);
    let enough = written(&mut graph, FEWEST);
    assert!(looped(&mut graph, enough, &[]).is_some());
    // What an exact flow is solved with, and what a condition compares.
    assert_eq!(looped(&mut graph, enough, &[enough]), None);
    let [x, y] = positions(&mut graph);
    let condition = graph.compare(Comparison::Less, enough, x);
    let choice = graph.select(condition, x, y);
    assert_eq!(looped(&mut graph, choice, &[]), None);
    // Terms that differ in a factor alone are like terms, and infinite numbers have no text.
    let (sine, mut multiples) = (graph.call("sin", x), x);
    for at in 0..FEWEST {
        let factor = graph.constant(number(at, 0.29));
        let multiple = graph.mul(factor, sine);
        multiples = graph.add(multiples, multiple);
    }
    assert_eq!(looped(&mut graph, multiples, &[]), None);
    let infinite = (0..FEWEST).fold(y, |sum, at| {
        let end = graph.constant(if at == 7 { f64::INFINITY } else { number(at, 0.43) });
        let nearer = graph.call_two("min", x, end);
        graph.add(sum, nearer)
    });
    assert_eq!(looped(&mut graph, infinite, &[]), None);
}
