//! The files of the playground, built once for all tests.

use std::env;
use std::sync::LazyLock;

use xtask::{Playground, playground};

/// Returns the files; `None` if something is missing to build them, which is printed.
///
/// # Panics
///
/// If they cannot be built and `LINKAGE_PLAYGROUND=required`.
pub(crate) fn built() -> Option<&'static Playground> {
    static BUILT: LazyLock<Result<Playground, String>> = LazyLock::new(playground);
    match &*BUILT {
        Ok(built) => Some(built),
        Err(message) => {
            let required =
                env::var_os("LINKAGE_PLAYGROUND").is_some_and(|value| value == "required");
            assert!(!required, "{message}");
            eprintln!("skipped: {message}");
            None
        }
    }
}
