/// Turn of the event loop after each test, in which the test runner's answers are read.
///
/// A file of hundreds of tests that compute without a pause may take longer than a minute on a busy machine. The runner takes its own progress messages for lost
/// when their answers have not been read by then, and fails although every test has passed.

import {setImmediate} from "node:timers/promises"
import {afterEach} from "vitest"

afterEach(async () => {
  await setImmediate()
})
