/// Words of the graph of a function, and of speed and position over time, in Portuguese.

export const graph = {
  functions: "Gráfico de uma função",
  of: (name: string) => `Gráfico de ${name}`,
  notRun: "Execute o programa: cada resposta da função é um ponto.",
  noNumbers: "O que esta função recebeu ou deu não é um número: ela não tem gráfico.",
  partial: "São os pontos desde que o gráfico foi aberto. Execute outra vez para ter todos.",
  input: "Entrada",
  output: "Saída",
  now: "agora",
  table: "Os pontos em tabela",
  case: "Caso",
  span: (from: string, to: string) => `de ${from} a ${to}`,
  motion: "Velocidade e posição",
  position: "Posição para a frente",
  speed: "Velocidade",
  tangent: "Tracejado: como seguiria nesta velocidade.",
}
