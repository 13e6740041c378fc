-- The language server, for `vim.lsp.enable("linkage")`.
return {
  cmd = { "linkage", "lsp" },
  filetypes = { "linkage" },
  root_markers = { ".git" },
}
