//! How the benches measure: many draws with one generator.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use rand_pcg::Pcg32;

const ITEMS: usize = 1_024;

/// Repeats an action that draws.
pub fn repeat<T>(bencher: Bencher, mut action: impl FnMut(&mut Pcg32) -> T) {
    let mut rng = Pcg32::new(1, 1);
    bencher.counter(ItemsCount::new(ITEMS)).bench_local(|| {
        for _ in 0..ITEMS {
            black_box(action(&mut rng));
        }
    });
}
