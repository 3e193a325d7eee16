/// Why an edit of the network is not made, in the learner's language.

import {words} from "../words/index.ts"
import type {NetworkRefusal} from "./network_action.ts"

export function refusalSentence(refusal: NetworkRefusal): string {
  const say = words.network
  switch (refusal.kind) {
    case "no-such-function":
      return say.noSuchFunction(refusal.function)
    case "name-taken":
      return say.nameTaken(refusal.name)
    case "not-a-name":
      return say.notAName(refusal.name)
    case "not-a-type-name":
      return say.notATypeName(refusal.name)
    case "no-simulate":
      return say.noSimulate
    case "type-unknown":
      return say.typeUnknown(refusal.function)
    case "already-takes":
      return say.alreadyTakes(refusal.function, refusal.type)
    case "already-sends":
      return say.alreadySends(refusal.function, refusal.type)
    case "already-runs":
      return say.alreadyRuns(refusal.function)
    case "does-not-run":
      return say.doesNotRun(refusal.function)
    case "takes-no-event":
      return say.takesNoEvent(refusal.function)
    case "takes-too-much":
      return say.takesTooMuch(refusal.function)
    case "tells-apart":
      return say.tellsApart(refusal.function, refusal.type)
    case "does-not-take":
      return say.doesNotTake(refusal.function, refusal.type)
    case "does-not-send":
      return say.doesNotSend(refusal.function, refusal.type)
    case "computes-together":
      return say.computesTogether(refusal.function, refusal.type)
    case "used-elsewhere":
      return say.usedElsewhere(refusal.function)
    case "no-such-step":
      return say.noSuchStep
    case "only-step":
      return say.onlyStep
    case "inside-itself":
      return say.insideItself
    case "other-chain":
      return say.otherChain
    case "not-composed":
      return say.notComposed
    case "unfinished":
      return say.unfinished(refusal.names.join(", "))
    case "unfinished-text":
      return say.unfinishedText
    default:
      return refusal.why
  }
}
