//! What a draw takes from a generator, and that it is what the words select.

use host::generators::{Broken, Counting, Failing};
use microwarp::discrete::{Alias, AliasEntry, Cdf, Reservoir};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

#[test]
fn a_draw_takes_the_stated_words_and_passes_a_failure_on() {
    fn driver(left: u64) -> Counting<Failing> {
        Counting::new(Failing {
            word: 0x9234_5678,
            left,
        })
    }
    fn takes<T>(words: u64, draw: impl Fn(&mut Counting<Failing>) -> Result<T, Broken>) {
        let mut rng = driver(9);
        assert!(draw(&mut rng).is_ok());
        assert_eq!(rng.words, words);
        for left in 0..words {
            assert!(draw(&mut driver(left)).is_err());
        }
    }
    const WEIGHTS: [f32; 4] = [1.0, 2.0, 0.0, 4.0];
    let narrow = Cdf::new(&WEIGHTS).unwrap();
    let wide = Cdf::new_u64(&WEIGHTS).unwrap();
    let alias = Alias::<[AliasEntry<u32>; 4]>::new(&WEIGHTS).unwrap();
    let wide_alias = Alias::<[AliasEntry<u64>; 4]>::new_u64(&WEIGHTS).unwrap();
    takes(1, |rng| narrow.try_draw(rng));
    takes(2, |rng| wide.try_draw(rng));
    takes(1, |rng| alias.try_draw(rng));
    takes(1, |rng| narrow.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw_index(rng));
    takes(2, |rng| wide_alias.try_draw(rng));
    takes(2, |rng| Reservoir::new().try_offer(1, 0.0, rng));
    takes(2, |rng| {
        Reservoir::<u8>::new().try_merge(Reservoir::new(), rng)
    });
    // What is drawn is what the words select, of which every one is counted; the leading word comes first.
    let (mut rng, mut words) = (Pcg32::new(4, 4), Pcg32::new(4, 4));
    for _ in 0..1000 {
        let word = words.next_u32();
        assert_eq!(narrow.draw(&mut rng), narrow.select(word));
        let word = words.next_u32();
        assert_eq!(alias.draw(&mut rng), alias.select(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide.draw(&mut rng), wide.select_word(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide_alias.draw(&mut rng), wide_alias.select_word(word));
        // The index alone is that of the selection.
        let word = words.next_u32();
        assert_eq!(narrow.draw_index(&mut rng), narrow.index(word));
        let word = u64::from(words.next_u32()) << 32 | u64::from(words.next_u32());
        assert_eq!(wide_alias.draw_index(&mut rng), wide_alias.index(word));
    }
    assert_eq!(rng, words);
}
