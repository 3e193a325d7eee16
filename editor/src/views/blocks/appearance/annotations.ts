/// Annotations on blocks: inferred types (colour, outline, header), problems, the position of the text cursor, and functions that fired.
///
/// An annotation is a class on the block's group (styled in `style_sheet.ts`); a problem also has an icon with its sentence. Only blocks whose appearance changes are redrawn.

import {
  type BlockId,
  type BlockProblem,
  type Family,
  type Inference,
  type SavedWorkspace,
  socketKey,
} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {extraOf, shapeOf} from "../construction/block_definitions.ts"
import {SignatureField} from "../construction/text_fields.ts"
import {connectionStyleOf, setConnectionStyle, styleName} from "../construction/theme.ts"

/// Milliseconds that a block glows after its function fired; long enough to be seen at 50 firings a second.
const glowTime = 450

const problemIcon = "rosy"

/// What a block wears: thousands may wear the same after an edit.
interface Worn {
  readonly block: Blockly.BlockSvg
  readonly words: string
  readonly isWrong: boolean
}

export class Annotations {
  private readonly workspace: Blockly.WorkspaceSvg
  private inferred: readonly BlockProblem[] = []
  private told: readonly BlockProblem[] = []
  private accepted = false
  private waiting = false
  private loose: ReadonlySet<BlockId | undefined> = new Set()
  private highlighted: readonly BlockId[] = []
  private explained: readonly BlockId[] = []
  private taken: readonly BlockId[] = []
  private running: readonly BlockId[] = []
  private dimmed: readonly BlockId[] = []
  private readonly worn = new Map<BlockId, Worn>()
  private readonly glowing = new Map<BlockId, number>()

  constructor(workspace: Blockly.WorkspaceSvg) {
    this.workspace = workspace
  }

  /// Problems that inference found in the blocks as they are.
  setInferred(problems: readonly BlockProblem[]): void {
    this.inferred = problems
    this.showProblems()
  }

  /// Problems from elsewhere (the compiler, a run); they stand until the next call.
  /// `accepted` says that the compiler has taken the program: what inference has against it is then not worn.
  setTold(problems: readonly BlockProblem[], accepted: boolean): void {
    this.told = problems
    this.accepted = accepted
    this.showProblems()
  }

  /// Shows what was learnt while something was being moved.
  dropped(): void {
    if (this.waiting) this.showProblems()
  }

  // Icons make blocks wider: nothing shifts under a hand that is about to let go.
  private showProblems(): void {
    this.waiting = this.workspace.isDragging()
    if (this.waiting) return
    const sentences = new Map<BlockId, string[]>()
    const wrong = new Set<BlockId>()
    for (const problem of [...this.inferredToWear(), ...this.told]) {
      if (problem.block === undefined) continue
      if (problem.severity === "error") wrong.add(problem.block)
      const all = sentences.get(problem.block) ?? []
      const sentence = problem.hint === "" ? problem.message : `${problem.message} ${problem.hint}`
      if (!all.includes(sentence)) all.push(sentence)
      sentences.set(problem.block, all)
    }
    const loose = new Set(
      this.inferred.filter(problem => problem.kind === "loose").map(problem => problem.block),
    )
    for (const id of [...this.loose, ...loose])
      if (id !== undefined) toggle(this.workspace.getBlockById(id), "rosyLoose", loose.has(id))
    this.loose = loose
    for (const id of new Set([...this.worn.keys(), ...sentences.keys()])) {
      const block = this.workspace.getBlockById(id)
      const words = sentences.get(id)?.join("\n") ?? ""
      const before = this.worn.get(id)
      if (block === null) this.worn.delete(id)
      if (block === null || block.isInsertionMarker()) continue
      const isWrong = wrong.has(id)
      if (before?.block === block && before.words === words && before.isWrong === isWrong) continue
      toggle(block, "rosyWrong", words !== "" && isWrong)
      toggle(block, "rosyWarned", words !== "" && !isWrong)
      if (words === "") this.worn.delete(id)
      else this.worn.set(id, {block, words, isWrong})
      if (before?.block === block && before.words === words) continue
      withoutEvents(() => block.setWarningText(words === "" ? null : bubbleText(words), problemIcon))
    }
  }

  /// The compiler does not check conflicts between functions: those stay when it has accepted the program.
  private inferredToWear(): readonly BlockProblem[] {
    return this.accepted
      ? this.inferred.filter(problem => problem.kind === "conflict")
      : problemsWithIcon(this.inferred)
  }

  /// Some blocks were replaced: their marks are gone with them.
  forget(): void {
    for (const id of this.worn.keys()) {
      const marks = this.workspace.getBlockById(id)?.getSvgRoot().classList
      if (marks?.contains("rosyWrong") !== true && marks?.contains("rosyWarned") !== true)
        this.worn.delete(id)
    }
    this.showProblems()
    this.highlight(this.highlighted)
    this.dim(this.dimmed)
    this.explain(this.explained)
    this.take(this.taken)
    this.run(this.running)
  }

