/// Language of the command line: that of the machine's locale, as `sim-service/rosy_sim/sentences/wording.py` reads it.

import {speak, type Words} from "./words/index.ts"

type Environment = Readonly<Record<string, string | undefined>>

/// Tables of the languages besides English, by the path of their file.
const tables = import.meta.glob<Words>(["../../languages/*/blocks/index.ts", "!../../languages/en/**"], {
  import: "table",
  eager: true,
})

/// The first variable that is set and not empty names the language. POSIX.1-2017, Base Definitions, section 8.2.
const variables = ["ROSY_LOCALE", "LC_ALL", "LC_MESSAGES", "LANG"]

export function terminalLanguage(environment: Environment): string {
  const named = variables.map(name => environment[name]).find(value => value) ?? ""
  return named.split(/[.@_-]/)[0]?.toLowerCase() ?? ""
}

/// Chooses the words of the machine's locale; English where there is no table.
export function speakAsTerminal(environment: Environment): void {
  const table = tables[`../../languages/${terminalLanguage(environment)}/blocks/index.ts`]
  if (table !== undefined) speak(table)
}
