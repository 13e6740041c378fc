//! Generated items as a module to be read, or to be checked in.

use linkage_engine::Source;
use linkage_js::description;
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Attribute, Expr, File, ImplItem, Item, ItemImpl, ItemMacro, Path, Stmt, parse_quote};

use crate::failure::Failure;

/// The module with the mechanisms of a text, with the items of these features: `if_alloc` and the
/// like, by the names of their macros.
pub(super) fn printed(source: &Source, features: &[&str]) -> Result<String, Failure> {
    let mut items = TokenStream::new();
    for call in source.calls() {
        let tokens = &call.tokens;
        items.extend(linkage_rust::compile(
            quote!([::linkage] #tokens),
            description,
        ));
    }
    let file: File = syn::parse2(items).map_err(|error| {
        Failure::Told(format!(
            "generated code is no module ({error}): this is a mistake of linkage"
        ))
    })?;
    let module = Module {
        features,
        silence: None,
    };
    Ok(module.text(file))
}

/// A module with the items of some features.
struct Module<'a> {
    features: &'a [&'a str],
    /// The attribute that silences lints in each generated item.
    silence: Option<Attribute>,
}

impl Module<'_> {
    fn text(mut self, mut file: File) -> String {
        file.items = self.items(file.items);
        if let Some(mut silence) = self.silence.take() {
            silence.style = syn::AttrStyle::Inner(Default::default());
            file.attrs.push(silence);
        }
        prettyplease::unparse(&file)
    }

    /// Returns the items of the features, without the attributes that silence lints, at every
    /// depth.
    fn items(&mut self, items: Vec<Item>) -> Vec<Item> {
        items.into_iter().flat_map(|item| self.item(item)).collect()
    }

    fn item(&mut self, item: Item) -> Vec<Item> {
        match item {
            Item::Macro(item) if item.ident.is_none() => {
                match (self.has(&item.mac.path), item.mac.parse_body::<File>()) {
                    (false, _) => Vec::new(),
                    (true, Ok(body)) => self.items(body.items),
                    (true, Err(_)) => vec![Item::Macro(item)],
                }
            }
            Item::Impl(mut item) => {
                self.quieten(&mut item.attrs);
                let members = std::mem::take(&mut item.items);
                let members = members.into_iter().flat_map(|member| self.member(member));
                item.items = members.collect();
                vec![Item::Impl(item)]
            }
            Item::Mod(mut item) => {
                self.quieten(&mut item.attrs);
                if let Some((_, items)) = &mut item.content {
                    *items = self.items(std::mem::take(items));
                }
                vec![Item::Mod(item)]
            }
            Item::Const(mut item) => {
                self.quieten(&mut item.attrs);
                if let Expr::Block(body) = &mut *item.expr {
                    let statements = std::mem::take(&mut body.block.stmts);
                    let statements = statements.into_iter().flat_map(|one| self.statement(one));
                    body.block.stmts = statements.collect();
                }
                vec![Item::Const(item)]
            }
            Item::Struct(mut item) => {
                self.quieten(&mut item.attrs);
                vec![Item::Struct(item)]
            }
            Item::Type(mut item) => {
                self.quieten(&mut item.attrs);
                vec![Item::Type(item)]
            }
            Item::Use(mut item) => {
                self.quieten(&mut item.attrs);
                vec![Item::Use(item)]
            }
            other => vec![other],
        }
    }

    /// Treats a statement of the block around generated code as the item that it is.
    fn statement(&mut self, statement: Stmt) -> Vec<Stmt> {
        let item = match statement {
            Stmt::Item(item) => item,
            Stmt::Macro(call) => Item::Macro(ItemMacro {
                attrs: call.attrs,
                ident: None,
                mac: call.mac,
                semi_token: call.semi_token,
            }),
            other => return vec![other],
        };
        self.item(item).into_iter().map(Stmt::Item).collect()
    }

    fn member(&mut self, member: ImplItem) -> Vec<ImplItem> {
        let ImplItem::Macro(member) = member else {
            return vec![member];
        };
        if !self.has(&member.mac.path) {
            return Vec::new();
        }
        if !name(&member.mac.path).starts_with("if_") {
            return vec![ImplItem::Macro(member)];
        }
        let members = &member.mac.tokens;
        let block: ItemImpl = parse_quote!(impl Members { #members });
        let members = block.items.into_iter();
        members.flat_map(|member| self.member(member)).collect()
    }

    /// Returns true if the items in this macro are wanted; those of other macros always.
    fn has(&self, path: &Path) -> bool {
        let name = name(path);
        let feature = match name.as_str() {
            "columns" | "sweeps" | "set_sweeps" => "if_alloc",
            name => name,
        };
        !feature.starts_with("if_") || self.features.contains(&feature)
    }

    /// Takes the attribute that silences lints from an item: the module has it once.
    fn quieten(&mut self, attributes: &mut Vec<Attribute>) {
        let is_silence = |attribute: &Attribute| {
            attribute.path().is_ident("allow")
                && attribute.to_token_stream().to_string().contains("pedantic")
        };
        if let Some(index) = attributes.iter().position(is_silence) {
            self.silence = Some(attributes.remove(index));
        }
    }
}

/// The name of a macro.
fn name(path: &Path) -> String {
    let last = path.segments.last();
    last.map_or_else(String::new, |segment| segment.ident.to_string())
}
