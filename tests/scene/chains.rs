//! Metropolis light transport in the example `scene`: pictures of many short chains have the mean of plain ones, region by
//! region. Chains that are wrong on purpose do not.

use host::mean::Mean;
use host::parallel::{in_parallel, threads};
use host::speed;
use microwarp::discrete::Cdf;
use microwarp::metropolis::{
    BoxStep, Chain, HastingsRatio, Mixture, Mutation, Product, Proposal, StateSource, Symmetric,
    UniformStep, WithPayload, WrappedWalk,
};
use microwarp::tier::{Libm, Poly};
use microwarp::uniform::ByPosition;
use microwarp_scene::camera::DIMENSIONS;
use microwarp_scene::metropolis::State;
use microwarp_scene::path::{LOBE, NUMBERS};
use microwarp_scene::scenes::{caustic, fog, room, sensor, slit};
use microwarp_scene::shift::NOWHERE;
use microwarp_scene::vector::Vector;
use microwarp_scene::{
    Camera, Clear, Colour, Echo, Film, Fog, Kit, Lamp, Light, Material, NoSky, Numbers, Plan,
    Power, Quad, Random, Run, Scene, Set, Shift, Sky, Source, View, Walk,
};
use rand_core::TryRng;
use rand_pcg::Pcg32;

const SIZE: [u32; 2] = [6, 4];

/// Light by quarter of the picture, all channels together.
type Quarters = [f64; 4];

fn add(quarters: &mut Quarters, [column, row]: [u32; 2], light: Vector) {
    let quarter = usize::from(column >= SIZE[0] / 2) + 2 * usize::from(row >= SIZE[1] / 2);
    quarters[quarter] += light.iter().map(|c| f64::from(*c)).sum::<f64>();
}

/// The mean of each quarter over pictures.
fn means(pictures: u32, picture: impl Fn(u32) -> Quarters) -> [Mean; 4] {
    let all: Vec<Quarters> = (0..pictures).map(picture).collect();
    std::array::from_fn(|k| Mean::of(all.iter().map(|quarters| quarters[k])))
}

/// Plain pictures of a path a pixel.
fn plain<K: Kit, P: Film, M: Material, L: Light, E: Sky, F: Fog>(
    scene: &Scene<'_, M, L, E, F>,
    camera: Camera,
    pictures: u32,
) -> [Mean; 4] {
    let view = View::<K>::new(camera, SIZE).unwrap();
    means(pictures, |seed| {
        let mut quarters = [0.0; 4];
        let plan = Plan {
            size: SIZE,
            samples: 1,
            seed,
        };
        for pixel in (0..SIZE[1]).flat_map(|row| (0..SIZE[0]).map(move |column| [column, row])) {
            let light = scene.pixel::<K, Power, P, Random>(&view, pixel, &plan);
            add(&mut quarters, pixel, light);
        }
        quarters
    })
}

/// The largest difference of two quarters, in standard errors.
fn apart(found: &[Mean; 4], truth: &[Mean; 4]) -> f64 {
    let off = |(a, b): (&Mean, &Mean)| ((a.mean - b.mean) / a.error.hypot(b.error)).abs();
    // NaN is as far apart as can be.
    let all = found.iter().zip(truth).map(off);
    all.fold(0.0, |most, off| if off <= most { most } else { off })
}

/// The chance of one such difference is 4e-8, and there are four a picture.
const FAR_OFF: f64 = 5.5;

/// Short chains of the core.
fn short(seed: u32) -> Walk {
    Walk {
        size: SIZE,
        guesses: 16,
        candidates: 16,
        steps: 64,
        seed,
    }
}

