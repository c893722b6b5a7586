//! Errors as numbers: those of `Error::code`, 0 for none, and what only C can meet.

use crate::generators::SourceFailed;
use core::convert::Infallible;
use core::ffi::{CStr, c_char};
use core_crate::Error;
use core_crate::rejection::Failure;

/// `mw_error`. In C it is an enumeration, whose size is the compiler's choice, so it is never part of a struct.
#[repr(transparent)]
#[derive(Clone, Copy)]
pub struct Code(u32);

pub const OK: Code = Code(0);
/// Outside the range of `Error::code`, which only grows from 1 up.
const SOURCE_FAILED: Code = Code(1000);
const BUDGET_SPENT: Code = Code(1001);
const BOUND_EXCEEDED: Code = Code(1002);
const BAD_DENSITY: Code = Code(1003);

impl From<Error> for Code {
    #[inline]
    fn from(error: Error) -> Self {
        Self(u32::from(error.code()))
    }
}

impl From<Infallible> for Code {
    #[inline]
    fn from(never: Infallible) -> Self {
        match never {}
    }
}

impl<E: Into<Code>> From<Failure<E>> for Code {
    #[inline]
    fn from(failure: Failure<E>) -> Self {
        match failure {
            Failure::Generator(error) => error.into(),
            Failure::BudgetSpent { .. } => BUDGET_SPENT,
            Failure::BoundExceeded { .. } => BOUND_EXCEEDED,
            _ => BAD_DENSITY,
        }
    }
}

impl From<SourceFailed> for Code {
    #[inline]
    fn from(_: SourceFailed) -> Self {
        SOURCE_FAILED
    }
}

/// What a C function returns of what Rust returned, the value put in its place.
#[inline]
pub fn code<T, E: Into<Code>>(result: Result<T, E>, then: impl FnOnce(T)) -> Code {
    match result {
        Ok(value) => {
            then(value);
            OK
        }
        Err(error) => error.into(),
    }
}

/// A text with a NUL behind it.
const fn ended<const N: usize>(text: &str) -> [u8; N] {
    let (mut bytes, mut i) = ([0; N], 0);
    while i < text.len() {
        bytes[i] = text.as_bytes()[i];
        i += 1;
    }
    bytes
}

macro_rules! texts {
    ($($error:expr,)*) => {
        /// What went wrong, in words.
        #[unsafe(export_name = "mw_error_text")]
        extern "C" fn text(code: Code) -> *const c_char {
            let text = match code.0 {
                0 => c"no error",
                1000 => c"the source of random words failed",
                1001 => c"the budget of tries is spent",
                1002 => c"the density is above the bound",
                1003 => c"a density is negative, NaN or infinite",
                $(code if code == const { $error.code() as u32 } => const {
                    const TEXT: &str = $error.message();
                    const BYTES: [u8; TEXT.len() + 1] = ended(TEXT);
                    match CStr::from_bytes_with_nul(&BYTES) {
                        Ok(text) => text,
                        Err(_) => panic!("a message holds a NUL"),
                    }
                },)*
                _ => c"not an error of microwarp",
            };
            text.as_ptr()
        }
    };
}

// `Error` may grow. The tests in C ask for the text of every code in the header, whose list is the same.
microwarp_list::errors!(texts);
