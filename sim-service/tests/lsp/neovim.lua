-- A session in Neovim's own client: opens the file named on the command line, and writes what a user sees as JSON to ROSY_OUT.

local buffer = vim.api.nvim_get_current_buf()
local uri = vim.uri_from_bufnr(buffer)
local out = {}

local function wait(what, condition)
  assert(vim.wait(240000, condition, 20), what)
end

local command = vim.fn.json_decode(vim.env.ROSY_COMMAND)
local client_id = vim.lsp.start_client({name = "rosy", cmd = command, root_dir = vim.fn.getcwd()})
vim.lsp.buf_attach_client(0, client_id)
local client = vim.lsp.get_client_by_id(client_id)
wait("the client is initialized", function() return client.initialized end)

wait("a diagnostic is shown", function() return #vim.diagnostic.get(0) == 1 end)
local found = vim.diagnostic.get(0)[1]
out.diagnostic = {line = found.lnum, column = found.col, end_column = found.end_col, message = found.message, code = found.code}

local function request(method, params)
  local answer = assert(client.request_sync(method, params, 240000, buffer))
  assert(answer.err == nil, vim.inspect(answer.err))
  return answer.result
end

local actions = request("textDocument/codeAction", {
  textDocument = {uri = uri},
  range = {start = {line = found.lnum, character = 0}, ["end"] = {line = found.lnum, character = 99}},
  context = {diagnostics = {}},
})
vim.lsp.util.apply_workspace_edit(actions[1].edit, client.offset_encoding)
wait("the diagnostic is gone", function() return #vim.diagnostic.get(0) == 0 end)

local renamed = request("textDocument/rename", {textDocument = {uri = uri}, position = {line = 1, character = 0}, newName = "ahead"})
vim.lsp.util.apply_workspace_edit(renamed, client.offset_encoding)
out.text = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, false), "\n")

local lens = request("textDocument/codeLens", {textDocument = {uri = uri}})[1]
out.lens = lens.command.title
local report = request("workspace/executeCommand", {command = lens.command.command, arguments = lens.command.arguments})
out.ended, out.problems = report.ended, report.problems

vim.fn.writefile({vim.fn.json_encode(out)}, vim.env.ROSY_OUT)
vim.cmd("qall!")
