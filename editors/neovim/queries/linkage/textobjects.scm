(struct_block body: (item_list) @class.inner) @class.outer
(impl_block body: (function_list) @class.inner) @class.outer
(function body: (quantity_list) @function.inner) @function.outer
(call) @call.outer
(inputs (identifier) @parameter.inner @parameter.outer)
[(line_comment) (doc_comment) (block_comment)] @comment.outer
