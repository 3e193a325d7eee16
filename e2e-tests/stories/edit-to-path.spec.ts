/// A number or an operator is changed by one key after a run, in five programs, and the path follows. Prints how long after the key it stands in the room; a
/// page of this file draws as often as the screen shows pictures, as for people, and not as seldom as those of the other stories.

import {test} from "@playwright/test"
import {measureEdits} from "./edit_to_path.ts"

test("after one key the path follows, in each of five programs", async ({page}) => {
  await measureEdits(page, 5)
})
