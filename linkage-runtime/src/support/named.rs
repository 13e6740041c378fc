//! Vectors as `Debug` of results shows them.

use core::fmt::{Debug, Formatter, Result};

use crate::vectors::{Vector2, Vector3};

/// A vector, or an array of such, with its components by name; as numbers of a matrix, which it is,
/// nobody would know them.
pub fn named<V>(vectors: &V) -> Named<'_, V> {
    Named(vectors)
}

/// Result of [`named`].
pub struct Named<'a, V>(&'a V);

/// A name without quotes.
struct Name(&'static str);

impl Debug for Name {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(self.0)
    }
}

fn components<'a, T: Debug + 'a>(
    f: &mut Formatter<'_>,
    numbers: impl Iterator<Item = &'a T>,
) -> Result {
    f.debug_map()
        .entries(["x", "y", "z"].map(Name).into_iter().zip(numbers))
        .finish()
}

impl<T: Debug> Debug for Named<'_, Vector2<T>> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        components(f, self.0.iter())
    }
}

impl<T: Debug> Debug for Named<'_, Vector3<T>> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        components(f, self.0.iter())
    }
}

impl<V, const N: usize> Debug for Named<'_, [V; N]>
where
    for<'a> Named<'a, V>: Debug,
{
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.debug_list().entries(self.0.iter().map(Named)).finish()
    }
}

#[cfg(all(test, feature = "alloc"))]
mod tests {
    use super::*;
    use alloc::format;

    #[test]
    fn components_have_names() {
        let rows = [Vector2::new(1.0, -0.25), Vector2::new(f64::NAN, 0.0)];
        assert_eq!(format!("{:?}", named(&rows[0])), "{x: 1.0, y: -0.25}");
        assert_eq!(
            format!("{:?}", named(&rows)),
            "[{x: 1.0, y: -0.25}, {x: NaN, y: 0.0}]"
        );
        assert_eq!(
            format!("{:.1?}", named(&Vector3::new(1.0, 2.0, 3.06))),
            "{x: 1.0, y: 2.0, z: 3.1}"
        );
    }
}
