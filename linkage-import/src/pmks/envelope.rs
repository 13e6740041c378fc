//! The envelope of newer addresses: `pmks2:`, a check sum, and the document in base 64.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;

use crate::error::ImportError;

/// The start of such an address.
pub(super) const PREFIX: &str = "pmks2:";

/// Returns the document of an address as text, if its check sum is right.
pub(super) fn document(query: &str) -> Result<String, ImportError> {
    let changed = || {
        ImportError::new(
            "the check of the address is wrong: it was cut or changed\nhelp: share the drawing \
             again and give the whole address in quotes",
        )
    };
    let parts = query
        .strip_prefix(PREFIX)
        .and_then(|rest| rest.split_once('.'));
    let (sum, payload) = parts.ok_or_else(changed)?;
    let bytes = URL_SAFE_NO_PAD.decode(payload).map_err(|_| changed())?;
    if u32::from_str_radix(sum, 16) != Ok(crc32fast::hash(&bytes)) {
        return Err(changed());
    }
    String::from_utf8(bytes).map_err(|_| changed())
}
