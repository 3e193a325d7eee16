/// Worksheets of the first eight lessons, an activity without a computer for each, and two written tests, in Portuguese.

import type {WorksheetWords} from "../../en/page/worksheets.ts"

export const worksheets: WorksheetWords = {
  labels: {
    sheet: lesson => `Folha: ${lesson}`,
    slides: course => `Slides: ${course}`,
    name: "Nome:",
    answer: "A sua resposta:",
    forTeachers: "Para o professor: respostas",
    unplugged: title => `Sem computador: ${title}`,
    test: number => `Prova ${number}`,
    testLead:
      "20 minutos, no papel, sem computador. Um ponto por pergunta. Marque uma resposta ou escreva um número.",
    marking:
      "Digite as respostas em uma tabela: um nome, a prova e as respostas em ordem, e salve como CSV. `./rosy class marks answers.csv -o marks.csv` conta os pontos. Um número pode variar um pouco onde o gabarito diz.",
  },
  cards: {
    title: "Cartões dos blocos",
    lead: "Cartões para os blocos: em palavras, na cor da sua família, e em Haskell. Os blocos que só ficam dentro de outros e os exemplos grandes não têm. Impressos, oito enchem uma folha; escolha as folhas de que precisa e recorte. Os alunos montam com eles um programa, leem os dos outros e o digitam.",
  },
  poster: {
    title: "A linguagem em uma folha",
    lead: "Os blocos dos cartões com o seu Haskell, para a parede. Enchem uma folha A3 deitada; para A4, deixe a impressora reduzir.",
    roles: {
      event: "Acontece em um momento:",
      state: "Sempre tem um valor:",
      command: "É enviado ao robô:",
    },
  },
  sheets: {
    "hello-robot": {
      tasks: [
        {
          say: "O robô deve estar 3 metros à frente depois de 10 segundos. Que número?",
          answer: "0,3 (no programa 0.3)",
        },
        {
          say: "Desenhe onde está `Velocity (-0.2) 0` depois de 5 segundos, e depois de 10.",
          answer: "1 metro e 2 metros atrás do começo",
        },
      ],
      unplugged: {
        title: "o robô que nunca para",
        steps: [
          "Um aluno é o robô e fica em uma linha. Outro é o programa e segura um cartão: 1 passo por segundo.",
          "A turma conta os segundos em voz alta. O robô faz o que diz o cartão, enquanto houver cartão.",
          "O programa mostra outro cartão: 2 passos, ou 1 passo para trás. Pergunte: quando o robô para? (Quando um cartão diz 0.)",
        ],
      },
    },
    "turn-on-the-spot": {
      tasks: [
        {
          say: "Quanto demora uma volta inteira com `Velocity 0 0.5`? Uma volta inteira é 6,28.",
          answer: "uns 12,6 segundos",
        },
        {say: "Que segundo número gira um quarto (1,57) para a direita em 2 segundos?", answer: "uns −0,79"},
      ],
      unplugged: {
        title: "radianos com um barbante",
        steps: [
          "Em duplas, os alunos desenham um círculo no chão com giz e um barbante preso no meio.",
          "Colocam o mesmo barbante ao longo do círculo e marcam quantas vezes ele cabe: um pouco mais de seis.",
          "Um barbante ao longo do círculo é um radiano. Fiquem no meio e girem um, depois três.",
        ],
      },
    },
    "round-the-box": {
      tasks: [
        {say: "Que raio tem o círculo de `Velocity 0.4 0.2`?", answer: "2 metros (0,4 dividido por 0,2)"},
        {
          say: "Ache outros dois números para o mesmo círculo, com metade da velocidade.",
          answer: "`Velocity 0.2 0.1`",
        },
      ],
      unplugged: {
        title: "andar em círculo",
        steps: [
          "Um aluno dá um passo para a frente e gira um pouco para a esquerda, de novo e de novo. Outros marcam o caminho.",
          "Agora ele gira menos. O círculo fica maior ou menor?",
          "Agora o passo e o giro são ao mesmo tempo: é o que o robô faz.",
        ],
      },
    },
    "light-and-motion": {
      tasks: [
        {
          say: "Escreva o valor para: andar para trás com 0,1, primeira luz laranja.",
          answer: "`(Velocity (-0.1) 0, Led1 Orange)`",
        },
        {
          say: "Um programa tem `Led1 Red` e `Led1 Green` lado a lado. O que há de estranho?",
          answer: "Dois valores para uma luz: um substitui o outro.",
        },
      ],
      unplugged: {
        title: "uma orquestra",
        steps: [
          "Três alunos recebem um cartão cada: bater palmas, bater o pé, cantarolar. Todos começam quando você diz “já”.",
          "Eles ficam em outra ordem e começam de novo. O que mudou? (Nada.)",
          "Dê a um aluno dois cartões que não dá para fazer juntos: sentado, de pé. O que acontece?",
        ],
      },
    },
    faster: {
      tasks: [
        {
          say: "A velocidade é 0, e soma-se 0,01 50 vezes por segundo. Quanto é depois de 1 segundo?",
          answer: "0,5 metro por segundo",
        },
        {say: "Complete: `slower (Velocity vl va) = Velocity (vl ___ 0.01) va`", answer: "`-`"},
      ],
      unplugged: {
        title: "uma máquina de números",
        steps: [
          "Um aluno atrás de uma mesa é uma máquina: um número entra em um bilhete e sai mais 2.",
          "O que sai entra de novo. A turma adivinha o número depois de cinco vezes.",
          "Outras regras: o dobro, um a menos. Qual cresce mais rápido?",
        ],
      },
    },
    "stop-in-time": {
      tasks: [
        {say: "O que `go` dá para x = 0,5, para x = 0,99 e para x = 1?", answer: "0,3, 0,3 e 0"},
        {
          say: "Acrescente uma linha: entre 1 e 1,5 ele anda com 0,1.",
          answer: "`| x < 1.5 = Velocity 0.1 0` como segunda linha",
        },
      ],
      unplugged: {
        title: "a turma decide",
        steps: [
          "Um aluno anda. Depois de cada passo ele diz em voz alta quantos passos foram.",
          "A turma é a função e responde a cada vez: “menos de 5: anda; senão: fica”.",
          "Coloque o aluno dois passos para trás e continue. O que a turma responde agora?",
        ],
      },
    },
    bump: {
      tasks: [
        {say: "O para-choque é pressionado 3 vezes e solto 3 vezes. Quantos eventos?", answer: "6"},
        {
          say: "Evento ou estado: uma batida, a velocidade, um botão, a posição?",
          answer: "evento, estado, evento, estado",
        },
      ],
      unplugged: {
        title: "palma ou nada",
        steps: [
          "Você levanta um cartão e o abaixa. As duas coisas são eventos. A turma responde a cada uma com uma palma.",
          "Regra nova: palma quando o cartão sobe, nada quando desce. “Nada” também é uma resposta.",
          "Quem bate palmas enquanto o cartão está no alto tomou um evento por um estado.",
        ],
      },
    },
    "which-side": {
      tasks: [
        {
          say: "Casos nesta ordem: qualquer lado, lado esquerdo. Quando o segundo é usado?",
          answer: "Nunca: tudo cabe no primeiro.",
        },
        {
          say: "Escreva o padrão para: o para-choque direito é solto.",
          answer: "`Bumper RightBumper Released`",
        },
      ],
      unplugged: {
        title: "o correio",
        steps: [
          "Caixas em fila: “cartas vermelhas”, “cartas para Ada”, “todas as outras”. Uma carta vai para a primeira caixa em que cabe.",
          "Separem dez cartas. Para onde vai uma carta vermelha para Ada?",
          "Ponham “todas as outras” em primeiro lugar e separem de novo. O que há nas outras caixas?",
        ],
      },
    },
  },
  tests: {
    "1": [
      {
        ask: "Até onde o robô chega em 5 segundos, em centímetros?",
        why: "0,3 metro em cada um dos 5 segundos.",
      },
      {
        ask: "Quando ele para sozinho?",
        answers: ["Depois de 1 metro", "Depois de 5 segundos", "Nunca"],
        why: "Uma velocidade vale até vir outra.",
      },
      {
        ask: "Que valor anda em círculo para a direita?",
        answers: ["`Velocity 0.3 0`", "`Velocity 0 (-0.3)`", "`Velocity 0.3 (-0.3)`"],
        why: "Ele anda e gira para a direita ao mesmo tempo.",
      },
      {
        ask: "O que este programa faz?",
        answers: ["Anda, depois vem a luz", "As duas coisas desde o começo", "Só a luz"],
        why: "Os valores ficam lado a lado.",
      },
      {
        ask: "Quantas vezes se pergunta se `x < 1`?",
        answers: ["Uma vez, no começo", "A cada aviso do robô", "Quando ele chega"],
        why: "Uma função de um estado é chamada de novo e de novo.",
      },
      {
        ask: "O robô bate 3 vezes e se solta a cada vez. Quantos sons?",
        why: "Pressionado e solto são dois eventos, três vezes.",
      },
      {
        ask: "O que o robô faz na parede?",
        answers: ["Continua empurrando", "Anda para trás", "Para"],
        why: "`go` é enviado de novo e de novo e substitui o que `back` enviou.",
      },
      {
        ask: "Quando `back` responde?",
        answers: [
          "Quando uma batida e um buraco aconteceram",
          "A cada batida e a cada mudança do chão",
          "Só ao primeiro que vier",
        ],
        why: "`Either` é um ou outro, a cada vez.",
      },
    ],
    "2": [
      {
        ask: "O para-choque é pressionado 3 vezes. Que número há então na memória?",
        why: "Ela começa com 0, e soma-se 2 cada vez que ele é pressionado.",
      },
      {
        ask: "O que o robô faz depois de uma batida?",
        answers: ["Anda para trás", "Para", "Segue em frente como antes"],
        why: "`drive` não olha a memória.",
      },
      {
        ask: "O que o robô faz no começo?",
        answers: ["Anda para a frente", "Anda para trás", "Gira"],
        why: "A memória começa com o primeiro caso.",
      },
      {
        ask: "O que o programa faz no segundo depois de uma batida?",
        answers: ["Espera um segundo", "Compara o relógio de novo e de novo", "Nada"],
        why: "Nada espera; o relógio decide.",
      },
      {
        ask: "Um programa com `StdGen` é executado duas vezes com a mesma semente. O que muda?",
        answers: ["Nada", "Tudo", "Só o primeiro giro"],
        why: "A mesma semente dá os mesmos números.",
      },
      {
        ask: "Quando começa `turn 90`?",
        answers: ["Ao mesmo tempo que `drive`", "Quando `drive 100` terminou", "Depois de um segundo"],
        why: "Os passos de uma tarefa vêm um depois do outro.",
      },
      {
        ask: "Quantos cantos tem a figura que o robô percorre?",
        why: "Cinco vezes 72 graus é uma volta inteira.",
      },
      {
        ask: "Quando este programa termina?",
        answers: ["Depois de 5 metros", "Quando as duas tarefas terminaram", "Depois de 4 segundos"],
        why: "`race` termina com a primeira; 5 metros demoram mais.",
      },
    ],
  },
}
