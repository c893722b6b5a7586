//! A point serves whatever takes a generator: a cursor yields its dimensions in order, and draws are the samples of its words.

use super::sobol;
use fixed::types::U0F32;
use host::generators::{Broken, Failing};
use microwarp::fixed as integers;
use microwarp::uniform::{
    ByPosition, MAX_DIMENSIONS, Points, Recurrence, Sobol, Strata2d, deep_from_word, grid_from_word,
};
use microwarp::{Warp, poly};
use rand_pcg::rand_core::Rng;

#[test]
fn a_cursor_yields_the_dimensions_in_order() {
    fn check<P: Points + std::fmt::Debug + PartialEq>(points: P) {
        let words: [u32; 12] = points.words(77);
        let mut cursor = points.at(77);
        assert!((0..12).all(|d| cursor.dimension() == d && cursor.next_u32() == words[d as usize]));
        let mut later = points.at(77).skip_to(5);
        assert_eq!(later.next_u32(), words[5]);
        let long = points.at(77).next_u64();
        assert_eq!(long, u64::from(words[1]) << 32 | u64::from(words[0]));
        let mut bytes = [0; 7];
        points.at(77).fill_bytes(&mut bytes);
        assert_eq!(bytes[..4], words[0].to_le_bytes());
        assert_eq!(bytes[4..], words[1].to_le_bytes()[..3]);
        // Whatever the numbers are, there is a word, and the dimensions begin again.
        let mut last = points.at(u32::MAX).skip_to(u32::MAX);
        assert_eq!(last.next_u32(), points.word(u32::MAX, u32::MAX));
        assert_eq!(last, points.at(u32::MAX));
    }
    check(Sobol::<1>::new(3).unwrap());
    check(Sobol::<3>::new(3).unwrap());
    check(Sobol::<8>::new(3).unwrap());
    check(Recurrence::<2>::new(3).unwrap());
    check(ByPosition::new(3, 4));
}

#[test]
fn warps_of_all_tiers_and_strata_take_a_point() {
    let points = Sobol::<2>::new(11).unwrap();
    let strata = Strata2d::new(4, 4).unwrap();
    for index in 0..1000 {
        let words = sobol(11, index);
        let drawn = poly::Disk::new().draw(&mut points.at(index));
        assert_eq!(drawn, poly::Disk::new().sample(words.map(grid_from_word)));
        assert_eq!(points.point(index), words.map(deep_from_word));
        let drawn = integers::Disk::new().draw(&mut points.at(index));
        assert_eq!(
            drawn,
            integers::Disk::new().sample(words.map(U0F32::from_bits))
        );
        let [u, v] = strata.draw(index, &mut points.at(index));
        assert_eq!(
            [(4.0 * u) as u32, (4.0 * v) as u32],
            [index % 4, index / 4 % 4]
        );
    }
}

/// Methods of two explicit uniforms draw them from the next two dimensions, in order; a failing generator's error comes through.
#[test]
fn reflections_and_places_take_a_point() {
    let [across, up, aside] = [[2.0, 0.0, 0.5], [0.0, 1.5, 0.0], [0.5, 0.5, 2.0]];
    let glossy = poly::GgxVisible::new([0.6, 0.0, 0.8], [0.3, 0.1]).unwrap();
    let ball = poly::VisibleSphere::new([0.0; 3], aside, 0.7).unwrap();
    let panel = poly::SphericalRectangle::new([0.0; 3], aside, [across, up]).unwrap();
    let face = poly::SphericalTriangle::new([0.0; 3], [aside, across, up]).unwrap();
    let set = Sobol::<4>::new(11).unwrap();
    for index in 0..200 {
        let [_, u, v] = set.words(index).map(grid_from_word);
        let mut point = set.at(index).skip_to(1);
        assert_eq!(glossy.draw_reflection(&mut point), glossy.reflect([u, v]));
        assert_eq!(point.dimension(), 3);
        let point = || set.at(index).skip_to(1);
        assert_eq!(ball.draw_surface(&mut point()), ball.sample_surface([u, v]));
        assert_eq!(panel.draw_place(&mut point()), panel.locate([u, v]));
        assert_eq!(face.draw_place(&mut point()), face.locate([u, v]));
        // What is drawn is the point that the warp itself draws.
        assert_eq!(
            glossy.draw_reflection(&mut point()).normal,
            glossy.draw(&mut point())
        );
        assert_eq!(
            ball.draw_surface(&mut point()).direction,
            ball.draw(&mut point())
        );
        assert_eq!(
            panel.draw_place(&mut point()).direction,
            panel.draw(&mut point())
        );
        assert_eq!(
            face.draw_place(&mut point()).direction,
            face.draw(&mut point())
        );
        assert_ne!(glossy.draw_reflection(&mut point()), glossy.reflect([v, u]));
    }
    let spent = |left| Failing { word: 0, left };
    let failed = Broken(17);
    assert_eq!(glossy.try_draw_reflection(&mut spent(1)), Err(failed));
    assert_eq!(ball.try_draw_surface(&mut spent(0)), Err(failed));
    assert_eq!(panel.try_draw_place(&mut spent(1)), Err(failed));
    let place = face.try_draw_place(&mut spent(2));
    assert_eq!(place, Ok(face.locate([0.0, 0.0])));
}

/// Two dimensions stay below what was asked for, and only more of them have a table.
#[test]
fn two_words_are_cheap_and_link_no_table() {
    let counts = host::counts::Counts::read().unwrap();
    let of = |kernel: &str, core: &str| {
        ["instructions", "tables"].map(|column| counts.figure(kernel, core, column).unwrap())
    };
    for (core, most) in [("m0", 100.0), ("m4f", 50.0)] {
        let ([sobol, tables], [recurrence, none]) =
            (of("sobol_2d", core), of("recurrence_2d", core));
        println!("{core}: {sobol} instructions, {recurrence} of a recurrence");
        assert!(sobol <= most && recurrence <= 10.0);
        assert_eq!([tables, none, of("sobol_8d", core)[1]], [0.0, 0.0, 768.0]);
    }
}

/// The step of a dimension is a power of the root that Newton finds, to half an odd word.
#[test]
fn steps_of_a_recurrence_are_powers_of_the_generalised_golden_ratio() {
    fn check<const D: usize>() {
        let power = D as i32 + 1;
        let newton = |x: f64, _| {
            x - (x.powi(power) - x - 1.0) / (f64::from(power) * x.powi(power - 1) - 1.0)
        };
        let root = (0..50).fold(2.0, newton);
        for seed in [0, 1, 0xffff_ffff] {
            let points = Recurrence::<D>::new(seed).unwrap();
            let [first, next]: [[u32; D]; 2] = [points.words(0), points.words(1)];
            for d in 0..D {
                let step = next[d].wrapping_sub(first[d]);
                let exact = root.powi(-(d as i32) - 1) * 2f64.powi(32);
                assert!(
                    (f64::from(step) - exact).abs() <= 1.0,
                    "{D}: {step}, {exact}"
                );
                assert_eq!(step % 2, 1);
                let far = points.word(u32::MAX, d as u32);
                assert_eq!(far, first[d].wrapping_sub(step));
            }
        }
    }
    check::<1>();
    check::<2>();
    check::<3>();
    check::<4>();
    check::<5>();
    check::<6>();
    check::<7>();
    check::<MAX_DIMENSIONS>();
}
