//! The units of literals in one table. Their dimensions are in `model`.

/// A unit: a scale times powers of kilogram, newton, metre and second.
#[derive(Clone, Copy, Debug)]
pub struct UnitOfMeasure {
    pub kilograms: i32,
    pub newtons: i32,
    pub metres: i32,
    pub seconds: i32,
    pub angle: bool,
    pub scale: Scale,
}

/// `10^ten * pi^pi`, times each of `wholes` to its power.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    pub ten: i64,
    pub pi: i32,
    pub wholes: &'static [(u64, i32)],
}

const ONE: UnitOfMeasure = UnitOfMeasure {
    kilograms: 0,
    newtons: 0,
    metres: 0,
    seconds: 0,
    angle: false,
    scale: Scale {
        ten: 0,
        pi: 0,
        wholes: &[],
    },
};
const METRE: UnitOfMeasure = UnitOfMeasure { metres: 1, ..ONE };
const KILOGRAM: UnitOfMeasure = UnitOfMeasure {
    kilograms: 1,
    ..ONE
};
const NEWTON: UnitOfMeasure = UnitOfMeasure { newtons: 1, ..ONE };
const SECOND: UnitOfMeasure = UnitOfMeasure { seconds: 1, ..ONE };
const JOULE: UnitOfMeasure = UnitOfMeasure {
    metres: 1,
    ..NEWTON
};
const WATT: UnitOfMeasure = UnitOfMeasure {
    seconds: -1,
    ..JOULE
};
const PASCAL: UnitOfMeasure = UnitOfMeasure {
    metres: -2,
    ..NEWTON
};
const RADIAN: UnitOfMeasure = UnitOfMeasure { angle: true, ..ONE };
/// 25.4 mm: 254 of the unit 1e-4 m. Inch, foot and pound are those of the agreement of 1959 (NIST
/// Special Publication 811, appendix B).
const INCH: UnitOfMeasure = METRE.shifted(-4).wholes(&[(254, 1)]);
/// 12 inches.
const FOOT: UnitOfMeasure = METRE.shifted(-4).wholes(&[(3048, 1)]);
/// 0.45359237 kg.
const POUND: UnitOfMeasure = KILOGRAM.shifted(-8).wholes(&[(45_359_237, 1)]);
/// The weight of a pound at standard gravity, 9.80665 m/s^2 (General Conference on Weights and
/// Measures, 1901).
const POUND_OF_FORCE: UnitOfMeasure = NEWTON.shifted(-13).wholes(&[(45_359_237, 1), (980_665, 1)]);
/// A pound of force on a square inch, whose side is 254 of the unit 1e-4 m.
const POUND_ON_SQUARE_INCH: UnitOfMeasure =
    PASCAL
        .shifted(-5)
        .wholes(&[(45_359_237, 1), (980_665, 1), (254, -2)]);
const MINUTE: UnitOfMeasure = SECOND.wholes(&[(60, 1)]);
/// Two half turns in 60 seconds.
const TURN_IN_A_MINUTE: UnitOfMeasure = UnitOfMeasure {
    seconds: -1,
    ..RADIAN.half_turns(&[(30, -1)])
};

/// Spellings, the first of which messages list, its name and its size.
type Row = (&'static [&'static str], &'static str, UnitOfMeasure);

