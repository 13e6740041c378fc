//! Differences of two texts by lines.

/// Returns the lines of both texts: those of the first only after `-`, of the second only after
/// `+`, and all others after a space.
pub(crate) fn difference(expected: &str, found: &str) -> String {
    let [expected, found] = [expected, found].map(|text| text.lines().collect::<Vec<_>>());
    let common = common_lengths(&expected, &found);
    let [mut left, mut right] = [0; 2];
    let mut text = String::new();
    while left < expected.len() || right < found.len() {
        let is_equal = expected
            .get(left)
            .is_some_and(|line| Some(line) == found.get(right));
        if is_equal {
            text += &format!("  {}\n", expected[left]);
            left += 1;
            right += 1;
        } else if right == found.len()
            || left < expected.len() && common[left + 1][right] >= common[left][right + 1]
        {
            text += &format!("- {}\n", expected[left]);
            left += 1;
        } else {
            text += &format!("+ {}\n", found[right]);
            right += 1;
        }
    }
    text
}

/// The length of the longest common sequence of lines from a line of each text on.
fn common_lengths(expected: &[&str], found: &[&str]) -> Vec<Vec<usize>> {
    let mut lengths = vec![vec![0; found.len() + 1]; expected.len() + 1];
    for left in (0..expected.len()).rev() {
        for right in (0..found.len()).rev() {
            lengths[left][right] = if expected[left] == found[right] {
                lengths[left + 1][right + 1] + 1
            } else {
                lengths[left + 1][right].max(lengths[left][right + 1])
            };
        }
    }
    lengths
}

#[test]
fn differences_are_marked() {
    assert_eq!(difference("a\nb\nc\n", "a\nc\nd\n"), "  a\n- b\n  c\n+ d\n");
    assert_eq!(difference("", "a\n"), "+ a\n");
    assert_eq!(difference("a\n", ""), "- a\n");
}
