/// The cases of `protocol/goldens/messages.jsonl`, which `scripts/wire_cases.py` makes from the service's types.

import {readFileSync} from "node:fs"

export interface MessageCase {
  /// The union of messages that it belongs to.
  readonly type: string
  readonly message: unknown
  /// What the page reads; absent for what is no message.
  readonly value?: unknown
}

export const messageCases: readonly MessageCase[] = readFileSync(
  new URL("../../../protocol/goldens/messages.jsonl", import.meta.url),
  "utf8",
)
  .trim()
  .split("\n")
  .map(line => JSON.parse(line) as MessageCase)
