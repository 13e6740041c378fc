//! Lines of CSV files in messages.

use csv::StringRecord;

/// Returns the number of the line in which a record begins. Records know where the one before them
/// ended: comments and empty lines may lie between.
pub(crate) fn line_number(text: &str, record: &StringRecord) -> usize {
    let end_of_last = record.position().map_or(0, csv::Position::byte);
    let end_of_last = usize::try_from(end_of_last).unwrap_or(usize::MAX);
    let (before, rest) = text.split_at_checked(end_of_last).unwrap_or((text, ""));
    let is_skipped = |line: &&str| line.is_empty() || line.starts_with('#');
    before.matches('\n').count() + rest.lines().take_while(is_skipped).count() + 1
}
