/// Blocks that may go into a socket of some type: likely ones, and now and then any at all.

import {choices} from "../../src/blocks/spec/constructor_labels.ts"
import type {Extra, SavedBlock} from "../../src/index.ts"
import type {Type} from "../../src/types/syntax/type.ts"
import {
  asFunction,
  con,
  prune,
  showType,
  spine,
  substitute,
  variablesIn,
} from "../../src/types/syntax/type.ts"
import type {Maker, WithOrigin} from "./blocks.ts"
import {everyName, libraryConstructors, makersOf} from "./blocks.ts"

/// A name that is known where the block goes.
export interface Known {
  readonly name: string
  readonly type: Type
}

const numbers = new Set(["Double", "Int", "Integer", "Seconds", "Orientation", "Float", "Word"])
const whole = new Set(["Int", "Integer", "Word"])

function headOf(type: Type): string {
  const {head} = spine(type)
  return head.kind === "con" ? head.name : head.kind === "var" ? `'${head.name}` : "*"
}

/// What a known name makes with as many inputs as it takes to get there.
function uses(known: readonly Known[], wanted: Type): {readonly name: string; readonly args: number}[] {
  const head = headOf(wanted)
  return known.flatMap(k => {
    const found = []
    let type = prune(k.type)
    for (let args = 0; args < 10; args++) {
      const h = headOf(type)
      if (h === head || h === "*" || head === "*") found.push({name: k.name, args})
      const f = asFunction(type)
      if (f === undefined) break
      type = prune(f.to)
    }
    return found
  })
}

export class Values {
  private readonly make: Maker

  constructor(make: Maker) {
    this.make = make
  }

  /// A block for a socket. `small`: without sockets of its own, if that can be.
  propose(wanted: Type, known: readonly Known[], small: boolean): SavedBlock {
    const {dice} = this.make
    const near = uses(known, wanted).filter(u => !small || u.args === 0)
    const use = () => {
      const {name, args} = dice.pick(near)
      return this.make.call(name, args)
    }
    const fitting = this.ofType(wanted, small)
    return dice.weighed<() => SavedBlock>([
      [near.length > 0 ? 5 : 0, use],
      [fitting === undefined ? 0 : 11, () => fitting ?? this.anything(small)],
      [small ? 0 : 5, () => this.around(wanted)],
      [small ? 0 : 2, () => this.throughLibrary(wanted)],
      [small ? 1 : 3, () => this.anything(small)],
    ])()
  }

  /// Blocks that go anywhere, whatever the type.
  private around(wanted: Type): SavedBlock {
    const {make} = this
    const {dice} = make
    const text = showType(wanted)
    const closed = /^[^?]*$/.test(text) && variablesIn(wanted).size === 0 && !/\b[a-z]\w*\b/.test(text)
    return dice.weighed<() => SavedBlock>([
      [3, () => make.block("if")],
      [2, () => this.caseOf()],
      [1, () => make.block("branches", {guards: 1 + dice.below(2), otherwise: true})],
      [2, () => make.block("let", {}, {D: make.localDefinitions(1)})],
      [1, () => make.block("apply", {args: 1 + dice.below(2)})],
      [1, () => make.block("apply", {args: 1}, {F: make.block("lambda", {inputs: 1}, {P0: make.named()})})],
      [1, () => make.block("infix", {op: "$"})],
      [closed ? 1 : 0, () => make.block("typed", {type: text})],
      [1, () => this.update()],
    ])()
  }

  private caseOf(extra: Extra = {}): SavedBlock {
    const {make} = this
    const parts = Array.from({length: 1 + make.dice.below(make.dice.once(5) ? 5 : 3)}, () => make.equation(2))
    const inputs = Object.assign({}, ...parts.map((p, i) => p.inputs(i))) as {[name: string]: SavedBlock}
    return make.block("case", {...extra, alternatives: parts.map(p => p.extra)}, inputs)
  }

  private update(): SavedBlock {
    const records = [...this.make.own, ...libraryConstructors].filter(c => c.fieldNames[0] !== undefined)
    const fields = this.make.dice.pick(records).fieldNames.flatMap(f => f ?? [])
    const first = this.make.dice.below(fields.length)
    return this.make.block("update", {fields: fields.slice(first, first + 1 + this.make.dice.below(2))})
  }