fn agrees<K: Kit, P: Film, M: Material, L: Light, E: Sky, F: Fog>(
    what: &str,
    scene: &Scene<'_, M, L, E, F>,
    camera: Camera,
    times: u32,
) {
    let pictures = times * speed::of("pictures", 400, 4000);
    let truth = plain::<K, P, _, _, _, _>(scene, camera, 4 * pictures);
    let view = View::<K>::new(camera, SIZE).unwrap();
    let found = means(pictures, |seed| {
        let mut quarters = [0.0; 4];
        let run = scene.metropolis::<K, Power, P>(&view, &short(seed), |pixel, light| {
            assert!(light.iter().all(|c| c.is_finite() && *c >= 0.0));
            add(&mut quarters, pixel, light);
        });
        assert_eq!(run.unwrap().refused, 0);
        quarters
    });
    let off = apart(&found, &truth);
    println!("{what}: {off:.2} standard errors");
    for (a, b) in found.iter().zip(&truth) {
        println!(
            "  {:.5} ± {:.5}, plain {:.5} ± {:.5}",
            a.mean, a.error, b.mean, b.error
        );
    }
    assert!(off <= FAR_OFF, "{what}: {off}");
    // Otherwise nothing could be found out.
    let error = found.iter().map(|m| m.error / m.mean).fold(0.0, f64::max);
    assert!(error < 0.25, "{what}: an error of {error}");
}

#[test]
fn short_chains_have_the_mean_of_plain_pictures() {
    agrees::<Poly, Colour, _, _, _, _>("room", &room::SCENE, room::CAMERA, 1);
    agrees::<Libm, Colour, _, _, _, _>("fog", &fog::SCENE, fog::CAMERA, 1);
    agrees::<Poly, Colour, _, _, _, _>("slit", &slit::SCENE, slit::CAMERA, 1);
    agrees::<Poly, Colour, _, _, _, _>("caustic", &caustic::SCENE, caustic::CAMERA, 8);
    agrees::<Poly, Echo, _, _, _, _>("sensor", &sensor::SCENE, sensor::CAMERA, 1);
}

/// How a chain of one's own records.
#[derive(Clone, Copy, Debug)]
enum Way {
    Right,
    /// Every run counts as if it were as bright as all together.
    NoWeight,
    /// The state has the payload of the latest proposal, accepted or not.
    OtherPayload,
    /// Every proposal counts as if it were accepted.
    NoAcceptance,
    /// Nothing but shifts.
    Shifts,
    /// The same, as if they were symmetric.
    NoRatio,
}

/// A shift with its ratio, or with that of a symmetric mutation.
struct Weighed<M>(M, Way);

impl<M: Mutation<State, Correction = HastingsRatio>> Mutation<State> for Weighed<M> {
    type Correction = HastingsRatio;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        from: State,
        rng: &mut R,
    ) -> Result<Proposal<State, HastingsRatio>, R::Error> {
        let proposal = self.0.try_propose(from, rng)?;
        Ok(match self.1 {
            Way::NoRatio => Proposal::new(proposal.state, HastingsRatio::ONE),
            _ => proposal,
        })
    }
}

/// Chains without random paths beside them, written as a user would.
fn by_hand(way: Way, brightness: f32, pictures: u32) -> [Mean; 4] {
    const STEPS: u32 = 24;
    let view = View::<Poly>::new(room::CAMERA, SIZE).unwrap();
    let target = |(place, path): State| {
        if place == NOWHERE {
            return WithPayload::new(0.0, ([0; 2], [0.0; 3]));
        }
        let pixel = [0, 1].map(|k| (place[k] * SIZE[k] as f32) as u32);
        let mut numbers = Numbers::new(path);
        let light = room::SCENE.sample::<Poly, Power, Colour>(&view, pixel, &mut numbers);
        WithPayload::new(light.iter().sum::<f32>(), (pixel, light))
    };
    let anew = Product::new((UniformStep::new(), UniformStep::new()));
    let near = Product::new((
        WrappedWalk::new(BoxStep::new([0.3; 2]).unwrap()),
        WrappedWalk::new(BoxStep::new([0.05; NUMBERS]).unwrap()),
    ));
    let shift = Shift {
        scene: &room::SCENE,
        view: &view,
        size: SIZE,
        place: WrappedWalk::new(BoxStep::new([2.0; 2]).unwrap()),
    };
    let (candidates, shares) = match way {
        Way::Shifts | Way::NoRatio => (16, [0.0, 0.0, 1.0]),
        _ => (2, [1.0, 2.0, 2.0]),
    };
    let shares = Cdf::new(&shares).unwrap();
    let mutation = Mixture::from_table((anew, near, Weighed(shift, way)), shares);
    means(pictures, |run| {
        let mut quarters = [0.0; 4];
        let mut rng = Pcg32::new(run.into(), 9);
        let Ok(start) = Chain::resample(target, &anew, candidates, &mut rng) else {
            return quarters;
        };
        let weight = match way {
            Way::NoWeight => brightness,
            _ => start.weight.density,
        };
        let scale = weight * (SIZE[0] * SIZE[1]) as f32 / STEPS as f32;
        let mut chain = start.chain;
        let mut latest = chain.density().payload;
        for _ in 0..STEPS {
            let step = chain.step(target, &mutation, &mut rng);
            let mut values = step.recorded_values();
            match way {
                Way::OtherPayload => values[0].0.payload = latest,
                Way::NoAcceptance => values = [(values[0].0, 0.0), (values[1].0, 1.0)],
                _ => {}
            }
            latest = step.proposed_density.payload;
            for (found, share) in values {
                let (pixel, light) = found.payload;
                if share > 0.0 && found.density > 0.0 {
                    let part = share * scale / found.density;
                    add(&mut quarters, pixel, light.map(|c| c * part));
                }
            }
        }
        quarters
    })
}

