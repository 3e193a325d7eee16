/// Walks of mixed steps, several pages at a time. `WALKS=200 STEPS=50 SEED=1 npx playwright test -c e2e-tests/walks` takes so many, from that seed on.

import {writeFileSync} from "node:fs"
import {test} from "../stories/story.ts"
import {openReaders} from "./seen_program.ts"
import {openWalk, walk} from "./walk.ts"

const first = Number(process.env["SEED"] ?? process.env["ROSY_TEST_SEED"] ?? 1)
const walks = Number(process.env["WALKS"] ?? 4)
const length = Number(process.env["STEPS"] ?? 50)

for (let seed = first; seed < first + walks; seed++) {
  test(`a walk of ${length} mixed steps (seed ${seed})`, async ({page}, info) => {
    try {
      const counts = await walk(openWalk(page, await openReaders()), seed, length)
      console.log(`seed ${seed}:`, JSON.stringify(counts))
    } catch (error) {
      // The projects before and after the last step, for a unit test.
      writeFileSync(info.outputPath("walk.json"), JSON.stringify(error, null, 1))
      throw error
    }
  })
}
