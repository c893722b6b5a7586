//! Where tables lie: in arrays, on the heap, in borrowed memory, in a container of the user's. What making them takes of
//! the stack is in `stack`, and what tables of wrong words still keep in `trusted`.

use microwarp::discrete::{
    Alias, AliasEntry, Cdf, OwnedStorage, PiecewiseConstant1d, PiecewiseConstant2d, Storage, Word,
};
use microwarp::{Error, Warp, constant};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

pub const UNIT: [f32; 2] = [0.0, 1.0];

pub fn weights(n: usize) -> Vec<f32> {
    let mut rng = Pcg32::new(n as u64, 15);
    let mut weights: Vec<f32> = (0..n).map(|_| (rng.next_u32() >> 20) as f32).collect();
    weights[n / 2] += 1.0;
    weights
}

#[test]
fn arrays_need_no_annotations() {
    let table = Cdf::new(&[1.0, 2.0]).unwrap();
    assert_eq!(table.as_words(), [1_431_655_766_u32, 1]);
    let integers = Cdf::from_integers(&[1, 2]).unwrap();
    assert_eq!(integers, table);
    let wide = Cdf::new_u64(&[1.0, 2.0]).unwrap();
    assert_eq!(wide, Cdf::from_integers_u64(&[1, 2]).unwrap());
    let alias = Alias::<[_; 2]>::new(&[1.0, 2.0]).unwrap();
    assert_eq!(alias.numerator(1), table.numerator(1));
    let line = PiecewiseConstant1d::new(&[1.0, 2.0], -1.0, 8.0).unwrap();
    assert_eq!((line.low(), line.high()), (-1.0, 8.0));
    assert_eq!(
        line,
        PiecewiseConstant1d::from_integers(&[1, 2], -1.0, 8.0).unwrap()
    );
    let wide_line = PiecewiseConstant1d::from_integers_u64(&[1, 2], -1.0, 8.0).unwrap();
    assert_eq!(*wide_line.cdf(), wide);
    let plane = PiecewiseConstant2d::new(&[[1.0, 2.0], [3.0, 4.0]], [-1.0, 8.0], UNIT).unwrap();
    assert_eq!((plane.u(), plane.v()), ([-1.0, 8.0], UNIT));
}

/// Up to a number of items, the others being unused.
struct Own<T>([T; 64], usize);

impl<T: Copy> Storage for Own<T> {
    type Item = T;
    fn items(&self) -> &[T] {
        &self.0[..self.1]
    }
}

impl<T: Copy> OwnedStorage for Own<T> {
    fn filled(item: T, length: usize) -> Option<Self> {
        (length <= 64).then_some(Self([item; 64], length))
    }
    fn items_mut(&mut self) -> &mut [T] {
        &mut self.0[..self.1]
    }
}

#[test]
fn every_storage_holds_the_words_of_the_array() {
    const WEIGHTS: [f32; 6] = [1.0, 0.0, 4.0, 0.5, 1e-6, 0.0];
    const INTEGERS: [u32; 6] = [1, 0, 4, 5, 1_000_000, 0];
    macro_rules! held {
        ($word:ty, $new:ident, $from_integers:ident) => {
            held!(@ $word, Cdf::$new(&WEIGHTS), Alias::<[_; 8]>::$new(&WEIGHTS), from_slice(&WEIGHTS));
            held!(@ $word, Cdf::$from_integers(&INTEGERS), Alias::<[_; 8]>::$from_integers(&INTEGERS),
                from_integer_slice(&INTEGERS));
        };
        (@ $word:ty, $cdf:expr, $alias:expr, $from:ident($weights:expr)) => {{
            let (cdf, alias) = ($cdf.unwrap(), $alias.unwrap());
            held!(@@ cdf as_words, Cdf, $word, $from($weights));
            held!(@@ alias as_bins, Alias, AliasEntry<$word>, $from($weights));
            let line = PiecewiseConstant1d::<Vec<$word>>::$from($weights, -1.0, 2.0).unwrap();
            assert_eq!(line.cdf().as_words(), cdf.as_words());
        }};
        (@@ $array:ident $items:ident, $table:ident, $item:ty, $from:ident($weights:expr)) => {
            let mut vec = $table::<Vec<$item>>::$from($weights).unwrap();
            assert_eq!(vec.$items(), $array.$items());
            assert_eq!($table::<Box<[$item]>>::$from($weights).unwrap().$items(), $array.$items());
            let bounded = $table::<heapless::Vec<$item, 8>>::$from($weights).unwrap();
            assert_eq!(bounded.$items(), $array.$items());
            assert_eq!($table::<Own<$item>>::$from($weights).unwrap().$items(), $array.$items());
            vec.clone_from(&vec.clone());
            let mut rng = Pcg32::new(3, 3);
            assert_eq!(vec.draw_index(&mut rng.clone()), $array.draw_index(&mut rng));
        };
    }
    // The compiler makes tables, and memory that is lent keeps what is beyond them.
    const FLASH: Cdf<[u32; 6]> = constant!(Cdf::new(&WEIGHTS));
    static WIDE: Alias<[AliasEntry<u64>; 8]> =
        constant!(Alias::<[AliasEntry<u64>; 8]>::from_integers_u64(&INTEGERS));
    assert_eq!((size_of_val(&FLASH), size_of_val(&WIDE)), (24, 8 * 24 + 8));
    assert_eq!(size_of::<AliasEntry<u32>>(), 12);
    let mut memory = [7; 9];
    let slice = Cdf::<&[u32]>::new_in(&WEIGHTS, &mut memory).unwrap();
    assert_eq!(FLASH.view(), slice);
    let again = Cdf::from_words(*slice.as_words().first_chunk::<6>().unwrap());
    assert_eq!((again, &memory[6..]), (Ok(FLASH), &[7; 3][..]));
    let mut memory = [AliasEntry::<u64>::EMPTY; 8];
    let slice = Alias::<&[AliasEntry<u64>]>::from_integers_in(&INTEGERS, &mut memory).unwrap();
    assert_eq!(WIDE.view(), slice);
    held!(u32, new, from_integers);
    held!(u64, new_u64, from_integers_u64);
    assert_eq!(
        Alias::<Vec<AliasEntry<u32>>>::from_slice(&[1.0; 5])
            .unwrap()
            .bins(),
        8
    );
}

