//! Mistakes of the user: collected through a phase, reported together.

use std::fmt::Display;

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};

pub mod characters;
mod origin;
mod sorted;
mod suggestion;
pub mod text;

pub use origin::SourceSpan;
pub use origin::{OriginId, Origins};
pub use sorted::Section;
use sorted::Sorted;
pub use suggestion::{EditLocation, Message, SourceEdit, Suggestion};

/// The sink of phases without spans, whose messages have the spans of [`OriginId`]s.
#[derive(Debug)]
pub struct Reporter<'a> {
    origins: &'a Origins,
    diagnostics: &'a mut Diagnostics,
    section: Section,
}

impl<'a> Reporter<'a> {
    /// A sink for messages about the mechanism.
    pub fn new(origins: &'a Origins, diagnostics: &'a mut Diagnostics) -> Self {
        Self {
            origins,
            diagnostics,
            section: Section::Mechanism,
        }
    }

    /// Returns the number of messages, for [`rewind`](Self::rewind).
    pub fn mark(&self) -> Mark {
        self.diagnostics.mark()
    }

    /// Removes the messages that were reported after `mark`.
    pub fn rewind(&mut self, mark: Mark) {
        self.diagnostics.rewind(mark);
    }

    /// A sink for messages of a section.
    pub fn within(&mut self, section: Section) -> Reporter<'_> {
        Reporter {
            origins: self.origins,
            diagnostics: self.diagnostics,
            section,
        }
    }

    /// The origins of the mechanism, for a sink of its own.
    pub fn origins(&self) -> &'a Origins {
        self.origins
    }

    /// See [`Diagnostics::error`].
    pub fn error(&mut self, origin: OriginId, message: impl Into<String>) -> &mut Message {
        let message = self.within_part(origin, message.into());
        let span = self.origins.span(origin);
        self.diagnostics.error_in(self.section, span, message)
    }

    /// See [`Diagnostics::error_with_help`].
    pub fn error_with_help(
        &mut self,
        origin: OriginId,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        self.error(origin, format!("{fact}\nhelp: {help}"))
    }

    /// Reports at all tokens from one place to another.
    pub fn error_between(
        &mut self,
        [first, last]: [OriginId; 2],
        message: impl Into<String>,
    ) -> &mut Message {
        let span = self.span_between([first, last]);
        let message = self.within_part(first, message.into());
        self.diagnostics.error_in(self.section, span, message)
    }

    /// A warning, printed if there is no mistake.
    pub fn warning_with_help(
        &mut self,
        origin: OriginId,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        let span = self.origins.span(origin);
        self.diagnostics.warning_in(self.section, span, fact, help)
    }

    /// Returns the span from one origin to another.
    pub fn span_between(&self, [first, last]: [OriginId; 2]) -> SourceSpan {
        self.origins.span(first).to(self.origins.span(last))
    }

    /// Begins a message about a part with the name of the part: the words at fault are those of the
    /// part's own struct.
    fn within_part(&self, origin: OriginId, message: String) -> String {
        match self.origins.part(origin) {
            Some(part) => format!("in the part `{part}`: {message}"),
            None => message,
        }
    }

    /// The same sink for a shorter time.
    pub fn reborrow(&mut self) -> Reporter<'_> {
        self.within(self.section)
    }

    /// Returns the number of mistakes of all phases.
    pub fn errors(&self) -> usize {
        self.diagnostics.len()
    }
}

/// The number of messages at some moment, while all are of the first section.
#[derive(Clone, Copy, Debug)]
pub struct Mark {
    mistakes: usize,
    warnings: usize,
}

/// The sink of all phases.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    mistakes: Sorted,
    warnings: Sorted,
}

impl Diagnostics {
    /// Returns the number of messages, for [`rewind`](Self::rewind).
    pub(crate) fn mark(&self) -> Mark {
        Mark {
            mistakes: self.mistakes.0.len(),
            warnings: self.warnings.0.len(),
        }
    }

    /// Removes the messages that were reported after `mark`.
    pub(crate) fn rewind(&mut self, mark: Mark) {
        self.mistakes.0.truncate(mark.mistakes);
        self.warnings.0.truncate(mark.warnings);
    }

    /// Fact first, lower case, names in back-ticks; a second line `help: ...` says what to write.
    pub fn error(&mut self, span: SourceSpan, message: impl Into<String>) -> &mut Message {
        self.error_in(Section::Mechanism, span, message)
    }

    fn error_in(
        &mut self,
        section: Section,
        span: SourceSpan,
        message: impl Into<String>,
    ) -> &mut Message {
        let message = Message::new(span, &message.into());
        self.mistakes.insert(section, message)
    }

    /// Adds a message as [`error`](Self::error) does, with the second line as a separate argument.
    pub fn error_with_help(
        &mut self,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        self.error(span, format!("{fact}\nhelp: {help}"))
    }

    /// Adds a warning, which is printed if there is no mistake.
    pub fn warning_with_help(
        &mut self,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        self.warning_in(Section::Mechanism, span, fact, help)
    }

    fn warning_in(
        &mut self,
        section: Section,
        span: SourceSpan,
        fact: impl Display,
        help: impl Display,
    ) -> &mut Message {
        let message = Message::new(span, &format!("{fact}\nhelp: {help}"));
        self.warnings.insert(section, message)
    }

    /// Adds the messages of another sink after those of this one.
    pub fn append(&mut self, other: Diagnostics) {
        self.mistakes.append(other.mistakes);
        self.warnings.append(other.warnings);
    }

    /// Moves all warnings to another sink.
    pub fn take_warnings(&mut self) -> Diagnostics {
        Diagnostics {
            mistakes: Sorted::default(),
            warnings: std::mem::take(&mut self.warnings),
        }
    }

    /// True without a mistake.
    pub fn is_empty(&self) -> bool {
        self.mistakes.0.is_empty()
    }

    /// Returns the number of mistakes.
    pub fn len(&self) -> usize {
        self.mistakes.0.len()
    }

    /// Returns the texts of all mistakes, without their places.
    pub fn texts(&self) -> Vec<String> {
        self.mistakes
            .iter()
            .map(|mistake| mistake.text.clone())
            .collect()
    }

    /// Mistakes and warnings, in the order in which they were found.
    pub fn into_messages(self) -> (Vec<Message>, Vec<Message>) {
        (self.mistakes.into_messages(), self.warnings.into_messages())
    }

    /// One `compile_error!` for each message, underlining the words at fault.
    pub fn to_tokens(&self) -> TokenStream {
        self.mistakes.iter().map(compile_error).collect()
    }
}

impl Diagnostics {
    /// Something for each warning that makes rustc print it, unless these attributes allow it.
    pub fn warnings_to_tokens(&self, attributes: &TokenStream) -> TokenStream {
        let warnings = self.warnings.iter();
        warnings
            .flat_map(|message| compile_warning(message, attributes))
            .collect()
    }
}

/// Makes rustc print a warning, which a macro cannot: rustc reports uses of deprecated items with
/// their reason, at the place of the use.
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
