//! The operands of an operation, one after the other.

/// At most three operands.
// An array of options, flattened, takes ten calls for each where nothing is optimised.
#[derive(Clone, Debug)]
pub struct Operands<T> {
    list: [T; 3],
    next: usize,
    count: usize,
}

impl<T> Operands<T> {
    /// The first `count` of a list.
    pub(crate) fn new(list: [T; 3], count: usize) -> Self {
        Self {
            list,
            next: 0,
            count,
        }
    }
}

impl<T: Copy> Iterator for Operands<T> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        let next = self.next;
        if next == self.count {
            return None;
        }
        self.next = next + 1;
        Some(self.list[next])
    }
}
