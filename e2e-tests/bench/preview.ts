/// How long after a key the path of the edited program stands in the room, in five programs, in a real browser on the real service. The service's part of it is
/// in `rosy_sim.bench`. Nothing is asserted: machines differ.

import {measureEdits} from "../stories/edit_to_path.ts"
import {openPage, setting, withPage} from "./service.ts"

await withPage(async (browser, address) => {
  await measureEdits(await openPage(browser), setting("ROSY_BENCH_RUNS", 5), address.replace(/\/$/, ""))
})
