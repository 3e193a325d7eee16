/// Words of the graph of a function, and of speed and position over time, in English.

export const graph = {
  functions: "Graph of a function",
  of: (name: string) => `Graph of ${name}`,
  notRun: "Run the program: each answer of the function is a point.",
  noNumbers: "What this function took or gave is no number: it has no graph.",
  partial: "These are the points since the graph was opened. Run again for all of them.",
  input: "Input",
  output: "Output",
  now: "now",
  table: "The points as a table",
  case: "Case",
  span: (from: string, to: string) => `from ${from} to ${to}`,
  motion: "Speed and position",
  position: "Position ahead",
  speed: "Speed",
  tangent: "Dashed: how it would go on at this speed.",
} as const
