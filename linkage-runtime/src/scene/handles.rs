//! The handles that a function of a scene uses.

use super::Handle;
use alloc::vec::Vec;
use core::any::Any;

/// One handle, or a tuple of two to four: whose results [`Scene::add_of`](crate::Scene::add_of)
/// gives to a function.
pub trait Handles: sealed::Handles {}

pub(super) mod sealed {
    use super::*;

    /// Written for handles alone.
    pub trait Handles: Copy {
        /// The results, borrowed from the scene.
        type Results<'r>;

        /// The numbers of the functions, with their scene.
        fn entries(self) -> Vec<(usize, usize)>;

        /// The results, if all are there and of the types of the handles.
        fn results<'r>(
            self,
            at: &dyn Fn(usize) -> Option<&'r dyn Any>,
        ) -> Option<Self::Results<'r>>;
    }

    impl<A: 'static> Handles for Handle<A> {
        type Results<'r> = &'r A;

        fn entries(self) -> Vec<(usize, usize)> {
            [(self.scene, self.index)].into()
        }

        fn results<'r>(self, at: &dyn Fn(usize) -> Option<&'r dyn Any>) -> Option<&'r A> {
            at(self.index)?.downcast_ref()
        }
    }

    macro_rules! several {
        ($($name:ident $index:tt),*) => {
            impl<$($name: 'static),*> Handles for ($(Handle<$name>,)*) {
                type Results<'r> = ($(&'r $name,)*);

                fn entries(self) -> Vec<(usize, usize)> {
                    [$((self.$index.scene, self.$index.index)),*].into()
                }

                fn results<'r>(
                    self,
                    at: &dyn Fn(usize) -> Option<&'r dyn Any>,
                ) -> Option<Self::Results<'r>> {
                    Some(($(self.$index.results(at)?,)*))
                }
            }
        };
    }

    several!(A 0, B 1);
    several!(A 0, B 1, C 2);
    several!(A 0, B 1, C 2, D 3);
}

impl<S: sealed::Handles> Handles for S {}
