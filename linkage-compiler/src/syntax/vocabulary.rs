//! Words of the language as enums: one list says what words there are, and a `match` over them what each means.

/// An enum of words, or of several such enums together. It has
///
/// * `all`, in the order in which messages list them,
/// * `word`, as it is written,
/// * `from_word`, what a written word is.
///
/// Code that has to know every word matches all variants without `_`, so that a new word does not compile before it is known everywhere.
macro_rules! vocabulary {
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$own:meta])* $variant:ident = $word:literal,)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $($(#[$own])* $variant,)+ }

        impl $name {
            /// All of them, in the order in which messages list them.
            $vis fn all() -> impl Iterator<Item = Self> {
                [$(Self::$variant),+].into_iter()
            }

            /// As it is written.
            $vis const fn word(self) -> &'static str {
                match self { $(Self::$variant => $word,)+ }
            }

            /// What a written word is.
            $vis fn from_word(word: &str) -> Option<Self> {
                Self::all().find(|own| own.word() == word)
            }
        }
    };
    ($(#[$meta:meta])* $vis:vis enum $name:ident { $($(#[$own:meta])* $variant:ident($part:ty),)+ }) => {
        $(#[$meta])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        $vis enum $name { $($(#[$own])* $variant($part),)+ }

        impl $name {
            /// All of them, in the order in which messages list them.
            $vis fn all() -> impl Iterator<Item = Self> {
                std::iter::empty()$(.chain(<$part>::all().map(Self::$variant)))+
            }

            /// As it is written.
            $vis const fn word(self) -> &'static str {
                match self { $(Self::$variant(own) => own.word(),)+ }
            }

            /// What a written word is.
            $vis fn from_word(word: &str) -> Option<Self> {
                None$(.or_else(|| <$part>::from_word(word).map(Self::$variant)))+
            }
        }
    };
}

pub(crate) use vocabulary;
