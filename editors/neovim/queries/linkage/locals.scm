(source_file) @local.scope
(function) @local.scope

(const_item name: (identifier) @local.definition.constant)
(param_item name: (identifier) @local.definition.parameter)
(argument_item name: (identifier) @local.definition.parameter)
(input_item name: (identifier) @local.definition.parameter)
(rates (identifier) @local.definition.parameter)
(unknown_item name: (identifier) @local.definition.var)
(let_item name: (identifier) @local.definition.var)
(part_item name: (identifier) @local.definition.var)
(arc_item name: (identifier) @local.definition.var)
(body_item name: (identifier) @local.definition.var)
(body_item joint: (identifier) @local.definition.var)
(pair_item name: (identifier) @local.definition.var)
(drawn_joint name: (identifier) @local.definition.var)
(link_item name: (identifier) @local.definition.var)
(slider_item name: (identifier) @local.definition.var)
(struct_block name: (type_identifier) @local.definition.type)

(identifier) @local.reference
(type_identifier) @local.reference