  private throughLibrary(wanted: Type): SavedBlock {
    const {dice} = this.make
    const makers = [...makersOf(headOf(wanted)), ...makersOf("*")]
    if (makers.length === 0) return this.anything(false)
    const maker = dice.pick(makers)
    return this.make.call(maker.name, dice.once(8) ? dice.below(maker.arity + 1) : maker.arity)
  }

  /// Any block without sockets.
  leaf(): SavedBlock {
    return this.anything(true)
  }

  /// Any block, mostly one with sockets.
  node(): SavedBlock {
    return this.anything(false)
  }

  /// Any block: the checker will say.
  private anything(small: boolean): SavedBlock {
    const {make} = this
    const {dice} = make
    const leaves: readonly (() => SavedBlock)[] = [
      () => make.block("number", {value: dice.pick(["0", "1", "0.5", "2", "-3", "1e-3"])}),
      () => make.block("text", {value: dice.pick(["", "hi", 'a"b', "grüß\\dich"])}),
      () => make.block("character", {value: dice.pick(["a", "'", "\\", "ü"])}),
      () => {
        const of = dice.pick(Object.keys(choices))
        return make.block("choice", {of, value: dice.pick(choices[of]?.options ?? ["True"])})
      },
      () => make.block("tuple", {items: 0}),
      () => make.block("list", {items: 0}),
      () => make.call(dice.pick(everyName).name, 0),
      () => make.block("construct", {con: dice.pick([...make.own, ...libraryConstructors]).con, args: 0}),
    ]
    const nodes: readonly (() => SavedBlock)[] = [
      () => this.construct(dice.pick([...make.own, ...libraryConstructors]), false),
      () => {
        const {name, arity} = dice.pick(everyName)
        return make.call(name, dice.below(arity + 1))
      },
      () =>
        make.block("infix", {
          op: dice.pick([
            "+",
            "-",
            "*",
            "/",
            "==",
            "<",
            "&&",
            "||",
            "++",
            ":",
            "$",
            ".",
            "<>",
            "div",
            "^",
            "/=",
            "**",
            "mod",
            ">=",
            "<$>",
            "<*>",
            ">>=",
            ">>",
            "=<<",
            "!!",
            "elem",
            "addVec",
          ]),
        }),
      () => make.block("negate"),
      () => make.block("tuple", {items: 2 + dice.below(dice.once(6) ? 8 : 2)}),
      () => make.block("list", {items: 1 + dice.below(dice.once(6) ? 6 : 2)}),
      () => make.block("lambda", {inputs: 1 + dice.below(3)}, {P0: make.named()}),
      () =>
        make.block("section", {
          op: dice.pick(["+", "*", "==", "++", "-", "<", "/", "div", ":", "."]),
          side: dice.pick(["left", "right"]),
        }),
      () => make.block("range", dice.pick([{}, {step: true}])),
      () => make.block("comprehension", {}, {S: make.sources()}),
      () => make.block("do", {}, {S: make.steps(1)}),
    ]
    return dice.pick(small ? leaves : dice.once(3) ? leaves : nodes)()
  }

  private construct(c: WithOrigin, small: boolean): SavedBlock {
    const {make} = this
    const named = c.fieldNames.length > 0 && c.fieldNames.every(n => n !== undefined)
    if (named && make.dice.once(3)) {
      const fields = c.fieldNames.flatMap(n => n ?? [])
      return make.block("record", {con: c.con, fields})
    }
    return small && c.fields.length > 0
      ? (this.least({kind: "con", name: c.of}, []) ??
          make.block("construct", {con: c.con, args: c.fields.length}))
      : make.block("construct", {con: c.con, args: c.fields.length})
  }

