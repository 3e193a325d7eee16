/// Catalogue of reasons why a piece of Haskell is a raw block. Every raw node names one of them.

import {en} from "../../../languages/en/blocks/index.ts"

/// As they are kept with a raw block, in English; what a learner reads is in their language.
export const {reasons} = en

export type Cause = keyof typeof reasons

const causes = new Map<string, Cause>(Object.entries(reasons).map(([cause, text]) => [text, cause as Cause]))

/// The cause behind a reason's words.
export function causeOf(reason: string | undefined): Cause | undefined {
  return reason === undefined ? undefined : causes.get(reason)
}
