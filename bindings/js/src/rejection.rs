//! Gamma numbers, shares of a whole and angles, by rejection.

use crate::buffers::Buffers;
use crate::flat::{Flat, get, put};
use crate::laws::written;
use crate::parts::NOT_LINKED;
use core::convert::Infallible;
use core::slice::Iter;
use microwarp::poly::{Dirichlet, Gamma, VonMises};
use microwarp::rejection::Rejection;
use microwarp::uniform::FromFn;
use microwarp_js_hot::Pcg32;
use rand_core::TryRng;

/// What is asked of a law.
const PDF: u32 = 1;
const DRAW_LN: u32 = 2;

/// The laws beside those of shares, whose kind is how many shares there are, from 2 to 8.
const GAMMA: u32 = 0;
const VON_MISES: u32 = 1;
/// Constructs a gamma law.
const CHI_SQUARED: u32 = 9;

/// Does something with the number of shares as a constant.
macro_rules! of_shares {
    ($shares:expr, $n:ident => $then:expr, else $otherwise:expr) => {
        of_shares!(@ $shares, $n => $then, else $otherwise, 2 3 4 5 6 7 8)
    };
    (@ $shares:expr, $n:ident => $then:expr, else $otherwise:expr, $($number:literal)*) => {
        match $shares {
            $($number => {
                const $n: usize = $number;
                $then
            })*
            _ => $otherwise,
        }
    };
}

/// Writes a law by its kind.
///
/// # Safety
/// As for `law`.
pub unsafe fn made(kind: u32, place: *mut u32, parameters: *const f32) -> i32 {
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            CHI_SQUARED => written(Gamma::chi_squared(get(parameters)), place.cast()),
            GAMMA => {
                let [shape, scale] = get(parameters);
                written(Gamma::new(shape, scale), place.cast())
            }
            VON_MISES => {
                let [mean, concentration] = get(parameters);
                written(VonMises::new(mean, concentration), place.cast())
            }
            shares => of_shares!(shares, N => {
                written(Dirichlet::<N>::new(get(parameters)), place.cast())
            }, else NOT_LINKED as i32),
        }
    }
}

/// Where the words of a draw come from: of one type, so that a law is compiled once.
enum Source<'a> {
    Generator(&'a mut Pcg32),
    Input(Iter<'a, u32>),
}

impl TryRng for Source<'_> {
    type Error = Infallible;

    #[inline(never)]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        match self {
            Self::Generator(rng) => rng.try_next_u32(),
            Self::Input(words) => Ok(words.next().copied().unwrap_or_default()),
        }
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        FromFn(|| self.try_next_u32()).try_next_u64()
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        FromFn(|| self.try_next_u32()).try_fill_bytes(bytes)
    }
}

/// Draws a point (0), evaluates the density of one in the input (1), or draws the logarithm of a gamma number (2), to the output:
/// by the generator where it is `drawn`, and otherwise by the words in the input. 0 where nothing was accepted.
///
/// # Safety
/// `made` has written the law by this kind; a chi-squared one is asked as a gamma law.
pub unsafe fn asked(
    kind: u32,
    what: u32,
    law: *const u32,
    buffers: &mut Buffers,
    drawn: bool,
) -> u32 {
    // SAFETY: as the caller says.
    unsafe {
        match kind {
            GAMMA => {
                let law = &*law.cast::<Gamma>();
                if what == DRAW_LN {
                    let found = law.try_draw_ln(&mut source(buffers, drawn));
                    return out(found.ok().map(|drawn| drawn.point), buffers);
                }
                one(law, |x| law.pdf(x), what, buffers, drawn)
            }
            VON_MISES => {
                let law = &*law.cast::<VonMises>();
                one(law, |x| law.pdf(x), what, buffers, drawn)
            }
            shares => of_shares!(shares, N => {
                let law = &*law.cast::<Dirichlet<N>>();
                one(law, |x| law.pdf(x), what, buffers, drawn)
            }, else 0),
        }
    }
}

fn source(buffers: &mut Buffers, drawn: bool) -> Source<'_> {
    if drawn {
        Source::Generator(&mut buffers.rng)
    } else {
        Source::Input(buffers.input.iter())
    }
}

fn one<P: Flat>(
    law: &impl Rejection<Point = P>,
    pdf: impl Fn(P) -> f32,
    what: u32,
    buffers: &mut Buffers,
    drawn: bool,
) -> u32 {
    if what == PDF {
        // SAFETY: the input has room for a point, whatever lies there.
        let density = unsafe { pdf(get(buffers.input.as_ptr().cast())) };
        return out(Some(density), buffers);
    }
    let found = law.try_draw(&mut source(buffers, drawn));
    out(found.ok().map(|drawn| drawn.point), buffers)
}

fn out<P: Flat>(found: Option<P>, buffers: &mut Buffers) -> u32 {
    let accepted = found.is_some();
    if let Some(point) = found {
        // SAFETY: the output has room for a point.
        unsafe { put(buffers.output.as_mut_ptr().cast(), point) };
    }
    accepted.into()
}
