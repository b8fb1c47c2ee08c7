//! Tests of deviation vectors for any system, method and layout.

use integrator_core::{Coords, Differentiable, Gradient, Method, prelude::*};

/// Returns the numbers of a point, positions first.
pub(crate) fn numbers<C: Coords<Leaf = f64>>(point: &Phase<C>) -> Vec<f64> {
    point.q.flat().iter().chain(point.p.flat()).copied().collect()
}

/// Returns a point with numbers computed from index and old value.
pub(crate) fn point<C: Coords<Leaf = f64>>(like: &Phase<C>, number: impl Fn(usize, f64) -> f64) -> Phase<C> {
    let mut point = like.clone();
    let leaves = point.q.flat_mut().iter_mut().chain(point.p.flat_mut());
    leaves.enumerate().for_each(|(place, leaf)| *leaf = number(place, *leaf));
    point
}

/// Returns `count` directions, none of them along a coordinate.
pub(crate) fn directions<C: Coords<Leaf = f64>>(like: &Phase<C>, count: usize) -> Vec<Phase<C>> {
    let angle = |vector: usize, place: usize| (1.0 + 1.7 * vector as f64 + 0.9 * place as f64).sin();
    (0..count).map(|vector| point(like, |place, _| angle(vector, place))).collect()
}

/// Tests a system with a method. The state is bitwise identical to that of the run alone. Each vector is bitwise
/// identical to that vector alone, however the steps are divided into calls, and agrees with finite differences.
pub(crate) fn holds<H, X, C>(name: &str, system: &H, method: X, start: Phase<C>, h: f64)
where
    H: Hamiltonian<Coords = C>,
    X: Differentiable<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let most = (2 * start.q.flat().len()).min(6);
    let vectors = directions(&start, most);
    let end = |start: &Phase<C>| {
        let mut run = system.run_with::<f64, X>(method, start.clone(), h).expect("a start");
        run.advance(12).expect("finite states");
        run.state()
    };
    let mut tangent = system.tangent::<f64, X>(method, start.clone(), vectors.clone(), h).expect("a start");
    tangent.advance(5).and_then(|()| tangent.advance(7)).expect("finite states");
    assert_eq!(tangent.state(), end(&start), "{name}: the state");
    let arrived = tangent.vectors();
    for (number, vector) in vectors.iter().enumerate() {
        let mut alone = system.tangent::<f64, X>(method, start.clone(), [vector.clone()], h).expect("a start");
        alone.advance(12).expect("finite states");
        assert_eq!(alone.vectors()[0], arrived[number], "{name}: vector {number} alone");

        // Fourth-order differences. The coarser ones have twice the width and sixteen times the error, so the
        // difference of both bounds the error of the finer ones. Rounding errors of the final states, of which there
        // are a few hundred, are divided by the width.
        let along = |width: f64| {
            let at = |s: f64| {
                let vector = numbers(vector);
                numbers(&end(&point(&start, |place, x| x + s * width * vector[place])))
            };
            let (far, near) = ([at(-2.0), at(2.0)], [at(-1.0), at(1.0)]);
            let of = |i: usize| (8.0 * (near[1][i] - near[0][i]) - (far[1][i] - far[0][i])) / (12.0 * width);
            (0..near[0].len()).map(of).collect::<Vec<_>>()
        };
        let width = 1.0 / 1024.0;
        let (fine, coarse, image) = (along(width), along(2.0 * width), numbers(&arrived[number]));
        let size = image.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
        for place in 0..image.len() {
            let tolerance = (fine[place] - coarse[place]).abs() + 1e3 * f64::EPSILON / width * size;
            let apart = (image[place] - fine[place]).abs();
            assert!(apart <= tolerance, "{name}: component {place} of vector {number} is off by {apart:e}");
        }
    }
    gradient_holds(name, system, method, &start, h, (&vectors, &arrived));
}

/// Tests that the gradient of a function of the end multiplies each vector at the start by the same number as the derivatives
/// of the function multiply its image, or that the method has no gradients.
fn gradient_holds<H, X, C>(
    name: &str,
    system: &H,
    method: X,
    start: &Phase<C>,
    h: f64,
    (vectors, images): (&[Phase<C>], &[Phase<C>]),
) where
    H: Hamiltonian<Coords = C>,
    X: Differentiable<H>,
    C: Coords<Leaf = f64, With<f64> = C>,
{
    let weights = &directions(start, 7)[6];
    let found = system.gradient::<f64, X>(method, start.clone(), h, 12, |_| (0.0, weights.clone()));
    let facts = Method::<H>::claims(method);
    if !facts.symmetric || !facts.symplectic || !X::FROM_STATES {
        return assert!(matches!(found, Err(Error::NoGradient { .. })), "{name}: {found:?}");
    }
    let Gradient { start: gradient, return_error, .. } = found.expect("a symmetric method");
    // Both ways round each number a few hundred times.
    let rounding = 1e3 * f64::EPSILON;
    assert!(return_error < rounding, "{name}: {return_error:e}");
    let products =
        |a: &Phase<C>, b: &Phase<C>| numbers(a).iter().zip(numbers(b)).map(|(a, b)| a * b).collect::<Vec<_>>();
    for (number, (vector, image)) in vectors.iter().zip(images).enumerate() {
        let (at_start, at_end) = (products(&gradient, vector), products(weights, image));
        let size: f64 = at_start.iter().chain(&at_end).map(|product| product.abs()).sum();
        let apart = at_start.iter().sum::<f64>() - at_end.iter().sum::<f64>();
        assert!(
            apart.abs() < rounding * size,
            "{name}: the gradient along vector {number} is off by {apart:e} of {size:e}"
        );
    }
}
