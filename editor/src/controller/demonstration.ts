/// Demonstration for a new learner: builds a program before the learner's eyes and runs it, in about 20 s. It ends by itself, when it is called again, and
/// when the learner takes over: changes the program, opens another one or runs it.

import type {Store} from "../browser/store.ts"

const withDrive = (main: string, turn: number) =>
  `drive :: Velocity\ndrive = Velocity 0.3 ${turn}\n\nmain = simulate ${main}\n`

interface Step {
  readonly text: string
  readonly runs: boolean
  /// Milliseconds until the next step: long enough to read its sentence.
  readonly lasts: number
}

/// Their sentences are in `words.welcome.steps`.
const steps: readonly Step[] = [
  {text: "main = simulate _\n", runs: false, lasts: 3500},
  {text: withDrive("_", 0), runs: false, lasts: 4500},
  {text: withDrive("drive", 0), runs: false, lasts: 3000},
  {text: withDrive("drive", 0), runs: true, lasts: 4000},
  {text: withDrive("drive", 1), runs: true, lasts: 6000},
]

export interface DemonstratedPage {
  /// Opens a program that is not stored.
  show(text: string): void
  run(): void
}

/// The command that begins and ends it.
export function openDemonstration(
  store: Pick<Store, "now" | "dispatch">,
  page: DemonstratedPage,
): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined
  /// What the page had when the last step was shown.
  let expected = {text: "", runs: 0}
  const announce = (step: number | null) => store.dispatch({kind: "demonstration", step})
  const end = () => {
    clearTimeout(timer)
    announce(null)
    store.dispatch({kind: "welcoming", welcoming: true})
  }
  const now = () => ({text: store.now.document.program.text, runs: store.now.runs})
  const isTakenOver = () => {
    const {text, runs} = now()
    return text !== expected.text || runs !== expected.runs
  }
  const show = (number: number) => {
    if (number > 0 && isTakenOver()) return announce(null)
    const step = steps[number]
    if (step === undefined) return end()
    if (store.now.document.program.text !== step.text) page.show(step.text)
    announce(number)
    if (step.runs) page.run()
    expected = now()
    timer = setTimeout(() => show(number + 1), step.lasts)
  }
  return () => {
    if (store.now.demonstration === null) show(0)
    else end()
  }
}
