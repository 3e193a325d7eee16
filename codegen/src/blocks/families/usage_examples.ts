/// Usage examples for tooltips, one for each library name in the toolbox.

import {words} from "../../words/index.ts"

/// An example of a name with `args` inputs; for names without one, how it is called.
export function exampleOf(name: string, args: number): string {
  const samples: {readonly [name: string]: string} = words.samples
  return (
    (Object.hasOwn(samples, name) ? samples[name] : undefined) ??
    [name, ..."abcdefghi".slice(0, args)].join(" ")
  )
}
