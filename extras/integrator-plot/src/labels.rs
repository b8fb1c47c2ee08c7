//! Placement of labels without overlap.

/// Heights near those that are wanted, in the same order, at least so far apart, and within these ends where there is room.
/// The wanted ones are sorted.
pub(crate) fn apart(wanted: &[f64], distance: f64, [top, bottom]: [f64; 2]) -> Vec<f64> {
    // Labels that touch form a block around the mean of what its members want; blocks that touch are joined.
    struct Block {
        /// Of the first label if all members had what they want on average.
        first: f64,
        count: usize,
    }
    let length = |count: usize| (count - 1) as f64 * distance;
    let mut blocks: Vec<Block> = Vec::new();
    for wish in wanted {
        let mut block = Block { first: *wish, count: 1 };
        loop {
            block.first = block.first.min(bottom - length(block.count)).max(top);
            let touches = |before: &mut Block| before.first + length(before.count) + distance > block.first;
            let Some(before) = blocks.pop_if(touches) else { break };
            // Each member wants its own height less its place in the block.
            let (a, b) = (before.count as f64, block.count as f64);
            let first = (a * before.first + b * (block.first - a * distance)) / (a + b);
            block = Block { first, count: before.count + block.count };
        }
        blocks.push(block);
    }
    let of = |block: &Block| (0..block.count).map(|i| block.first + i as f64 * distance).collect::<Vec<_>>();
    blocks.iter().flat_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::apart;

    #[test]
    fn labels_with_room_stay_and_others_move_as_little_as_they_can() {
        assert_eq!(apart(&[10.0, 50.0, 90.0], 20.0, [0.0, 100.0]), [10.0, 50.0, 90.0]);
        assert_eq!(apart(&[50.0, 50.0, 50.0], 20.0, [0.0, 100.0]), [30.0, 50.0, 70.0]);
        assert_eq!(apart(&[95.0, 96.0], 20.0, [0.0, 100.0]), [80.0, 100.0]);
        assert_eq!(apart(&[0.0, 1.0], 20.0, [0.0, 100.0]), [0.0, 20.0]);
        assert!(apart(&[], 20.0, [0.0, 100.0]).is_empty());
    }

    #[test]
    fn labels_are_apart_whatever_they_want() {
        let mut random = 1_u64;
        for count in 1..12 {
            let mut wanted: Vec<f64> = (0..count)
                .map(|_| {
                    random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                    (random >> 40) as f64 / (1_u64 << 24) as f64 * 300.0
                })
                .collect();
            wanted.sort_by(f64::total_cmp);
            let places = apart(&wanted, 20.0, [0.0, 300.0]);
            assert!(places.windows(2).all(|pair| pair[1] - pair[0] > 20.0 - 1e-9), "{places:?}");
            assert!(places.iter().all(|place| (-1e-9..=300.0 + 1e-9).contains(place)), "{places:?}");
        }
    }
}
