//! Operation counts as text, and as the runtime's `Operations`.

use linkage_symbolic::count::Count;

/// The counts that the runtime's `Operations` is made of.
pub(super) fn literal(count: &Count) -> String {
    let counts = count.by_class().map(|count| format!("{count}u32"));
    format!("[{}]", counts.join(","))
}

/// `12 additions, 3 square roots`, or `none`.
pub(super) fn words(count: &Count) -> String {
    let classes = [
        (count.add, "addition", "additions"),
        (count.mul, "multiplication", "multiplications"),
        (count.div, "division", "divisions"),
        (count.sqrt, "square root", "square roots"),
        (count.sin_cos, "sine-cosine pair", "sine-cosine pairs"),
        (count.atan2, "arctangent", "arctangents"),
        (count.other, "other", "others"),
    ];
    let words: Vec<String> = classes
        .iter()
        .filter(|(n, ..)| *n > 0)
        .map(|(n, one, many)| format!("{n} {}", if *n == 1 { one } else { many }))
        .collect();
    if words.is_empty() {
        "none".to_owned()
    } else {
        words.join(", ")
    }
}