  /// The branches that functions took at the displayed moment.
  take(ids: readonly BlockId[]): void {
    for (const id of this.taken) toggle(this.workspace.getBlockById(id), "rosyTaken", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyTaken", true)
    this.taken = ids
  }

  /// The definitions that led to the answer of a question.
  explain(ids: readonly BlockId[]): void {
    for (const id of this.explained) toggle(this.workspace.getBlockById(id), "rosyWhy", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyWhy", true)
    this.explained = ids
  }

  /// The blocks that the cursor in the text is in.
  highlight(ids: readonly BlockId[]): void {
    for (const id of this.highlighted) toggle(this.workspace.getBlockById(id), "rosyTold", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyTold", true)
    this.highlighted = ids
  }

  /// Blocks that show what their text was before it broke.
  dim(ids: readonly BlockId[]): void {
    for (const id of this.dimmed) toggle(this.workspace.getBlockById(id), "rosyDim", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyDim", true)
    this.dimmed = ids
  }

  /// The blocks that run at the moment that is looked at.
  run(ids: readonly BlockId[]): void {
    for (const id of this.running) toggle(this.workspace.getBlockById(id), "rosyRunning", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyRunning", true)
    this.running = ids
  }

  /// Lets blocks glow for a moment; those that glow already go on.
  glow(ids: readonly BlockId[]): void {
    for (const id of ids) {
      const running = this.glowing.get(id)
      if (running !== undefined) window.clearTimeout(running)
      else toggle(this.workspace.getBlockById(id), "rosyFired", true)
      this.glowing.set(
        id,
        window.setTimeout(() => {
          this.glowing.delete(id)
          toggle(this.workspace.getBlockById(id), "rosyFired", false)
        }, glowTime),
      )
    }
  }

  dispose(): void {
    for (const timer of this.glowing.values()) window.clearTimeout(timer)
    this.glowing.clear()
  }
}

/// Characters of a line in a bubble.
const bubbleWidth = 52

/// @internal A sentence for a bubble, which has lines but no code: backquotes are left out.
export function bubbleText(words: string): string {
  return words
    .replaceAll("`", "")
    .split("\n")
    .map(line => Blockly.utils.string.wrap(line, bubbleWidth))
    .join("\n")
}

function toggle(block: Blockly.BlockSvg | null, name: string, on: boolean): void {
  block?.getSvgRoot().classList.toggle(name, on)
}

/// Icons come and go through events, which would count as the learner's edits.
function withoutEvents(act: () => void): void {
  Blockly.Events.disable()
  try {
    act()
  } finally {
    Blockly.Events.enable()
  }
}

/// What each top-level block and what is told of it was when it was painted.
const painted = new WeakMap<Blockly.Block, {readonly stamp: object | undefined; readonly saved: unknown}>()

/// Paints `inference` onto the blocks of a workspace, which is saved as `now`. `names` are families of names from elsewhere, for blocks in the
/// toolbox, which stand outside the program.
export function showInference(
  workspace: Blockly.WorkspaceSvg,
  inference: Inference,
  now: SavedWorkspace,
  names?: ReadonlyMap<string, Family>,
): void {
  const savedTops = new Map(now.blocks.blocks.map(block => [block.id, block]))
  const holes = new Set(
    inference.problems
      .filter(
        problem => problem.kind === "hole" && problem.block !== undefined && problem.input !== undefined,
      )
      .map(problem => socketKey(problem.block!, problem.input!)),
  )
  const fresh = workspace.getTopBlocks(false).filter(top => {
    const stamp = inference.stamps.get(top.id)
    const saved = savedTops.get(top.id)
    const before = painted.get(top)
    const isSame = before !== undefined && before.stamp === stamp && before.saved === saved
    if (!isSame) painted.set(top, {stamp, saved})
    return names !== undefined || stamp === undefined || !isSame
  })
  const parts = fresh.flatMap(top => {
    const own = inference.stamps.get(top.id)
    return top.getDescendants(false).map(block => ({block, own}))
  })
  for (const {block, own} of parts) {
    if (block.isInsertionMarker()) continue
    const shape = shapeOf(block)
    if (shape === undefined) continue
    const definition = inference.definitions.get(block.id)
    const called = names?.get(String(extraOf(block).name ?? ""))
    // What its own group does not know, another one may: a definition below it in the same stack.
    const type = own?.blocks.get(block.id) ?? inference.blocks.get(block.id)
    const family = called ?? definition?.family ?? type?.family ?? shape.family
    const style = styleName(family, shape.connects.as === "pattern")
    if (block.getStyleName() !== style) block.setStyle(style)
    let changed = false
    if (block.outputConnection !== null) {
      changed = setConnectionStyle(block.outputConnection, {family, hint: "", hole: false})
    }
    for (const input of block.inputList) {
      if (definition !== undefined) {
        for (const field of input.fieldRow) if (field instanceof SignatureField) field.show(definition.type)
      }
      const connection = input.connection
      if (connection === null || input.type !== Blockly.inputs.inputTypes.VALUE) continue
      const key = socketKey(block.id, input.name)
      const taken = own?.sockets.get(key) ?? inference.sockets.get(key)
      const wanted = taken?.family ?? connectionStyleOf(connection).family
      const look = {
        family: wanted,
        hint: connectionStyleOf(connection).hint,
        hole: names === undefined && holes.has(key),
      }
      changed = setConnectionStyle(connection, look) || changed
    }
    if (changed) block.queueRender()
  }
}

/// Problems that a block wears as an icon with a sentence. A hole is shown by its socket and a loose block by its
/// outline: while a program is being built, both are normal, and an icon would come and go at every step.
function problemsWithIcon(problems: readonly BlockProblem[]): readonly BlockProblem[] {
  return problems.filter(problem => problem.kind !== "hole" && problem.kind !== "loose")
}
