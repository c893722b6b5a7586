//! The subjects of orders: shuffles, choices, permutations, Latin hypercubes and the order of a picture.

use crate::Out;
use crate::integers::stirred;
use crate::subjects::{generator, refusal, with};
use microwarp::uniform::{
    ChoiceInOrder, ChoiceOfStream, LatinHypercube, Permutation, Points, Screen, Sobol, choose,
    choose_with, shuffle, shuffle_each, shuffle_with, try_choose, try_choose_with, try_shuffle,
    try_shuffle_each, try_shuffle_with,
};
use rand_core::Rng;

/// Many words as one, of which each counts.
fn folded(words: impl IntoIterator<Item = u32>) -> u32 {
    let words = words.into_iter();
    words.fold(0, |all, word| all.rotate_left(7) ^ word)
}

/// Exchanges two items. What is outside stays: an index that can panic would link what says so.
fn exchange(items: &mut [u16], i: usize, j: usize) {
    if let (Some(&x), Some(&y)) = (items.get(i), items.get(j)) {
        for (place, item) in [(i, y), (j, x)] {
            if let Some(at) = items.get_mut(place) {
                *at = item;
            }
        }
    }
}

pub fn shuffles(u: [f32; 4], input: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let mut rng = generator(input);
    let mut deck: [u32; 52] = core::array::from_fn(|card| card as u32);
    shuffle(&mut deck, &mut rng);
    let Ok(()) = try_shuffle(&mut deck, &mut rng);
    out.word(folded(deck));
    shuffle_each(&mut deck, &mut rng);
    let Ok(()) = try_shuffle_each(&mut deck, &mut rng);
    out.word(folded(deck));
    let mut many: [u16; 300] = core::array::from_fn(|item| item as u16);
    shuffle_with(300, &mut rng, |i, j| exchange(&mut many, i, j));
    let Ok(()) = try_shuffle_with(300, &mut rng, |i, j| exchange(&mut many, i, j));
    out.word(folded(many.map(u32::from)));
    match choose(&mut deck, (a >> 26) as usize, &mut rng) {
        Ok((some, others)) => {
            out.word(folded(some.iter().copied()));
            out.word(folded(others.iter().copied()));
        }
        Err(e) => out.word(refusal(e)),
    }
    let refused = choose_with(300, 5, &mut rng, |i, j| exchange(&mut many, i, j)).is_err();
    let Ok(done) = try_choose_with(300, b as usize >> 23, &mut rng, |i, j| {
        exchange(&mut many, i, j)
    });
    out.word(done.map_or_else(refusal, |()| u32::from(refused)));
    let Ok(chosen) = try_choose(&mut many, 7, &mut rng);
    out.word(chosen.map_or_else(refusal, |(some, _)| folded(some.iter().map(|&x| x.into()))));
    out.word(rng.next_u32());
    with(
        ChoiceInOrder::new(c & 31, d & 63),
        out,
        |mut choice, out| {
            let taken = (0..64).map(|_| u32::from(choice.draw(&mut rng)));
            out.word(folded(taken) ^ u32::from(choice.take(0)));
        },
    );
    with(ChoiceOfStream::new(c & 7), out, |mut choice, out| {
        out.word(choice.take(d).unwrap_or(99));
        let places = (0..64).map(|_| choice.draw(&mut rng).unwrap_or(99));
        out.word(folded(places));
    });
}

pub fn permutations(u: [f32; 4], _: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    for count in [a & 15, (b & 1023) + 1, c, d | 1 << 31] {
        with(Permutation::new(count, a), out, |order, out| {
            let last = order.count().wrapping_sub(1);
            let places = [0, last, last / 2, c];
            out.word(folded(
                places.map(|place| order.get(place).unwrap_or(count)),
            ));
            out.word(folded(
                places.map(|number| order.index_of(number).unwrap_or(count)),
            ));
        });
    }
    for count in [a & 15, (b & 1023) + 1, c] {
        with(LatinHypercube::new(count, a), out, |points, out| {
            let indices = [0, 1, points.count().wrapping_sub(1), d];
            out.word(folded(indices.map(|index| points.word(index, d & 3))));
        });
    }
}

pub fn screens(u: [f32; 4], _: usize, out: &mut Out) {
    let [a, b, c, d] = stirred(u);
    let Ok(set) = Sobol::<8>::new(a) else { return };
    for (size, log2_samples) in [
        ([1920, 1080], 4),
        ([(b & 1023) + 1, c & 1023], b >> 28),
        ([c, d], d & 3),
        ([1, 1], 32),
    ] {
        with(
            Screen::new(set, size, log2_samples, a),
            out,
            |screen, out| {
                let pixel = screen.pixel(c & 2047, d & 1023);
                out.word(pixel.index(d >> 28));
                out.word(folded(pixel.words::<3>(c >> 28)));
                out.word(pixel.word(d, 1) ^ screen.pixel(a, d).word(c, 9));
            },
        );
    }
}
