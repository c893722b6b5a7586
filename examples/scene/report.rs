//! The table on the terminal, and what there is to complain of.

use crate::chains::reference_of;
use crate::render::{PointSet, Tier};
use crate::shots::Shot;
use crate::study::{KINDS, SAMPLES, Study};
use host::cli::print;

pub fn errors(shots: &[Shot], studies: &[Study]) {
    let mut rows = Vec::new();
    for (shot, study) in shots.iter().zip(studies) {
        let random = study.find(Tier::Poly, PointSet::Random, SAMPLES[1]).error;
        for (tier, points) in KINDS {
            let found = SAMPLES.map(|samples| study.find(tier, points, samples));
            let mut row = vec![
                shot.title.to_owned(),
                points.name().to_owned(),
                tier.name().to_owned(),
            ];
            row.extend(found.iter().map(|m| format!("{:.1} %", 100.0 * m.error)));
            row.push(format!("{:+.0} %", 100.0 * (found[1].error / random - 1.0)));
            rows.push(row);
        }
    }
    let header = [
        "scene",
        "points",
        "tier",
        "16 samples",
        "64 samples",
        "against PCG32",
    ];
    println!("Relative error of a pixel:");
    print(&header, rows, 3);
    for (shot, study) in shots.iter().zip(studies) {
        println!(
            "{}: with the same points the tiers differ by {:.1e} of the error; control: without weights the \
             picture is {:.0} % brighter, {:.0} standard errors.",
            shot.title,
            study.apart,
            100.0 * study.control.excess,
            study.control.deviation
        );
    }
    println!();
}

/// Standard errors by which a picture may be brighter or darker than the reference.
const DEVIATION: f64 = 6.0;

/// How far apart the tiers may be, as a part of the error that both have.
const APART: f64 = 0.1;

pub fn complaints(shots: &[Shot], studies: &[Study]) -> Vec<String> {
    let (mut complaints, mut gain, mut noticed) = (Vec::new(), 0.0, 0.0);
    // What must hold is written so that NaN does not.
    let mut hold = |good: bool, text: String| complaints.extend((!good).then_some(text));
    for (shot, study) in shots.iter().zip(studies) {
        let title = shot.title;
        hold(
            study.invalid == 0,
            format!("{title}: {} numbers are no light", study.invalid),
        );
        for m in &study.measured {
            let (points, tier, samples) = (m.points.name(), m.tier.name(), m.samples);
            let text = format!(
                "{title}: {points}, {tier}, {samples} samples: {:+.1} standard errors",
                m.deviation
            );
            hold(m.deviation.abs() <= DEVIATION, text);
        }
        hold(
            study.apart <= APART,
            format!(
                "{title}: the tiers differ by {:.3} of the error",
                study.apart
            ),
        );
        let [random, sobol] = [PointSet::Random, PointSet::Sobol]
            .map(|points| study.find(Tier::Poly, points, SAMPLES[1]).error);
        // The errors of the hard scenes are those of a few rare paths, whatever the points.
        if reference_of(shot.name).is_none() {
            gain += (sobol / random).ln();
        }
        noticed += study.control.deviation;
    }
    // One pixel that is far off may turn either round in a single scene.
    hold(
        noticed / (studies.len() as f64).sqrt() > DEVIATION,
        "a renderer that forgets its weights passes".into(),
    );
    hold(
        gain < 0.0,
        "Sobol' points are no better than random ones".into(),
    );
    complaints
}
