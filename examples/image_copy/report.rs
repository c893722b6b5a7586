//! The tables on the terminal: errors against mutations a pixel, and the controls.

use crate::copy::{CANDIDATES, RECORDINGS, Recording};
use crate::study::{FITTED_FROM, Study};
use support::draw::text::{signed, thousands};
use support::mean::Mean;
use support::table;
use support::verdict::ALARM;

pub fn errors(study: &Study) {
    let mut rows = Vec::new();
    for (k, &count) in study.counts.iter().enumerate() {
        let [plain, weighted] = [Recording::Plain, Recording::Weighted].map(|recording| {
            [
                format!("{:.4}", study.rmse(k, recording)),
                format!("{:.4}", study.expected(k, recording)),
                format!("{:.4}", study.variation(k, recording)),
            ]
        });
        let mut row = vec![thousands(count as usize)];
        row.extend(plain);
        row.extend(weighted);
        row.push(format!("{:.4}", study.gain(k).mean.sqrt()));
        row.push(format!("{:.2} %", 100.0 * study.acceptance(k).mean));
        row.push(study.normalisation(k).beside(study.mean, 5, 1.0));
        rows.push(row);
    }
    let header = [
        "mutations a pixel",
        "RMSE, plain",
        "theory",
        "TV",
        "RMSE, weighted",
        "theory",
        "TV",
        "weighted / plain",
        "accepted",
        "mean brightness",
    ];
    table::print(&header, rows, 0);
    let ratio = study.theory.error[1] / study.theory.error[0];
    println!(
        "RMSE: over the pixels, in units of the mean brightness, root mean square of {} copies; TV: total \
         variation. Both recordings\n\
         are of the same chains, so at the same evaluations, one a mutation. weighted: both states of each step, \
         by 1 − a and a.\n\
         Theory, from the eigenvectors of the transition matrix: {:.3} and {:.3} over the root of the mutations a \
         pixel, ratio {ratio:.4};\n\
         {:.3} for independent draws. Acceptance {:.3} %, relaxation in {:.1} steps. Copies are scaled by the \
         exact mean brightness,\n\
         {:.5}; the one in the table is what the chain's proposals tell. {:.1} ns a mutation, all recordings \
         included.\n",
        study.repetitions(),
        study.theory.error[0],
        study.theory.error[1],
        study.theory.error[2],
        100.0 * study.theory.acceptance,
        study.theory.relaxation,
        study.mean,
        study.nanoseconds,
    );
}

pub fn recordings(study: &Study) {
    let last = study.counts.len() - 1;
    let rows = RECORDINGS.map(|recording| {
        let (slope, excess) = (study.slope(recording), study.excess(last, recording));
        vec![
            recording.name().to_string(),
            format!("{:.4}", study.rmse(last, recording)),
            format!("{:.4} ± {:.4}", excess.mean, excess.error),
            table::p_text(excess.p(1.0)),
            format!("{} ± {:.4}", signed(slope.mean, 4), slope.error),
            table::p_text(slope.p(-0.5)),
            if study.is_right(recording) {
                "right"
            } else {
                "rejected"
            }
            .to_string(),
        ]
    });
    let most = study.counts[last];
    let rmse = format!("RMSE at {most}");
    let header = [
        "recorded",
        &rmse,
        "square error over theory's",
        "p-value",
        "slope",
        "p-value of −1/2",
        "verdict",
    ];
    table::print(&header, rows.to_vec(), 1);
    println!(
        "slope: of the logarithm of the RMSE from {FITTED_FROM} mutations a pixel to {most}, of each copy alone; ± \
         is the standard error of the mean.\n\
         A p-value below {ALARM:.0e} is a rejection; that of the square error is taken at 256 too.\n"
    );
    let starts = Mean::of(study.starts.iter().map(|start| start[0]));
    let [weight, claimed] = study.starts[0];
    let [black, lit] = study.black;
    println!(
        "Each chain starts at one of {CANDIDATES} pixels, with a weight that estimates the mean brightness too: \
         {weight:.4} ± {claimed:.4} the first, {}\n\
         on average, exactly {:.5}. Of {} black pixels, {lit} are not black in a copy.",
        starts.beside(study.mean, 4, 1.0),
        study.mean,
        thousands(black),
    );
}
