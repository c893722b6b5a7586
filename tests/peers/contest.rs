//! The benches' stopwatch itself: orders, quartiles, and that it tells slow from fast.

use host::contest::{Contest, Quartiles, Standings, order};
use std::cell::RefCell;
use std::rc::Rc;

/// Quartiles by counting alone: a value of which at most that share lies below and at most the rest above.
fn is_quantile(values: &[f64], share: f64, quantile: f64) -> bool {
    let n = values.len() as f64;
    let below = values.iter().filter(|&&v| v < quantile).count() as f64;
    let above = values.iter().filter(|&&v| v > quantile).count() as f64;
    // One value in either direction is a matter of definition.
    below <= share * n + 1.0 && above <= (1.0 - share) * n + 1.0
}

#[test]
fn quartiles_part_the_values_in_quarters() {
    let shuffled: Vec<f64> = (0..101).map(|i| f64::from(i * 37 % 101)).collect();
    let quartiles = Quartiles::of(shuffled.iter().copied());
    assert_eq!(quartiles.median, 50.0);
    assert!(is_quantile(&shuffled, 0.25, quartiles.lower));
    assert!(is_quantile(&shuffled, 0.75, quartiles.upper));
    // The same counting refuses what is off by three hundredths.
    assert!(!is_quantile(&shuffled, 0.25, quartiles.lower + 3.0));
    assert!(!is_quantile(&shuffled, 0.75, quartiles.upper - 3.0));
}

#[test]
fn the_median_of_an_even_number_is_in_the_middle() {
    assert_eq!(Quartiles::of([4.0, 1.0, 3.0, 2.0]).median, 2.5);
    let one = Quartiles::of([7.0]);
    assert_eq!((one.lower, one.median, one.upper), (7.0, 7.0, 7.0));
    assert!(Quartiles::of([]).median.is_nan());
}

#[test]
fn the_spread_is_relative_to_the_median() {
    let quartiles = Quartiles {
        lower: 9.0,
        median: 10.0,
        upper: 12.0,
    };
    assert!((quartiles.spread() - 0.3).abs() < 1e-15);
}

#[test]
fn ratios_are_taken_within_a_round() {
    // A machine that runs at five speeds; b takes thrice as long as a at every one. Neither the medians nor the sums
    // of the times in another order would say so.
    let speeds = [1.0, 16.0, 2.0, 8.0, 4.0];
    let a = speeds.to_vec();
    let b = speeds.map(|speed| 3.0 * speed).to_vec();
    let c = vec![6.0; speeds.len()];
    let names = ["a", "b", "c"].map(String::from).to_vec();
    let standings = Standings::new(names, vec![a, b, c]);
    let ratio = standings.ratio("b", "a").unwrap();
    assert_eq!((ratio.lower, ratio.median, ratio.upper), (3.0, 3.0, 3.0));
    // A quotient that noise moves shows it in its quartiles.
    let noisy = standings.ratio("a", "c").unwrap();
    assert_eq!(noisy.median, 4.0 / 6.0);
    assert!(noisy.lower < 0.5 && noisy.upper > 1.0);
    assert_eq!(standings.nanoseconds("b").unwrap().median, 12.0);
    assert!(standings.ratio("a", "nobody").is_none() && standings.nanoseconds("nobody").is_none());
}

/// How often each contestant has each place, and how often each is followed by each other.
fn counts(contestants: usize, rounds: usize) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
    let mut places = vec![vec![0; contestants]; contestants];
    let mut successors = vec![vec![0; contestants]; contestants];
    for round in 0..rounds {
        let order = order(contestants, round);
        assert_eq!(order.len(), contestants);
        for (place, &contestant) in order.iter().enumerate() {
            places[contestant][place] += 1;
        }
        for pair in order.windows(2) {
            successors[pair[0]][pair[1]] += 1;
        }
    }
    (places, successors)
}

#[test]
fn everyone_has_every_place_and_follows_everyone_equally_often() {
    for contestants in 1..=24 {
        let cycles = if contestants % 2 == 0 { 1 } else { 2 };
        let (places, successors) = counts(contestants, cycles * contestants);
        assert!(places.iter().flatten().all(|&count| count == cycles));
        for (one, row) in successors.iter().enumerate() {
            for (other, &count) in row.iter().enumerate() {
                assert_eq!(count, if one == other { 0 } else { cycles });
            }
        }
    }
}

#[test]
fn turning_the_same_order_round_would_not_pass_for_balanced() {
    // The plain rotation: everyone has every place, and always the same successor.
    let mut successors = vec![vec![0; 6]; 6];
    for round in 0..6 {
        for place in 0..5 {
            successors[(place + round) % 6][(place + 1 + round) % 6] += 1;
        }
    }
    assert!(successors.iter().enumerate().any(|(one, row)| {
        row.iter()
            .enumerate()
            .any(|(other, &count)| one != other && count != 1)
    }));
}

#[test]
fn a_round_calls_everyone_as_often_and_in_the_order_of_the_plan() {
    const REPEATS: usize = 3;
    let calls = Rc::new(RefCell::new(Vec::new()));
    let mut contest = Contest::of_blocks(0_u32, 5, REPEATS);
    for contestant in 0..4 {
        let calls = Rc::clone(&calls);
        contest = contest.block(&contestant.to_string(), move |points| {
            assert_eq!(points.len(), 5);
            calls.borrow_mut().push(contestant);
        });
    }
    let mut rounds = 0;
    let standings = contest.run(7, || rounds += 1);
    assert_eq!(rounds, 7);
    // One call warms up, the others are timed.
    let expected: Vec<usize> = (0..7)
        .flat_map(|round| order(4, round))
        .flat_map(|contestant| [contestant; 1 + REPEATS])
        .collect();
    assert_eq!(*calls.borrow(), expected);
    assert_eq!(standings.names().collect::<Vec<_>>(), ["0", "1", "2", "3"]);
}

/// Steps of a recurrence that no compiler shortens, as long as one needs the last.
fn steps(point: &mut u32, count: u32) {
    for _ in 0..count {
        *point = (*point ^ (*point >> 15)).wrapping_mul(0x2c1b_3c6d) | 1;
    }
}

#[test]
fn twice_the_work_is_seen_as_twice_the_time() {
    let once = |points: &mut [u32]| points.iter_mut().for_each(|point| steps(point, 100));
    let twice = |points: &mut [u32]| points.iter_mut().for_each(|point| steps(point, 200));
    let standings = Contest::of_blocks(1_u32, 256, 4)
        .block("once", once)
        .block("the same", once)
        .block("twice", twice)
        .run(60, || ());
    let same = standings.ratio("the same", "once").unwrap().median;
    let double = standings.ratio("twice", "once").unwrap().median;
    assert!((0.8..1.25).contains(&same), "the same work: {same}");
    assert!((1.5..2.7).contains(&double), "twice the work: {double}");
}

#[test]
fn points_that_are_drawn_differ_from_block_to_block() {
    use rand_pcg::rand_core::Rng;
    let seen = Rc::new(RefCell::new(Vec::new()));
    let log = Rc::clone(&seen);
    let contest = Contest::of_blocks(0_u32, 4, 2).draw("words", move |rng| {
        let word = rng.next_u32();
        log.borrow_mut().push(word);
        word
    });
    contest.run(2, || ());
    let mut rng = host::contest::generator();
    let words: Vec<u32> = (0..2 * 3 * 4).map(|_| rng.next_u32()).collect();
    assert_eq!(*seen.borrow(), words);
}
