/// Strongly connected components, each after those it depends on (Tarjan's algorithm).

export function stronglyConnectedComponents(edges: readonly (readonly number[])[]): number[][] {
  const index = new Map<number, number>()
  const low = new Map<number, number>()
  const stack: number[] = []
  const on = new Set<number>()
  const found: number[][] = []
  const visit = (v: number): void => {
    const mine = index.size
    index.set(v, mine)
    low.set(v, mine)
    stack.push(v)
    on.add(v)
    for (const w of edges[v] ?? []) {
      if (!index.has(w)) visit(w)
      if (on.has(w)) low.set(v, Math.min(low.get(v) ?? mine, low.get(w) ?? mine))
    }
    if (low.get(v) !== mine) return
    const component: number[] = []
    for (;;) {
      const w = stack.pop()
      if (w === undefined) break
      on.delete(w)
      component.push(w)
      if (w === v) break
    }
    found.push(component.reverse())
  }
  edges.forEach((_, v) => {
    if (!index.has(v)) visit(v)
  })
  return found
}
