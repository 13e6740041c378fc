//! Messages about names of links: the link alone, and quantities that it does not have.

use proc_macro2::Ident;

use crate::diagnostic::text::{list, nearest};
use crate::model::symbols::member_names::LinkNames;
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;

/// Reports a link or slider that is used as a value. Returns false if the name is none.
pub(in crate::model) fn refuse_lonely_link(
    parts: &Parts,
    links: &LinkNames,
    sink: &mut Sink,
    ident: &Ident,
) -> bool {
    let text = ident.to_string();
    if links.present && text == "frame" {
        let fact = "`frame` is the fixed link, which has no position and no angle";
        sink.error_with_help(ident.into(), fact, "name a joint of it, or another link");
        return true;
    }
    let quantities = parts.quantities_of(&text);
    if quantities.is_empty() {
        return false;
    }
    if links.lost {
        return true;
    }
    let kind = kind(&text, &quantities);
    let fact = format!("the {kind} `{text}` alone has no value");
    let help = format!("its quantities are {}", list(&quantities));
    let message = sink.error_with_help(ident.into(), fact, help);
    for quantity in quantities {
        message.suggest(format!("write `{quantity}`"), ident.into(), quantity);
    }
    true
}

/// Reports a misspelt link or slider in front of a quantity that it has: `roker.angle`. Returns
/// false if no name is near.
pub(in crate::model) fn refuse_misspelt_link(
    parts: &Parts,
    links: &LinkNames,
    sink: &mut Sink,
    link: &Ident,
    member: &Ident,
) -> bool {
    if links.lost {
        return false;
    }
    let ending = format!(".{member}");
    let names = parts.quantities.iter();
    let names = names.filter_map(|name| name.strip_suffix(&ending));
    let Some(meant) = nearest(&link.to_string(), names) else {
        return false;
    };
    let fact = format!("unknown name `{link}`");
    let help = format!("did you mean `{meant}.{member}`?");
    let message = sink.error_with_help(link.into(), fact, help);
    message.suggest(format!("write `{meant}`"), link.into(), meant);
    true
}

/// Reports a quantity that a link does not have. Returns false if the name is no link.
pub(in crate::model) fn refuse_unknown_quantity(
    parts: &Parts,
    links: &LinkNames,
    sink: &mut Sink,
    link: &Ident,
    member: &Ident,
) -> bool {
    let text = link.to_string();
    let quantities = parts.quantities_of(&text);
    if quantities.is_empty() {
        return false;
    }
    if links.lost {
        return true;
    }
    let before = format!("{text}.");
    let words = quantities
        .iter()
        .filter_map(|name| name.strip_prefix(&before));
    let kind = kind(&text, &quantities);
    let fact = format!("the {kind} `{text}` has no `{member}`");
    let meant = match distance_of_ends(links, &text, member) {
        Some([first, second]) => {
            let quantity = format!("{text}.length");
            let help = format!("the distance from `{first}` to `{second}` is `{quantity}`");
            Some((quantity, help))
        }
        None => nearest(&member.to_string(), words).map(|word| {
            let quantity = format!("{text}.{word}");
            let help = format!("did you mean `{quantity}`?");
            (quantity, help)
        }),
    };
    match meant {
        Some((quantity, help)) => {
            let message = sink.error_with_help(member.into(), fact, help);
            let span = crate::diagnostic::SourceSpan::from(link).to(member.into());
            message.suggest(format!("write `{quantity}`"), span, quantity);
        }
        None => {
            let help = format!("it has {}", list(&quantities));
            sink.error_with_help(member.into(), fact, help);
        }
    }
    true
}

/// Returns the ends of a link if a word consists of their names: `bc` or `b_c`.
fn distance_of_ends<'n>(links: &'n LinkNames, link: &str, word: &Ident) -> Option<[&'n str; 2]> {
    let [first, second, ..] = &links.members.get(link)?[..] else {
        return None;
    };
    let word = word.to_string().replace('_', "");
    let [one, other] = [first, second].map(|end| end.replace('_', ""));
    let is_meant = word == format!("{one}{other}") || word == format!("{other}{one}");
    is_meant.then_some([first, second])
}

/// Returns the kind of an item by its quantities.
fn kind(name: &str, quantities: &[&str]) -> &'static str {
    let has = |word: &str| quantities.contains(&format!("{name}.{word}").as_str());
    match has("radius") || has("start") {
        true => "slider",
        false => "link",
    }
}
