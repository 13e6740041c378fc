//! Operators of the adapters: each works on the number in the newtype.

/// Implements the operators and their assigning forms for a newtype `$name<$inner>`.
macro_rules! operators {
    ($name:ident, $($bound:tt)*) => {
        operators!(@each $name, [$($bound)*],
            Add add AddAssign add_assign,
            Sub sub SubAssign sub_assign,
            Mul mul MulAssign mul_assign,
            Div div DivAssign div_assign);

        impl<V: $($bound)*> core::ops::Neg for $name<V> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
    };
    (@each $name:ident, $bound:tt, $($op:ident $method:ident $assign:ident $assign_method:ident),*) => {
        $(operators!(@one $name, $bound, $op $method $assign $assign_method);)*
    };
    (@one $name:ident, [$($bound:tt)*],
     $op:ident $method:ident $assign:ident $assign_method:ident) => {
        impl<V: $($bound)*> core::ops::$op for $name<V> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(core::ops::$op::$method(self.0, other.0))
            }
        }

        impl<V: $($bound)*> core::ops::$assign for $name<V> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = core::ops::$op::$method(*self, other);
            }
        }
    };
}

pub(super) use operators;
