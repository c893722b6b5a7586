//! What a renderer of lamps needs: places on them, masking, reservoirs of lights, weights of several techniques, roulette.

use crate::Out;
use crate::subjects::{Put, generator, refusal, with};
use microwarp::discrete::{LightReservoir, Normaliser};
use microwarp::estimate::{balance_heuristic_of, power_heuristic_of, roulette};
use microwarp::tier::Tier;
use microwarp::uniform::Chance;
use microwarp::warp::{
    Ggx, GgxVisible, LightSample, SphericalRectangle, SphericalTriangle, VisibleSphere,
};
use rand_pcg::Pcg32;

fn held(of: &LightReservoir<u32>, out: &mut Out) {
    out.word(of.item().copied().unwrap_or(99));
    out.word(of.count());
    out.float(of.target());
    out.float(of.contribution());
}

/// Two streams with targets and densities of any size, of which the first says what it took.
fn streams(
    [a, b, c, d]: [f32; 4],
    rng: &mut Pcg32,
    mut took: impl FnMut(u32),
) -> [LightReservoir<u32>; 2] {
    let (mut one, mut two) = (LightReservoir::new(), LightReservoir::new());
    let offers = [
        (a, b),
        (1e30 * c, a),
        (0.0, d),
        (d, 1e-30 * c),
        (b, a - 0.5),
    ];
    for (item, (target, density)) in (0..).zip(offers) {
        match one.offer(item, target, density, rng) {
            Ok(taken) => took(taken.into()),
            Err(e) => took(refusal(e)),
        }
        let _ = two.offer(item + 8, target + 0.25, 0.5, rng);
    }
    [one, two]
}

/// A stream, and the same capped.
pub fn reservoirs(u: [f32; 4], input: usize, out: &mut Out) {
    let [mut one, _] = streams(u, &mut generator(input), |word| out.word(word));
    held(&one, out);
    one.cap(2);
    held(&one, out);
}

/// Two streams merged, and what places make of both that see other targets.
pub fn merged([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let mut rng = generator(input);
    let [one, mut two] = streams([a, b, c, d], &mut rng, |_| ());
    match two.absorb(one, b, &mut rng) {
        Ok(taken) => out.word(taken.into()),
        Err(e) => out.word(refusal(e)),
    }
    held(&two, out);
    two.normalise(5);
    out.float(two.contribution());
    let targets = |place: usize, item: &u32| match (place, item & 1) {
        (0, 0) => a,
        (1, 1) => 0.0,
        (2, _) => d,
        _ => b,
    };
    for rule in [
        Normaliser::Support,
        Normaliser::Balance,
        Normaliser::Pairwise,
    ] {
        let whole = LightReservoir::combine(&[one, two, one], 0, rule, targets, &mut rng);
        out.word(whole.item().copied().unwrap_or(99));
        out.float(whole.contribution());
    }
    let bits = u64::from(a.to_bits()) << 32;
    let _ = two.offer_with(7, c, 0.5, bits);
    let _ = two.absorb_with(one, d, bits ^ u64::from(b.to_bits()));
    out.word(two.item().copied().unwrap_or(99));
    out.float(two.contribution());
}

/// Weights of three techniques.
pub fn techniques([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    let n = c.to_bits() >> 20;
    for scale in [1.0, 3e38] {
        let (counts, densities) = ([1, n, 7], [scale * a, b, scale * d]);
        for own in 0..3 {
            out.float(balance_heuristic_of(&counts, &densities, own));
            out.float(power_heuristic_of(&counts, &densities, own));
        }
    }
}

/// What goes on by any chance, by two words.
pub fn roulettes([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    let word = d.to_bits() << 9;
    for chance in [a, 1e-4 * b, 2.0 * c, d - 0.5] {
        out.float(roulette(chance, word).unwrap_or(0.0));
        out.float(roulette(chance, 0).unwrap_or(0.0));
    }
    let n = c.to_bits() >> 20;
    if let Ok(chance) = Chance::from_ratio(n, n | word) {
        out.float(chance.weight());
    }
}

/// Places on a ball, a panel and a face, and the densities of all directions there.
pub fn seen<T: Tier>([a, b, c, d]: [f32; 4], input: usize, out: &mut Out) {
    let (near, far) = ([0.5 + a, b, 2.0], [[2.0, 0.0, c], [0.0, 1.5, 0.0]]);
    let mut rng = generator(input);
    let put = |to: LightSample, density: f32, out: &mut Out| {
        [to.distance, to.place[0], to.place[1], density].put(out);
    };
    with(
        VisibleSphere::<T>::new([0.0; 3], near, 0.7),
        out,
        |ball, out| {
            put(ball.draw_light(&mut rng), ball.density(), out);
        },
    );
    with(
        SphericalRectangle::<T>::new([0.0; 3], near, far),
        out,
        |panel, out| {
            put(panel.draw_light(&mut rng), panel.density(), out);
        },
    );
    let [x, y] = far;
    with(
        SphericalTriangle::<T>::new([0.0; 3], [near, x, y]),
        out,
        |face, out| {
            put(face.sample_light([c, d]), face.density(), out);
        },
    );
}

/// A reflection, its density and that of its normal; masking, shadowing and the distribution there.
pub fn masking<T: Tier>([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    let alpha = [0.05 + 0.9 * c, 0.05 + 0.9 * d];
    with(
        GgxVisible::<T>::new([a - 0.5, b, d], alpha),
        out,
        |gloss, out| {
            let bounce = gloss.reflect([b, c]);
            [bounce.pdf, gloss.reflected_pdf(bounce.normal), gloss.g1()].put(out);
            [
                gloss.unmasked(bounce.direction),
                gloss.visibility(bounce.direction),
            ]
            .put(out);
            with(Ggx::<T>::new(alpha), out, |surface, out| {
                out.float(surface.distribution(bounce.normal));
            });
        },
    );
}

/// Masking of any direction.
pub fn masked<T: Tier>([a, b, c, d]: [f32; 4], _: usize, out: &mut Out) {
    with(Ggx::<T>::new([0.05 + 0.9 * c, 1.0]), out, |surface, out| {
        out.float(surface.g1([a - 0.5, b - 0.5, d]));
    });
}
