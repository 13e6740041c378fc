//! Errors before a mechanism is assembled.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

/// A text that holds no mechanisms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SourceError {
    /// A file that cannot be read, a text that is no text of mechanisms: the whole message.
    Message(String),
    /// A character or bracket that cannot be read: a message with the source under it.
    Rendered(String),
}

impl Display for SourceError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Message(text) | Self::Rendered(text) => write!(f, "{text}"),
        }
    }
}

impl Error for SourceError {}

/// A text whose mechanisms have mistakes, or another number of mechanisms than is asked for.
///
/// It is shown as all messages of the compiler, each with the source under it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompileError(pub(crate) String);

impl Display for CompileError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.trim_end())
    }
}

impl Error for CompileError {}

impl From<SourceError> for CompileError {
    fn from(error: SourceError) -> Self {
        Self(error.to_string())
    }
}

/// A name that no function of a mechanism has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownFunction {
    /// The mechanism.
    pub mechanism: &'static str,
    /// The name.
    pub name: String,
    /// The functions that there are.
    pub functions: Vec<&'static str>,
}

impl Display for UnknownFunction {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self {
            mechanism,
            name,
            functions,
        } = self;
        write!(f, "{mechanism} has no function `{name}`; it has ")?;
        match &functions[..] {
            [] => f.write_str("none"),
            all => write!(f, "`{}`", all.join("`, `")),
        }
    }
}

impl Error for UnknownFunction {}

/// A design problem with mistakes, or one without a result: the message.
#[cfg(feature = "design")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DesignError(pub(crate) String);

#[cfg(feature = "design")]
impl Display for DesignError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.trim_end())
    }
}

#[cfg(feature = "design")]
impl Error for DesignError {}

/// Tolerances whose effects cannot be computed: the message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ToleranceError(pub(crate) String);

impl Display for ToleranceError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl Error for ToleranceError {}

/// A function that is no equation of motion.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NotDriven {
    /// The mechanism has no input.
    NoInput {
        /// The mechanism.
        mechanism: &'static str,
    },
    /// The function lacks the `driven_acceleration` of an input.
    Accelerations {
        /// The function.
        function: &'static str,
        /// The first input.
        input: &'static str,
        /// The name of its speed.
        speed: String,
    },
    /// The function does not take an input.
    Input {
        /// The function.
        function: &'static str,
        /// The input.
        input: &'static str,
        /// The name of its speed.
        speed: String,
    },
    /// The function does not take the speed of an input.
    Speed {
        /// The function.
        function: &'static str,
        /// The input.
        input: &'static str,
        /// The name of its speed.
        speed: String,
    },
}

impl NotDriven {
    /// Returns advice how to write an equation of motion, with the names of an input and its speed.
    #[must_use]
    pub fn help(input: &str, speed: &str) -> String {
        format!(
            "help: declare bodies with masses and `input {input} = ... at {speed}`, and write a function such as \
             `fn motion({input}, {speed}) -> Motion {{ a: driven_acceleration({input}) }}`"
        )
    }
}

impl Display for NotDriven {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let (input, speed) = match self {
            Self::NoInput { mechanism } => {
                return write!(f, "{mechanism} has no input that could move");
            }
            Self::Accelerations {
                function,
                input,
                speed,
            } => {
                writeln!(
                    f,
                    "`{function}` does not have the accelerations of all inputs"
                )?;
                (input, speed)
            }
            Self::Input {
                function,
                input,
                speed,
            } => {
                writeln!(f, "`{function}` does not take the input `{input}`")?;
                (input, speed)
            }
            Self::Speed {
                function,
                input,
                speed,
            } => {
                writeln!(
                    f,
                    "`{function}` does not take the speed of `{input}`, so that it leaves out what speeds do"
                )?;
                (input, speed)
            }
        };
        f.write_str(&Self::help(input, speed))
    }
}

impl Error for NotDriven {}
