/// Words of the graph of a function, and of speed and position over time, in French.

export const graph = {
  functions: "Graphe d’une fonction",
  of: (name: string) => `Graphe de ${name}`,
  notRun: "Démarre le programme : chaque réponse de la fonction est un point.",
  noNumbers: "Ce que cette fonction a reçu ou donné n’est pas un nombre : elle n’a pas de graphe.",
  partial: "Ce sont les points depuis l’ouverture du graphe. Relance le programme pour les avoir tous.",
  input: "Entrée",
  output: "Sortie",
  now: "maintenant",
  table: "Les points en tableau",
  case: "Cas",
  span: (from: string, to: string) => `de ${from} à ${to}`,
  motion: "Vitesse et position",
  position: "Position vers l’avant",
  speed: "Vitesse",
  tangent: "En tirets : la suite à cette vitesse.",
}
