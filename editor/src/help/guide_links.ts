/// Pages of the guide that fit a lesson, a problem or a part of the page. Addresses are from the page's own address, as in `help_links.ts`.

const pageOf = (name: string, anchor = ""): string => `guide/${name}.html${anchor === "" ? "" : `#${anchor}`}`

/// By course of the lesson (`examples/lessons`).
const coursePages: ReadonlyMap<string, string> = new Map([
  ["drive", pageOf("tutorial-drive")],
  ["react", pageOf("tutorial-events")],
  ["remember", pageOf("tutorial-memory")],
  ["tasks", pageOf("how-to-tasks")],
  ["algebra", pageOf("how-to-page", "graph")],
])

/// By kind of the problem (protocol, section 1).
const problemPages: ReadonlyMap<string, string> = new Map([
  ["conflict", pageOf("why", "last-sent")],
  ...(["missing-argument", "argument-count"] as const).map(
    kind => [kind, pageOf("why", "value-missing")] as const,
  ),
  ...(["never-sent", "never-taken"] as const).map(kind => [kind, pageOf("why", "not-run")] as const),
  ...(["missing-memory", "memory-as-value", "never-written", "never-read", "no-default"] as const).map(
    kind => [kind, pageOf("tutorial-memory")] as const,
  ),
  ...(["missing-cases", "missing-just", "unexpected-maybe"] as const).map(
    kind => [kind, pageOf("tutorial-events", "sometimes")] as const,
  ),
  ...(
    ["task-needed", "task-result", "done-type", "done-outside-task", "wrong-done", "call-in-once"] as const
  ).map(kind => [kind, pageOf("how-to-tasks")] as const),
  ...(["controller-needed", "missing-controller", "not-a-command", "not-a-sensor"] as const).map(
    kind => [kind, pageOf("ideas", "type-says-when")] as const,
  ),
  ["unit", pageOf("why", "radians")],
  ["second-simulate", pageOf("tutorial-drive", "two-things")],
  ["ran-before", pageOf("tutorial-drive", "two-things")],
])

export const guidePageOfCourse = (course: string): string | undefined => coursePages.get(course)
export const guidePageOfProblem = (kind: string): string | undefined => problemPages.get(kind)

/// How to work with the page.
export const pageHelp = pageOf("how-to-page")
/// What a teacher does when pupils hand in.
export const handInHelp = pageOf("class", "hand-in")

/// All of them, for the test that looks each up in the guide.
/// @internal
export const allGuideLinks: readonly string[] = [
  ...new Set([...coursePages.values(), ...problemPages.values(), pageHelp, handInHelp]),
]
