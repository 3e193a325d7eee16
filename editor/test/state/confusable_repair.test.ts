/// The offered repair of pasted characters: in the text as it is by then.

import {confusablesIn} from "@rosy/codegen"
import {expect, test} from "vitest"
import {applyChanges} from "../../src/program/text_changes.ts"
import {confusableRepair} from "../../src/state/confusable_repair.ts"

const pasted = "f = 2 − 1 × “a”\n"
const [first, ...others] = confusablesIn(pasted, {start: 0, end: pasted.length})

test.each([
  ["as it was pasted", pasted, 'f = 2 - 1 * "a"\n'],
  ["with more in front of it", `-- − is −\n${pasted}`, '-- − is −\nf = 2 - 1 * "a"\n'],
  ["with more in the middle", "f = 2 + 3 − 1 + 7 × “a b”\n", 'f = 2 + 3 - 1 + 7 * "a b"\n'],
  ["with one repaired by hand", "f = 2 - 1 × “a”\n", 'f = 2 - 1 * "a"\n'],
  ["with a part taken out", "f = 2 “a”\n", 'f = 2 "a"\n'],
  ["taken out", "", ""],
  ["in place of which there is another program", "g = h\n", "g = h\n"],
])("%s", (_, now, repaired) => {
  if (first === undefined) throw new Error("nothing is found")
  expect(applyChanges(now, confusableRepair({text: pasted, found: [first, ...others]}, now))).toBe(repaired)
})