  /// Literals, constructors and structures of a type.
  private ofType(wanted: Type, small: boolean): SavedBlock | undefined {
    const {make} = this
    const {dice} = make
    const {head, args} = spine(wanted)
    if (head.kind !== "con") return undefined
    if (numbers.has(head.name)) {
      const value = whole.has(head.name)
        ? dice.pick(["0", "1", "2", "10", "-1"])
        : dice.pick(["0", "1", "0.5", "2", "-0.25"])
      const number = () => make.block("number", {value})
      if (small) return number()
      return dice.weighed<() => SavedBlock>([
        [4, number],
        [
          4,
          () =>
            make.block("infix", {
              op: dice.pick(
                whole.has(head.name) ? ["+", "-", "*", "div", "mod", "^"] : ["+", "-", "*", "/", "**"],
              ),
            }),
        ],
        [1, () => make.block("negate")],
        [2, () => this.throughLibrary(wanted)],
      ])()
    }
    const of = choices[head.name]
    if (head.name === "Bool" && !small)
      return dice.weighed<() => SavedBlock>([
        [3, () => make.block("infix", {op: dice.pick(["==", "/=", "<", "<=", ">", ">="])})],
        [2, () => make.block("infix", {op: dice.pick(["&&", "||"])})],
        [2, () => this.throughLibrary(wanted)],
        [1, () => make.block("choice", {of: "Bool", value: dice.pick(["True", "False"])})],
      ])()
    if (of !== undefined) return make.block("choice", {of: head.name, value: dice.pick(of.options)})
    if (/^\(,+\)$/.test(head.name)) return make.block("tuple", {items: args.length})
    if (head.name === "()") return make.block("tuple", {items: 0})
    if (head.name === "Char") return make.block("character", {value: dice.pick(["a", " ", "z"])})
    if (head.name === "[]") return this.list(args[0] ?? con("()"), small)
    if (head.name === "->") return this.fn(wanted, small)
    if (head.name === "Call") return small ? this.least(wanted, []) : this.call()
    if (head.name === "CallOptions") return small ? make.call("callOptions", 0) : this.callOptions()
    if (head.name === "TaskOptions") return small ? make.call("taskOptions", 0) : this.taskOptions()
    if (head.name === "Task") {
      if (small) return this.least(wanted, [])
      return dice.weighed<() => SavedBlock>([
        [7, () => make.block("do", {}, {S: make.steps(0)})],
        [2, () => this.throughLibrary(wanted)],
        [3, () => this.task()],
      ])()
    }
    const made = make.constructorsOf(head.name)
    if (made.length === 0) return this.throughLibrary(wanted)
    const leaves = made.filter(c => c.fields.length === 0)
    return this.construct(dice.pick(small && leaves.length > 0 ? leaves : made), small)
  }

  /// Tasks of Rosy's own, with all they are told.
  private task(): SavedBlock {
    const {make} = this
    return make.dice.pick<() => SavedBlock>([
      () => make.call("once", 1),
      () => make.call("task", 2),
      () => make.block("name", {name: "taskWith", args: 2, fn: true}, {A0: this.taskOptions()}),
      () => make.block("name", {name: "taskWith", args: 2, fn: true}, {A0: this.taskOptions()}),
      () => make.block("name", {name: "task", args: 2, fn: true}, {A1: this.call()}),
      () => make.call("race", 2),
      () => make.call("parallel", 2),
      () => make.call("forever", 1),
      () => make.call("replicateM_", 2),
    ])()
  }

  private taskOptions(): SavedBlock {
    return this.told("TaskOptions", "taskOptions", ["starting", "stopped"])
  }

  /// A task that runs beside its caller, with all that the caller may ask and hear.
  private call(): SavedBlock {
    return this.make.block("name", {name: "call", args: 2, fn: true}, {A1: this.callOptions()})
  }

  private callOptions(): SavedBlock {
    const {make} = this
    const all = ["cancelOn", "onFeedback", "onEnd"]
    const given: {readonly [field: string]: () => SavedBlock} = {
      cancelOn: () => this.onEvent(make.block("construct", {con: "Just", args: 1})),
      onFeedback: () => this.onEvent(undefined),
      onEnd: () => make.call("Done", 0),
    }
    return this.told("CallOptions", "callOptions", all, given)
  }

  /// The usual options with some of them changed, or all of them anew.
  private told(
    con: string,
    usual: string,
    all: readonly string[],
    given: {readonly [field: string]: () => SavedBlock} = {},
  ): SavedBlock {
    const {make} = this
    const {dice} = make
    if (dice.once(4)) return make.call(usual, 0)
    const whole = dice.once(3)
    const fields = whole ? [...all] : all.filter(() => dice.once(2))
    if (fields.length === 0) return make.call(usual, 0)
    const values = fields.flatMap((field, i) => {
      const value = dice.once(3) ? undefined : given[field]?.()
      return value === undefined ? [] : [[`F${i}`, value] as const]
    })
    return whole
      ? make.block("record", {con, fields}, Object.fromEntries(values))
      : make.block("update", {fields}, {R: make.call(usual, 0), ...Object.fromEntries(values)})
  }

