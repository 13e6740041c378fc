-- Opens a text with a mistake, prints the messages and the hover of a name, and mends the text. The folder of the text is in FOLDER, the
-- command in LINKAGE.
local timeout = 60000

local function try()
  vim.opt.runtimepath:append(vim.env.EDITORS .. "/neovim")
  -- Before version 0.8 the table of file types that Lua fills is not read without this.
  vim.g.do_filetype_lua = 1
  vim.cmd("filetype on")
  vim.cmd("edit " .. vim.env.FOLDER .. "/broken.mech")
  print("type: " .. vim.bo.filetype)
  local client = vim.lsp.start_client({ cmd = { vim.env.LINKAGE, "lsp" }, root_dir = vim.env.FOLDER })
  vim.lsp.buf_attach_client(0, client)
  local function count()
    return #vim.diagnostic.get(0)
  end
  vim.wait(timeout, function() return count() > 0 end, 10)
  for _, found in ipairs(vim.diagnostic.get(0)) do
    print(("message: %d:%d %s"):format(found.lnum + 1, found.col + 1, found.message))
  end
  local lines = vim.api.nvim_buf_get_lines(0, 0, -1, false)
  for number, line in ipairs(lines) do
    if line:find("polar(rodx", 1, true) then
      vim.api.nvim_buf_set_lines(0, number - 1, number, false, { (line:gsub("rodx", "rod")) })
    end
    if line:find("let pin", 1, true) then
      local params = {
        textDocument = { uri = vim.uri_from_bufnr(0) },
        position = { line = number - 1, character = line:find("pin", 1, true) },
      }
      local answers = vim.lsp.buf_request_sync(0, "textDocument/hover", params, timeout)
      for _, answer in pairs(answers) do
        print("hover: " .. answer.result.contents.value:gsub("\n.*", ""))
      end
    end
  end
  vim.wait(timeout, function() return count() == 0 end, 10)
  print("left: " .. count())
end

local sound, fault = pcall(try)
if not sound then print("fault: " .. fault) end
vim.cmd("qa!")
