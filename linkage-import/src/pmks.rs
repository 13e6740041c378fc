//! Addresses of PMKS+ pages: the query has the whole drawing.
//!
//! Numbers are whole thousandths of the length unit, inch, centimetre or metre, in base 64, so that
//! a drawing in metres is rounded to 1 mm. Newer pages correct single numbers in a tail. The newest
//! ones share documents of bodies, `pmks2:...`, and a rewritten page shares `data=...`.

use crate::document::Document;
use crate::error::ImportError;

mod body_conversion;
mod body_document;
mod compressed;
mod conversion;
mod converted;
mod corrections;
mod cylinders;
mod drawn_bodies;
mod envelope;
mod groups;
mod masses;
mod page_drawing;
mod payload;
mod pounds;
mod record;

/// The characters of checks: the digits of numbers without the last two.
const CHECK_CHARACTERS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
const DIGEST_MARK: char = '*';
const DIGEST_LENGTH: usize = 6;

/// Reads an address, or a text with one: the query begins after the first question mark.
pub(crate) fn read(content: &[u8], name: &str) -> Result<Document, ImportError> {
    let text = if content.is_empty() {
        name.to_owned()
    } else {
        String::from_utf8_lossy(content).into_owned()
    };
    let query = query(&text)?;
    if query.starts_with(envelope::PREFIX) {
        return drawn_bodies::read(&query);
    }
    if let Some(packed) = query.strip_prefix(compressed::PREFIX) {
        return compressed::read(packed);
    }
    let drawing = payload::read(checked(&query)?)?;
    converted::document(drawing)
}

/// Returns the query of an address: all up to a space, a quote or a closing bracket.
fn query(text: &str) -> Result<String, ImportError> {
    let text = text.trim();
    // In a longer text, the address is that of the page.
    let from = text.find("pmksplus.com").unwrap_or(0);
    let page = &text[from..];
    let query = match page.split_once('?') {
        Some((_, query)) => query,
        // The query alone.
        None if !text.contains("://") => page,
        None => "",
    };
    let is_end = |letter: char| letter.is_whitespace() || "\"'<>)#&".contains(letter);
    let query = query.split(is_end).next().unwrap_or_default();
    if query.is_empty() {
        return Err(ImportError::new(
            "the address has no query\nhelp: give the whole address in quotes, from the \
             button that shares the drawing",
        ));
    }
    decoded(query)
}

/// Replaces `%20` and the like.
fn decoded(query: &str) -> Result<String, ImportError> {
    let mut bytes = Vec::new();
    let mut rest = query.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let digits = [rest.next(), rest.next()];
        let [Some(high), Some(low)] = digits.map(|digit| (digit? as char).to_digit(16)) else {
            return Err(ImportError::new("the address has a broken `%` sequence"));
        };
        bytes.push((16 * high + low) as u8);
    }
    String::from_utf8(bytes).map_err(|_| ImportError::new("the address is no text"))
}

/// Takes the checks off: the last character is the length, and a digest may follow it.
fn checked(query: &str) -> Result<&str, ImportError> {
    let changed = || {
        ImportError::new(
            "the check of the address is wrong: it was cut or changed\nhelp: share the drawing \
             again and give the whole address in quotes",
        )
    };
    let mut body = query;
    if let Some((before, digest)) = query.rsplit_once(DIGEST_MARK)
        && digest.len() == DIGEST_LENGTH
        && digest
            .chars()
            .all(|letter| CHECK_CHARACTERS.contains(letter))
    {
        if digest_of(before) != digest {
            return Err(changed());
        }
        body = before;
    }
    let check = body.chars().next_back().ok_or_else(changed)?;
    let body = &body[..body.len() - check.len_utf8()];
    let length = body.encode_utf16().count();
    if CHECK_CHARACTERS
        .chars()
        .nth(length % CHECK_CHARACTERS.len())
        != Some(check)
    {
        return Err(changed());
    }
    Ok(body)
}

/// The digest of the page: FNV-1a of the UTF-16 units, six digits in base 62.
fn digest_of(body: &str) -> String {
    const BASIS: u32 = 0x811c_9dc5;
    const PRIME: u32 = 0x0100_0193;
    let hash = body.encode_utf16().fold(BASIS, |hash, unit| {
        (hash ^ u32::from(unit)).wrapping_mul(PRIME)
    });
    let characters: Vec<char> = CHECK_CHARACTERS.chars().collect();
    let mut value = hash as usize;
    let mut digits = Vec::new();
    for _ in 0..DIGEST_LENGTH {
        digits.push(characters[value % characters.len()]);
        value /= characters.len();
    }
    digits.iter().rev().collect()
}
