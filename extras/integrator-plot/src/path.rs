//! Curves clipped at the border of a frame, without invisible points.

use crate::canvas::Place;

/// A rectangle of pixels: left, top, right, bottom.
pub(crate) type Border = [f64; 4];

/// The pieces of a curve within a border. The curve ends and begins again where a point is missing.
pub(crate) fn pieces(points: impl Iterator<Item = Option<Place>>, border: Border) -> Vec<Vec<Place>> {
    let mut pieces: Vec<Vec<Place>> = Vec::new();
    let mut before: Option<Place> = None;
    // Whether the last piece ends where the curve last was.
    let mut attached = false;
    for point in points {
        if let Some((from, to)) = before.zip(point)
            && let Some((begin, end)) = inside(from, to, border)
        {
            match pieces.last_mut() {
                Some(piece) if attached && begin == from => piece.push(end),
                _ => pieces.push(vec![begin, end]),
            }
            attached = end == to;
        } else {
            attached = false;
        }
        before = point;
    }
    pieces.into_iter().map(thinned).collect()
}

/// The largest displacement of a curve by leaving out a point, in pixels.
const UNSEEN: f64 = 0.04;
/// Points after each other in a column of half a pixel are a crowd if there are at least this many, and the curve
/// through them is
/// `TO_AND_FRO` times as long as the column is high: four of them are kept. A curve that turns around there once is not.
const CROWD: usize = 8;
const TO_AND_FRO: f64 = 4.0;

/// The curve without points that add nothing to what is seen.
fn thinned(points: Vec<Place>) -> Vec<Place> {
    let mut kept: Vec<Place> = Vec::new();
    for column in points.chunk_by(|a, b| (2.0 * a.0).floor() == (2.0 * b.0).floor()) {
        if !is_crowd(column) {
            kept.extend(column);
            continue;
        }
        let extreme = |of: fn(&f64, &f64) -> std::cmp::Ordering| {
            (0..column.len()).max_by(|i, j| of(&column[*i].1, &column[*j].1))
        };
        let (lowest, highest) = (extreme(f64::total_cmp), extreme(|a, b| b.total_cmp(a)));
        let mut places = [Some(0), lowest, highest, Some(column.len() - 1)];
        places.sort_unstable();
        kept.extend(places.into_iter().flatten().map(|place| column[place]));
    }
    let needed = needed(&kept);
    kept.into_iter().zip(needed).filter_map(|(point, needed)| needed.then_some(point)).collect()
}

/// Whether a curve goes up and down within a column so often that nothing but its extremes is seen.
fn is_crowd(column: &[Place]) -> bool {
    let heights = column.iter().map(|place| place.1);
    let (lowest, highest) =
        heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
    let length: f64 = column.windows(2).map(|pair| (pair[1].0 - pair[0].0).hypot(pair[1].1 - pair[0].1)).sum();
    column.len() >= CROWD && length >= TO_AND_FRO * (highest - lowest)
}

/// Marks the points that a curve needs, after Ramer, Douglas and Peucker: of a part of the curve the one that is
/// farthest from the chord, and the same of both halves, until no point is visibly off the chord.
fn needed(points: &[Place]) -> Vec<bool> {
    let mut needed = vec![false; points.len()];
    let mut parts = Vec::new();
    if let Some(last) = points.len().checked_sub(1) {
        (needed[0], needed[last]) = (true, true);
        parts.push((0, last));
    }
    while let Some((begin, end)) = parts.pop() {
        let off = |place: usize| distance(points[place], [points[begin], points[end]]);
        let farthest = (begin + 1..end).map(|place| (off(place), place)).max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((off, place)) = farthest
            && off > UNSEEN
        {
            needed[place] = true;
            parts.extend([(begin, place), (place, end)]);
        }
    }
    needed
}

