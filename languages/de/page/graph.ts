/// Words of the graph of a function, and of speed and position over time, in German.

export const graph = {
  functions: "Graph einer Funktion",
  of: (name: string) => `Graph von ${name}`,
  notRun: "Starte das Programm: Jede Antwort der Funktion ist ein Punkt.",
  noNumbers: "Was diese Funktion bekam oder gab, ist keine Zahl: Sie hat keinen Graphen.",
  partial: "Das sind die Punkte, seit der Graph offen ist. Starte noch einmal für alle.",
  input: "Eingabe",
  output: "Ausgabe",
  now: "jetzt",
  table: "Die Punkte als Tabelle",
  case: "Fall",
  span: (from: string, to: string) => `von ${from} bis ${to}`,
  motion: "Tempo und Ort",
  position: "Ort nach vorn",
  speed: "Tempo",
  tangent: "Gestrichelt: So ginge es mit diesem Tempo weiter.",
}
