/// Short walks of mixed steps in blocks and text that have passed before: another one each day, `./rosy test nightly` all of them. `../walks` takes longer ones and new ones.

import {openReaders} from "../walks/seen_program.ts"
import {openWalk, walk} from "../walks/walk.ts"
import {isFull, seed} from "./extent.ts"
import {test as daily} from "./story.ts"
import {inTurn} from "./turns.ts"

const test = inTurn(daily, import.meta.url)

const short = [201, 202, 203]
// With 300 lines pasted on the way.
const long = [205, 206]
const seeds = isFull ? [...short, ...long] : [short[seed % short.length]!]
const length = 15

for (const one of seeds) {
  test(`blocks and text agree after each of ${length} random steps, and nothing is lost (seed ${one})`, async ({
    page,
  }) => {
    await walk(openWalk(page, await openReaders()), one, length)
  })
}
