//! Lengths of links that are negative.

use crate::algebra::Nominal;
use crate::diagnostic::Reporter;
use crate::message_format::MessageFormat;
use crate::model::Mechanism;

/// Warns of negative defaults of parameters that are lengths of links. Parameters of a part are
/// checked in the part.
pub(crate) fn warn_of_negative_lengths(
    mechanism: &Mechanism,
    nominal: &Nominal,
    reporter: &mut Reporter,
) {
    for index in mechanism.link_lengths() {
        let parameter = &mechanism.parameters[index];
        let value = nominal.parameters[parameter.first_scalar.0];
        if value < 0.0 && !parameter.name.contains('.') {
            let name = &parameter.name;
            let value = MessageFormat::new(mechanism).value(&parameter.ty, &[value]);
            let fact = format!("`{name} = {value}` is negative, but it is the length of a link");
            let help = "write a positive length; a link in the opposite direction has an angle that is larger by 180deg";
            reporter.warning_with_help(parameter.nominal.origin, fact, help);
        }
    }
}