const UNITS: [Row; 35] = [
    (&["m"], "metre", METRE),
    (&["mm"], "millimetre", METRE.shifted(-3)),
    (&["cm"], "centimetre", METRE.shifted(-2)),
    // The micro sign and the Greek letter look alike.
    (
        &["um", "\u{b5}m", "\u{3bc}m"],
        "micrometre",
        METRE.shifted(-6),
    ),
    (&["nm"], "nanometre", METRE.shifted(-9)),
    (&["inch"], "inch, 25.4 mm", INCH),
    (&["ft"], "foot, 12 inches", FOOT),
    (&["deg"], "degree", RADIAN.half_turns(&[(180, -1)])),
    (&["rad"], "radian", RADIAN),
    (
        &["arcmin"],
        "minute of arc",
        RADIAN.half_turns(&[(180 * 60, -1)]),
    ),
    (
        &["arcsec"],
        "second of arc",
        RADIAN.half_turns(&[(180 * 3600, -1)]),
    ),
    (&["turn"], "turn, 360 degrees", RADIAN.half_turns(&[(2, 1)])),
    (&["kg"], "kilogram", KILOGRAM),
    (&["g"], "gram", KILOGRAM.shifted(-3)),
    (&["mg"], "milligram", KILOGRAM.shifted(-6)),
    (&["t"], "tonne", KILOGRAM.shifted(3)),
    (&["lb"], "pound, 0.45359237 kg", POUND),
    (&["N"], "newton", NEWTON),
    (&["mN"], "millinewton", NEWTON.shifted(-3)),
    (&["kN"], "kilonewton", NEWTON.shifted(3)),
    (&["lbf"], "pound of force", POUND_OF_FORCE),
    (&["s"], "second", SECOND),
    (&["ms"], "millisecond", SECOND.shifted(-3)),
    (&["min"], "minute", MINUTE),
    (&["rpm"], "turns in a minute", TURN_IN_A_MINUTE),
    (&["J"], "joule", JOULE),
    (&["mJ"], "millijoule", JOULE.shifted(-3)),
    (&["kJ"], "kilojoule", JOULE.shifted(3)),
    (&["W"], "watt", WATT),
    (&["mW"], "milliwatt", WATT.shifted(-3)),
    (&["kW"], "kilowatt", WATT.shifted(3)),
    (&["Pa"], "pascal", PASCAL),
    (&["kPa"], "kilopascal", PASCAL.shifted(3)),
    (&["MPa"], "megapascal", PASCAL.shifted(6)),
    (
        &["psi"],
        "pound of force on a square inch",
        POUND_ON_SQUARE_INCH,
    ),
];

/// The units as messages list them.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|(spellings, ..)| spellings[0])
}

/// Returns the full name of a unit, in any spelling: `millimetre`.
pub fn unit_description(name: &str) -> Option<&'static str> {
    row(name).map(|(_, description, _)| *description)
}

/// Returns true for the suffix of a literal.
pub fn is_unit(name: &str) -> bool {
    row(name).is_some()
}

/// Returns true for a name that is hardly meant as anything else: `psi` is an angle in most
/// mechanisms.
pub fn is_meant_as_unit(name: &str) -> bool {
    name != "psi" && is_unit(name)
}

/// The unit of this name, in any spelling.
pub fn find_unit(name: &str) -> Option<UnitOfMeasure> {
    row(name).map(|(.., unit)| *unit)
}

/// The spelling of a unit that messages list.
pub fn first_spelling(name: &str) -> Option<&'static str> {
    row(name).map(|(spellings, ..)| spellings[0])
}

fn row(name: &str) -> Option<&'static Row> {
    UNITS
        .iter()
        .find(|(spellings, ..)| spellings.contains(&name))
}

impl UnitOfMeasure {
    const fn shifted(mut self, ten: i64) -> UnitOfMeasure {
        self.scale.ten = ten;
        self
    }

    const fn wholes(mut self, wholes: &'static [(u64, i32)]) -> UnitOfMeasure {
        self.scale.wholes = wholes;
        self
    }

    /// Half a turn times these numbers to their powers.
    const fn half_turns(mut self, wholes: &'static [(u64, i32)]) -> UnitOfMeasure {
        self.scale.pi = 1;
        self.wholes(wholes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_spelling_stands_twice() {
        let mut spellings: Vec<&str> = UNITS
            .iter()
            .flat_map(|(spellings, ..)| spellings.iter().copied())
            .collect();
        let count = spellings.len();
        spellings.sort_unstable();
        spellings.dedup();
        assert_eq!(spellings.len(), count);
    }
}
