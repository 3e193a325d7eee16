/// Offers the repair of characters that look right and are not, as they come with text from elsewhere.

import {confusablesIn} from "@rosy/codegen"
import type {Store} from "../../browser/store.ts"

/// `name` is what came: a file, or the pasted text; `parts` are its places in the text.
export function offerRepair(
  store: Store,
  name: string,
  text: string,
  parts: readonly {readonly start: number; readonly end: number}[],
): void {
  const [first, ...others] = parts.flatMap(part => confusablesIn(text, part))
  if (first !== undefined)
    store.dispatch({kind: "notice", notice: {kind: "confusable", name, text, found: [first, ...others]}})
}
