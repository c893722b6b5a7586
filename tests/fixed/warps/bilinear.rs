//! The bilinear patch.

use super::families::plane::linear;
use super::figures::{Figures, WORD, hold, over_pairs, sample_rows};
use fixed::types::{U0F32, U16F16, U32F0};
use microwarp::fixed::warp::Bilinear;
use microwarp::fixed::{Coarse, Compact, Density, Fine, Grade};
use microwarp::{Error, Invert, Warp};

const PAIRS: u64 = 1 << 22;
const WEIGHTS: [[f64; 2]; 2] = [[1.0, 3.0], [2.0, 0.0]];

fn patch<G: Grade>(weights: [[f64; 2]; 2]) -> Bilinear<G> {
    Bilinear::new(weights.map(|row| row.map(U16F16::from_num))).unwrap()
}

/// x for the y that is returned.
fn truth([u, v]: [u32; 2], y: f64) -> [f64; 2] {
    let ends = [0, 1].map(|x| (1.0 - y) * WEIGHTS[0][x] + y * WEIGHTS[1][x]);
    let x = linear(ends, f64::from(u) * WORD);
    [x, linear([4.0, 2.0], f64::from(v) * WORD)]
}

fn sample_error<G: Grade>() -> Figures {
    let warp = patch::<G>(WEIGHTS);
    over_pairs(PAIRS, |pair, observe| {
        let got = warp.sample(pair.map(U0F32::from_bits));
        assert!(warp.pdf(got) > 0);
        let got = got.map(|c| c.to_num::<f64>());
        for (got, due) in got.into_iter().zip(truth(pair, got[1])) {
            observe(got - due);
        }
    })
}

fn round_trip<G: Grade>() -> Figures {
    let warp = patch::<G>(WEIGHTS);
    over_pairs(PAIRS / 2, |pair, observe| {
        let back = warp.invert(warp.sample(pair.map(U0F32::from_bits)));
        for (back, word) in back.into_iter().zip(pair) {
            observe((f64::from(back.to_bits()) - f64::from(word)) * WORD);
        }
    })
}

#[test]
fn the_patch_keeps_its_stated_errors() {
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
    hold("Bilinear", &rows);
}

#[test]
fn weights_of_0_leave_out_their_corners_edges_and_points() {
    let sample = |weights, u: [u32; 2]| patch::<Fine>(weights).sample(u.map(U0F32::from_bits));
    for u in [0, 1, 1 << 31, u32::MAX] {
        for v in [0, 1, 1 << 31, u32::MAX] {
            let [x, y] = sample([[0.0, 0.0], [0.0, 1.0]], [u, v]);
            for (got, word) in [(x, u), (y, v)] {
                let due = (f64::from(word) * WORD).sqrt();
                let off = (got.to_num::<f64>() - due).abs();
                assert!(off <= 3e-7, "{word}: {got} for {due}");
            }
            assert!(y > 0);
            let [x, y] = sample([[1.0, 0.0], [0.0, 0.0]], [u, v]);
            for (got, word) in [(x, u), (y, v)] {
                let due = 1.0 - (1.0 - f64::from(word) * WORD).sqrt();
                let off = (got.to_num::<f64>() - due).abs();
                assert!(off <= 3e-7, "{word}: {got} for {due}");
            }
        }
    }
    let flat = patch::<Fine>([[2.5; 2]; 2]);
    let near_1 = |density: Density| density.abs_diff(Density::ONE) <= 2 * Density::DELTA;
    assert!(flat.corners().iter().flatten().all(|d| near_1(*d)));
    assert_eq!(patch::<Fine>(WEIGHTS).corners()[1][1], 0);
    for word in [0, 1 << 31, u32::MAX] {
        let point = [word, !word].map(U0F32::from_bits);
        assert!(near_1(flat.pdf(point)));
        let off = flat.sample(point)[0].abs_diff(point[0]).to_num::<f64>();
        assert!(off <= 2.1e-7, "{point:?}: {off}");
    }
}

#[test]
fn weights_that_are_all_0_are_refused_and_others_count_by_their_ratios() {
    let refused = Bilinear::<Fine>::new([[U32F0::ZERO; 2]; 2]);
    assert_eq!(refused, Err(Error::NotPositive(0)));
    let bits = [[1, 3], [2, 0]];
    let of_units = Bilinear::<Fine>::new(bits.map(|row| row.map(U32F0::from_bits)));
    let of_steps = Bilinear::<Fine>::new(bits.map(|row| row.map(U0F32::from_bits)));
    assert_eq!(of_units, of_steps);
    assert_eq!(of_units, Ok(patch(WEIGHTS)));
}
