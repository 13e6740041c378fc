//! A sign that the lexer of Rust does not know; it is missing in what the macro sees.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm ± 1um;
    }
}

fn main() {}
