//! Values that live as long as the process.

/// Something that lives as long as the process.
pub(crate) fn forever<T: ?Sized, B: Into<Box<T>>>(value: B) -> &'static T {
    Box::leak(value.into())
}
