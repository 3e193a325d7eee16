/// Desafios: a lista e as estrelas de uma tentativa.

import type {Words} from "../../../editor/src/words/index.ts"

export const challenges: Words["challenges"] = {
  title: "Desafios",
  lead: "Uma meta, até três estrelas. Vale a sua melhor tentativa.",
  loading: "Procurando os desafios…",
  failed:
    "Não foi possível carregar os desafios. O serviço do Rosy não responde; tente de novo daqui a pouco.",
  number: n => `Desafio ${n}`,
  leave: "Sair do desafio",
  stars: (earned, all) => `Estrelas: ${earned} de ${all}`,
  best: "Sua melhor tentativa:",
  thisRun: (earned, all) => `Esta tentativa: ${earned} de ${all} estrelas.`,
  allStars: "São todas!",
  /// `text` is what is missing, as the challenge says it.
  next: text => `Para mais uma estrela: ${text}.`,
  nextChallenge: "Próximo desafio",
}
