//! Units that do not exist, or have another name here.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mn;
        param rocker = 3ft;
        param coupler = 2in;
        param lift = 30degrees;
    }
}

fn main() {}
