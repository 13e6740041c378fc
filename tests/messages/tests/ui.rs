//! Messages that need rustc, as their user sees them; all others are cases of the compiler, in
//! `linkage-compiler/tests/messages`.
//!
//! The folder `tests/ui` has faulty programs, each with the output of rustc next to it:
//!
//! - `type_imported`, `type_of_another_mechanism`: rustc finds two types of one name in a module,
//!   and underlines the words of the user.
//! - `not_assembled`, `prepared_fields`: generated types do not have what the program uses.
//! - `skeleton_*`: a program that uses the mechanism has its types after a mistake of each kind, so
//!   that one mistake causes one message, and a mistake in the program is still reported.
//! - `change_point`, `unused_parameter`: warnings are those of a lint, with attributes that allow
//!   them.
//! - `names_that_look_alike`, `plus_minus_sign`: rustc itself reports names that look alike, and
//!   letters that are no token, in the text of a mechanism.
//! - `no_struct`: the whole call is underlined if it has no token.
//!
//! All are built together. `TRYBUILD=overwrite cargo test -p linkage-messages --test ui` writes the
//! messages: read the difference before you commit it.

#[test]
fn messages() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}