  /// A function of something that a robot tells.
  private onEvent(body: SavedBlock | undefined): SavedBlock {
    const {make} = this
    const heard = make.dice.pick(["Bumper", "Cliff", "Wheel", "Button", "Velocity", "Feedback"])
    const args = make.constructorsOf(heard)[0]?.fields.length ?? 0
    const pattern = make.block("pattern_construct", {con: heard, args})
    return make.block("lambda", {inputs: 1}, {P0: pattern, ...(body === undefined ? {} : {B: body})})
  }

  private list(item: Type, small: boolean): SavedBlock {
    const {make} = this
    const {dice} = make
    const text = headOf(item) === "Char"
    if (text && (small || dice.once(2))) return make.block("text", {value: dice.pick(["", "hi", "go on"])})
    if (small) return make.block("list", {items: 0})
    return dice.weighed<() => SavedBlock>([
      [2, () => make.block("list", {items: dice.below(4)})],
      [2, () => make.block("infix", {op: dice.pick(["++", ":", "<>"])})],
      [numbers.has(headOf(item)) ? 2 : 0, () => make.block("range", dice.pick([{}, {step: true}]))],
      [2, () => make.block("comprehension", {}, {S: make.sources()})],
      [2, () => this.throughLibrary({kind: "app", fn: con("[]"), arg: item})],
      [text ? 2 : 0, () => make.call("show", 1)],
    ])()
  }

  private fn(wanted: Type, small: boolean): SavedBlock {
    const {make} = this
    const {dice} = make
    let inputs = 0
    for (let f = asFunction(wanted); f !== undefined; f = asFunction(f.to)) inputs++
    const lambda = () => {
      const count = dice.once(4) ? 1 : inputs
      const parameters = Array.from({length: count}, (_, i) => [`P${i}`, make.named()] as const)
      return make.block("lambda", {inputs: count}, Object.fromEntries(parameters))
    }
    if (small) return this.least(wanted, []) ?? lambda()
    return dice.weighed<() => SavedBlock>([
      [4, lambda],
      [1, () => this.caseOf({lambda: true})],
      [
        2,
        () =>
          make.block("section", {
            op: dice.pick(["+", "*", "-", "/", "==", "<", "++", ":", "div"]),
            side: dice.pick(["left", "right"]),
          }),
      ],
      [1, () => make.block("infix", {op: "."})],
      [
        2,
        () => {
          const long = everyName.filter(n => n.arity >= inputs)
          if (long.length === 0) return lambda()
          const {name, arity} = dice.pick(long)
          return make.call(name, arity - inputs)
        },
      ],
      [
        1,
        () =>
          make.block("construct", {
            con: dice.pick(["Just", "Left", "Right", "Led1", "Memory", "Say"]),
            args: 0,
          }),
      ],
    ])()
  }

  /// A small task with this result, of Rosy's own.
  private leastTask(result: Type, known: readonly Known[], depth: number): SavedBlock | undefined {
    const {make} = this
    const {head, args} = spine(result)
    if (head.kind !== "con") return undefined
    const light = () => {
      const value = make.dice.pick(["Red", "Green", "Black"])
      const colour = make.block("choice", {of: "LedColor", value})
      return make.block("construct", {con: "Led1", args: 1}, {A0: colour})
    }
    if (head.name === "()") return make.block("name", {name: "once", args: 1, fn: true}, {A0: light()})
    const both = {Either: "race", "(,)": "parallel"}[head.name]
    const [left, right] = args.map(type =>
      this.least({kind: "app", fn: con("Task"), arg: type}, known, depth + 1),
    )
    if (both !== undefined && left !== undefined && right !== undefined)
      return make.block("name", {name: both, args: 2, fn: true}, {A0: left, A1: right})
    const done = this.least({kind: "app", fn: con("Done"), arg: result}, known, depth + 1)
    if (done === undefined) return undefined
    return make.dice.once(3)
      ? make.block("name", {name: "taskWith", args: 2, fn: true}, {A0: make.call("taskOptions", 0), A1: done})
      : make.block("name", {name: "task", args: 2, fn: true}, {A0: light(), A1: done})
  }

