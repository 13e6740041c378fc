//! Mistakes of the user: collected through a phase, reported together.

use std::fmt::Display;

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

mod origin;
pub(crate) mod text;

pub use origin::SourceSpan;
pub(crate) use origin::{OriginId, Origins};

/// What is wrong, and where.
#[derive(Clone, Debug)]
pub struct Message {
    /// The words at fault.
    pub span: SourceSpan,
    /// The fact, in lower case, names in back-ticks; where something can be said about it, a second line `help: ...` with what to write.
    pub text: String,
}

/// Where phases without spans report: messages at the places that [`OriginId`]s lead back to.
#[derive(Debug)]
pub(crate) struct Reporter<'a> {
    pub(crate) origins: &'a Origins,
    pub(crate) diagnostics: &'a mut Diagnostics,
}

impl Reporter<'_> {
    /// See [`Diagnostics::error`].
    pub(crate) fn error(&mut self, origin: OriginId, message: impl Into<String>) {
        let message = self.within_part(origin, message.into());
        self.diagnostics.error(self.origins.span(origin), message);
    }

    /// See [`Diagnostics::error_with_help`].
    pub(crate) fn error_with_help(
        &mut self,
        origin: OriginId,
        fact: impl Display,
        help: impl Display,
    ) {
        self.error(origin, format!("{fact}\nhelp: {help}"));
    }

    /// At all that stands from one place to another.
    pub(crate) fn error_between(
        &mut self,
        [first, last]: [OriginId; 2],
        message: impl Into<String>,
    ) {
        let span = self.origins.span(first).to(self.origins.span(last));
        let message = self.within_part(first, message.into());
        self.diagnostics.error(span, message);
    }

    /// See [`Diagnostics::warning_with_help`].
    pub(crate) fn warning_with_help(
        &mut self,
        origin: OriginId,
        fact: impl Display,
        help: impl Display,
    ) {
        let span = self.origins.span(origin);
        self.diagnostics.warning_with_help(span, fact, help);
    }

    /// What is said about a place in a part begins with the part: the words at fault are those of its own struct.
    fn within_part(&self, origin: OriginId, message: String) -> String {
        match self.origins.part(origin) {
            Some(part) => format!("in the part `{part}`: {message}"),
            None => message,
        }
    }

    /// For somebody who keeps it.
    pub(crate) fn reborrow(&mut self) -> Reporter<'_> {
        Reporter {
            origins: self.origins,
            diagnostics: self.diagnostics,
        }
    }

    /// How many messages there are by now, of all phases.
    pub(crate) fn errors(&self) -> usize {
        self.diagnostics.len()
    }
}

/// The sink that every phase writes to.
#[derive(Debug, Default)]
pub(crate) struct Diagnostics {
    list: Vec<Message>,
    warnings: Vec<Message>,
}

impl Diagnostics {
    /// Fact first, lower case, names in back-ticks; a second line `help: ...` says what to write.
    pub(crate) fn error(&mut self, span: SourceSpan, message: impl Into<String>) {
        let text = text::short_words(&message.into());
        self.list.push(Message { span, text });
    }

    /// As [`error`](Self::error), with the second line given apart.
    pub(crate) fn error_with_help(
        &mut self,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) {
        self.error(span, format!("{fact}\nhelp: {help}"));
    }

    /// What is no mistake, but hardly meant: told if there is no mistake.
    pub(crate) fn warning_with_help(
        &mut self,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) {
        let text = text::short_words(&format!("{fact}\nhelp: {help}"));
        self.warnings.push(Message { span, text });
    }

    /// Adds the messages of another sink behind those of this one.
    pub(crate) fn append(&mut self, other: Diagnostics) {
        self.list.extend(other.list);
        self.warnings.extend(other.warnings);
    }

    /// True without a mistake.
    pub(crate) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// How many mistakes there are.
    pub(crate) fn len(&self) -> usize {
        self.list.len()
    }

    /// What is wrong, without the places.
    pub(crate) fn texts(&self) -> Vec<String> {
        self.list.iter().map(|own| own.text.clone()).collect()
    }

    /// Mistakes and warnings, in the order in which they were found.
    pub(crate) fn into_messages(self) -> (Vec<Message>, Vec<Message>) {
        (self.list, self.warnings)
    }

    /// One `compile_error!` for each message, underlining the words at fault.
    pub(crate) fn to_tokens(&self) -> TokenStream {
        self.list.iter().map(compile_error).collect()
    }
}

impl Diagnostics {
    /// Something for each warning that makes rustc print it, unless these attributes allow it.
    pub(crate) fn warnings_to_tokens(&self, attributes: &TokenStream) -> TokenStream {
        let warnings = self.warnings.iter();
        warnings
            .flat_map(|message| compile_warning(message, attributes))
            .collect()
    }
}

/// A macro cannot warn. But rustc tells of uses of what is deprecated with the reason given, and at the place of the use.
fn compile_warning(message: &Message, attributes: &TokenStream) -> TokenStream {
    let used = Ident::new("__mechanism", message.span.first);
    let text = &message.text;
    quote! {
        #attributes
        const _: () = {
            #[deprecated(note = #text)]
            #[allow(non_upper_case_globals)]
            const __mechanism: () = ();
            #used
        };
    }
}

fn compile_error(message: &Message) -> TokenStream {
    let SourceSpan { first, last } = message.span;
    let message = &message.text;
    let path = [
        Ident::new("core", first),
        Ident::new("compile_error", first),
    ];
    let [core, macro_name] = path;
    let head = quote_spanned!(first=> ::#core::#macro_name!);
    let tail = quote_spanned!(last=> { #message });
    quote!(#head #tail)
}
