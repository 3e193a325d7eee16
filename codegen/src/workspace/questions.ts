/// Answers about one workspace as it changes, each remembering what the ones before have found out.

import type {Session as Questions} from "../api.ts"
import {checker} from "./check.ts"
import {inferenceOf, type KnownParts} from "./infer.ts"
import {namesInScope} from "./scope.ts"
import {Session} from "./session.ts"

export function session(): Questions {
  const remembered = new Session()
  const known: KnownParts = new WeakMap()
  return {
    infer: workspace => inferenceOf(workspace, remembered.solve(workspace), known),
    checker: workspace => checker(workspace, remembered),
    namesInScope: (workspace, place) => namesInScope(workspace, place, remembered),
  }
}
