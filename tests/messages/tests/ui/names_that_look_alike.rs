//! Letters of two scripts: rustc warns of them within the macro, too. One name in two spellings is one.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param a = 3mm;
        param а = 4mm;
        param ré = 5mm;
        let b = ré + other;
    }
}

fn main() {}
