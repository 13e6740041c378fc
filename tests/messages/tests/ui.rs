//! Messages that need rustc, as their user sees them; all others are cases of the compiler, in
//! `linkage-compiler/tests/messages`.
//!
//! The folder `tests/ui` has faulty programs, each with the output of rustc next to it:
//!
//! - `types_of_one_name`: rustc finds two types of one name in a module, and underlines the words of the user.
//! - `mistakes_of_users`: generated types do not have what the program uses, or are not what it expects; a mistake in a
//!   mechanism does not hide one in the program.
//! - `skeletons`: a program that uses the mechanism has its types after a mistake of each kind, so that one mistake causes
//!   one message.
//! - `warnings`: warnings are those of a lint, with attributes that allow them.
//! - `texts`: rustc itself reports names that look alike, and letters that are no token, in the text of a mechanism. The
//!   whole call is underlined if it has no token.
//!
//! All are built together. `TRYBUILD=overwrite cargo test -p linkage-messages --test ui` writes the
//! messages: read the difference before you commit it.

#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
