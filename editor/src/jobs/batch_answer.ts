/// Texts in the answers of a batch of headless runs (a test in many rooms, a rehearsal of a lesson), in the language of the page.

import type {Failed} from "../wire/page/jobs.generated.ts"
import type {Problem} from "../wire/problem.generated.ts"
import {worded} from "../words/worker_sentences.ts"

/// What is wrong with a program of the batch.
export const batchProblem = ({sentences, message}: Problem): string =>
  worded(sentences?.message ?? null, message)

/// Why the batch could not be done.
export const batchFailure = ({sentence, message}: Failed): string => worded(sentence, message)