  /// The usual options, or with one thing changed.
  private leastOptions(): SavedBlock {
    const {make} = this
    const usual = make.call("callOptions", 0)
    const when = (con: string, args: number, body: SavedBlock) => {
      const parts = Array.from({length: args}, (_, i) => [
        `A${i}`,
        make.block("pattern_any", {what: "thing"}),
      ])
      const pattern = make.block("pattern_construct", {con, args}, Object.fromEntries(parts))
      return make.block("lambda", {inputs: 1}, {P0: pattern, B: body})
    }
    const changed = (field: string, value: SavedBlock) =>
      make.block("update", {fields: [field]}, {R: usual, F0: value})
    const cancel = () => make.block("construct", {con: "Cancel", args: 0})
    return make.dice.pick<() => SavedBlock>([
      () => usual,
      () =>
        changed(
          "cancelOn",
          when("Bumper", 2, make.block("construct", {con: "Just", args: 1}, {A0: cancel()})),
        ),
      () => changed("onFeedback", when("Feedback", 1, make.block("tuple", {items: 0}))),
      () => changed("onEnd", when("()", 0, make.block("construct", {con: "OnSound", args: 0}))),
    ])()
  }

  /// The smallest value of a type with nothing left open, or `undefined` where none is known.
  least(wanted: Type, known: readonly Known[], depth = 0): SavedBlock | undefined {
    const {make} = this
    const {head, args} = spine(wanted)
    if (depth > 6) return undefined
    const [use] = uses(known, wanted).filter(u => u.args === 0 && headOf(wanted) !== "*")
    if (head.kind === "var") return use === undefined ? undefined : make.call(use.name, 0)
    if (head.kind !== "con") return make.block("tuple", {items: 0})
    if (numbers.has(head.name)) return make.block("number", {value: make.dice.pick(["1", "2"])})
    const of = choices[head.name]
    if (of !== undefined) return make.block("choice", {of: head.name, value: make.dice.pick(of.options)})
    const all = (types: readonly Type[]): SavedBlock[] | undefined => {
      const found = types.map(t => this.least(t, known, depth + 1))
      return found.every(b => b !== undefined) ? (found as SavedBlock[]) : undefined
    }
    const numbered = (blocks: readonly SavedBlock[], letter: string) =>
      Object.fromEntries(blocks.map((b, i) => [`${letter}${i}`, b]))
    if (/^\(,*\)$/.test(head.name)) {
      const items = all(args)
      return items && make.block("tuple", {items: items.length}, numbered(items, "I"))
    }
    if (head.name === "Char") return make.block("character", {value: "a"})
    if (head.name === "[]")
      return args[0] !== undefined && headOf(args[0]) === "Char"
        ? make.block("text", {value: "hi"})
        : make.block("list", {items: 0})
    const f = asFunction(wanted)
    if (f !== undefined) {
      const result = this.least(f.to, known, depth + 1)
      return result && make.block("name", {name: "const", args: 1}, {A0: result})
    }
    if (head.name === "CallOptions" || head.name === "TaskOptions") {
      const name = head.name === "CallOptions" ? "callOptions" : "taskOptions"
      if (args.every(a => ["()", "Never", "*"].includes(headOf(a)))) return make.call(name, 0)
    }
    const [result] = args
    if (head.name === "Call") {
      const task = this.leastTask(con("()"), known, depth + 1)
      return (
        task && make.block("name", {name: "call", args: 2, fn: true}, {A0: task, A1: this.leastOptions()})
      )
    }
    if (head.name === "Task" && result !== undefined && make.dice.once(2)) {
      const rosy = this.leastTask(result, known, depth)
      if (rosy !== undefined) return rosy
    }
    if (head.name === "Task" || head.name === "IO") {
      const [inner] = all(args) ?? []
      return inner && make.block("name", {name: "return", args: 1}, {A0: inner})
    }
    const made = [...make.constructorsOf(head.name)].sort((a, b) => a.fields.length - b.fields.length)
    for (const c of made) {
      const by = new Map(c.parameters.map((p, i) => [p, args[i] ?? con("()")] as const))
      const fields = all(c.fields.map(t => substitute(t, by)))
      if (fields !== undefined)
        return make.block("construct", {con: c.con, args: fields.length}, numbered(fields, "A"))
    }
    return use === undefined ? undefined : make.call(use.name, 0)
  }
}