/// A map of 6 by 3 cells, over ranges.
type Map<W> = PiecewiseConstant2d<[W; 3], [[W; 6]; 3]>;

fn same_on_the_heap<W: Word>(array: Map<W>, flat: &[f32], [u, v]: [[f32; 2]; 2]) {
    let vec = PiecewiseConstant2d::<Vec<W>, Vec<W>>::from_slice(flat, [6, 3], u, v).unwrap();
    let boxed = PiecewiseConstant2d::<Box<[W]>, Box<[W]>>::from_slice(flat, [6, 3], u, v).unwrap();
    assert_eq!(vec.as_words(), array.as_words());
    assert_eq!(boxed.as_words(), array.as_words());
    let mut rngs = [Pcg32::new(1, 2), Pcg32::new(1, 2)];
    for _ in 0..1000 {
        let points = (array.draw(&mut rngs[0]), vec.draw(&mut rngs[1]));
        assert_eq!(points.0.map(f32::to_bits), points.1.map(f32::to_bits));
        assert_eq!(array.pdf(points.0).to_bits(), vec.pdf(points.1).to_bits());
    }
}

#[test]
fn a_map_on_the_heap_has_the_bits_of_the_array() {
    let rows: [[f32; 6]; 3] = std::array::from_fn(|v| weights(6 + v)[..6].try_into().unwrap());
    let (u, v) = ([-3.0, 5.0], UNIT);
    let (narrow, wide) = (Map::new(&rows, u, v), Map::new_u64(&rows, u, v));
    same_on_the_heap(narrow.unwrap(), rows.as_flattened(), [u, v]);
    same_on_the_heap(wide.unwrap(), rows.as_flattened(), [u, v]);
    // Refused as an array would be.
    type Heap = PiecewiseConstant2d<Vec<u32>, Vec<u32>>;
    let refused = |weights: &[f32], shape| Heap::from_slice(weights, shape, UNIT, UNIT).err();
    assert_eq!(refused(&[1.0; 6], [2, 2]), Some(Error::OutOfRange(1)));
    assert_eq!(refused(&[], [0, 0]), Some(Error::NoWeights));
    let dim = [1.0, 1.0, 0.0, 1e-12, 0.0, 1e-12];
    assert_eq!(refused(&dim, [2, 3]), Some(Error::Unreachable(3)));
    let cell = [1.0, 1.0, 1.0, 1.0, 1e-12, 1e-13];
    assert_eq!(refused(&cell, [3, 2]), Some(Error::Unreachable(5)));
    type Bounded = PiecewiseConstant2d<heapless::Vec<u32, 2>, heapless::Vec<u32, 5>>;
    let bounded = |shape| Bounded::from_slice(&[1.0; 6], shape, UNIT, UNIT).err();
    assert_eq!(bounded([3, 2]), Some(Error::TooManyWeights));
}

/// Storage that does not keep to what was asked for.
struct Liar<T>(Vec<T>);

impl<T: Copy> Storage for Liar<T> {
    type Item = T;
    fn items(&self) -> &[T] {
        &self.0
    }
}

impl<T: Copy> OwnedStorage for Liar<T> {
    fn filled(item: T, length: usize) -> Option<Self> {
        Some(Self(vec![item; length - 1]))
    }
    fn items_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

#[test]
fn storage_without_room_is_refused() {
    let full = Some(Error::TooManyWeights);
    assert_eq!(Cdf::<Own<u32>>::from_slice(&[1.0; 65]).err(), full);
    assert_eq!(
        Alias::<Own<AliasEntry<u32>>>::from_slice(&[1.0; 64]).err(),
        None
    );
    assert_eq!(
        Alias::<Own<AliasEntry<u32>>>::from_slice(&[1.0; 65]).err(),
        full
    );
    assert_eq!(Cdf::<Liar<u32>>::from_slice(&[1.0; 4]).err(), full);
    assert_eq!(
        Alias::<Liar<AliasEntry<u64>>>::from_slice(&[1.0; 4]).err(),
        full
    );
}
