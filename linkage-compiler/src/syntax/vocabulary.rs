//! Words of the language as enums: one list says what words there are, and a `match` over them what each means.

/// A word of some kind.
pub(crate) trait Word: Copy + 'static {
    /// All of them, in the order in which messages list them.
    fn all() -> impl Iterator<Item = Self>;

    /// As it is written.
    fn word(self) -> &'static str;

    /// What a written word is.
    fn from_word(word: &str) -> Option<Self> {
        Self::all().find(|own| own.word() == word)
    }
}

/// An enum of words, or of several such enums together, which is a [`Word`].
///
/// Code that has to know every word matches all variants without `_`, so that a new word does not compile before it is known everywhere.
macro_rules! vocabulary {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$own:meta])* $variant:ident = $word:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $($(#[$own])* $variant,)+ }

        impl $crate::syntax::Word for $name {
            fn all() -> impl Iterator<Item = Self> {
                [$(Self::$variant),+].into_iter()
            }

            fn word(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }
        }
    };
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$own:meta])* $variant:ident($part:ty),)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $($(#[$own])* $variant($part),)+ }

        impl $crate::syntax::Word for $name {
            fn all() -> impl Iterator<Item = Self> {
                std::iter::empty()$(.chain(<$part as $crate::syntax::Word>::all().map(Self::$variant)))+
            }

            fn word(self) -> &'static str {
                match self { $(Self::$variant(own) => own.word(),)+ }
            }
        }
    };
}

pub(crate) use vocabulary;
