// Why a constructor refuses its parameters, by `cargo regenerate` from src/error.rs: the codes from 1 on. `#` is the
// index of a weight.
export const reasons = [
  "a parameter is NaN or infinite",
  "the lower bound is above the upper bound",
  "the domain or range is empty, or too small for a finite density",
  "the domain, a parameter or a sum is too large, or samples overflow",
  "a parameter that must be positive is not",
  "a parameter that must not be negative is",
  "a parameter is outside its stated range",
  "the density has no finite integral over the domain",
  "a direction has no length",
  "there are no weights",
  "there are more weights than the table holds",
  "weight # is NaN or infinite",
  "weight # is negative",
  "every weight is zero",
  "weight # is too small beside the others to be reached",
  "the entries do not form a table",
];
