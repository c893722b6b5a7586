//! Tables that are taken without a check: what was made comes back, and wrong words do no more than select wrongly.

use crate::storage::{UNIT, weights};
use host::speed;
use microwarp::discrete::{
    Alias, AliasEntry, Cdf, PiecewiseConstant1d, PiecewiseConstant2d, Storage, Word,
};
use microwarp::{Error, Invert, Warp};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// Words of every kind: anything, the ends, small numbers.
fn garbage(rng: &mut Pcg32, n: usize) -> Vec<u64> {
    let word = |rng: &mut Pcg32| match rng.next_u32() % 4 {
        0 => rng.next_u64(),
        1 => u64::from(rng.next_u32() % 9),
        2 => u64::MAX,
        _ => 0,
    };
    (0..n).map(|_| word(rng)).collect()
}

fn in_unit(x: f32) -> bool {
    (0.0..1.0).contains(&x)
}

fn judge_cdf<W: Word, S: Storage<Item = W>>(table: &Cdf<S>, rng: &mut Pcg32) {
    let n = table.entries();
    for bits in [0, 1, u32::MAX, rng.next_u32()] {
        let chosen = table.select(bits);
        assert!(chosen.index < n && table.index(W::from_bits(bits)) < n);
        assert!(in_unit(chosen.leftover) && (0.0..=1.0).contains(&chosen.pmf));
        let exact = table.select_exact(bits);
        assert_eq!(exact.index, chosen.index);
        assert!(exact.numerator <= W::TOTAL);
        let chosen = table.select_uniform(bits as f32);
        assert!(chosen.index < n && in_unit(chosen.leftover));
    }
    assert!(table.draw(rng).index < n && table.draw_exact(rng).index < n);
    for index in 0..n + 2 {
        let _ = table.words_of(index);
        assert!((0.0..=1.0).contains(&table.pmf(index)));
    }
}

#[test]
fn wrong_words_select_entries_of_the_table() {
    let mut rng = Pcg32::new(7, 7);
    let inside = |x: f32, [low, high]: [f32; 2]| low <= x && x < high;
    let (u, v) = ([-3.0, 5.0], [1e6, 2e6]);
    for round in 0..speed::of("wrong tables", 20_000, 400_000) {
        let n = 1 + round as usize % 9;
        let wide = garbage(&mut rng, n * 3);
        let narrow: Vec<u32> = wide.iter().map(|word| *word as u32).collect();
        judge_cdf(&Cdf::from_trusted_words(&narrow[..n]).unwrap(), &mut rng);
        judge_cdf(&Cdf::from_trusted_words(&wide[..n]).unwrap(), &mut rng);
        let line = Cdf::from_trusted_words(&wide[..n]).unwrap();
        let line = PiecewiseConstant1d::from_cdf(line, u[0], u[1]).unwrap();
        let x = line.draw(&mut rng);
        assert!(inside(x, u) && in_unit(line.invert(x)) && line.pdf(x).is_finite());
        let words = (&narrow[..3], narrow.as_slice());
        let plane = PiecewiseConstant2d::from_trusted_words(words.0, words.1, u, v).unwrap();
        assert_eq!(plane.shape(), [n, 3]);
        for point in [plane.draw(&mut rng), plane.sample([0.0; 2])] {
            assert!(inside(point[0], u) && inside(point[1], v), "{point:?}");
            let [column, row] = plane.cell(point);
            assert!(column < n && row < 3);
            assert!(plane.pdf(point) >= 0.0 && plane.pdf(point).is_finite());
            assert!(plane.invert(point).into_iter().all(in_unit));
        }
    }
}

#[test]
fn wrong_bins_neither_panic_nor_leave_the_range() {
    let mut rng = Pcg32::new(8, 8);
    for round in 0..speed::of("wrong bins", 20_000, 400_000) {
        let n = 1_usize << (round % 5);
        let words = garbage(&mut rng, 3 * n);
        let bin = |part: &[u64]| AliasEntry::new(part[0], part[1], part[2] as u32);
        let bins: Vec<AliasEntry<u64>> = words.chunks(3).map(bin).collect();
        let narrow = |part: &[u64]| AliasEntry::new(part[0] as u32, part[1] as u32, part[2] as u32);
        let narrow: Vec<AliasEntry<u32>> = words.chunks(3).map(narrow).collect();
        let wide = Alias::from_trusted_bins(bins, n).unwrap();
        let narrow = Alias::from_trusted_bins(narrow, n).unwrap();
        for chosen in [
            wide.draw(&mut rng),
            narrow.draw(&mut rng),
            narrow.select_uniform(0.7),
        ] {
            assert!(in_unit(chosen.leftover) && (0.0..=1.0).contains(&chosen.pmf));
        }
        let _ = (wide.draw_exact(&mut rng), narrow.draw_exact(&mut rng));
    }
}