#[test]
fn chains_that_are_wrong_on_purpose_are_found_out() {
    let pictures = speed::of("pictures", 4000, 12_000);
    let truth = plain::<Poly, Colour, _, _, _, _>(&room::SCENE, room::CAMERA, 8 * pictures);
    let brightness = truth.iter().map(|m| m.mean).sum::<f64>() / f64::from(SIZE[0] * SIZE[1]);
    let off = |way| {
        // What shifts do wrong is little.
        let times = if matches!(way, Way::NoRatio) { 12 } else { 1 };
        let found = by_hand(way, brightness as f32, times * pictures);
        let off = apart(&found, &truth);
        println!("{way:?}: {off:.1} standard errors");
        off
    };
    // The longest one first.
    let ways = [
        Way::NoRatio,
        Way::NoWeight,
        Way::OtherPayload,
        Way::NoAcceptance,
        Way::Right,
        Way::Shifts,
    ];
    for (way, off) in ways
        .iter()
        .zip(in_parallel(threads(), &ways, |&way| off(way)))
    {
        match way {
            Way::Right | Way::Shifts => assert!(off <= FAR_OFF, "{way:?}: {off}"),
            _ => assert!(off > 1.5 * FAR_OFF, "{way:?} passes: {off}"),
        }
    }
}

/// Goes to a place that is given.
struct To([f32; 2]);

impl Mutation<[f32; 2]> for To {
    type Correction = Symmetric;

    fn try_propose<R: TryRng + ?Sized>(
        &self,
        _: [f32; 2],
        _: &mut R,
    ) -> Result<Proposal<[f32; 2], Symmetric>, R::Error> {
        Ok(Proposal::new(self.0, Symmetric))
    }
}

/// The two numbers of the first bounce of a matte surface.
const POLAR: usize = (DIMENSIONS + LOBE) as usize;
const AZIMUTH: usize = POLAR + 1;

/// How many paths of a scene are shifted, and how many of them do not come back to the same numbers.
fn returns<M: Material, L: Light, E: Sky, F: Fog>(
    scene: &Scene<'_, M, L, E, F>,
    camera: Camera,
) -> (u32, u32) {
    let view = View::<Poly>::new(camera, SIZE).unwrap();
    let mut rng = Pcg32::new(3, 3);
    let (mut moved, mut lost) = (0, 0);
    let anew = Product::new((UniformStep::new(), UniformStep::new()));
    let go = |from: State, to| {
        let (view, size, place) = (&view, SIZE, To(to));
        let shift = Shift {
            scene,
            view,
            size,
            place,
        };
        let Ok(proposal) = shift.try_propose(from, &mut Pcg32::new(1, 1));
        proposal.state
    };
    for _ in 0..20_000 {
        let [from, to]: [State; 2] = [0, 1].map(|_| {
            let Ok(state) = anew.try_draw_state(&mut rng);
            state
        });
        let there = go(from, to.0);
        if there.0 == NOWHERE {
            continue;
        }
        moved += 1;
        let back = go(there, from.0);
        let apart = from.1.iter().zip(back.1).map(|(x, y)| (x - y).abs());
        // An azimuth of 0 may come back as one of nearly 1, and at the pole it does not matter.
        let sine = from.1[POLAR].sqrt();
        let apart = apart.enumerate().map(|(k, d)| match k {
            AZIMUTH => d.min(1.0 - d) * sine,
            _ => d,
        });
        let apart = apart.fold(0.0, f32::max);
        lost += u32::from(back.0 == NOWHERE || apart > 1e-4);
    }
    (moved, lost)
}

