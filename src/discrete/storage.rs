//! Where a table keeps its entries: an array, a `heapless` vector, or a borrowed slice.

mod sealed {
    pub trait Sealed {}
    impl<T, const N: usize> Sealed for [T; N] {}
    impl<T, const N: usize> Sealed for heapless::Vec<T, N> {}
    impl<T> Sealed for &[T] {}

    pub trait SealedGrid {}
    impl<T, const U: usize, const V: usize> SealedGrid for [[T; U]; V] {}
    impl<T, const N: usize> SealedGrid for heapless::Vec<T, N> {}
    impl<T> SealedGrid for &[T] {}
}

/// The three places where a table can lie. The trait is sealed.
///
/// An array is what a `const` table in flash is made of, a [`heapless::Vec`] has a bounded number of
/// entries that is known at run time only, and a borrowed slice is a view of either, or of memory that is
/// the caller's.
pub trait Storage: sealed::Sealed {
    /// What an entry is.
    type Item: Copy;
    /// The entries.
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

/// The places where the rows of a two-dimensional table can lie: an array of arrays, a [`heapless::Vec`]
/// or a borrowed slice, row after row. The trait is sealed.
pub trait Grid: sealed::SealedGrid {
    /// What an entry is.
    type Word: Copy;
    /// The entries of all rows, one row after the other.
    fn flat(&self) -> &[Self::Word];
}

impl<T: Copy, const U: usize, const V: usize> Grid for [[T; U]; V] {
    type Word = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self.as_flattened()
    }
}

impl<T: Copy, const N: usize> Grid for heapless::Vec<T, N> {
    type Word = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self
    }
}

impl<T: Copy> Grid for &[T] {
    type Word = T;
    #[inline]
    fn flat(&self) -> &[T] {
        self
    }
}
