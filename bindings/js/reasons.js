// Why a constructor refuses its parameters, by `cargo regenerate` from src/error.rs: the codes from 1 on. `#` is the
// index of a weight; `a parameter` is the one that is refused.
export const reasons = [
  "a parameter is NaN or infinite",
  "a parameter is below its lower bound",
  "a parameter leaves the domain or range empty, or too small for a finite density",
  "a parameter is too large, or lets the domain, a sum or samples be so",
  "a parameter must be positive",
  "a parameter must not be negative",
  "a parameter is outside its stated range",
  "a parameter leaves the density no finite integral over the domain",
  "a parameter has no length",
  "there are no weights",
  "there are more weights than the table holds",
  "weight # is NaN or infinite",
  "weight # is negative",
  "every weight is zero",
  "weight # is too small beside the others to be reached",
  "the entries do not form a table",
];
