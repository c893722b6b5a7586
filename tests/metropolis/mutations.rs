//! The mutations: symmetry to the last bit, exact wrapping, ranges, words, errors.
