/// What the pages for teachers say besides the lessons' own texts, in Portuguese.

import type {TeachingWords} from "../../en/page/teaching.ts"

export const teaching: TeachingWords = {
  labels: {
    about: (minutes, week) => `Uns ${minutes} minutos · semana ${week}`,
    optional: (minutes, week) => `Uns ${minutes} minutos · opcional, a partir da semana ${week}`,
    aims: "O que os alunos sabem depois",
    steps: "O que se pede",
    step: "passo",
    rightAnswer: "resposta certa, ou o que é verificado",
    begins: "A lição começa com este programa",
    ask: "Perguntas para fazer",
    wrong: "O que dá errado",
    nearMisses: "Algumas tentativas que não passam, com as linhas que importam e o que a página diz delas:",
    says: (check, seen) => `“${check}” não está feito. ${seen}`,
    solutions: "Soluções que passam",
    others: "Estas também passam:",
  },
  plan: {
    title: "Doze semanas",
    lead: "Um plano para um semestre com um encontro de 45 minutos por semana. Os alunos fazem as lições da página sozinhos ou em duplas; o resto do tempo é para conversar, para o papel e para os projetos. Com dois encontros por semana, o segundo é de um projeto.",
    columns: ["semana", "lições", "do que trata", "preparar", "juntos e no papel"],
    handbook: "45 minutos juntos",
    weeks: [
      "Iniciar a turma; três palavras para cada aluno. Imprimir a folha.",
      "Uma caixa ou uma mochila no chão, para andar em volta.",
      "Um metro de fita no chão.",
      "Nada; os alunos batem palmas.",
      "O projetor, para **Por quê?**.",
      "Um brinquedo para levantar, se houver. Escolher os projetos.",
      "Prova 1 no papel, 20 minutos. Um bilhete e um lápis como “memória”.",
      "Três cartões: Go, Back, Turn.",
      "Um dado por dupla.",
      "Uma receita de cozinha.",
      "Dois alunos que fazem coisas ao mesmo tempo.",
      "Prova 2, o concurso, e os projetos são mostrados.",
    ],
    strand: (page, week) =>
      `**Com matemática:** a partir da semana ${week} pode entrar a série [Álgebra](${page}), também na aula de matemática:`,
    after: projects =>
      `**Se o tempo for curto:** deixe de fora a terceira lição das semanas 6, 8, 9 e 11. **Se a turma for rápida:** comece os [projetos](${projects}) na semana 5. Uma lição que não terminou se abre da próxima vez no mesmo passo.`,
  },
  curricula: {
    title: "O que a escola deve ensinar",
    lead: "Frases dos currículos, como estão escritas e na sua língua, e as lições da página em que os alunos fazem o que elas pedem. *Em parte* quer dizer que as lições não ensinam tudo. Aqui só está o que se pôde citar, e a escolha das lições é nossa: nenhuma autoridade a conferiu. Os currículos mudam: compare cada frase com a edição em vigor antes de se apoiar nela.",
    columns: ["onde", "frase", "lições"],
    part: "em parte",
    all: "todas as lições",
    incomplete: "O que este documento diz da programação em cada ano não pôde ser citado; falta aqui.",
    places: {
      csta: "Estados Unidos",
      england: "Inglaterra",
      kmk: "Alemanha",
      "baden-7": "Alemanha: Baden-Württemberg, 7º ano",
      baden: "Alemanha: Baden-Württemberg, Gymnasium",
      "cycle-4": "França: 7º a 9º ano (cycle 4)",
      snt: "França: 10º ano (seconde)",
      spain: "Espanha",
      portugal: "Portugal",
    },
  },
  lessons: {
    "hello-robot": {
      often: "Os alunos esperam o fim do programa. Não há fim: uma velocidade vale até vir outra.",
      ask: [
        "Onde ele está depois de 10 segundos?",
        "Quando ele para?",
        "Que número você muda para ir duas vezes mais longe?",
      ],
    },
    "turn-on-the-spot": {
      often: "O segundo número é lido como graus. São radianos por segundo: 3,14 é meia volta.",
      ask: [
        "A esquerda é a sua ou a do robô?",
        "Quanto demora uma volta inteira com 0,5?",
        "O que faz um sinal de menos?",
      ],
    },
    "round-the-box": {
      often:
        "Os alunos esperam uma esquina: primeiro reto, depois a curva. Os dois números valem ao mesmo tempo.",
      ask: [
        "O que deixa o círculo maior?",
        "Dois pares de números, o mesmo círculo: quais?",
        "Qual é o círculo com 0 como segundo número?",
      ],
    },
    "light-and-motion": {
      often: "O segundo valor é tomado por um segundo passo. Lado a lado quer dizer ao mesmo tempo.",
      ask: [
        "A ordem importa?",
        "O que faz um programa com duas velocidades?",
        "O que você consegue fazer ao mesmo tempo?",
      ],
    },
    faster: {
      often: "`vl + 0.02` parece uma velocidade de 0,02. É o que se soma, 50 vezes por segundo.",
      ask: [
        "O que a função recebe, e o que ela dá?",
        "Quantas vezes ela é chamada?",
        "O que faria `vl - 0.02`?",
      ],
    },
    "stop-in-time": {
      often: "Pensa-se que a escolha é feita uma vez, no começo. Ela é feita de novo a cada aviso do robô.",
      ask: [
        "Quanto vale `x` agora, e agora?",
        "O que acontece se você levar o robô para trás?",
        "Por que não `x == 2`?",
      ],
    },
    bump: {
      often: "Uma batida são dois eventos, pressionado e solto; por isso há dois sons.",
      ask: [
        "Quantos eventos foram?",
        "O que `Nothing` envia?",
        "Qual é a diferença entre `Nothing` e uma luz apagada?",
      ],
    },
    "which-side": {
      often: "Um caso em que tudo cabe vem primeiro, e os outros nunca são usados.",
      ask: ["Em que caso este evento cabe?", "E se couber em dois casos?", "O que quer dizer `_` aqui?"],
    },
    "two-wills": {
      often:
        "Os alunos trocam as funções de lugar: a última deve ganhar. O que conta é quem envia por último.",
      ask: [
        "Quem enviou o que o robô faz agora?",
        "Quantas vezes cada uma envia?",
        "Como você decidiria entre dois amigos que dão ordens?",
      ],
    },
    "remote-control": {
      often: "Espera-se que o robô pare quando o botão é solto. Ninguém disse isso a ele.",
      ask: [
        "Que evento é soltar?",
        "Como seria um controle que só anda enquanto você aperta?",
        "O que o robô faz sem nenhum comando?",
      ],
    },
    "one-or-the-other": {
      often: "`Either` é lido como “quando os dois aconteceram”. A função responde a cada um quando ele vem.",
      ask: ["Qual dos dois foi?", "Como a função vê a diferença?", "O que mudaria com duas funções?"],
    },
    "lift-me": {
      often: "No ar só a luz muda. As rodas precisam de um comando próprio.",
      ask: [
        "O que nunca pode acontecer?",
        "Quem pode ligar as rodas de novo?",
        "Que máquinas da sua casa param quando são abertas?",
      ],
    },
    "wire-a-reflex": {
      often:
        "Espera-se que o segundo fio ao mesmo atuador ganhe. Os dois enviam; algo precisa dizer qual vai primeiro.",
      ask: [
        "Quais sensores chegam às rodas?",
        "O que está no diagrama, e o que só na função?",
        "Onde começaria um terceiro fio para `Velocity`, e quem deveria ir primeiro então?",
      ],
    },
    "stop-before-the-wall": {
      often: "A distância livre à frente é confundida com o caminho andado. Uma diminui, o outro aumenta.",
      ask: [
        "Para que lado vai o número?",
        "E se a parede se mover?",
        "Como parar a 10 cm de uma parede, comece onde começar?",
      ],
    },
    "count-the-bumps": {
      often:
        "Soltar também é contado, ou espera-se o número novo na hora. A função lê o valor antigo e envia o novo.",
      ask: [
        "O que há na memória antes da primeira batida?",
        "O que ela lê na terceira batida?",
        "Por que ele diz 2, 4, 6?",
      ],
    },
    "there-and-back": {
      often: "Espera-se que `bump` vire o robô. Ela só escreve; `drive` precisa ler.",
      ask: ["Quem escreve, quem lê?", "As duas se conhecem?", "O que `drive` faz antes de algo ser escrito?"],
    },
    "a-mode-of-my-own": {
      often: "Um caso novo entra no tipo, e uma das funções não o conhece.",
      ask: [
        "Em que lugares cada modo aparece?",
        "Desenhe os modos como círculos: que setas há?",
        "`Mode` é um valor ou uma lista de valores?",
      ],
    },
    "for-one-second": {
      often:
        "Os alunos procuram um comando que espere. Nada espera; o relógio é comparado de novo e de novo.",
      ask: [
        "O que é lembrado: uma hora ou uma duração?",
        "O que faz uma batida durante esse segundo?",
        "Como fazer meio segundo?",
      ],
    },
    "three-states": {
      often: "O estado é procurado em uma função. Ele está na memória; as funções leem e escrevem nela.",
      ask: [
        "Que seta falta à máquina?",
        "Desenhe os três estados como círculos: que sensor está em que seta?",
        "O que faz o botão em `Go`?",
      ],
    },
    "my-own-event": {
      often:
        "A resposta é escrita duas vezes, uma por sensor. Um evento com dois emissores precisa de uma resposta.",
      ask: [
        "Quem envia `Blocked`, e quem o recebe?",
        "O que muda com um terceiro sensor?",
        "Como se chama o seu evento?",
      ],
    },
    chance: {
      often:
        "Espera-se que o acaso seja diferente a cada vez. A mesma semente dá a mesma execução, que por isso pode ser vista de novo.",
      ask: [
        "Por que é bom poder repetir uma execução?",
        "O que a função faz com o gerador que recebe de volta?",
        "Em que sala uma regra fixa é melhor?",
      ],
    },
    "a-recipe": {
      often: "Escrevem-se metros onde são centímetros: `drive 1` é um centímetro.",
      ask: [
        "Quando começa o segundo passo?",
        "Quando o programa termina?",
        "O que é diferente de duas funções lado a lado?",
      ],
    },
    "four-times": {
      often:
        "Os passos são copiados quatro vezes, e uma cópia é mudada. Um pedaço com nome se muda em um só lugar.",
      ask: ["O que se repete?", "Quanto ele gira ao todo?", "Que ângulo faz um triângulo?"],
    },
    "look-inside": {
      often: "Espera-se que `Done` pare o robô. Ele termina a tarefa; a última velocidade continua valendo.",
      ask: [
        "O que começa, o que vigia, o que termina?",
        "Quem para as rodas?",
        "O que nunca enviaria `Done`?",
      ],
    },
    "a-task-that-answers": {
      often: "Ele diz o texto “distance” em vez do número, ou metros em vez de centímetros.",
      ask: ["De onde vem o resultado?", "Ele pode mudar depois?", "Como você acharia a área da sala?"],
    },
    "at-the-same-time": {
      often: "Usa-se `parallel` onde uma deve desistir: ele espera as duas.",
      ask: [
        "Qual das duas termina primeiro?",
        "O que acontece com a outra?",
        "Quando você quer a primeira, quando as duas?",
      ],
    },
    "the-papers-robot": {
      often:
        "A segurança e a curiosidade enviam às rodas ao mesmo tempo. O que importa mais deve segurar o outro.",
      ask: ["O que deve ganhar sempre?", "Por quanto tempo?", "Tente outra sala: o que foi sorte?"],
    },
    "a-machine-for-numbers": {
      often: "A letra é tomada por um só número. `x` é cada lugar do caminho, um depois do outro.",
      ask: [
        "Que saída corresponde à entrada 2?",
        "Que entrada dá 0?",
        "Duas entradas podem ter a mesma saída? Uma pode ter duas?",
      ],
    },
    "where-the-graph-meets-zero": {
      often:
        "O gráfico é tomado pelo caminho do robô. À direita está o lugar, para cima a velocidade; o caminho está na sala.",
      ask: [
        "Que equação o robô resolveu?",
        "O que faz um gráfico mais inclinado?",
        "Leve o robô além do zero: para onde ele vai?",
      ],
    },
    "a-graph-in-pieces": {
      often:
        "As condições são lidas como se cada uma estivesse sozinha. `x < 2` também vale em 0,5; ali não conta, porque serve um caso anterior.",
      ask: [
        "Para que `x` vale cada regra?",
        "Onde dois pedaços se encontram, e onde há um salto?",
        "Há uma entrada sem saída?",
      ],
    },
    "machines-in-a-row": {
      often:
        "`speed . distance` é lido da esquerda. A máquina da direita trabalha primeiro: `speed (distance here)`, como em f(g(x)).",
      ask: [
        "O que passa de uma máquina para a outra?",
        "Dá para trocar a ordem? O que dizem os tipos?",
        "Que máquina muda se o círculo muda de lugar?",
      ],
    },
    "a-family-of-functions": {
      often:
        "`a` e `x` são letras e se confundem. `x` muda enquanto o robô anda; `a` é escolhido uma vez e fica.",
      ask: [
        "O que todas da família têm em comum?",
        "O que acontece com `a` negativo?",
        "Que letra é a entrada e quais são parâmetros?",
      ],
    },
    "rate-of-change": {
      often:
        "Leem posição e velocidade na mesma curva. Posição horizontal é velocidade 0; velocidade horizontal é posição que sobe por igual.",
      ask: [
        "Como se vê na posição quando ele foi mais rápido?",
        "O que significa uma posição que desce?",
        "O que diz a área sob a velocidade?",
      ],
    },
  },
}
