//! Facts about the values that names are declared with, as far as items have been resolved.

use crate::model::types::{Expr, ExprKind, MotionLaw, Name, ScalarParameter};

/// Facts about parameters, inputs and derived quantities.
#[derive(Default)]
pub(in crate::model) struct Values {
    pub(in crate::model) scalar_parameters: Vec<ScalarParameter>,
    /// Number of inputs; in functions, arguments are counted after them.
    pub(in crate::model) input_count: usize,
    /// For each derived quantity so far, an argument that it depends on.
    arguments_of_lets: Vec<Option<usize>>,
    /// For each derived quantity so far, the course that it is.
    motion_laws_of_lets: Vec<Option<MotionLaw>>,
    /// Speeds and accelerations of each input.
    pub(in crate::model) rates: Vec<[Option<usize>; 2]>,
}

impl Values {
    /// Adds the facts about the next derived quantity.
    pub(in crate::model) fn note_let(&mut self, value: &Expr) {
        self.arguments_of_lets.push(self.argument_below(value));
        self.motion_laws_of_lets
            .push(self.motion_law_of(value).cloned());
    }

    /// Adds the next derived quantity, an unknown frame, which depends on no argument.
    pub(in crate::model) fn note_unknown_frame(&mut self) {
        self.arguments_of_lets.push(None);
        self.motion_laws_of_lets.push(None);
    }

    /// Returns an argument that a value depends on, perhaps through derived quantities.
    pub(in crate::model) fn argument_below(&self, value: &Expr) -> Option<usize> {
        let mut names = value.parts().filter_map(Expr::as_name);
        names.find_map(|name| match name {
            Name::Argument(argument) => Some(argument),
            Name::Let(index) => self.arguments_of_lets.get(index).copied()?,
            Name::Const(_) | Name::Parameter(_) | Name::Input(_) | Name::Unknown(_) | Name::Pi => {
                None
            }
        })
    }

    /// Returns the course that a value is, directly or as the value of a name.
    pub(in crate::model) fn motion_law_of<'v>(&'v self, value: &'v Expr) -> Option<&'v MotionLaw> {
        match &value.kind {
            ExprKind::MotionLaw(course) => Some(course),
            ExprKind::Name(Name::Let(index)) => self.motion_laws_of_lets.get(*index)?.as_ref(),
            _ => None,
        }
    }
}
