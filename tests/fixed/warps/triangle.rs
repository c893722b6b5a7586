//! Barycentric coordinates.

use super::figures::{Figures, WORD, hold, over_pairs, sample_rows};
use fixed::types::{I2F30, U0F32};
use host::truth::{Barycentric, Truth};
use microwarp::fixed::warp::Triangle;
use microwarp::fixed::{Coarse, Compact, Fine, Grade};
use microwarp::{Invert, Warp};

const PAIRS: u64 = 1 << 22;

fn truth([u, v]: [u32; 2]) -> [f64; 3] {
    Barycentric.sample([f64::from(u) * WORD, f64::from(v) * WORD, 0.0, 0.0])
}

fn sample_error<G: Grade>() -> Figures {
    let warp = Triangle::<G>::new();
    over_pairs(PAIRS, |pair, observe| {
        let got = warp.sample(pair.map(U0F32::from_bits));
        assert_eq!(got[0] + got[1] + got[2], 1);
        assert!(got.iter().all(|c| *c >= 0));
        assert_eq!(warp.pdf(got), 2);
        // The third is what the others leave of 1.
        for (got, due) in got.into_iter().zip(truth(pair)).take(2) {
            observe(got.to_num::<f64>() - due);
        }
    })
}

fn round_trip<G: Grade>() -> Figures {
    let warp = Triangle::<G>::new();
    over_pairs(PAIRS / 2, |pair, observe| {
        let back = warp.invert(warp.sample(pair.map(U0F32::from_bits)));
        let [u, v] = [0, 1].map(|i| (f64::from(back[i].to_bits()) - f64::from(pair[i])) * WORD);
        observe(u);
        observe(v * (f64::from(pair[0]) * WORD).sqrt());
    })
}

#[test]
fn the_triangle_keeps_its_stated_errors() {
    let samples = [
        sample_error::<Fine>(),
        sample_error::<Coarse>(),
        sample_error::<Compact>(),
    ];
    let back = [
        round_trip::<Fine>(),
        round_trip::<Coarse>(),
        round_trip::<Compact>(),
    ];
    let mut rows = sample_rows(samples).to_vec();
    rows.push(("round trip", back.map(|f| f.max)));
    hold("Triangle", &rows);
}

#[test]
fn corners_are_reached_and_what_is_outside_has_no_density() {
    let warp = Triangle::<Fine>::new();
    let point = |c: [f64; 3]| c.map(I2F30::from_num);
    for v in [0, 1 << 31, u32::MAX] {
        assert_eq!(warp.sample([0, v].map(U0F32::from_bits)), [1, 0, 0]);
    }
    assert_eq!(
        warp.sample([1 << 30, 1 << 31].map(U0F32::from_bits)),
        [0.5, 0.25, 0.25]
    );
    for outside in [
        [1.5, -0.25, -0.25],
        [0.5, 0.5, 0.5],
        [0.0, 0.0, 0.0],
        [-1.0, 1.0, 1.0],
    ] {
        assert_eq!(warp.pdf(point(outside)), 0);
    }
    assert_eq!(warp.invert(point([0.5, 0.25, 0.25])), [0.25, 0.5]);
    assert_eq!(warp.invert(point([0.0, 1.0, 0.0])), [U0F32::MAX; 2]);
    assert_eq!(
        warp.invert(point([0.0, 0.0, 1.0])),
        [U0F32::MAX, U0F32::ZERO]
    );
    assert_eq!(warp.invert(point([1.0, 0.0, 0.0])), [0, 0]);
    let ends = [I2F30::MIN, I2F30::ZERO, I2F30::MAX];
    for a in ends {
        for b in ends {
            for c in ends {
                assert_eq!(warp.pdf([a, b, c]), 0);
                let _ = warp.invert([a, b, c]);
            }
        }
    }
}
