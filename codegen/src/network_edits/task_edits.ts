/// Edits of tasks as chains of steps: a step more, less or elsewhere, a loop around some, two side by side. Each is an edit of blocks.
///
/// A chain is a stack of steps, or a place for a task that holds one: a place that gets a second step holds a `do` from then on. A step is named by the id of
/// its block or of any block in it.

import {chain as stackOf} from "../blocks/block_reader.ts"
import type {BlockId, SavedBlock, SavedInput, SavedWorkspace} from "../serialized_blocks.ts"
import {words} from "../words/index.ts"
import {call, make, num, ref, text} from "../workspace/toolbox/block_builders.ts"
import type {NetworkAction, NewStep} from "./network_action.ts"
import {refuse} from "./refused.ts"

export type TaskAction = Extract<
  NetworkAction,
  {
    readonly kind: "add-step" | "move-step" | "delete-step" | "loop-steps" | "put-beside" | "take-apart"
  }
>

const taskActions: ReadonlySet<string> = new Set<TaskAction["kind"]>([
  "add-step",
  "move-step",
  "delete-step",
  "loop-steps",
  "put-beside",
  "take-apart",
])

export const isTaskAction = (action: NetworkAction): action is TaskAction => taskActions.has(action.kind)

/// The workspace after an edit of its tasks. `isTask` tells the blocks of expressions that are tasks; `asUnit` gives two side by side no result.
export function taskEdit(
  workspace: SavedWorkspace,
  action: TaskAction,
  isTask: (block: BlockId) => boolean,
  asUnit = false,
): SavedWorkspace {
  const edit = new TaskEdit(workspace, isTask)
  edit.apply(action, asUnit)
  return {...workspace, blocks: {...workspace.blocks, blocks: edit.tops}}
}

/// A place where steps stand one after the other.
interface Chain {
  readonly owner: SavedBlock
  readonly input: string
  readonly steps: readonly SavedBlock[]
  /// Whether it is a place for an expression, not a stack.
  readonly isPlace: boolean
}

interface Found {
  readonly chain: Chain
  readonly at: number
  readonly step: SavedBlock
}

/// A block with the block that holds it, and how.
interface Link {
  readonly block: SavedBlock
  readonly input: string | null
}

class TaskEdit {
  readonly tops: SavedBlock[]
  readonly #isTask: (block: BlockId) => boolean

  constructor({blocks}: SavedWorkspace, isTask: (block: BlockId) => boolean) {
    this.tops = [...blocks.blocks]
    this.#isTask = isTask
  }

  apply(action: TaskAction, asUnit: boolean): void {
    switch (action.kind) {
      case "add-step":
        this.#add(action.at, action.where, stepBlock(action.step))
        break
      case "move-step":
        this.#move(action.step, action.at, action.where)
        break
      case "delete-step": {
        const {chain, at} = this.#find(action.step)
        this.#write(chain, chain.steps.toSpliced(at, 1))
        break
      }
      case "loop-steps":
        this.#loop(action.from, action.to, action.turns)
        break
      case "put-beside":
        this.#putBeside(action.step, action.with, action.as, asUnit)
        break
      default:
        this.#takeApart(action.step)
    }
  }

