//! Maps and sets for look-ups, which cannot be iterated and so cannot decide the order of anything.
//!
//! Equal input gives equal output, so no order of a hash table may reach a result. Code that goes
//! through entries takes a `BTreeMap`, a `Vec`, or sorts a list of keys. `clippy.toml` forbids the
//! tables of the standard library.
//!
//! The macro runs without optimisation in dev builds of its users. The tables are therefore short
//! code that calls little: entries in a list, and their numbers in an array that is searched from
//! the slot of the hash on. An attacker who chooses colliding keys slows down only the build.

mod hash;
mod map;
mod set;

pub use map::{Entry, Map};
pub use set::Set;

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use linkage_random::Random;

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

    /// Keys that share slots with others are found after any of these is taken away.
    #[test]
    fn a_map_has_the_values_that_a_list_has() {
        let mut random = Random::new(7);
        let mut map: Map<usize, u64> = Map::new();
        let mut list: BTreeMap<usize, u64> = BTreeMap::new();
        for _ in 0..20_000 {
            let (key, value) = (random.below(50), random.bits());
            match random.below(3) {
                0 => assert_eq!(map.remove(&key), list.remove(&key)),
                1 => assert_eq!(map.insert(key, value), list.insert(key, value)),
                _ => assert_eq!(*map.entry(key).or_insert(value), {
                    *list.entry(key).or_insert(value)
                }),
            }
            let key = random.below(50);
            assert_eq!((map.get(&key), map.len()), (list.get(&key), list.len()));
        }
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
