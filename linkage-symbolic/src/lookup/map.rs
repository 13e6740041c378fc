//! A map for look-ups: entries in a list, and a table of their numbers.

use std::borrow::Borrow;
use std::hash::Hash;
use std::ops::Index;

use super::hash::hash;

/// A map that answers questions about keys, and about nothing else.
#[derive(Clone, Debug)]
pub struct Map<K, V> {
    entries: Vec<(K, V)>,
    /// The numbers of entries plus 1, each at the first free slot from that of its hash on. 0 is a
    /// free slot. A power of two, of which at most half are taken, or nothing.
    slots: Box<[u32]>,
}

/// The least number of slots.
const LEAST: usize = 8;

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
        let number = self.number(key)?;
        Some(&self.entries[number].1)
    }

    /// The value of a key, to be changed.
    pub fn get_mut<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        let number = self.number(key)?;
        Some(&mut self.entries[number].1)
    }

    /// Returns true if a key has a value.
    pub fn contains_key<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.number(key).is_some()
    }

    /// Gives a key a value; the result is its old one.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        self.reserve();
        let slot = self.slot(&key);
        match self.slots[slot] {
            0 => {
                self.push(slot, key, value);
                None
            }
            number => {
                let old = &mut self.entries[number as usize - 1].1;
                Some(std::mem::replace(old, value))
            }
        }
    }

    /// The slot of a key, with a value or without.
    pub fn entry(&mut self, key: K) -> Entry<'_, K, V> {
        Entry { map: self, key }
    }

    /// Takes the value of a key away.
    pub fn remove<Q: Eq + Hash + ?Sized>(&mut self, key: &Q) -> Option<V>
    where
        K: Borrow<Q>,
    {
        let number = self.number(key)?;
        let slot = self.slot(key);
        // The last entry gets its number.
        let end = self.entries.len() - 1;
        let moved = self.slot(self.entries[end].0.borrow());
        self.slots[moved] = self.slots[slot];
        self.slots[slot] = 0;
        let (_, value) = self.entries.swap_remove(number);
        // Those that follow may have been kept from a slot before.
        let last = self.slots.len() - 1;
        let mut next = (slot + 1) & last;
        while self.slots[next] != 0 {
            let number = std::mem::take(&mut self.slots[next]);
            self.put(number);
            next = (next + 1) & last;
        }
        Some(value)
    }

    /// The number of keys.
    #[must_use]
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Returns true if there is no key.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Takes all values away.
    pub fn clear(&mut self) {
        self.entries.clear();
        self.slots = free(self.slots.len());
    }

    /// Returns the number of the entry of a key.
    fn number<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> Option<usize>
    where
        K: Borrow<Q>,
    {
        if self.slots.is_empty() {
            return None;
        }
        match self.slots[self.slot(key)] {
            0 => None,
            number => Some(number as usize - 1),
        }
    }

    /// Returns the slot of a key, or that where it is put; there must be free slots.
    fn slot<Q: Eq + Hash + ?Sized>(&self, key: &Q) -> usize
    where
        K: Borrow<Q>,
    {
        let entries: &[(K, V)] = &self.entries;
        let last = self.slots.len() - 1;
        let mut slot = hash(key) & last;
        loop {
            let number = self.slots[slot];
            if number == 0 || *entries[number as usize - 1].0.borrow() == *key {
                return slot;
            }
            slot = (slot + 1) & last;
        }
    }

    fn push(&mut self, slot: usize, key: K, value: V) {
        self.entries.push((key, value));
        self.slots[slot] = self.entries.len() as u32;
    }

    /// Makes room for one more entry.
    fn reserve(&mut self) {
        let count = self.slots.len();
        if 2 * self.entries.len() >= count {
            self.number_again((2 * count).max(LEAST));
        }
    }

    /// Puts all entries into so many slots.
    fn number_again(&mut self, count: usize) {
        self.slots = free(count);
        let mut number = 0;
        while (number as usize) < self.entries.len() {
            number += 1;
            self.put(number);
        }
    }

    /// Puts an entry that has no slot into one, by its number plus 1.
    fn put(&mut self, number: u32) {
        let last = self.slots.len() - 1;
        let mut slot = hash(&self.entries[number as usize - 1].0) & last;
        while self.slots[slot] != 0 {
            slot = (slot + 1) & last;
        }
        self.slots[slot] = number;
    }
}

fn free(count: usize) -> Box<[u32]> {
    vec![0; count].into_boxed_slice()
}

/// A key of a map, with a value or without.
pub struct Entry<'a, K, V> {
    map: &'a mut Map<K, V>,
    key: K,
}

impl<'a, K: Eq + Hash, V> Entry<'a, K, V> {
    /// Returns the value of the key, which becomes `value` if there is none.
    pub fn or_insert(self, value: V) -> &'a mut V {
        self.or_insert_with(|| value)
    }

    /// Returns the value of the key, which is made if there is none.
    pub fn or_insert_with(self, value: impl FnOnce() -> V) -> &'a mut V {
        let Self { map, key } = self;
        map.reserve();
        let slot = map.slot(&key);
        if map.slots[slot] == 0 {
            map.push(slot, key, value());
        }
        let number = map.slots[slot] as usize - 1;
        &mut map.entries[number].1
    }

    /// Returns the value of the key, which becomes the default if there is none.
    pub fn or_default(self) -> &'a mut V
    where
        V: Default,
    {
        self.or_insert_with(V::default)
    }
}

impl<K, V> Default for Map<K, V> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            slots: Box::default(),
        }
    }
}

impl<K: Eq + Hash + Borrow<Q>, V, Q: Eq + Hash + ?Sized> Index<&Q> for Map<K, V> {
    type Output = V;

    /// The value of a key that has one.
    fn index(&self, key: &Q) -> &V {
        match self.get(key) {
            Some(value) => value,
            None => panic!("the key has no value"),
        }
    }
}

impl<K: Eq + Hash, V> Extend<(K, V)> for Map<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, pairs: I) {
        for (key, value) in pairs {
            self.insert(key, value);
        }
    }
}

impl<K: Eq + Hash, V> FromIterator<(K, V)> for Map<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(pairs: I) -> Self {
        let mut map = Self::new();
        map.extend(pairs);
        map
    }
}

impl<K: Eq + Hash, V, const N: usize> From<[(K, V); N]> for Map<K, V> {
    fn from(pairs: [(K, V); N]) -> Self {
        pairs.into_iter().collect()
    }
}