  #add(at: BlockId | null, where: "before" | "after" | "inside", step: SavedBlock): void {
    const inner = at !== null && where === "inside" ? this.#innerChain(at) : undefined
    if (inner !== undefined) this.#write(inner, [...inner.steps, step])
    else if (at === null) this.#addToProgram(step)
    else {
      const {chain, at: i} = this.#find(at)
      this.#write(chain, chain.steps.toSpliced(where === "before" ? i : i + 1, 0, step))
    }
  }

  /// At the end of the task that the program is, or beside what it runs.
  #addToProgram(step: SavedBlock): void {
    const main = this.#mainBlock()
    const count = typeof main.extraState?.controllers === "number" ? main.extraState.controllers : 1
    const places = Array.from({length: count}, (_, i) => `R${i}`)
    const isFree = (input: string) => main.inputs?.[input]?.block === undefined
    const input = places.find(isFree) ?? places.find(one => this.#holdsTask(main, one))
    if (input === undefined) main.extraState = {...main.extraState, controllers: count + 1}
    const chain = chainAt(main, input ?? `R${count}`)
    this.#write(chain, [...chain.steps, step])
  }

  #move(id: BlockId, to: BlockId, where: "before" | "after"): void {
    const {chain, at, step} = this.#find(id)
    const held = step.id ?? plainExpression(step)?.id
    if (this.#path(to).some(({block}) => block === step || block.id === held)) refuse({kind: "inside-itself"})
    const target = this.#find(to)
    if (target.chain.owner === chain.owner && target.chain.input === chain.input) {
      const rest = chain.steps.toSpliced(at, 1)
      const i = rest.indexOf(target.step)
      this.#write(chain, rest.toSpliced(where === "before" ? i : i + 1, 0, step))
      return
    }
    const i = where === "before" ? target.at : target.at + 1
    this.#write(target.chain, target.chain.steps.toSpliced(i, 0, step))
    this.#write(chain, chain.steps.toSpliced(at, 1))
  }

  #loop(from: BlockId, to: BlockId, turns: number | null): void {
    const first = this.#find(from)
    const {chain} = first
    const last = chain.steps.indexOf(this.#find(to).step)
    if (last < 0) refuse({kind: "other-chain"})
    const [start, end] = first.at <= last ? [first.at, last] : [last, first.at]
    const inner = chain.steps.slice(start, end + 1)
    checkLast(inner)
    const loop = make(
      turns === null ? "step_forever" : "step_repeat",
      {},
      turns === null ? {} : {N: num(`${turns}`)},
    )
    loop.inputs = {...loop.inputs, S: {block: stacked(inner)}}
    this.#write(chain, chain.steps.toSpliced(start, inner.length, loop))
  }

  #putBeside(one: BlockId, other: BlockId, as: "parallel" | "race", asUnit: boolean): void {
    const first = this.#find(one)
    const second = this.#find(other)
    const {chain} = first
    const j = chain.steps.indexOf(second.step)
    if (j < 0 || j === first.at) refuse({kind: "other-chain"})
    const ordered = first.at < j ? [first.step, second.step] : [second.step, first.step]
    const both = call(as, 2, ...ordered.map(taskOf))
    const joined: SavedBlock = {type: "step_do", inputs: {X: {block: asUnit ? call("void", 1, both) : both}}}
    const rest = chain.steps.filter(step => !ordered.includes(step))
    this.#write(chain, rest.toSpliced(Math.min(first.at, j), 0, joined))
  }

  #takeApart(id: BlockId): void {
    const {chain, at, step} = this.#opened(id)
    const expression = step.type === "step_do" ? (step.inputs?.X?.block ?? step) : step
    const bare = nameOf(expression) === "void" ? (expression.inputs?.A0?.block ?? step) : expression
    const inputs = regionsOf(bare)
    if (inputs.length === 0) refuse({kind: "not-composed"})
    const inner = inputs.flatMap(input => chainAt(bare, input).steps)
    this.#write(chain, chain.steps.toSpliced(at, 1, ...inner))
  }

  /// The step; of one that names a definition with a single step, that one: they are one thing to see.
  #opened(id: BlockId): Found {
    const found = this.#find(id)
    const inner = this.#definitionOf(plainExpression(found.step))
    const [only, ...others] = inner?.steps ?? []
    return inner === undefined || only === undefined || others.length > 0
      ? found
      : {chain: inner, at: 0, step: only}
  }

  /// The steps of the definition that an expression names.
  #definitionOf(expression: SavedBlock | undefined): Chain | undefined {
    const name = nameOf(expression)
    const top = this.tops
      .flatMap(stackOf)
      .find(({type, extraState}) => type === "define" && extraState?.name === name)
    const {block} = (top?.id === undefined ? undefined : this.#path(top.id).at(-1)) ?? {}
    return block !== undefined && this.#holdsTask(block, "E0_0") ? chainAt(block, "E0_0") : undefined
  }

  /// Where further steps of a loop, of a `do` or of a definition go.
  #innerChain(id: BlockId): Chain | undefined {
    const {block} = this.#path(id).at(-1) ?? {}
    if (block?.type === "do") return chainAt(block, "S")
    const named = this.#definitionOf(block?.type === "step_do" ? plainExpression(block) : block)
    const [only, ...others] = named?.steps ?? []
    const step = named === undefined ? block : others.length > 0 ? undefined : only
    const held = step?.type === "step_do" ? step.inputs?.X?.block : step
    const [region, ...more] = held === undefined ? [] : regionsOf(held)
    return held === undefined || region === undefined || more.length > 0 ? named : chainAt(held, region)
  }

  /// The innermost step that a block is in.
  #find(id: BlockId): Found {
    const path = this.#path(id)
    for (let i = path.length - 1; i > 0; i--) {
      const [link, holder] = [path[i], path[i - 1]]
      if (link === undefined || holder === undefined || link.input === null) continue
      const {block, input} = link
      if (isStep(block)) {
        const top = holder.block.type === "do" ? path[i - 2] : undefined
        const place = path[i - 1]?.input
        const chain =
          top !== undefined && typeof place === "string" && !isStep(holder.block)
            ? chainAt(top.block, place)
            : chainAt(holder.block, input)
        const at = chain.steps.indexOf(block)
        if (at >= 0) return {chain, at, step: block}
      } else if (block.type !== "do" && isTaskPlace(holder.block, input) && this.#isTask(block.id ?? "")) {
        const owner = loopAsStep(holder.block, input)
        const chain = chainAt(owner, owner === holder.block ? input : "S")
        const [step] = chain.steps
        if (step !== undefined) return {chain, at: 0, step}
      }
    }
    return refuse({kind: "no-such-step"})
  }

  /// From the top-level block to the one with an id. What is stacked below another is held by what holds that one. The top-level block is copied: it is
  /// about to be changed.
  #path(id: BlockId): readonly Link[] {
    for (const [i, top] of this.tops.entries()) {
      const found = pathIn({block: top, input: null}, id)
      if (found === undefined) continue
      if (this.#copied.has(top)) return found
      const copy = structuredClone(top)
      this.#copied.add(copy)
      this.tops[i] = copy
      return pathIn({block: copy, input: null}, id) ?? []
    }
    return refuse({kind: "no-such-step"})
  }
  readonly #copied = new Set<SavedBlock>()

  #mainBlock(): SavedBlock {
    const main = this.tops.flatMap(stackOf).find(({type}) => type === "main") ?? refuse({kind: "no-simulate"})
    const path = this.#path(main.id ?? "")
    return path.at(-1)?.block ?? main
  }

  #holdsTask(owner: SavedBlock, input: string): boolean {
    const block = owner.inputs?.[input]?.block
    return block !== undefined && (block.type === "do" || this.#isTask(block.id ?? ""))
  }

  /// Blocks are changed where they stand: another chain of the same edit may hold them.
  #write({owner, input, isPlace}: Chain, steps: readonly SavedBlock[]): void {
    const [first, ...others] = steps
    if (first === undefined) {
      if (owner.type !== "main") refuse({kind: "only-step"})
      closePlace(owner, input)
      return
    }
    checkLast(steps)
    const inputs: {[name: string]: SavedInput} = {...owner.inputs}
    const held = inputs[input]?.block
    if (!isPlace) inputs[input] = {block: stacked(steps)}
    else {
      const plain = others.length === 0 ? plainExpression(first) : undefined
      const around: SavedBlock = held?.type === "do" ? held : {type: "do"}
      if (plain === undefined) around.inputs = {S: {block: stacked(steps)}}
      inputs[input] = {block: plain ?? around}
    }
    owner.inputs = inputs
  }
}

