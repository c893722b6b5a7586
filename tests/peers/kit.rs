//! The rest of a renderer's kit by hand does what ours does, so that the benches compare like with like.

use crate::renderers::{ALPHA, VIEW, apart, apart_on_the_line};
use host::peers::kit::{self, Curve, Mitchell, Piecewise, PiecewiseRows, WeightedReservoir};
use host::peers::uniform;
use microwarp::discrete::{
    LightReservoir, Mixture, PiecewiseConstant1d, PiecewiseConstant2d, SignedLinear1d, filter,
};
use microwarp::estimate::{balance_heuristic, power_heuristic};
use microwarp::uniform::{Screen, Sobol};
use microwarp::{Error, Warp, poly as mw};
use rand_pcg::Pcg32;
use std::collections::BTreeSet;

#[test]
fn reflections_and_masking_are_those_of_ours() -> Result<(), Error> {
    let reflected = mw::Reflected::new(mw::GgxVisible::new(VIEW, ALPHA)?);
    let off = |alpha| {
        let (densities, means) = apart(&reflected, |u| kit::ggx_reflection(VIEW, alpha, u));
        densities.max(means)
    };
    assert!(off(ALPHA) <= 2e-3, "{}", off(ALPHA));
    assert!(off([0.3, 0.21]) > 2e-3);
    for view in [VIEW, [0.0, 0.0, 1.0], [0.6, -0.64, 0.48], [-0.8, 0.6, 1e-3]] {
        let off = |alpha| {
            let ours = mw::Ggx::new(ALPHA).map(|surface| surface.g1(view));
            ours.map(|ours| (kit::ggx_g1(view, alpha) / ours - 1.0).abs())
        };
        assert!(off(ALPHA)? <= 1e-5, "{view:?}: {}", off(ALPHA)?);
        assert!(view[2] == 1.0 || off([0.33, 0.22])? > 1e-3, "{view:?}");
    }
    Ok(())
}

#[test]
fn tables_and_filters_have_the_distributions_of_ours() -> Result<(), Error> {
    let weights: [f32; 5] = [1.0, 3.0, 0.5, 2.0, 4.0];
    let ours = PiecewiseConstant1d::<[u32; 5]>::new(&weights, 0.0, 2.0)?;
    let of = |weights: &[f32]| {
        let peer = Piecewise::new(weights, [0.0, 2.0]);
        apart_on_the_line(&ours, |[u]| {
            let (point, density, _) = peer.sample(u);
            (point, density)
        })
    };
    assert!(of(&weights) <= 1e-5);
    assert!(of(&[1.0, 3.0, 0.6, 2.0, 4.0]) > 1e-2);

    let rows = [weights, [2.0, 0.1, 1.0, 1.0, 0.3], [1.0; 5]];
    let ours = PiecewiseConstant2d::<[u32; 3], _>::new(&rows, [0.0, 2.0], [0.0, 1.0])?;
    let peer = PiecewiseRows::new(
        rows.iter().map(|row| row.as_slice()),
        [[0.0, 2.0], [0.0, 1.0]],
    );
    let (densities, means) = apart(&ours, |u| peer.sample(u));
    assert!(densities <= 1e-5 && means <= 1e-5, "{densities}, {means}");

    let tent = mw::Tent::new(1.5)?;
    assert!(apart_on_the_line(&tent, |u| kit::tent(1.5, u)) <= 1e-5);
    assert!(apart_on_the_line(&tent, |u| kit::tent(1.6, u)) > 1e-2);
    Ok(())
}

/// Of functions of a place, the means under the filter.
#[test]
fn pixel_filters_have_the_means_of_ours() -> Result<(), Error> {
    const THIRD: f32 = 1.0 / 3.0;
    let ours = SignedLinear1d::new(&filter::mitchell::<65>(THIRD, THIRD), -2.0, 2.0)?;
    let off = |b: f32| {
        let peer = Mitchell::new(2, b, THIRD);
        let mut means = [0.0; 3];
        for k in 0..=u16::MAX {
            let u = [k % 256, k / 256].map(|i| (f32::from(i) + 0.5) / 256.0);
            let [(x, across), (y, down)] = u.map(|u| ours.sample(u));
            for (sign, ([x, y], weight)) in [(1.0, ([x, y], across * down)), (-1.0, peer.sample(u))]
            {
                for (mean, value) in means.iter_mut().zip([1.0, x * x, x * y]) {
                    *mean += f64::from(sign * weight * value) / 65_536.0;
                }
            }
        }
        means
            .into_iter()
            .fold(0.0, |most, mean| mean.abs().max(most))
    };
    assert!(off(THIRD) <= 2e-3, "{}", off(THIRD));
    assert!(off(0.4) > 1e-2, "{}", off(0.4));
    Ok(())
}

