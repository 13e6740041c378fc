//! A misspelt item; the ones after it are read.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unt mm;
        parm crank = 50mm;
        joint a = 3mm;
        param rocker = nothing;
    }
}

fn main() {}
