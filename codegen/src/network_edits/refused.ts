/// Exception that ends an edit of the network which is refused.

import type {NetworkRefusal} from "./network_action.ts"

export class Refused extends Error {
  readonly refusal: NetworkRefusal

  constructor(refusal: NetworkRefusal) {
    super(refusal.kind)
    this.refusal = refusal
  }
}

export const refuse = (refusal: NetworkRefusal): never => {
  throw new Refused(refusal)
}
