//! Host time in nanoseconds of selections, tries and estimators, next to the generator alone.
//!
//! `cargo bench --bench tables`. Each figure is for 1,024 of them with PCG32; compare figures of one run
//! only. The times to build tables, per entry, come last.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use host::bench::repeat;
use microwarp::Warp;
use microwarp::discrete::*;
use microwarp::estimate::{Integral, Moments, WeightedMean, balance_heuristic, power_heuristic};
use microwarp::poly as mw;
use microwarp::rejection::{BallRejection, Bounded, DiskRejection, Rejection};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

fn main() {
    divan::main();
}

fn weights(n: usize) -> Vec<f32> {
    let mut rng = Pcg32::new(2, 2);
    (0..n).map(|_| (rng.next_u32() >> 20) as f32).collect()
}

#[divan::bench]
fn a_floor_of_one_word(bencher: Bencher) {
    repeat(bencher, |rng| rng.next_u32());
}

#[divan::bench(args = [6, 64, 1_024, 65_536, 1_048_576])]
fn cdf_u32(bencher: Bencher, n: usize) {
    let mut memory = vec![0; n];
    let table = Cdf::<&[u32]>::new_in(&weights(n), &mut memory).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench(args = [6, 64, 1_024, 65_536, 1_048_576])]
fn cdf_u64(bencher: Bencher, n: usize) {
    let mut memory = vec![0; n];
    let table = Cdf::<&[u64]>::new_in(&weights(n), &mut memory).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench(args = [6, 1_024, 1_048_576])]
fn cdf_u32_index_only(bencher: Bencher, n: usize) {
    let mut memory = vec![0; n];
    let table = Cdf::<&[u32]>::new_in(&weights(n), &mut memory).unwrap();
    repeat(bencher, |rng| black_box(&table).index(rng.next_u32()));
}

#[divan::bench(args = [6, 64, 1_024, 65_536, 1_048_576])]
fn alias_u32(bencher: Bencher, n: usize) {
    let mut memory = vec![AliasEntry::<u32>::EMPTY; n.next_power_of_two()];
    let table = Alias::<&[AliasEntry<u32>]>::new_in(&weights(n), &mut memory).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench(args = [6, 1_024, 1_048_576])]
fn alias_u64(bencher: Bencher, n: usize) {
    let mut memory = vec![AliasEntry::<u64>::EMPTY; n.next_power_of_two()];
    let table = Alias::<&[AliasEntry<u64>]>::new_in(&weights(n), &mut memory).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench(args = [2, 8, 64])]
fn select_once_over(bencher: Bencher, n: usize) {
    let weights = weights(n);
    repeat(bencher, |rng| {
        select_once(black_box(&weights), rng.next_u32())
    });
}

#[divan::bench]
fn reservoir_offer(bencher: Bencher) {
    let mut reservoir = Reservoir::new();
    repeat(bencher, |rng| reservoir.offer(0_u32, black_box(1.5), rng));
}

#[divan::bench]
fn piecewise_1d_of_1024(bencher: Bencher) {
    let mut memory = vec![0; 1_024];
    let cdf = Cdf::<&[u32]>::new_in(&weights(1_024), &mut memory).unwrap();
    let table = PiecewiseConstant1d::from_cdf(cdf, 0.0, 1.0).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench]
fn piecewise_2d_of_256_by_128(bencher: Bencher) {
    let (mut rows, mut cells) = (vec![0; 128], vec![0; 256 * 128]);
    let weights = weights(256 * 128);
    let (shape, unit) = ([256, 128], [0.0, 1.0]);
    type Borrowed<'a> = PiecewiseConstant2d<&'a [u32], &'a [u32]>;
    let table = Borrowed::new_in(&weights, shape, unit, unit, &mut rows, &mut cells).unwrap();
    repeat(bencher, |rng| black_box(&table).draw(rng));
}

#[divan::bench]
fn rejection_disk(bencher: Bencher) {
    repeat(bencher, |rng| black_box(DiskRejection::new()).draw(rng));
}

#[divan::bench]
fn rejection_ball(bencher: Bencher) {
    repeat(bencher, |rng| black_box(BallRejection::new()).draw(rng));
}

#[divan::bench]
fn rejection_bump_on_the_disk(bencher: Bencher) {
    let bump = |[x, y]: [f32; 2]| 1.0 / (1.0 + x * x + y * y);
    let bounded = Bounded::new(mw::Disk::new(), bump, std::f32::consts::PI).unwrap();
    repeat(bencher, |rng| black_box(&bounded).draw(rng));
}

#[divan::bench]
fn moments_push(bencher: Bencher) {
    let mut moments = Moments::new();
    repeat(bencher, |rng| moments.push(rng.next_u32() as f32));
}

#[divan::bench]
fn integral_push(bencher: Bencher) {
    let mut integral = Integral::new();
    repeat(bencher, |rng| {
        integral.push(rng.next_u32() as f32, black_box(0.5))
    });
}

#[divan::bench]
fn ratio_push(bencher: Bencher) {
    let mut ratio = WeightedMean::new();
    repeat(bencher, |rng| {
        ratio.push(rng.next_u32() as f32, black_box(0.5))
    });
}

#[divan::bench]
fn balance(bencher: Bencher) {
    repeat(bencher, |rng| {
        balance_heuristic(1, rng.next_u32() as f32, 1, black_box(1e9))
    });
}

#[divan::bench]
fn power(bencher: Bencher) {
    repeat(bencher, |rng| {
        power_heuristic(1, rng.next_u32() as f32, 1, black_box(1e9))
    });
}

/// Nanoseconds per entry.
#[divan::bench(args = [64, 65_536])]
fn building_cdf_u32(bencher: Bencher, n: usize) {
    let (weights, mut memory) = (weights(n), vec![0; n]);
    bencher.counter(ItemsCount::new(n)).bench_local(|| {
        black_box(Cdf::<&[u32]>::new_in(black_box(&weights), &mut memory).is_ok());
    });
}

/// Nanoseconds per entry.
#[divan::bench(args = [64, 65_536])]
fn building_alias_u32(bencher: Bencher, n: usize) {
    let (weights, mut memory) = (weights(n), vec![AliasEntry::<u32>::EMPTY; n]);
    bencher.counter(ItemsCount::new(n)).bench_local(|| {
        black_box(Alias::<&[AliasEntry<u32>]>::new_in(black_box(&weights), &mut memory).is_ok());
    });
}

/// Nanoseconds a table: all words are checked.
#[divan::bench(args = [64, 4_096])]
fn cdf_from_words(bencher: Bencher, n: usize) {
    let mut memory = vec![0; n];
    let table = Cdf::<&[u32]>::new_in(&weights(n), &mut memory).unwrap();
    bencher.bench_local(|| black_box(Cdf::from_words(black_box(table.as_words())).is_ok()));
}

/// Nanoseconds a table: the words are not looked at.
#[divan::bench(args = [64, 4_096])]
fn cdf_from_trusted_words(bencher: Bencher, n: usize) {
    let mut memory = vec![0; n];
    let table = Cdf::<&[u32]>::new_in(&weights(n), &mut memory).unwrap();
    bencher.bench_local(|| black_box(Cdf::from_trusted_words(black_box(table.as_words())).is_ok()));
}
