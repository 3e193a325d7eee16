/// The layout engine: ELK in a web worker, so that the page stays responsive while a diagram is laid out.

import ELK, {type ElkNode} from "elkjs/lib/elk-api.js"
import workerAddress from "elkjs/lib/elk-worker.min.js?url"
import type {ElkGraph, Engine} from "./layout.ts"

export interface LayoutEngine {
  readonly layOut: Engine
  dispose(): void
}

export function openLayoutEngine(): LayoutEngine {
  const elk = new ELK({workerFactory: () => new Worker(workerAddress)})
  return {
    // ELK writes the positions into the graph that it is given.
    layOut: graph => elk.layout(structuredClone(graph) as ElkNode) as Promise<ElkGraph>,
    dispose: () => elk.terminateWorker(),
  }
}