#[test]
fn weights_are_those_of_ours() {
    let densities = [1e-3_f32, 0.3, 1.0, 7.0, 200.0];
    for (own, other) in densities
        .iter()
        .flat_map(|own| densities.map(|other| (*own, other)))
    {
        let balance = balance_heuristic(1, own, 1, other);
        let power = power_heuristic(1, own, 1, other);
        assert!((kit::balance_heuristic(own, other) - balance).abs() <= 1e-6);
        assert!((kit::power_heuristic(own, other) - power).abs() <= 1e-6);
        assert!(own == other || (balance - power).abs() > 1e-6);
    }
}

#[test]
fn choices_have_the_probabilities_of_ours() -> Result<(), Error> {
    const RUNS: u32 = 40_000;
    let targets = [1.0_f32, 4.0, 2.0, 3.0];
    let mut rng = Pcg32::new(4, 4);
    let mut held = [[0_u32; 4]; 2];
    for _ in 0..RUNS {
        let (mut ours, mut peer) = (LightReservoir::new(), WeightedReservoir::default());
        for (light, target) in (0_u32..).zip(targets) {
            ours.offer(light, target, 0.25, &mut rng)?;
            peer.add(light, target / 0.25, uniform(&mut rng));
        }
        let (of_peer, probability) = peer.held();
        assert!((10.0 * probability - targets[of_peer as usize]).abs() <= 1e-5);
        for (held, light) in held.iter_mut().zip([ours.item().copied(), Some(of_peer)]) {
            held[light.unwrap() as usize] += 1;
        }
    }
    // Five standard errors of a share.
    let off = |held: &[u32; 4], shares: [f32; 4]| {
        let pairs = held.iter().zip(shares);
        pairs.fold(0.0, |most, (n, share)| {
            (f64::from(*n) / f64::from(RUNS) - f64::from(share))
                .abs()
                .max(most)
        })
    };
    for held in &held {
        assert!(
            off(held, targets.map(|target| target / 10.0)) <= 0.0125,
            "{held:?}"
        );
        assert!(off(held, [0.25; 4]) > 0.0125, "{held:?}");
    }

    let cone = mw::Cone::from_one_minus_cos(0.25)?;
    let ours = Mixture::new((mw::MalleyHemisphere::new(), cone), &[1.0, 2.0])?;
    let mut heights = [0.0; 3];
    for _ in 0..RUNS {
        let u = [(); 3].map(|()| uniform(&mut rng));
        let (direction, density) = kit::two_lobes(1.0 / 3.0, 0.75, u);
        let [_, _, z] = direction;
        // Next to the rim rounding decides.
        assert!((density / ours.pdf(direction) - 1.0).abs() <= 1e-5 || (z - 0.75).abs() < 1e-6);
        let [_, _, equal] = kit::two_lobes(0.5, 0.75, u).0;
        for (height, z) in heights.iter_mut().zip([z, ours.draw(&mut rng)[2], equal]) {
            *height += f64::from(z) / f64::from(RUNS);
        }
    }
    let [peer, ours, equal] = heights;
    assert!(
        (peer - ours).abs() <= 0.01 && (equal - ours).abs() > 0.02,
        "{heights:?}"
    );
    Ok(())
}

/// Every square of a picture whose corner is at multiples of its side has a block of the indices.
#[test]
fn orders_give_squares_blocks_as_ours_does() -> Result<(), Error> {
    const SIDE: u32 = 8;
    fn blocks(samples: u32, index: impl Fn([u32; 2], u32) -> u64) -> bool {
        [1, 2, 4, 8].into_iter().all(|side: u32| {
            let squares = (0..SIDE / side).flat_map(|i| (0..SIDE / side).map(move |j| [i, j]));
            squares.into_iter().all(|[i, j]| {
                let indices: BTreeSet<u64> = (0..side * side * samples)
                    .map(|k| (k / samples, k % samples))
                    .map(|(k, sample)| index([i * side + k % side, j * side + k / side], sample))
                    .collect();
                let count = u64::from(side * side * samples);
                let blocks: BTreeSet<u64> = indices.iter().map(|index| index / count).collect();
                indices.len() as u64 == count && blocks.len() == 1
            })
        })
    }
    for log2_samples in [0, 2, 3] {
        let samples = 1 << log2_samples;
        let ours = Screen::new(Sobol::<2>::new(7)?, [SIDE; 2], log2_samples, 7)?;
        let peer = Curve::new([SIDE; 2], log2_samples);
        assert!(blocks(samples, |[x, y], sample| ours
            .pixel(x, y)
            .index(sample)
            .into()));
        assert!(blocks(samples, |at, sample| peer.index(at, sample, 2)));
        let in_rows = |[x, y]: [u32; 2], sample| u64::from((y * SIDE + x) * samples + sample);
        assert!(!blocks(samples, in_rows));
    }
    Ok(())
}