const isStep = ({type}: SavedBlock) => type.startsWith("step_")

const nameOf = (block: SavedBlock | undefined) =>
  block?.type === "name" ? block.extraState?.name : undefined

/// Sockets of steps hold what these do; the step itself is the one that moves.
const isTaskPlace = ({type}: SavedBlock, input: string) =>
  !((type === "step_do" || type === "step_bind") && input === "X")

function pathIn(link: Link, id: BlockId): readonly Link[] | undefined {
  // Iterative along the stack: it may be long.
  for (const block of stackedBlocks(link.block)) {
    const here: Link = {block, input: link.input}
    if (block.id === id) return [here]
    for (const [input, {block: inner}] of Object.entries(block.inputs ?? {})) {
      const found = inner === undefined ? undefined : pathIn({block: inner, input}, id)
      if (found !== undefined) return [here, ...found]
    }
  }
  return undefined
}

/// A block and those below it, each as it is.
function stackedBlocks(first: SavedBlock): readonly SavedBlock[] {
  const all: SavedBlock[] = []
  for (let block: SavedBlock | undefined = first; block !== undefined; block = block.next?.block)
    all.push(block)
  return all
}

/// The steps at a place. The block of a chain's step is the very block that stands there, so that it can be found in it.
function chainAt(owner: SavedBlock, input: string): Chain {
  const held = owner.inputs?.[input]?.block
  if (held !== undefined && isStep(held)) return {owner, input, steps: stackedBlocks(held), isPlace: false}
  if (held?.type === "do") {
    const first = held.inputs?.S?.block
    return {owner, input, steps: first === undefined ? [] : stackedBlocks(first), isPlace: true}
  }
  const isStack = (isStep(owner) || owner.type === "do") && input === "S"
  return {owner, input, steps: held === undefined ? [] : [asStep(held)], isPlace: !isStack}
}

