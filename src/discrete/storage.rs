//! Where a table keeps its entries: an array, a `heapless` vector, a borrowed slice, or what a caller has.

/// A place where a table can lie.
///
/// An array is what a `const` table in flash is made of, a [`heapless::Vec`] has a bounded number of
/// entries that is known at run time only, and a borrowed slice is a view of either, or of memory that is
/// the caller's. A type of one's own that owns its memory, such as a `Vec` on a host, becomes another with
/// the one function here, and a table by [`Cdf::from_words`](super::Cdf::from_words).
///
/// ```
/// use microwarp::discrete::{Cdf, Storage};
/// struct Owned(Vec<u32>);
/// impl Storage for Owned {
///     type Item = u32;
///     fn items(&self) -> &[u32] {
///         &self.0
///     }
/// }
/// let mut memory = vec![0; 3];
/// Cdf::<&[u32]>::new_in(&[1.0, 2.0, 1.0], &mut memory)?;
/// let table: Cdf<Owned> = Cdf::from_words(Owned(memory))?;
/// assert_eq!(table.pmf(1), 0.5);
/// # Ok::<(), microwarp::Error>(())
/// ```
pub trait Storage {
    /// What an entry is.
    type Item: Copy;
    /// The entries, the same at every call.
    #[must_use]
    fn items(&self) -> &[Self::Item];
}

impl<T: Copy, const N: usize> Storage for [T; N] {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

impl<T: Copy, const N: usize> Storage for heapless::Vec<T, N> {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

impl<T: Copy> Storage for &[T] {
    type Item = T;
    #[inline]
    fn items(&self) -> &[T] {
        self
    }
}

/// A place where the rows of a two-dimensional table can lie: an array of arrays, or row after row what a
/// [`Storage`] can be.
pub trait Grid {
    /// What an entry is.
    type Item: Copy;
    /// The entries of all rows, one row after the other; the same at every call.
    #[must_use]
    fn flat(&self) -> &[Self::Item];
}

impl<T: Copy, const U: usize, const V: usize> Grid for [[T; U]; V] {
    type Item = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self.as_flattened()
    }
}

impl<T: Copy, const N: usize> Grid for heapless::Vec<T, N> {
    type Item = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self
    }
}

impl<T: Copy> Grid for &[T] {
    type Item = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self
    }
}
