//! Texts that differ in blanks and comments alone.

use crate::lexer::Token;

/// Returns true if two texts have the same words, numbers and marks, so that all mechanisms and all
/// messages are the same. Marks that touch each other can be another mark.
pub(crate) fn alike(old: (&str, &[Token]), new: (&str, &[Token])) -> bool {
    solid(old.0, old.1).eq(solid(new.0, new.1))
}

/// Returns the tokens other than blanks and comments, each with true if it touches the next one.
fn solid<'t>(text: &'t str, tokens: &'t [Token]) -> impl Iterator<Item = (&'t str, bool)> {
    let solid = tokens.iter().enumerate();
    let solid = solid.filter(|(_, token)| !token.is_trivia());
    solid.map(move |(index, token)| {
        let next = tokens.get(index + 1);
        let touches = next.is_some_and(|next| !next.is_trivia());
        (token.text(text), touches)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lexer::tokens;

    #[test]
    fn comments_and_blanks_change_nothing() {
        let is_alike = |new: &str| {
            let old = "param r = 3mm +- 1um; // the crank";
            alike((old, &tokens(old)), (new, &tokens(new)))
        };
        assert!(is_alike("/// The crank.\n  param  r = 3mm +- 1um;"));
        assert!(is_alike("param r = 3mm +- 1um;"));
        assert!(!is_alike("param r = 3mm + - 1um;"));
        assert!(!is_alike("param r = 3 mm +- 1um;"));
        assert!(!is_alike("param r = 3mm +- 1um; /* no end"));
        assert!(!is_alike("param s = 3mm +- 1um;"));
        assert!(!is_alike("param r = 3mm +- 1um"));
    }
}
