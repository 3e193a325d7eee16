/// Turns of the test files that need a browser: each is run on one day in seven (`codegen/test/turns.ts`), a file that is not listed
/// each day. Stories build a small program each day (`e2e-tests/stories/first-hour.spec.ts`).

import type {Turns} from "../../codegen/test/turns.ts"

/// The names are without `.web.test.ts`.
export const turns: Turns = {
  days: [
    ["blocks/interaction"],
    ["blocks/building"],
    ["blocks/bin", "blocks/scroll_bars"],
    ["blocks/ready_made_blocks"],
    ["blocks/reference_drop", "blocks/refusals"],
    ["blocks/screen_reader", "blocks/touch"],
    ["blocks/view", "source/cursor"],
  ],
  tested: [
    "codegen/src/blocks/",
    "editor/src/blocks/",
    "editor/src/source/",
    "editor/test/blocks/",
    "editor/test/source/",
  ],
}
