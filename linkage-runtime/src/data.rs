//! Data of a generated mechanism.

use core::fmt;

/// A scalar dimension of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Name as in the mechanism, with `.x`, `.y`, `.z` for a component of a vector.
    pub name: &'static str,
    /// Unit of `nominal` and `tolerance`: the mechanism's length unit, `rad`, or empty for a
    /// number.
    pub unit: &'static str,
    /// The default value.
    pub nominal: f64,
    /// Half the width of the tolerance zone; 0 where none is given.
    pub tolerance: f64,
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} = {}", self.name, self.nominal)?;
        if self.tolerance != 0.0 {
            write!(f, " +- {}", self.tolerance)?;
        }
        if !self.unit.is_empty() {
            write!(f, " {}", self.unit)?;
        }
        Ok(())
    }
}

/// A driving coordinate of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: &'static str,
    /// The mechanism's length unit, or `rad`.
    pub unit: &'static str,
    /// The reference position.
    pub reference: f64,
    /// The range in which the mechanism must work.
    pub range: Option<(f64, f64)>,
}

impl Input {
    /// The ends of its range. Without one: a whole turn from the reference for an angle, otherwise
    /// the reference twice.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        let turn = match self.unit {
            "rad" => core::f64::consts::TAU,
            _ => 0.0,
        };
        self.range
            .unwrap_or((self.reference, self.reference + turn))
    }

    /// `count` evenly spaced values over [`ends`](Self::ends), both of them included.
    ///
    /// ```
    /// let range = Some((1.0, 3.0));
    /// let input = linkage_runtime::Input { name: "s", unit: "mm", reference: 0.0, range };
    /// assert_eq!(input.positions(5), [1.0, 1.5, 2.0, 2.5, 3.0]);
    /// ```
    #[cfg(feature = "alloc")]
    #[must_use]
    pub fn positions(&self, count: usize) -> alloc::vec::Vec<f64> {
        (0..count)
            .map(|index| self.position(index, count))
            .collect()
    }

    /// The position of this index among `count` [positions](Self::positions): for more of them than
    /// memory holds.
    #[must_use]
    pub fn position(&self, index: usize, count: usize) -> f64 {
        let (low, high) = self.ends();
        let last = count.saturating_sub(1);
        match index {
            0 => low,
            _ if index == last => high,
            _ => low + (high - low) * (index as f64 / last as f64),
        }
    }
}

/// The solution of a group that its assembly uses, out of two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AssemblyMode {
    /// The solution with the positive root.
    Plus,
    /// The solution with the negative root.
    Minus,
}

impl AssemblyMode {
    /// +1 or -1.
    #[must_use]
    #[inline]
    pub const fn sign(self) -> f64 {
        // Without a branch: sweeps over mechanisms ask for it in their loops. `Plus` is 0, `Minus`
        // 1.
        1.0 - 2.0 * (self as u8 as f64)
    }

    /// The other mode.
    #[must_use]
    #[inline]
    pub const fn flipped(self) -> Self {
        match self {
            Self::Plus => Self::Minus,
            Self::Minus => Self::Plus,
        }
    }
}

impl fmt::Display for AssemblyMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Plus => "+",
            Self::Minus => "-",
        })
    }
}

/// The numbers of operations that a generated function executes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Additions and subtractions.
    pub add: u32,
    /// Multiplications. A fused multiply-add counts as a multiplication and an addition.
    pub mul: u32,
    /// Divisions.
    pub div: u32,
    /// Square roots.
    pub sqrt: u32,
    /// Pairs of sine and cosine.
    pub sin_cos: u32,
    /// Angles of vectors.
    pub atan2: u32,
    /// Everything else: minimum, choice, arc sine and so on.
    pub other: u32,
}

impl Operations {
    /// All operations together.
    #[must_use]
    pub const fn total(&self) -> u32 {
        self.add + self.mul + self.div + self.sqrt + self.sin_cos + self.atan2 + self.other
    }
}

/// The operations that occur, as in `12 add, 9 mul, 1 sqrt`.
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.add, "add"),
            (self.mul, "mul"),
            (self.div, "div"),
            (self.sqrt, "sqrt"),
            (self.sin_cos, "sin_cos"),
            (self.atan2, "atan2"),
            (self.other, "other"),
        ];
        let mut separator = "";
        for (count, word) in counts.into_iter().filter(|(count, _)| *count > 0) {
            write!(f, "{separator}{count} {word}")?;
            separator = ", ";
        }
        if separator.is_empty() {
            f.write_str("none")?;
        }
        Ok(())
    }
}