#[test]
fn shifted_paths_come_back() {
    for (what, (moved, lost)) in [
        ("room", returns(&room::SCENE, room::CAMERA)),
        ("fog", returns(&fog::SCENE, fog::CAMERA)),
        ("slit", returns(&slit::SCENE, slit::CAMERA)),
        ("sensor", returns(&sensor::SCENE, sensor::CAMERA)),
    ] {
        println!("{what}: {moved} moved, {lost} of them lost");
        assert!(moved > 20 && 100 * lost <= moved, "{what}");
    }
}

#[test]
fn numbers_of_a_pixel_are_those_of_its_position() {
    let view = View::<Poly>::new(room::CAMERA, SIZE).unwrap();
    let plan = |seed| Plan {
        size: SIZE,
        samples: 256,
        seed,
    };
    let by_numbers =
        |seed| room::SCENE.pixel::<Poly, Power, Colour, Numbers>(&view, [3, 2], &plan(seed));
    let by_position = |seed| {
        room::SCENE.pixel::<Poly, Power, Colour, Set<ByPosition>>(&view, [3, 2], &plan(seed))
    };
    for seed in 0..8 {
        let (a, b) = (by_numbers(seed), by_position(seed));
        for (x, y) in a.iter().zip(b) {
            assert!((x / y - 1.0).abs() <= 1e-3, "{a:?}, {b:?}");
        }
    }
    // Other words give another light.
    assert!((by_numbers(1)[0] / by_position(2)[0] - 1.0).abs() > 1e-2);
    // Beyond the last number there is no panic.
    let mut numbers = Numbers::new([0.25; NUMBERS]);
    numbers.skip_to(u32::MAX);
    assert_eq!(rand_core::Rng::next_u64(&mut numbers) >> 63, 0);
}

#[test]
fn degenerate_pictures_are_black_and_short_chains_do_not_fail() {
    let dark: Scene<'_, _, Lamp<Quad>, NoSky, Clear> = Scene {
        lights: &[],
        ..room::SCENE
    };
    let view = View::<Poly>::new(room::CAMERA, SIZE).unwrap();
    let mut splats = 0;
    let run = dark.metropolis::<Poly, Power, Colour>(&view, &short(1), |_, light| {
        splats += usize::from(light != [0.0; 3]);
    });
    assert_eq!((run, splats), (Ok(Run::default()), 0));
    for (guesses, candidates, steps) in [(0, 0, 0), (0, 4, 0), (0, 4, 4), (4, 0, 4), (1, 1, 1)] {
        let walk = Walk {
            guesses,
            candidates,
            steps,
            ..short(1)
        };
        assert_eq!(walk.paths(), guesses + candidates + steps);
        let run = room::SCENE.metropolis::<Poly, Power, Colour>(&view, &walk, |[x, y], light| {
            assert!(x < SIZE[0] && y < SIZE[1]);
            assert!(light.iter().all(|c| c.is_finite()));
        });
        assert!(run.unwrap().brightness >= 0.0);
    }
    let none = Walk {
        size: [0, 4],
        ..short(1)
    };
    assert!(
        room::SCENE
            .metropolis::<Poly, Power, Colour>(&view, &none, |_, _| ())
            .is_err()
    );
}

/// What a core keeps of a chain: it fits the smallest.
#[test]
fn a_chain_of_paths_is_small() {
    type Found = WithPayload<f32, ([u32; 2], Vector)>;
    let size = size_of::<Chain<State, Found>>();
    println!("{size} bytes");
    assert!(size <= 480, "{size} bytes");
}
