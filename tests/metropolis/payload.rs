//! Payloads: always those of the state, whatever became of the proposal; a chain steps as if there were none; and what is
//! recorded by them has the right mean from the first step on, if runs have the weights of their starts.

use host::mean::Mean;
use host::speed;
use microwarp::metropolis::{
    BoxStep, Chain, LogDensity, Mixture, Mutation, Outcome, Product, UniformIndex, UniformStep,
    WithPayload, WrappedWalk,
};
use microwarp::tier::Poly;
use rand_pcg::Pcg32;
use std::num::NonZeroU32;

type Point = [f32; 2];

/// A payload that tells the state.
fn told([x, y]: Point) -> [u32; 2] {
    [y.to_bits(), x.to_bits()]
}

fn steps() -> impl Mutation<Point> {
    let small = WrappedWalk::new(BoxStep::new([0.2; 2]).unwrap());
    Mixture::large_small(0.3, small).unwrap()
}

/// Goes beside a chain without payloads, is saved and resumed after every step, and says how often each outcome was met, and
/// how often the payload of the latest proposal was not that of the state.
macro_rules! follow {
    ($target:expr) => {{
        let (plain, limit) = ($target, NonZeroU32::new(6).unwrap());
        let carrying = |x: Point| WithPayload::new(plain(x), told(x));
        let (mutation, start) = (steps(), [0.5, 0.75]);
        let (mut rng, mut twin) = (Pcg32::new(5, 1), Pcg32::new(5, 1));
        let mut chain = Chain::new(start, carrying).unwrap();
        let mut bare = Chain::new(start, plain).unwrap();
        let (mut outcomes, mut wrong) = ([0; 4], 0);
        for k in 0..20_000 {
            let (step, other) = if k % 3 == 0 {
                let step = chain.step_limited(carrying, &mutation, limit, &mut rng);
                (step, bare.step_limited(plain, &mutation, limit, &mut twin))
            } else {
                let step = chain.step(carrying, &mutation, &mut rng);
                (step, bare.step(plain, &mutation, &mut twin))
            };
            assert_eq!(
                (step.from, step.proposed, step.outcome, step.kind),
                (other.from, other.proposed, other.outcome, other.kind)
            );
            assert_eq!(step.acceptance, other.acceptance);
            assert_eq!(step.from_density.density, other.from_density);
            let both = step.recorded().into_iter().zip(step.recorded_values());
            for ((state, share), (value, same)) in both {
                assert_eq!((value.payload, share), (told(state), same));
            }
            assert_eq!(step.density().payload, told(step.state()));
            chain = Chain::resume(chain.save()).unwrap();
            assert_eq!(chain.density().payload, told(chain.state()));
            assert_eq!(
                (chain.state(), chain.density().density),
                (bare.state(), bare.density())
            );
            outcomes[step.outcome as usize] += 1;
            wrong += u32::from(step.proposed_density.payload != told(chain.state()));
        }
        assert_eq!(
            (chain.accepted(), chain.refused(), chain.rejected_in_a_row()),
            (bare.accepted(), bare.refused(), bare.rejected_in_a_row())
        );
        println!("{outcomes:?}, {wrong}");
        (outcomes, wrong)
    }};
}

#[test]
fn a_payload_is_that_of_the_state_after_every_step() {
    let bright = |[x, y]: Point| if x < 0.2 { f32::NAN } else { (x * y).powi(6) };
    let dark = |x: Point| LogDensity::<Poly>::new(bright(x).ln());
    let whole = |x: Point| (bright(x) * 1e9) as u32;
    for (outcomes, wrong) in [follow!(bright), follow!(dark), follow!(whole)] {
        for outcome in [Outcome::Accepted, Outcome::Rejected, Outcome::Forced] {
            assert!(outcomes[outcome as usize] > 100, "{outcomes:?}");
        }
        // What keeps the payload of the latest proposal is told apart.
        assert!(wrong > 1000, "{wrong}");
    }
    let (outcomes, _) = follow!(bright);
    assert!(outcomes[Outcome::Refused as usize] > 100, "{outcomes:?}");
}

const LAMPS: [f32; 3] = [1.0, 0.25, 2.0];

type Lit = (usize, f32);

/// (x − ½)² between ¼ and 1: two humps of 1/9 and 8/9 of the mass, and nothing below.
fn humps(x: f32) -> f32 {
    if (0.25..1.0).contains(&x) {
        (x - 0.5) * (x - 0.5)
    } else {
        0.0
    }
}

/// A lamp and a place that it lights: the payload is the pixel, and a colour that is not the density.
fn path((lamp, x): Lit) -> WithPayload<f32, (usize, f32)> {
    let density = LAMPS[lamp] * humps(x);
    WithPayload::new(density, (usize::from(x > 0.5), x * density))
}

/// ∫x·f over the places of the second pixel, and the sum over lamps.
const TRUE: f64 = (0.5 / 24.0 + 1.0 / 64.0) * 3.25;

/// How a picture is recorded.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Right,
    /// Without the weight of the start, as if every run were as bright as all.
    NoWeight,
    /// With the payload of the state before.
    OtherPayload,
    /// As if every proposal were accepted.
    NoAcceptance,
}

/// The light of the second pixel, by runs of a few steps each, that start from four candidates.
fn picture(way: Way) -> Mean {
    const STEPS: usize = 6;
    let runs = speed::of("runs", 20_000, 400_000);
    let anew = Product::new((UniformIndex::new(3).unwrap(), UniformStep::new()));
    let near = WrappedWalk::new(BoxStep::new(0.1).unwrap());
    let near = Product::new((UniformIndex::new(3).unwrap(), near));
    let mutation = Mixture::new((anew, near), &[0.2, 0.8]).unwrap();
    Mean::of((0..runs).map(|run| {
        let mut rng = Pcg32::new(run, 77);
        let Ok(start) = Chain::resample(path, &anew, 4, &mut rng) else {
            return 0.0;
        };
        // ∫f over places is 3/64.
        let weight = match way {
            Way::NoWeight => 3.25 * 3.0 / 64.0,
            _ => start.weight.density,
        };
        let (mut chain, mut sum) = (start.chain, 0.0);
        for _ in 0..STEPS {
            let step = chain.step(path, &mutation, &mut rng);
            let mut values = step.recorded_values();
            match way {
                Way::OtherPayload => values[1].0.payload = step.from_density.payload,
                Way::NoAcceptance => values = [(values[0].0, 0.0), (values[1].0, 1.0)],
                _ => {}
            }
            for (found, share) in values {
                let (pixel, colour) = found.payload;
                if share > 0.0 && found.density > 0.0 && pixel == 1 {
                    sum += f64::from(share * colour / found.density);
                }
            }
        }
        f64::from(weight) * sum / STEPS as f64
    }))
}

#[test]
fn what_payloads_record_is_right_from_the_first_step_on() {
    let off = |way| {
        let found = picture(way);
        println!("{:.6} ± {:.6}, not {TRUE:.6}", found.mean, found.error);
        found.deviation(TRUE).abs()
    };
    let right = off(Way::Right);
    assert!(right <= 5.0, "{right} σ");
    for wrong in [Way::NoWeight, Way::OtherPayload, Way::NoAcceptance] {
        let wrong = off(wrong);
        assert!(wrong > 10.0, "{wrong} σ");
    }
}
