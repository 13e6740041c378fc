//! The numbers that C computes with.

use linkage_core::certificate;

/// The numbers of exported C, which has no other floating-point type.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Real {
    /// `double`
    #[default]
    Double,
    /// `double` with fused multiply-adds, for processors that have them: sines come from a table of
    /// 4 KB, as those of single calls of generated Rust do, in fewer operations.
    Fused,
    /// `float`, for processors that have no doubles.
    Single,
}

impl Real {
    /// Its name in C.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double | Self::Fused => "double",
            Self::Single => "float",
        }
    }

    /// A number with the fewest digits that C reads back as the nearest number of this type.
    pub(crate) fn literal(self, x: f64) -> String {
        let (text, none) = match self {
            Self::Double | Self::Fused => (format!("{x:?}"), !x.is_finite()),
            Self::Single => {
                let single = x as f32;
                (format!("{single:?}f"), !single.is_finite())
            }
        };
        match none {
            // C's macros are of type float.
            true if x.is_nan() => format!("(({})NAN)", self.name()),
            true => {
                let sign = if x < 0.0 { "-" } else { "" };
                format!("({sign}({})INFINITY)", self.name())
            }
            false if text.starts_with('-') => format!("({text})"),
            false => text,
        }
    }

    /// Returns the text for a name in a template; `None` for a name that stays as it is written.
    pub(crate) fn template_word(self, word: &str) -> Option<String> {
        let double = self != Self::Single;
        let bits = |double_bits: u64, single_bits: u32| match double {
            true => format!("0x{double_bits:016x}u"),
            false => format!("0x{single_bits:08x}u"),
        };
        let number = |double_bits: u64, single_bits: u32| match double {
            true => self.literal(f64::from_bits(double_bits)),
            false => self.literal(f64::from(f32::from_bits(single_bits))),
        };
        Some(match word {
            "real" => self.name().to_owned(),
            "word" => if double { "uint64_t" } else { "uint32_t" }.to_owned(),
            "sqrt" | "fabs" if !double => format!("{word}f"),
            "TOP" => if double { "63" } else { "31" }.to_owned(),
            "SIGN_BITS" => bits(1 << 63, 1 << 31),
            "INFINITE_BITS" => bits(f64::INFINITY.to_bits(), f32::INFINITY.to_bits()),
            "GREATEST_BITS" => bits(f64::MAX.to_bits(), f32::MAX.to_bits()),
            "LEAST_BITS" => bits(f64::MIN_POSITIVE.to_bits(), f32::MIN_POSITIVE.to_bits()),
            // The largest power of two whose reciprocal is no subnormal number.
            "MOST_BITS" => bits(
                f64::MIN_POSITIVE.recip().to_bits(),
                f32::MIN_POSITIVE.recip().to_bits(),
            ),
            "ONE_BITS" => bits(1.0_f64.to_bits(), 1.0_f32.to_bits()),
            // Less the bits of a power of two these are the bits of its reciprocal.
            "TWO_ONES" => bits(2 * 1.0_f64.to_bits(), 2 * 1.0_f32.to_bits()),
            "HALF_BITS" => bits(0.5_f64.to_bits(), 0.5_f32.to_bits()),
            // Half of the digits.
            "UPPER_BITS" => bits(u64::MAX << 27, u32::MAX << 12),
            "EIGHT_ROUNDOFFS" => self.literal(certificate::ROUNDINGS * self.roundoff()),
            // 1.5 times the number from which on there is nothing behind the point: added to
            // another, it rounds that.
            "ROUND" => self.literal(1.5 / self.roundoff()),
            "TWO_OVER_PI" => self.literal(std::f64::consts::FRAC_2_PI),
            "RIGHT" => self.literal(std::f64::consts::FRAC_PI_2),
            "RIGHT_LOW" => number(0x3c91_a626_3314_5c07, 0xb33b_bd2e),
            // A right angle in parts, so that products of the first ones with whole numbers are
            // exact.
            "RIGHT_FIRST" => number(0x3ff9_21fb_4000_0000, 0x3fc9_1000),
            "RIGHT_SECOND" => number(0x3e74_442d_0000_0000, 0xb695_7800),
            "RIGHT_THIRD" => number(0x3cf8_4698_98cc_0000, 0x2e85_a400),
            "RIGHT_FOURTH" => number(0x3a94_5c06_e0e6_8948, 0xa6f7_2ced),
            // The bits of 2^30, from where on an angle has no sine.
            "SINE_END_BITS" => bits(0x41d0_0000_0000_0000, 0x4e80_0000),
            // Times this, angles without a sine become infinite.
            "SINE_LIMIT" => number(0x7e10_0000_0000_0000, 0x7580_0000),
            // See `linkage_core::numeric::winding`: remainders that serve inputs a little outside
            // the range, too, those that serve the range, and a sum of middles.
            "COMFORT" => self.literal(certificate::COMFORTABLE_STRAY * std::f64::consts::PI),
            "MOST_STRAY" => self.literal(certificate::MOST_STRAY * std::f64::consts::PI),
            "MOST_MIDDLE" => self.literal(certificate::MOST_MIDDLE * std::f64::consts::PI),
            "TURN" => self.literal(std::f64::consts::TAU),
            "TURNS" => match double {
                true => self.literal(1.0 / std::f64::consts::TAU),
                false => self.literal(f64::from(1.0 / std::f32::consts::TAU)),
            },
            "TURN_HIGH" => number(0x4019_21fb_5440_0000, 0x40c9_0000),
            "TURN_LOW" => match double {
                true => self.literal(2.430_840_202_602_477e-10),
                false => self.literal(1.935_307_2e-3),
            },
            _ => return None,
        })
    }

    /// The distance from 1 to the next number.
    pub(crate) fn roundoff(self) -> f64 {
        match self {
            Self::Double | Self::Fused => f64::EPSILON,
            Self::Single => f64::from(f32::EPSILON),
        }
    }
}
