//! The formats that are read, and their recognition.

use crate::error::ImportError;
use crate::names::shown;

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
    /// Models of MuJoCo.
    Mjcf,
    /// Robot descriptions of ROS.
    Urdf,
    /// Models of Gazebo.
    Sdf,
    /// Tables of the points of a wheel suspension.
    HardPoints,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 9] = [
        Self::Linkage,
        Self::Pmks,
        Self::Pyslvs,
        Self::Pylinkage,
        Self::JointTable,
        Self::Mjcf,
        Self::Urdf,
        Self::Sdf,
        Self::HardPoints,
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
            Self::Mjcf => "mjcf",
            Self::Urdf => "urdf",
            Self::Sdf => "sdf",
            Self::HardPoints => "hard-points",
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
            Self::Mjcf => "models of MuJoCo, with `connect`, `weld` and `joint` equalities",
            Self::Urdf => {
                "robot descriptions of ROS, with `mimic`, `loop_joint` or a table of closures"
            }
            Self::Sdf => "models of Gazebo, whose joints may close loops",
            Self::HardPoints => "points of a wheel suspension as CSV or YAML, by roles",
        }
    }

    /// Returns the format of a name at the command.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// Returns the format of a file by its name, or else by its first bytes.
    pub(crate) fn detected(content: &[u8], name: &str) -> Result<Self, ImportError> {
        if content.is_empty() && name.contains('?') {
            return Ok(Self::Pmks);
        }
        let extension = name.rsplit_once('.').map_or("", |parts| parts.1);
        match &extension.to_ascii_lowercase()[..] {
            "linkage2" => return Ok(Self::Linkage),
            "csv" | "tsv" => return Ok(Self::JointTable),
            "urdf" => return Ok(Self::Urdf),
            "sdf" => return Ok(Self::Sdf),
            "mjcf" => return Ok(Self::Mjcf),
            "mech" => {
                return Err(ImportError::new(format!(
                    "`{}` is a mechanism already\nhelp: the other commands read it as it is, as \
                     `linkage check`",
                    shown(name)
                )));
            }
            _ => {}
        }
        let start = &content[..content.len().min(LOOKED_AT)];
        let start = String::from_utf8_lossy(start);
        let start = start.trim_start_matches('\u{feff}').trim_start();
        if start.contains("<linkage2") {
            Ok(Self::Linkage)
        } else if start.contains("<mujoco") {
            Ok(Self::Mjcf)
        } else if start.contains("<robot") {
            Ok(Self::Urdf)
        } else if start.contains("<sdf") {
            Ok(Self::Sdf)
        } else if start.contains("pmksplus.com/?") {
            Ok(Self::Pmks)
        } else if start.contains("M[") && start.contains("J[") {
            Ok(Self::Pyslvs)
        } else if start.starts_with('{') && start.contains("joints") {
            Ok(Self::Pylinkage)
        } else if ["name,", "name;"]
            .iter()
            .any(|name| start.starts_with(name))
        {
            Ok(Self::JointTable)
        } else {
            let names = Self::ALL.map(Self::name).join(", ");
            Err(ImportError::new(format!(
                "the format of the file is not known\nhelp: name it with `--format`: {names}"
            )))
        }
    }
}

/// The bytes at the start of a file that tell its format.
const LOOKED_AT: usize = 4096;
