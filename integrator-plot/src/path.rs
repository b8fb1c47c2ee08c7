//! Curves cut at the border of a frame, and without points that no pixel would show.

/// A rectangle of pixels: left, top, right, bottom.
pub(crate) type Border = [f64; 4];

/// The pieces of a curve within a border, as pixels. The curve ends and begins anew where a point is missing.
pub(crate) fn pieces(points: impl Iterator<Item = Option<(f64, f64)>>, border: Border) -> Vec<Vec<(i32, i32)>> {
    let mut pieces: Vec<Vec<(i32, i32)>> = Vec::new();
    let mut before: Option<(f64, f64)> = None;
    // Whether the last piece ends where the curve last was.
    let mut attached = false;
    for point in points {
        if let Some((from, to)) = before.zip(point)
            && let Some((begin, end)) = inside(from, to, border)
        {
            let (begin, end) = (pixel(begin), pixel(end));
            if !attached || pieces.last().and_then(|piece| piece.last()) != Some(&begin) {
                pieces.push(vec![begin]);
            }
            if let Some(piece) = pieces.last_mut() {
                extend(piece, end);
            }
            attached = end == pixel(to);
        } else {
            attached = false;
        }
        before = point;
    }
    pieces
}

/// How far apart the points of a drawn curve are, in pixels: whole pixels closer to each other make a smooth curve wavy.
const STRIDE: i32 = 3;

/// Moves the end of a piece. It stays a point of the curve once it is far enough from the one before.
fn extend(piece: &mut Vec<(i32, i32)>, end: (i32, i32)) {
    if let [.., before, last] = piece[..]
        && (last.0 - before.0).pow(2) + (last.1 - before.1).pow(2) < STRIDE.pow(2)
    {
        piece.pop();
    }
    if piece.last() != Some(&end) {
        piece.push(end);
    }
}

fn pixel((x, y): (f64, f64)) -> (i32, i32) {
    (x.round() as i32, y.round() as i32)
}

/// The part of a segment within a border, by Liang and Barsky's parameters of entry and exit.
fn inside(from: (f64, f64), to: (f64, f64), [left, top, right, bottom]: Border) -> Option<((f64, f64), (f64, f64))> {
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
    // The ends themselves stay what they are, so that one piece goes on where the other ends.
    let begin = if entry > 0.0 { at(entry) } else { from };
    let end = if exit < 1.0 { at(exit) } else { to };
    (entry <= exit).then_some((begin, end))
}

#[cfg(test)]
mod tests {
    use super::pieces;

    const BORDER: [f64; 4] = [0.0, 0.0, 10.0, 10.0];

    fn cut(points: &[(f64, f64)]) -> Vec<Vec<(i32, i32)>> {
        pieces(points.iter().map(|&(x, y)| (x.is_finite() && y.is_finite()).then_some((x, y))), BORDER)
    }

    #[test]
    fn a_curve_inside_stays_whole_and_loses_what_is_close() {
        assert_eq!(cut(&[(1.0, 1.0), (1.1, 1.2), (5.0, 5.0), (6.0, 4.0), (9.0, 1.0)]), [[(1, 1), (5, 5), (9, 1)]]);
    }

    #[test]
    fn a_curve_is_cut_at_the_border() {
        let pieces = cut(&[(5.0, 5.0), (15.0, 5.0), (15.0, 8.0), (5.0, 8.0)]);
        assert_eq!(pieces, [[(5, 5), (10, 5)], [(10, 8), (5, 8)]]);
        assert_eq!(cut(&[(-5.0, 5.0), (1e300, 5.0)]), [[(0, 5), (10, 5)]]);
        assert!(cut(&[(-5.0, 5.0), (5.0, 25.0)]).is_empty());
    }

    #[test]
    fn a_missing_point_is_a_gap() {
        let pieces = cut(&[(1.0, 1.0), (2.0, 2.0), (f64::NAN, 0.0), (3.0, 3.0), (4.0, 4.0)]);
        assert_eq!(pieces, [[(1, 1), (2, 2)], [(3, 3), (4, 4)]]);
    }
}
