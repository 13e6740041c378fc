//! The effort of searches, so that large robots take bounded time.

use std::cell::Cell;

/// Operations of all searches of a robot: some seconds.
const MOST_OPERATIONS: u64 = 3_000_000_000;

/// The operations of a derivative of an equation.
const DERIVATIVE: u64 = 30;

/// The operations that are left.
#[derive(Debug)]
pub(super) struct Effort {
    left: Cell<u64>,
}

impl Effort {
    pub(super) fn new() -> Self {
        Self {
            left: Cell::new(MOST_OPERATIONS),
        }
    }

    /// Takes the operations of a Newton step for so many equations. Returns false if they are not
    /// left.
    pub(super) fn step(&self, equations: usize) -> bool {
        let size = equations as u64;
        let cost = size * size * (size / 3 + DERIVATIVE);
        match self.left.get().checked_sub(cost) {
            Some(left) => {
                self.left.set(left);
                true
            }
            None => {
                self.left.set(0);
                false
            }
        }
    }

    /// Returns true if a search was ended.
    pub(super) fn is_spent(&self) -> bool {
        self.left.get() == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn large_steps_spend_the_effort() {
        let effort = Effort::new();
        assert!(effort.step(10));
        assert!(!effort.is_spent());
        let steps = (0..1000).take_while(|_| effort.step(1000)).count();
        assert_eq!(steps, 8);
        assert!(effort.is_spent() && !effort.step(10));
    }
}
