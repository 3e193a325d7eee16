/// Turns what GHCi says of modules and classes into the lines that `src/types/environment/environment.ts` reads.
///
/// Pure: text in, text out. A name that GHCi writes with its module is not in scope for a learner: such constructors and
/// methods are left out. Types beyond Haskell 2010 (higher rank) are left out too; GHC alone judges those.

/// The lines for values, types and classes, from `:browse`.
export function browsed(text: string): string[] {
  const lines: string[] = []
  let method = false
  for (const raw of logicalLines(text)) {
    if (/^type \S+ ::/.test(raw) || raw.startsWith("{-#")) continue
    if (raw.startsWith("  ")) {
      if (method) lines.push(...methodLine(raw.trim(), lines))
      continue
    }
    method = raw.startsWith("class ")
    if (method) lines.push(classLine(raw))
    else if (/^(?:data|newtype) /.test(raw)) lines.push(dataLine(raw))
    else if (raw.startsWith("type ")) lines.push(unqualify(raw))
    else if (/ :: /.test(raw)) lines.push(...valueLine(raw))
  }
  return [...new Set(lines.map(l => l.trim()))].filter(
    l => l !== "" && !/\bforall\b|#|\*/.test(l.replace(/^\([^)]*\)|\(?:\*:\)?/g, "")),
  )
}

/// The lines for instances, from `:info` of a class.
export function instancesOf(text: string): string[] {
  return logicalLines(text)
    .filter(l => l.startsWith("instance "))
    .map(l => l.replace(/\s+-- Defined.*$/, "").replace(/^instance (?:\[\w+\] )*/, "instance "))
    .map(unqualify)
    .filter(l => !/forall|~|@|::/.test(l))
}

function logicalLines(text: string): string[] {
  return text.split("\n").filter(l => l.trim() !== "" && !/^\s+-- /.test(l))
}

/// `Rosy.Robot.Velocity` to `Velocity`.
export function unqualify(text: string): string {
  return text
    .replace(/\b[a-z][\w.-]*-\d[\w.]*:(?=[A-Z])/g, "")
    .replace(/\b(?:[A-Z][\w']*\.)+(?=[\w(])/g, "")
    .replace(/HasCallStack => /, "")
    .replace(/\{-#.*?#-\}\s*/g, "")
    .replace(/(?<=[\s({])!\s*(?:\([^()]*\[\d+\]\))?/g, "")
}

function isQualified(name: string): boolean {
  return /^\(?(?:[A-Z][\w']*\.)+[^.\s]/.test(name)
}

function classLine(line: string): string {
  const head = line.replace(/ where$/, "").replace(/ \|.*$/, "")
  return unqualify(head).replace(/\((\w+) :: [^()]*\)/g, "$1")
}

/// Constructors that are not in scope are left out: the type is abstract for a learner.
function dataLine(line: string): string {
  const [head = "", right = ""] = line.split(/ = (.*)/s)
  const name = unqualify(head)
  const cases = right === "" ? [] : right.split(" | ")
  const visible = cases.filter(c => !isQualified(c.trim()) && !/forall/.test(c))
  if (visible.length === 0 || visible.length < cases.length) return name
  return `${name} = ${visible.map(c => unqualify(withoutHiddenFields(c))).join(" | ")}`
}

/// A record whose field names are not in scope is shown as if it had none.
function withoutHiddenFields(text: string): string {
  const record = /^(\S+) \{(.*)\}$/s.exec(text.trim())
  if (record === null) return text
  const fields = (record[2] ?? "").split(/, (?=\S+ ::)/)
  if (!fields.some(f => isQualified(f))) return text
  return [record[1], ...fields.map(f => `(${f.replace(/^\S+ :: /, "")})`)].join(" ")
}

function valueLine(line: string): string[] {
  const [name = "", type = ""] = line.split(/ :: (.*)/s)
  return isQualified(name) ? [] : [`${name} :: ${unqualify(type.replace(/^forall [^.]*\. /, ""))}`]
}

/// A class's method gets the class's constraint.
function methodLine(line: string, before: readonly string[]): string[] {
  const of = before.findLast(l => l.startsWith("class "))
  const head = of?.replace(/^class /, "").replace(/^.*=> /, "")
  if (head === undefined || !/ :: /.test(line) || line.startsWith("default ")) return []
  const [name = "", type = ""] = line.split(/ :: (.*)/s)
  if (isQualified(name)) return []
  const own = unqualify(type.replace(/^forall [^.]*\. /, ""))
  const [context, rest] = /^(?:\(([^()]*(?:\([^()]*\)[^()]*)*)\)|([^()=]*)) => (.*)$/s.test(own)
    ? [own.replace(/ => .*$/s, ""), own.replace(/^.*? => /s, "")]
    : ["", own]
  const all = [
    head,
    ...context
      .replace(/^\((.*)\)$/, "$1")
      .split(", ")
      .filter(c => c !== ""),
  ]
  return [`${name} :: ${all.length === 1 ? all[0] : `(${all.join(", ")})`} => ${rest}`]
}
