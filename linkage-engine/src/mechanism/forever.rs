//! Values that live as long as the process. Equal ones are stored once, so that a text which is
//! compiled again and again takes memory once.

use std::any::{Any, TypeId};
use std::collections::BTreeMap;
use std::fmt::Debug;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Mutex, PoisonError};

/// References of the type of the key, by a hash of the text of their values.
type Stored = BTreeMap<(TypeId, u64), Vec<Box<dyn Any + Send>>>;

static STORED: Mutex<Stored> = Mutex::new(BTreeMap::new());

/// Something that lives as long as the process: an equal value that is stored already, or this one.
///
/// Values are equal if `Debug` prints the same text of them, which all types of descriptions derive.
/// It distinguishes every number, zeros of both signs included.
pub(crate) fn forever<T, B>(value: B) -> &'static T
where
    T: ?Sized + Debug + Sync + 'static,
    B: Into<Box<T>>,
{
    let value: Box<T> = value.into();
    let text = format!("{value:?}");
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    let key = (TypeId::of::<&'static T>(), hasher.finish());
    // Nothing panics while the table is locked, and each state of the table is sound.
    let mut stored = STORED.lock().unwrap_or_else(PoisonError::into_inner);
    let alike = stored.entry(key).or_default();
    let mut references = alike
        .iter()
        .filter_map(|one| one.downcast_ref::<&'static T>());
    match references.find(|one| format!("{one:?}") == text) {
        Some(found) => found,
        None => {
            let value: &'static T = Box::leak(value);
            alike.push(Box::new(value));
            value
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_are_stored_once() {
        let text = |text: &str| forever::<str, _>(text);
        assert!(std::ptr::eq(text("crank"), text("crank")));
        assert_eq!([text("crank"), text("rod")], ["crank", "rod"]);
        let numbers = |numbers: &[f64]| forever::<[f64], _>(numbers);
        assert!(std::ptr::eq(
            numbers(&[0.1, f64::NAN]),
            numbers(&[0.1, f64::NAN])
        ));
        assert!(!std::ptr::eq(numbers(&[0.0]), numbers(&[-0.0])));
        assert!(!std::ptr::eq(
            numbers(&[0.1]),
            numbers(&[0.1 + f64::EPSILON])
        ));
        // Other types with the same text.
        assert_eq!(forever::<[u8], _>(&[1, 2][..]), [1, 2]);
        assert_eq!(forever::<[u32], _>(&[1, 2][..]), [1, 2]);
    }
}
