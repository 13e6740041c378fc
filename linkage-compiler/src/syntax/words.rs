//! Words with a meaning of their own.

/// First words of the struct block's items.
pub(super) const ITEMS: [&str; 19] = [
    "unit", "const", "param", "input", "unknown", "let", "loop", "argument", "gravity", "body",
    "pin", "slide", "ball", "cylinder", "fixed", "force", "torque", "spring", "damper",
];

/// Words that begin a clause of a body, a joint or a load.
const CLAUSES: [&str; 10] = [
    "on", "at", "along", "about", "turns", "mass", "inertia", "from", "to", "free",
];

/// The word itself if it begins clauses.
pub(super) fn clause(word: &str) -> Option<&'static str> {
    CLAUSES.into_iter().find(|clause| *clause == word)
}

/// Rust's keywords, those reserved for later included; none may name anything.
const KEYWORDS: [&str; 53] = [
    "_", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

pub(super) fn is_keyword(word: &str) -> bool {
    KEYWORDS.contains(&word)
}
