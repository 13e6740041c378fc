//! The sweeps of a function over mechanisms: the prepared values of each mechanism that the
//! function uses.

use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;
use proc_macro2::TokenStream;

use super::array_types::Types;
use super::load::Places;
use super::outline::{Function, Outline};
use super::slots::Slots;
use super::stages::Version;
use super::{attribute, code, stages};

/// The runtime's `SetStages` for the stages of a function that refines; nothing for a function without
/// inputs. `prepare` computes all prepared slots.
pub(super) fn items(
    outline: &Outline,
    function: &Function,
    stages: &[Stage],
    prepare: &Program,
) -> TokenStream {
    if function.arguments.is_empty() || outline.parameters.is_empty() {
        return TokenStream::new();
    }
    let everywhere = attribute::everywhere(function.attributes);
    let name = code::text(outline.name);
    let marker = code::text(&stages::name(function, Version::refining(function)));
    let slots = Slots::for_stages(stages, prepare);
    let modes = Types::new(outline).modes;
    let prepare = slots.prepare(outline).map(|prepare| {
        format!(
            "#[inline(always)]
            fn prepare<const __FUSED: __p::bool>(
                __m: &{name}<T>,
                __modes: &{modes},
                __turns: &__p::RevolutionsOf<{name}<T>>,
                __slots: &mut impl __p::RowNumbersMut<T>,
            ) {{ {prepare} }}"
        )
    });
    let prepare = prepare.unwrap_or_default();
    let used = slots.numbers();
    let (count, all) = (used.len(), outline.prepared);
    let dimensions = outline.scalar_fields().len();
    let inputs = dimensions + function.arguments.len();
    let arguments = dimensions + Places::of_function(outline, function).width();
    code::tokens(&format!(
        "__p::if_alloc! {{
            {everywhere} impl<T: __p::Scalar>
                __p::SetStages<{name}<T>, {dimensions}, {inputs}, {arguments}> for {marker}
            {{
                type Prepared<const __BLOCK: __p::usize> = __p::Block<T, __BLOCK, {count}>;
                const COLUMNS: &'static [__p::usize] = &__p::columns_of::<{all}>(&{used:?});
                {prepare}
            }}
        }}"
    ))
}
