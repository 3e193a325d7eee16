/// Extension of Visual Studio Code: starts `rosy lsp` for Haskell files and shows what it says. All rules are the server's.

import {type ExtensionContext, workspace} from "vscode"
import {LanguageClient} from "vscode-languageclient/node"
import {clientOptions, serverOptions} from "./options.ts"

let client: LanguageClient | undefined

export async function activate(context: ExtensionContext): Promise<void> {
  const settings = workspace.getConfiguration("rosy")
  client = new LanguageClient(
    "rosy",
    "Rosy",
    serverOptions(settings.get("command", "rosy")),
    clientOptions(settings.get("world", "room"), settings.get("seconds", 60)),
  )
  context.subscriptions.push(
    workspace.onDidChangeConfiguration(async event => {
      if (!event.affectsConfiguration("rosy")) return
      await deactivate()
      await activate(context)
    }),
  )
  await client.start()
}

export async function deactivate(): Promise<void> {
  const running = client
  client = undefined
  await running?.stop()
}
