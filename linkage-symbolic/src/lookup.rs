//! Maps and sets for look-ups, which cannot be iterated and so cannot decide the order of anything.
//!
//! Equal input gives equal output, so no order of a hash table may reach a result. Code that goes
//! through entries takes a `BTreeMap`, a `Vec`, or sorts a list of keys. `clippy.toml` forbids the
//! tables of the standard library.
//!
//! The hasher is that of rustc, fast for the small keys of a graph and the same in every run. An
//! attacker who chooses colliding keys slows down only the build.

use std::borrow::Borrow;
use std::collections::hash_map::Entry;
use std::hash::Hash;
use std::ops::Index;

use rustc_hash::{FxHashMap, FxHashSet};

/// A map that answers questions about keys, and about nothing else.
#[derive(Clone, Debug)]
pub struct Map<K, V>(FxHashMap<K, V>);

impl<K: Eq + Hash, V> Map<K, V> {
    /// An empty map.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The value of a key.
    pub fn get<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        self.0.get(key)
    }

    /// The value of a key, to be changed.
    pub fn get_mut<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        self.0.get_mut(key)
    }

    /// Returns true if a key has a value.
    pub fn contains_key<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.0.contains_key(key)
    }

    /// Gives a key a value; the result is its old one.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        self.0.insert(key, value)
    }

    /// The place of a key, with a value or without.
    pub fn entry(&mut self, key: K) -> Entry<'_, K, V> {
        self.0.entry(key)
    }

    /// Takes the value of a key away.
    pub fn remove<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        self.0.remove(key)
    }

    /// The number of keys.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns true if there is no key.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Takes all values away.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}

impl<K, V> Default for Map<K, V> {
    fn default() -> Self {
        Self(FxHashMap::default())
    }
}

impl<K: Eq + Hash + Borrow<Q>, V, Q: Eq + Hash + ?Sized> Index<&Q> for Map<K, V> {
    type Output = V;

    /// The value of a key that has one.
    fn index(&self, key: &Q) -> &V {
        &self.0[key]
    }
}

impl<K: Eq + Hash, V> Extend<(K, V)> for Map<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, pairs: I) {
        self.0.extend(pairs);
    }
}

impl<K: Eq + Hash, V> FromIterator<(K, V)> for Map<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(pairs: I) -> Self {
        Self(pairs.into_iter().collect())
    }
}

impl<K: Eq + Hash, V, const N: usize> From<[(K, V); N]> for Map<K, V> {
    fn from(pairs: [(K, V); N]) -> Self {
        pairs.into_iter().collect()
    }
}

/// A set that can be asked for a value, and for nothing else.
#[derive(Clone, Debug)]
pub struct Set<T>(FxHashSet<T>);

impl<T: Eq + Hash> Set<T> {
    /// An empty set.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Returns true if a value is in the set.
    pub fn contains<Q: Eq + Hash + ?Sized>(&self, value: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        self.0.contains(value)
    }

    /// Puts something into the set; true if it was not there.
    pub fn insert(&mut self, value: T) -> bool {
        self.0.insert(value)
    }

    /// Takes something out of the set; true if it was there.
    pub fn remove<Q: Eq + Hash + ?Sized>(&mut self, value: &Q) -> bool
    where
        T: Borrow<Q>,
    {
        self.0.remove(value)
    }

    /// Returns the number of values.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Returns true if the set is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Takes everything out of the set.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}

impl<T> Default for Set<T> {
    fn default() -> Self {
        Self(FxHashSet::default())
    }
}

impl<T: Eq + Hash> Extend<T> for Set<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        self.0.extend(values);
    }
}

impl<T: Eq + Hash> FromIterator<T> for Set<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Self(values.into_iter().collect())
    }
}

impl<T: Eq + Hash, const N: usize> From<[T; N]> for Set<T> {
    fn from(values: [T; N]) -> Self {
        values.into_iter().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Map, Set};

    #[test]
    fn a_map_answers_for_its_keys() {
        let mut map: Map<Vec<usize>, usize> = Map::new();
        assert!(map.is_empty() && map.get(&[1][..]).is_none());
        assert_eq!(map.insert(vec![1], 10), None);
        assert!(!map.is_empty());
        assert_eq!(map.insert(vec![1], 11), Some(10));
        *map.entry(vec![2]).or_insert(20) += 1;
        *map.entry(vec![2]).or_insert(20) += 1;
        // Keys are asked for by what they lend, as `Vec` by slices.
        assert_eq!((map[&[1][..]], map[&vec![2]]), (11, 22));
        *map.get_mut(&[1][..]).expect("it is there") = 12;
        assert!(map.contains_key(&[1][..]) && !map.contains_key(&[3][..]));
        assert_eq!(
            (map.remove(&[1][..]), map.remove(&[1][..])),
            (Some(12), None)
        );
        map.extend([(vec![3], 30), (vec![4], 40)]);
        assert_eq!(map.len(), 3);
        map.clear();
        assert!(map.is_empty());
    }

    #[test]
    fn a_set_tells_what_is_in_it() {
        let mut set = Set::new();
        assert!(set.insert(3) && !set.insert(3) && set.contains(&3) && !set.is_empty());
        assert!(set.remove(&3) && !set.remove(&3) && set.is_empty());
        set.extend([1, 2, 2]);
        assert_eq!(set.len(), 2);
        set.clear();
        assert!(!set.contains(&1));
    }

    #[test]
    fn lists_become_maps_and_sets() {
        let map: Map<_, _> = (0..5).map(|k| (k, k * k)).collect();
        assert_eq!((map.len(), map[&4]), (5, 16));
        assert_eq!(Map::from([("a", 1), ("a", 2)])["a"], 2);
        let set: Set<_> = "aba".chars().collect();
        assert_eq!((set.len(), Set::from([1, 1]).len()), (2, 1));
    }
}
