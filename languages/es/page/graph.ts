/// Words of the graph of a function, and of speed and position over time, in Spanish.

export const graph = {
  functions: "Gráfica de una función",
  of: (name: string) => `Gráfica de ${name}`,
  notRun: "Ejecuta el programa: cada respuesta de la función es un punto.",
  noNumbers: "Lo que esta función recibió o dio no es un número: no tiene gráfica.",
  partial: "Son los puntos desde que se abrió la gráfica. Ejecuta otra vez para tenerlos todos.",
  input: "Entrada",
  output: "Salida",
  now: "ahora",
  table: "Los puntos como tabla",
  case: "Caso",
  span: (from: string, to: string) => `de ${from} a ${to}`,
  motion: "Velocidad y posición",
  position: "Posición hacia delante",
  speed: "Velocidad",
  tangent: "A trazos: cómo seguiría a esta velocidad.",
}
