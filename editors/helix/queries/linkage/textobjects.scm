(struct_block body: (item_list) @class.inside) @class.around
(impl_block body: (function_list) @class.inside) @class.around
(function body: (quantity_list) @function.inside) @function.around
(inputs (identifier) @parameter.inside @parameter.around)
(drawn_joint) @entry.around
(quantity) @entry.around
[(line_comment) (doc_comment) (block_comment)] @comment.inside
(line_comment)+ @comment.around
(doc_comment)+ @comment.around
