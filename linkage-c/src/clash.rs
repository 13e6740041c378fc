//! Mechanisms whose names are one in C.

use std::collections::BTreeMap;

use crate::error::Refused;

/// Fails if two of these mechanisms give the same name to something.
pub(crate) fn check<'a>(
    mechanisms: impl Iterator<Item = (&'a str, Vec<String>)>,
) -> Result<(), Refused> {
    let mut owners: BTreeMap<String, &str> = BTreeMap::new();
    for (title, names) in mechanisms {
        for name in &names {
            if let Some(other) = owners.get(name) {
                return Err(Refused {
                    message: format!(
                        "`{other}` and `{title}` would both have the name `{name}` in C. Call one of them otherwise, or write them one by one, \
                         into two folders, for programs that use one of them"
                    ),
                });
            }
        }
        owners.extend(names.into_iter().map(|name| (name, title)));
    }
    Ok(())
}
