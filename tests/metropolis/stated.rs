//! How a measured figure is held to one of the documentation, and figures in its sentences; the neighbours of a number.

/// Holds a measured error to the one stated, and the statement to being no more than 2.5 times what is measured: one that
/// a search found has a margin, and this search may be shorter.
pub fn assert_stated(what: &str, measured: f64, stated: f64) {
    println!("{what}: {measured:.3e} measured, {stated:.2e} stated");
    assert!(
        measured <= stated,
        "{what}: {measured:e} against {stated:e}"
    );
    assert!(
        stated <= 2.5 * measured,
        "{what}: {measured:e}, {stated:e} is stale"
    );
}

/// The error of an autocorrelation, as its documentation states it in a line of the text.
pub fn stated_error(source: &str) -> f64 {
    after(source, "Error of an autocorrelation: ")
}

/// The number that follows some words in a text, up to a comma.
pub fn after(source: &str, words: &str) -> f64 {
    let (_, rest) = source.split_once(words).unwrap();
    let figure = rest.split(',').next().unwrap();
    figure.trim().parse().unwrap()
}

/// The next number towards 0, of one above it.
pub fn below(x: f32) -> f32 {
    f32::from_bits(x.to_bits() - 1)
}

/// The next number away from 0.
pub fn above(x: f32) -> f32 {
    f32::from_bits(x.to_bits() + 1)
}
