//! Texts of mechanisms that rustc itself reports: names that look alike, letters that are no token, and no token at all.

/// Letters of two scripts: rustc warns of them within the macro, too. One name in two spellings is one.
mod names_that_look_alike {
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
}

/// A sign that the lexer of Rust does not know; it is missing in what the macro sees.
mod plus_minus_sign {
    use linkage::mechanism;

    mechanism! {
        pub struct M {
            param crank = 50mm ± 1um;
        }
    }
}

/// The first block is missing.
mod no_struct {
    use linkage::mechanism;

    mechanism! {
        impl M {
            pub fn motion(phi) -> Motion { phi }
        }
    }

    mechanism! {}
}

fn main() {}
