/// The block of `priority`: of two controllers the first goes before the second (rule R25).

import type {Expr} from "../../model/syntax_tree.ts"
import {words} from "../../words/index.ts"
import {type BlockSpec, noButtons} from "../spec/block_spec.ts"

export const priority: BlockSpec = {
  type: "priority",
  calls: "priority",
  shape() {
    const {priority: w} = words
    const socket = (name: string, aria: string) =>
      ({kind: "socket", name, sort: "expression", aria, hint: words.definitions.function}) as const
    return {
      family: "task",
      connects: {as: "expression"},
      rows: [
        [
          {kind: "label", text: w.first},
          socket("A", w.whatGoesFirst),
          {kind: "label", text: w.for},
          {
            kind: "socket",
            name: "T",
            sort: "expression",
            aria: words.tasks.seconds,
            hint: words.tasks.number,
          },
          {kind: "label", text: `s${w.otherwise}`},
          socket("B", w.whatGoesSecond),
        ],
      ],
      tooltip: w.theFirstKeepsTheRobot,
      aria: w.firstForSecondsOtherwise,
      help: "v:priority",
    }
  },
  press: noButtons,
  meaning: {
    as: "expression",
    read(r) {
      const fn: Expr = {kind: "variable", name: "priority", from: r.from}
      return {kind: "apply", fn, args: [r.expr("T"), r.expr("A"), r.expr("B")], from: r.from}
    },
    write(e) {
      if (e.kind !== "apply" || e.fn.kind !== "variable" || e.fn.name !== "priority") return undefined
      const [time, first, second, ...more] = e.args
      return time === undefined || first === undefined || second === undefined || more.length > 0
        ? undefined
        : {extra: {}, sockets: {T: time, A: first, B: second}}
    },
  },
}
