//! The smaller and the larger of two numbers that are not negative. The smaller of NaN and a number
//! is the number.
//!
//! ARM processors before version 8 have no instruction for it, and what `core` has becomes calls of
//! a library there. The bits of such numbers are in their order.

macro_rules! ends {
    ($module:ident, $least:ident, $most:ident, $float:ident) => {
        mod $module {
            #[inline(always)]
            pub(super) fn least(a: $float, b: $float) -> $float {
                $float::from_bits(a.to_bits().min(b.to_bits()))
            }

            #[inline(always)]
            pub(super) fn most(a: $float, b: $float) -> $float {
                $float::from_bits(a.to_bits().max(b.to_bits()))
            }
        }

        #[inline(always)]
        pub(super) fn $least(a: $float, b: $float) -> $float {
            if cfg!(target_arch = "arm") {
                $module::least(a, b)
            } else {
                a.min(b)
            }
        }

        #[inline(always)]
        pub(super) fn $most(a: $float, b: $float) -> $float {
            if cfg!(target_arch = "arm") {
                $module::most(a, b)
            } else {
                a.max(b)
            }
        }
    };
}

ends!(double, least, most, f64);
ends!(single, least_single, most_single, f32);

#[cfg(test)]
mod tests {
    use super::{double, single};

    macro_rules! bits_are_ordered {
        ($name:ident, $module:ident, $float:ident) => {
            #[test]
            fn $name() {
                const NUMBERS: [$float; 8] = [
                    0.0,
                    $float::from_bits(1),
                    $float::MIN_POSITIVE,
                    0.3,
                    1.0,
                    1e30,
                    $float::MAX,
                    $float::INFINITY,
                ];
                for a in NUMBERS {
                    for b in NUMBERS {
                        assert_eq!($module::least(a, b), a.min(b));
                        assert_eq!($module::most(a, b), a.max(b));
                    }
                    assert_eq!($module::least($float::NAN, a), a);
                }
            }
        };
    }

    bits_are_ordered!(bits_of_doubles_are_in_their_order, double, f64);
    bits_are_ordered!(bits_of_singles_are_in_their_order, single, f32);
}