#[test]
fn trusted_tables_are_those_that_were_made() {
    let weights = weights(1000);
    let cdf = Cdf::<Vec<u32>>::from_slice(&weights).unwrap();
    assert_eq!(Cdf::from_trusted_words(cdf.as_words().to_vec()), Ok(cdf));
    let no_words: [u32; 0] = [];
    assert_eq!(Cdf::from_trusted_words(no_words), Err(Error::NoWeights));
    let too_many = vec![0_u32; microwarp::discrete::MAX_ENTRIES + 1];
    let refused = Cdf::from_trusted_words(too_many.as_slice()).err();
    assert_eq!(refused, Some(Error::TooManyWeights));
    let alias = Alias::<Vec<AliasEntry<u64>>>::from_slice(&weights).unwrap();
    let bins = alias.as_bins();
    assert_eq!(
        Alias::from_trusted_bins(bins.to_vec(), 1000).unwrap(),
        alias
    );
    for (bins, entries, error) in [
        (bins, 0, Error::NoWeights),
        (bins, 1025, Error::NotATable),
        (&bins[1..], 1000, Error::NotATable),
        (&[], 1, Error::NotATable),
    ] {
        assert_eq!(Alias::from_trusted_bins(bins, entries), Err(error));
    }
    let map = PiecewiseConstant2d::<Vec<u32>, Vec<u32>>::from_slice(&weights, [40, 25], UNIT, UNIT);
    let map = map.unwrap();
    let (rows, cells) = map.as_words();
    let again = PiecewiseConstant2d::from_trusted_words(rows.to_vec(), cells.to_vec(), UNIT, UNIT);
    assert_eq!(again.unwrap(), map);
    for (rows, cells, error) in [
        (&rows[1..], cells, Error::NotATable),
        (&rows[..0], cells, Error::NoWeights),
        (rows, &cells[..0], Error::NoWeights),
    ] {
        let refused = PiecewiseConstant2d::from_trusted_words(rows, cells, UNIT, UNIT).err();
        assert_eq!(refused, Some(error));
    }
}

/// All bins of a table of any weights are accepted, and those in which one number is another are not.
#[test]
fn only_bins_that_were_laid_out_are_accepted() {
    let mut rng = Pcg32::new(9, 9);
    let mut rejected = 0;
    for round in 0..speed::of("tables of bins", 2_000, 40_000) {
        let n = 1 + rng.next_u32() as usize % 40;
        let mut weights: Vec<f32> = (0..n).map(|_| (rng.next_u32() >> 28) as f32).collect();
        match round % 4 {
            0 => weights.fill(1.0),
            1 => weights.fill(0.0),
            _ => {}
        }
        weights[n / 2] += 1.0;
        macro_rules! judge {
            ($word:ty) => {
                let table = Alias::<Vec<AliasEntry<$word>>>::from_slice(&weights).unwrap();
                let bins = table.as_bins();
                assert_eq!(Alias::from_bins(bins.to_vec(), n).as_ref(), Ok(&table));
                let at = rng.next_u32() as usize % bins.len();
                let mut wrong = bins.to_vec();
                let old = wrong[at];
                let (mut threshold, mut numerator, mut alias) =
                    (old.threshold(), old.numerator(), old.alias());
                match rng.next_u32() % 3 {
                    0 => threshold ^= 1 << (rng.next_u32() % 32),
                    1 => numerator ^= 1 << (rng.next_u32() % 32),
                    _ => alias ^= 1 << (rng.next_u32() % 8),
                }
                wrong[at] = AliasEntry::new(threshold, numerator, alias);
                match Alias::from_bins(wrong, n) {
                    Err(error) => {
                        assert_eq!(error, Error::NotATable);
                        rejected += 1;
                    }
                    // The entry of all words has no use for its threshold.
                    Ok(table) => {
                        assert_eq!(table.pmf(at), 1.0, "{weights:?} {old:?}");
                        assert_eq!(table.draw(&mut rng).index, at);
                    }
                }
            };
        }
        judge!(u32);
        judge!(u64);
    }
    assert!(rejected > 1_000, "{rejected}");
}
