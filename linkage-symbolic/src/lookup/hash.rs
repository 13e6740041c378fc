//! Hashes of keys, the same in every run.

use std::hash::{Hash, Hasher};

/// Returns the hash of a key.
pub(super) fn hash<K: Hash + ?Sized>(key: &K) -> usize {
    let mut mixer = Mixer(0);
    key.hash(&mut mixer);
    mixer.0 as usize
}

/// The hash of the words of a key up to here: each is multiplied into those before it.
struct Mixer(u64);

/// The golden ratio as a fraction of `2^64`, made odd.
const MULTIPLIER: u64 = 0x9e37_79b9_7f4a_7c15;

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u64(u64::from_le_bytes(word));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(word as u64);
    }

    fn write_u64(&mut self, word: u64) {
        let product = (self.0 ^ word).wrapping_mul(MULTIPLIER);
        // The low bits are the slot: they depend on the high ones, and these on all bits.
        self.0 = product ^ (product >> 32);
    }

    fn write_usize(&mut self, word: usize) {
        self.write_u64(word as u64);
    }
}
