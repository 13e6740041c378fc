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

/// `10^ten * pi^pi * whole.0^whole.1`
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    pub ten: i64,
    pub pi: i32,
    pub whole: (u32, i32),
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
        whole: (1, 1),
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
/// 254 of the unit 1e-4 m.
const INCH: UnitOfMeasure = UnitOfMeasure {
    scale: Scale {
        ten: -4,
        pi: 0,
        whole: (254, 1),
    },
    ..METRE
};
const MINUTE: UnitOfMeasure = UnitOfMeasure {
    scale: Scale {
        whole: (60, 1),
        ..ONE.scale
    },
    ..SECOND
};

/// Spellings, the first of which messages list.
const UNITS: [(&[&str], UnitOfMeasure); 30] = [
    (&["m"], METRE),
    (&["mm"], METRE.shifted(-3)),
    (&["cm"], METRE.shifted(-2)),
    // The micro sign and the Greek letter look alike.
    (&["um", "\u{b5}m", "\u{3bc}m"], METRE.shifted(-6)),
    (&["nm"], METRE.shifted(-9)),
    (&["inch"], INCH),
    (&["deg"], RADIAN.half_turns(180, -1)),
    (&["rad"], RADIAN),
    (&["arcmin"], RADIAN.half_turns(180 * 60, -1)),
    (&["arcsec"], RADIAN.half_turns(180 * 3600, -1)),
    (&["turn"], RADIAN.half_turns(2, 1)),
    (&["kg"], KILOGRAM),
    (&["g"], KILOGRAM.shifted(-3)),
    (&["mg"], KILOGRAM.shifted(-6)),
    (&["t"], KILOGRAM.shifted(3)),
    (&["N"], NEWTON),
    (&["mN"], NEWTON.shifted(-3)),
    (&["kN"], NEWTON.shifted(3)),
    (&["s"], SECOND),
    (&["ms"], SECOND.shifted(-3)),
    (&["min"], MINUTE),
    (&["J"], JOULE),
    (&["mJ"], JOULE.shifted(-3)),
    (&["kJ"], JOULE.shifted(3)),
    (&["W"], WATT),
    (&["mW"], WATT.shifted(-3)),
    (&["kW"], WATT.shifted(3)),
    (&["Pa"], PASCAL),
    (&["kPa"], PASCAL.shifted(3)),
    (&["MPa"], PASCAL.shifted(6)),
];

/// The units as messages list them.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|(spellings, _)| spellings[0])
}

/// Returns true for the suffix of a literal.
pub fn is_unit(name: &str) -> bool {
    row(name).is_some()
}

/// The unit of this name, in any spelling.
pub fn find_unit(name: &str) -> Option<UnitOfMeasure> {
    row(name).map(|(_, unit)| *unit)
}

/// The spelling of a unit that messages list.
pub fn first_spelling(name: &str) -> Option<&'static str> {
    row(name).map(|(spellings, _)| spellings[0])
}

fn row(name: &str) -> Option<&'static (&'static [&'static str], UnitOfMeasure)> {
    UNITS
        .iter()
        .find(|(spellings, _)| spellings.contains(&name))
}

impl UnitOfMeasure {
    const fn shifted(mut self, ten: i64) -> UnitOfMeasure {
        self.scale.ten = ten;
        self
    }

    /// Half a turn times a power of a number.
    const fn half_turns(mut self, number: u32, power: i32) -> UnitOfMeasure {
        self.scale.pi = 1;
        self.scale.whole = (number, power);
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_spelling_stands_twice() {
        let mut spellings: Vec<&str> = UNITS
            .iter()
            .flat_map(|(spellings, _)| spellings.iter().copied())
            .collect();
        let count = spellings.len();
        spellings.sort_unstable();
        spellings.dedup();
        assert_eq!(spellings.len(), count);
    }
}
