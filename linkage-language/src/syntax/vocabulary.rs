//! Words of the language as enums: an enum lists the words, and a `match` over it defines their
//! meaning.

/// A word of some kind.
pub trait Word: Copy + 'static {
    /// All of them, in the order in which messages list them.
    fn all() -> impl Iterator<Item = Self>;

    /// Returns the word as it is written.
    fn word(self) -> &'static str;

    /// Returns its meaning in a line of Markdown: the doc comment of its row.
    fn description(self) -> &'static str;

    /// Returns the meaning of a written word.
    fn from_word(word: &str) -> Option<Self> {
        Self::all().find(|candidate| candidate.word() == word)
    }
}

/// The names of all enums of words.
macro_rules! vocabularies {
    ($($name:ident,)+) => {
        /// The names of all enums of words, so that a list of words cannot leave one out.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Vocabulary { $($name,)+ }

        impl Vocabulary {
            /// Returns all of them, in the order in which a word is looked up.
            pub fn all() -> impl Iterator<Item = Self> {
                [$(Self::$name),+].into_iter()
            }
        }
    };
}

vocabularies! {
    DeclarationWord,
    LoadWord,
    LinkedWord,
    JointKind,
    ClauseWord,
    LinkClause,
    SliderWord,
    WheelsWord,
    MarkWord,
    LinkQuantity,
    Law,
    Ends,
    Degree,
    Repeating,
    Function,
    MotionLawWord,
    MotionWord,
    MechanicsWord,
    LengthUnit,
    ElementKind,
    Sweep,
}

/// An enum of words, or of several such enums together, which is a [`Word`].
///
/// The doc comment of a row is its meaning, for readers of the code as for editors.
///
/// Code that handles every word matches all variants without `_`, so a new word does not compile
/// before all places handle it. A new enum does not compile before [`Vocabulary`] has its name, and
/// with it the lists of words that editors use.
macro_rules! vocabulary {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $(#[doc = $doc:literal] $variant:ident = $word:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $(#[doc = $doc] $variant,)+ }

        // Every enum is in the list of all.
        const _: $crate::syntax::Vocabulary = $crate::syntax::Vocabulary::$name;

        impl $crate::syntax::Word for $name {
            fn all() -> impl Iterator<Item = Self> {
                [$(Self::$variant),+].into_iter()
            }

            fn word(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }

            fn description(self) -> &'static str {
                match self { $(Self::$variant => $doc.trim_ascii(),)+ }
            }
        }
    };
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$doc:meta])* $variant:ident($part:ty),)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $($(#[$doc])* $variant($part),)+ }

        impl $crate::syntax::Word for $name {
            fn all() -> impl Iterator<Item = Self> {
                std::iter::empty()$(.chain(<$part as $crate::syntax::Word>::all().map(Self::$variant)))+
            }

            fn word(self) -> &'static str {
                match self { $(Self::$variant(inner) => inner.word(),)+ }
            }

            fn description(self) -> &'static str {
                match self { $(Self::$variant(inner) => inner.description(),)+ }
            }
        }
    };
}

pub(crate) use vocabulary;
