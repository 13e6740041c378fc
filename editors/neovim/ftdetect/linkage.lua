-- Text files of linkage.
vim.filetype.add({ extension = { mech = "linkage" } })
