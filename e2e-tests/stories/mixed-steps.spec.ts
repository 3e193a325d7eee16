/// Short walks of mixed steps in blocks and text that have passed before; `./rosy test nightly` takes longer ones as well. `../walks` takes longer ones and new ones.

import {isNightly} from "../../codegen/test/extent.ts"
import {openReaders} from "../walks/seen_program.ts"
import {openWalk, walk} from "../walks/walk.ts"
import {test} from "./story.ts"

const short = [201, 202, 203]
// With 300 lines pasted on the way.
const long = [205, 206]
const seeds = isNightly ? [...short, ...long] : short
const length = 15

for (const one of seeds) {
  test(`blocks and text agree after each of ${length} random steps, and nothing is lost (seed ${one})`, async ({
    page,
  }) => {
    await walk(openWalk(page, await openReaders()), one, length)
  })
}