const asStep = (expression: SavedBlock): SavedBlock => ({type: "step_do", inputs: {X: {block: expression}}})

/// What a step is without a `do`, where it is nothing but an expression.
const plainExpression = ({type, inputs, icons}: SavedBlock): SavedBlock | undefined =>
  type === "step_do" && icons === undefined ? inputs?.X?.block : undefined

const taskOf = (step: SavedBlock): SavedBlock => {
  if (step.type === "step_bind" || step.type === "step_let")
    refuse({
      kind: "does-not-fit",
      why: `${words.tasks.theLastStepMustDoSomething} ${words.tasks.afterNamingAValueAddAStep}`,
    })
  const {next: _, ...alone} = step
  return plainExpression(alone) ?? {type: "do", inputs: {S: {block: alone}}}
}

/// Steps one below the other; these blocks are changed.
function stacked(steps: readonly SavedBlock[]): SavedBlock {
  for (const [i, step] of steps.entries()) {
    const below = steps[i + 1]
    if (below === undefined) delete step.next
    else step.next = {block: below}
  }
  return steps[0] as SavedBlock
}

function checkLast(steps: readonly SavedBlock[]): void {
  const last = steps.at(-1)
  if (last?.type === "step_bind" || last?.type === "step_let")
    refuse({
      kind: "does-not-fit",
      why: `${words.tasks.theLastStepMustDoSomething} ${words.tasks.afterNamingAValueAddAStep}`,
    })
}

const isLoopCall = (block: SavedBlock) => /^(?:forever|replicateM_)$/.test(String(nameOf(block)))

/// The inputs that hold the steps of a loop, or the tasks that run side by side.
function regionsOf(block: SavedBlock): readonly string[] {
  if (block.type === "step_forever" || block.type === "step_repeat") return ["S"]
  switch (nameOf(block)) {
    case "forever":
      return ["A0"]
    case "replicateM_":
      return ["A1"]
    case "parallel":
    case "race":
    case "parallel_":
    case "race_":
      return ["A0", "A1"]
    default:
      return []
  }
}

/// A loop that is written as a call becomes the step with a stack, which has room for more; its text stays the same.
function loopAsStep(block: SavedBlock, input: string): SavedBlock {
  if (!isLoopCall(block) || !regionsOf(block).includes(input)) return block
  const {id, inputs} = block
  const held = inputs?.[input]?.block
  const isForever = nameOf(block) === "forever"
  const count = inputs?.A0
  const loop: SavedBlock = {
    type: isForever ? "step_forever" : "step_repeat",
    ...(id === undefined ? {} : {id}),
    inputs: {
      ...(isForever || count === undefined ? {} : {N: count}),
      ...(held === undefined
        ? {}
        : {
            S: {
              block:
                held.type === "do" && held.inputs?.S?.block !== undefined
                  ? held.inputs.S.block
                  : asStep(held),
            },
          }),
    },
  }
  delete block.id
  delete block.extraState
  Object.assign(block, {type: "do", inputs: {S: {block: loop}}})
  return loop
}

function closePlace(main: SavedBlock, input: string): void {
  const count = typeof main.extraState?.controllers === "number" ? main.extraState.controllers : 1
  const kept = Array.from({length: count}, (_, i) => `R${i}`)
    .filter(one => one !== input)
    .map(one => main.inputs?.[one])
  main.extraState = {...main.extraState, controllers: Math.max(1, kept.length)}
  main.inputs = Object.fromEntries(
    kept.flatMap((place, i) => (place === undefined ? [] : [[`R${i}`, place] as const])),
  )
}

/// A new step of a task, with values to be changed.
function stepBlock(step: NewStep): SavedBlock {
  switch (step.kind) {
    case "drive":
      return make("step_drive", {}, {X: num("30")})
    case "turn":
      return make("step_turn", {}, {X: num("90")})
    case "wait":
      return make("step_wait", {}, {X: num("1")})
    case "say":
      return make("step_say", {}, {X: text("hello")})
    case "driveUntilBump":
      return make("step_drive_until_bump")
    case "driveBack":
      return make("step_drive_back", {}, {X: num("1")})
    default:
      return make("step_do", {}, {X: ref(step.name)})
  }
}
