//! The formats that are read, and their recognition.

use crate::error::ImportError;

/// A format of files of other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// The XML files of the program Linkage.
    Linkage,
    /// The addresses of PMKS+ pages, with a mechanism in their query.
    Pmks,
    /// The expressions of Pyslvs.
    Pyslvs,
    /// The JSON files of pylinkage.
    Pylinkage,
    /// A table of joints as CSV.
    JointTable,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 5] = [
        Self::Linkage,
        Self::Pmks,
        Self::Pyslvs,
        Self::Pylinkage,
        Self::JointTable,
    ];

    /// Returns the name of the format at the command.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linkage => "linkage2",
            Self::Pmks => "pmks",
            Self::Pyslvs => "pyslvs",
            Self::Pylinkage => "pylinkage",
            Self::JointTable => "csv",
        }
    }

    /// Returns a line about the format for lists.
    #[must_use]
    pub fn about(self) -> &'static str {
        match self {
            Self::Linkage => "files `.linkage2` of the program Linkage",
            Self::Pmks => "addresses of PMKS+ pages, or a file with one",
            Self::Pyslvs => "expressions `M[J[R, ...], ...]` of Pyslvs",
            Self::Pylinkage => "JSON files of pylinkage: positions, no lengths",
            Self::JointTable => "tables of joints: name, kind, x, y, links",
        }
    }

    /// Returns the format of a name at the command.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// Returns the format of a file by its name and its first bytes.
    pub(crate) fn detected(_content: &[u8], name: &str) -> Result<Self, ImportError> {
        let extension = name.rsplit_once('.').map_or("", |parts| parts.1);
        match &extension.to_ascii_lowercase()[..] {
            "linkage2" => Ok(Self::Linkage),
            "csv" => Ok(Self::JointTable),
            _ => Err(ImportError::new(
                "the format of the file is not known\nhelp: give it with `--format`",
            )),
        }
    }
}
