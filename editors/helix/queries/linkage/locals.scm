(source_file) @local.scope

(const_item name: (identifier) @local.definition.constant)
(param_item name: (identifier) @local.definition.variable.parameter)
(argument_item name: (identifier) @local.definition.variable.parameter)
(input_item name: (identifier) @local.definition.variable.parameter)
(rates (identifier) @local.definition.variable.parameter)

(identifier) @local.reference