/// The distance of a point from a segment.
fn distance((x, y): Place, [(x0, y0), (x1, y1)]: [Place; 2]) -> f64 {
    let (dx, dy) = (x1 - x0, y1 - y0);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { (((x - x0) * dx + (y - y0) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (x - x0 - along * dx).hypot(y - y0 - along * dy)
}

/// The part of a segment within a border, by Liang and Barsky's parameters of entry and exit.
fn inside(from: Place, to: Place, [left, top, right, bottom]: Border) -> Option<(Place, Place)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut entry, mut exit) = (0.0_f64, 1.0_f64);
    let sides = [(-dx, from.0 - left), (dx, right - from.0), (-dy, from.1 - top), (dy, bottom - from.1)];
    for (outward, distance) in sides {
        if outward == 0.0 {
            if distance < 0.0 {
                return None;
            }
        } else if outward < 0.0 {
            entry = entry.max(distance / outward);
        } else {
            exit = exit.min(distance / outward);
        }
    }
    let at = |part: f64| (from.0 + part * dx, from.1 + part * dy);
    // The ends themselves stay what they are, so that one piece continues where the other ends.
    let begin = if entry > 0.0 { at(entry) } else { from };
    let end = if exit < 1.0 { at(exit) } else { to };
    (entry <= exit).then_some((begin, end))
}

#[cfg(test)]
mod tests {
    use super::{Place, pieces};

    const BORDER: [f64; 4] = [0.0, 0.0, 10.0, 10.0];

    fn cut(points: &[Place]) -> Vec<Vec<Place>> {
        pieces(points.iter().map(|&(x, y)| (x.is_finite() && y.is_finite()).then_some((x, y))), BORDER)
    }

    #[test]
    fn a_simplified_curve_keeps_parts_of_pixels_and_drops_invisible_points() {
        let curve = [(1.0, 1.0), (2.0, 1.97), (5.25, 5.25), (6.0, 4.0), (8.9, 1.0), (8.9, 1.02), (9.0, 1.0)];
        assert_eq!(cut(&curve), [[(1.0, 1.0), (5.25, 5.25), (6.0, 4.0), (8.9, 1.0), (9.0, 1.0)]]);
        let round: Vec<Place> = (0..=1000)
            .map(|i| f64::from(i) / 1000.0 * std::f64::consts::TAU)
            .map(|t| (5.0 + 4.0 * t.cos(), 5.0 + 4.0 * t.sin()))
            .collect();
        let thin = &cut(&round)[0];
        // Chords of a circle of radius 4 that are 0.04 off at their middle are 1.13 long.
        assert!((20..80).contains(&thin.len()), "{} points", thin.len());
    }

    #[test]
    fn a_curve_that_turns_around_within_a_column_stays_round() {
        // Some hundred points of a circle lie in the last half pixel.
        let round: Vec<Place> =
            (-1000..=1000).map(|i| f64::from(i) * 2e-3).map(|t| (5.9 + 4.0 * t.cos(), 5.0 + 4.0 * t.sin())).collect();
        let off = |(x, y): Place| ((x - 5.9).hypot(y - 5.0) - 4.0).abs();
        for piece in cut(&round) {
            let middles = piece.windows(2).map(|pair| (0.5 * (pair[0].0 + pair[1].0), 0.5 * (pair[0].1 + pair[1].1)));
            assert!(middles.map(off).all(|off| off < 0.05), "{piece:?}");
        }
    }

    #[test]
    fn of_a_crowd_the_extremes_are_kept() {
        let swing = |i: u32| if i.is_multiple_of(2) { 1.0 + 0.001 * f64::from(i) } else { 9.0 - 0.001 * f64::from(i) };
        let curve: Vec<Place> = (0..1000).map(|i| (4.0 + 0.0004 * f64::from(i), swing(i))).collect();
        let pieces = cut(&curve);
        assert_eq!(pieces, [[curve[0], curve[1], curve[999]]], "the highest and the lowest are among these");
    }

    #[test]
    fn a_curve_is_cut_at_the_border() {
        let pieces = cut(&[(5.0, 5.0), (15.0, 5.0), (15.0, 8.0), (5.0, 8.0)]);
        assert_eq!(pieces, [[(5.0, 5.0), (10.0, 5.0)], [(10.0, 8.0), (5.0, 8.0)]]);
        assert_eq!(cut(&[(-5.0, 5.0), (1e300, 5.0)]), [[(0.0, 5.0), (10.0, 5.0)]]);
        assert!(cut(&[(-5.0, 5.0), (5.0, 25.0)]).is_empty());
    }

    #[test]
    fn a_missing_point_is_a_gap() {
        let pieces = cut(&[(1.0, 1.0), (2.0, 2.0), (f64::NAN, 0.0), (3.0, 3.0), (4.0, 4.0)]);
        assert_eq!(pieces, [[(1.0, 1.0), (2.0, 2.0)], [(3.0, 3.0), (4.0, 4.0)]]);
    }
}
