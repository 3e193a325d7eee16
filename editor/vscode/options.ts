/// How the language server is started, and which files it serves. Pure.

import type {LanguageClientOptions} from "vscode-languageclient"
import type {Executable} from "vscode-languageclient/node"

export function serverOptions(command: string): Executable {
  return {command, args: ["lsp"]}
}

/// The options are `initializationOptions` of `sim-service/rosy_sim/lsp`: a room, and simulated seconds.
export function clientOptions(world: string, seconds: number): LanguageClientOptions {
  return {
    documentSelector: [
      {scheme: "file", language: "haskell"},
      {scheme: "untitled", language: "haskell"},
    ],
    initializationOptions: {world, seconds},
  }
}
