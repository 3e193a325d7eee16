/// The sentences and labels of the page in Portuguese.

import type {Words} from "../../../editor/src/words/index.ts"
import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, count} = measuresOf("pt-BR")

export const page: Omit<
  Words,
  | "backpack"
  | "blocks"
  | "challenges"
  | "classroom"
  | "world"
  | "recordings"
  | "companions"
  | "diagram"
  | "film"
  | "graph"
  | "replies"
  | "roomTests"
  | "preview"
  | "runs"
  | "keys"
  | "lessons"
  | "lessonEditor"
  | "twin"
  | "welcome"
  | "why"
  | "blockly"
> = {
  rosy: "Rosy",
  run: "Executar",
  stop: "Parar",
  runHint: "Executar (Ctrl+Enter)",
  stopHint: "Parar (Espaço)",
  reset: "Reiniciar",
  resetHint: "Pôr o robô de volta no começo",
  sameAgain: "A mesma execução de novo",
  sameAgainHint: "A mesma execução de novo: com o mesmo acaso nos dados e nas rodas que escorregam",
  pause: "Pausar",
  resume: "Continuar",
  continueHere: "Continuar daqui",
  continueHint: "Continua a partir deste momento, com o programa como ele está agora",
  forward: "Um passo (0,02 s)",
  stepBefore: "Passo anterior: onde uma função começou",
  stepAfter: "Próximo passo: onde uma função começa",
  lookBack: "Olhar para trás na execução",
  saveTable: "Salvar como tabela (CSV)",
  noRun: "Execute o programa para ver os valores dele.",
  chartedValues: "Valores para desenhar",
  chartSpan: "Tempo para desenhar",
  chartSpans: {20: "20 s", 60: "1 min", all: "Tudo"},
  remembers: "O programa lembra",
  robotValues: "O robô",
  time: "Tempo",
  quantities: {
    speed: "Velocidade",
    turning: "Giro",
    x: "x",
    y: "y",
    heading: "Direção",
    believedX: "x imaginado",
    believedY: "y imaginado",
    believedHeading: "Direção imaginada",
  },
  readout: {
    time: "tempo",
    heading: "direção",
    speed: "velocidade",
    bumpers: "para-choque",
    cliffs: "sensores de chão",
    wheels: "rodas",
    led1: "LED 1",
    led2: "LED 2",
  },
  sides: {left: "esquerda", centre: "meio", right: "direita"},
  senses: {
    bumper: ["pressionado", "solto"],
    cliff: ["buraco", "chão"],
    wheel: ["no ar", "no chão"],
    button: ["pressionado", "solto"],
  },
  led: n => `LED ${n}`,
  speed: "Velocidade",
  fastest: "máx.",
  examples: "Exemplos",
  undo: "Desfazer",
  redo: "Refazer",
  menu: "Mais",
  programName: "Nome do programa",
  unnamed: "meu programa",
  yourProgram: "Seu programa",
  saved: {saved: "salvo", changed: "salvando…", failed: "não foi salvo"},
  view: "Vista",
  views: {blocks: "Blocos", both: "Blocos + Haskell", haskell: "Haskell", diagram: "Diagrama"},
  regions: {blocks: "Blocos", haskell: "Haskell", diagram: "Diagrama", room: "Sala"},
  region: "Mostrar",
  canvasHeight: "Altura da sala",
  arrange: {
    title: "Organizar",
    hint: "Ponha blocos, Haskell e sala onde você quiser",
    choices: "Onde cada coisa fica",
    beside: (one, other) => `${one} ao lado de ${other}`,
    below: (one, other) => `${one} acima de ${other}`,
    shown: "O que você vê",
    reset: "Como no começo",
    how: "Arraste os pontos no alto de uma parte, ou a borda entre duas.",
    move: region => `Mover ${region}`,
    moveHint: "Arraste para outro lugar. As setas do teclado levam a parte para aquele lado.",
    hide: region => `Esconder ${region}`,
    border: (one, other) => `Borda entre ${one} e ${other}`,
  },
  room: "Sala",
  worldName: "Sala para andar",
  ownWorld: "sala própria",
  soundOn: "O som está ligado",
  soundOff: "O som está desligado",
  clock: "Tempo da execução",
  tabs: {console: "Saída", charts: "Gráficos", runs: "Execuções", sensors: "Valores", problems: "Problemas"},
  emptyConsole: "Aqui aparece o que o robô percebe e diz.",
  moreEvents: n => count(n, {one: "Mostrar mais um evento", other: k => `Mostrar mais ${k} eventos`}),
  fewerEvents: "Mostrar só os eventos mais importantes",
  noProblems: "Nenhum problema.",
  times: n => `×${n}`,
  plays: "toca",
  pastedText: "O texto colado",
  newName: old => `Novo nome para ${old}`,
  rename: "Mudar o nome",
  format: "Arrumar o Haskell",
  editor: {
    Find: "Procurar",
    Replace: "Trocar por",
    next: "Próximo",
    previous: "Anterior",
    all: "Selecionar tudo",
    "match case": "Diferenciar Aa",
    "by word": "Palavras inteiras",
    regexp: "Padrão",
    replace: "Trocar",
    "replace all": "Trocar tudo",
    close: "Fechar",
    "current match": "encontrado aqui",
    "replaced $ matches": "$ lugares mudados",
    "replaced match on line $": "um lugar mudado na linha $",
    "on line": "na linha",
    Diagnostics: "Problemas",
    "No diagnostics": "Nenhum problema",
    Completions: "O que cabe aqui",
    "Control character": "Caractere invisível",
  },
  showIt: "Mostrar",
  nothingToRun: "Nada é executado ainda. Escolha um bloco para `simulate` e pressione Executar.",
  nothingRuns: name => `Nada é executado ainda. Executar \`${name}\`?`,
  runIt: name => `Executar ${name}`,
  readMore: "Ler mais",
  fromToolbox: "Da caixa de ferramentas",
  writeType: signature => `Escrever o tipo: ${signature}`,
  compilerSays: "O que o compilador disse",
  givenInputs: "Recebeu",
  atTime: time => `aos ${seconds(time, 2)}`,
  close: "Fechar",
  newProgram: "Novo programa",
  openFile: "Abrir um arquivo…",
  saveFile: "Salvar como arquivo",
  saveHaskell: "Salvar o Haskell",
  share: {
    menu: "Compartilhar ou imprimir…",
    title: "Compartilhar",
    lead: "O link contém o programa inteiro e a sala dele. Nada é enviado para a internet.",
    making: "Preparando o link…",
    reach: {
      network:
        "O endereço desta página leva só a este computador. O link tem em vez disso o endereço dele na rede: outras pessoas podem abri-lo enquanto o Rosy estiver em execução aqui.",
      computer:
        "Este link leva só a este computador. Para outras pessoas salve o programa como arquivo, ou inicie o Rosy com `--host 0.0.0.0` e compartilhe de novo.",
    },
    link: "Link",
    copy: "Copiar",
    copied: "Copiado.",
    notCopied: "Aperte Ctrl+C para copiar.",
    code: "O link como QR code",
    codeHint: "O QR code contém o programa e a sala dele, mas não os lugares dos blocos.",
    noCode: "Este programa é comprido demais para um QR code. No link ele cabe.",
    embed: "Para pôr em uma página sua",
    page: "Salvar uma página que funciona em qualquer lugar",
    pageHint:
      "Um só arquivo com os blocos, o Haskell e o filme da última execução. Ele abre sem o Rosy, de um disco ou de um site.",
    pageWithoutFilm:
      "Um só arquivo com os blocos e o Haskell. Execute primeiro o programa, e ele terá também o filme da execução.",
    print: "Imprimir blocos e Haskell",
    openInRosy: "Abrir no Rosy",
  },
  sharedPage: {
    film: "A última execução",
    noFilm: "O programa ainda não tinha sido executado quando esta página foi feita.",
    olderFilm: "O filme mostra o programa antes das últimas mudanças.",
    play: "Reproduzir",
    reach: {
      network:
        "O link funciona para outras pessoas na mesma rede, enquanto o Rosy estiver em execução no computador onde esta página foi feita.",
      computer:
        "O link só funciona no computador onde esta página foi feita, enquanto o Rosy estiver em execução nele.",
    },
    made: version => `Feito com Rosy ${version}`,
  },
  driveByHand: "Dirigir à mão (ROS)",
  help: {
    title: "Os nomes do próprio Haskell",
    lead: "Todo programa em Haskell conhece estes nomes. Cada um está aqui com o seu tipo e um exemplo.",
  },
  guide: {
    menu: "Guia",
    teachers: "Para professores",
    isEnglish: "Esta página do guia existe só em inglês.",
    more: "Ler mais no guia",
  },
  about: version => `Sobre o Rosy ${version}: licenças`,
  language: "Idioma",
  theme: "Cores",
  themes: {auto: "Como no sistema", light: "Claro", dark: "Escuro"},
  galleryTitle: "Exemplos",
  galleryLead: "Abra um, execute, mude. O seu próprio programa fica guardado.",
  galleryLoading: "Procurando os exemplos…",
  galleryFailed:
    "Não deu para carregar os exemplos. O serviço do Rosy não responde; tente de novo daqui a pouco.",
  exampleLevels: {
    start: "Primeiros passos",
    react: "Reagir e lembrar",
    tasks: "Uma coisa depois da outra",
    large: "Programas maiores",
  },
  otherExamples: "Mais exemplos",
  moreAbout: title => `O que ${title} ensina`,
  again: "Tentar de novo",
  myPrograms: {
    title: "Meus programas",
    lead: "Este navegador guarda todo programa que você muda.",
    none: "Mude um exemplo ou comece um novo programa, e ele fica guardado aqui.",
    open: "aberto agora",
    rename: name => `Mudar o nome de ${name}`,
    newName: name => `Novo nome para ${name}`,
    duplicate: name => `Duplicar ${name}`,
    remove: name => `Apagar ${name}`,
    removed: name => `${name} foi apagado.`,
    undo: "Desfazer",
    deleted: "Programas apagados",
    restore: name => `Recuperar ${name}`,
    restoreShort: "Recuperar",
  },
  invite: {
    change: "Mude",
    from: "+",
    to: "para",
    into: "-",
    after: "e execute de novo. Para que lado o robô anda agora?",
  },
  haskellPane: "O programa em Haskell",
  haskellKeys: "Esc e depois Tab saem do texto. F8 vai ao próximo problema.",
  blocksPane: "O programa em blocos",
  link: {
    connecting: "Procurando o robô…",
    lost: "A conexão com o Rosy caiu. Ela volta sozinha; o seu programa está guardado.",
  },
  programComing:
    "Os blocos estão a caminho. A primeira vez é a mais demorada; depois o seu navegador os guarda.",
  worker: {
    starting: "O programa que lê Haskell está começando.",
    restarting:
      "O programa que lê Haskell está recomeçando. O seu trabalho está guardado; execute de novo daqui a pouco.",
  },
  queued: place =>
    place === 1
      ? "A sala está cheia. O seu programa é o próximo."
      : `A sala está cheia. ${count(place - 1, {one: "Um programa está", other: n => `${n} programas estão`})} na frente do seu.`,
  roomLabel: world =>
    `A sala ${world} vista de cima, com o robô dentro. Durante a execução, as setas movem o robô, vírgula e ponto o giram, e B pega uma coisa para empurrar; mais e menos mudam o zoom, e F segue o robô. W pergunta por que ele se move assim, e P por que ele está lá.`,
  sight: "Como ver a sala",
  follow: "Seguir o robô",
  followHint: "Seguir o robô (F)",
  closer: "Mais perto",
  further: "Mais longe",
  wholeRoom: "A sala inteira",
  sightMenu: "Rastro, imagem e filme",
  trail: "Rastro",
  trails: {plain: "Uma cor", speed: "Velocidade", time: "Tempo"},
  trailEnds: {speed: ["devagar", "rápido"], time: ["começo", "agora"]},
  savePicture: "Salvar uma imagem",
  startFilm: "Começar um filme",
  endFilm: "Terminar o filme",
  robots: {
    title: "Qual robô?",
    lead: "O mesmo programa funciona em cada um deles.",
    choose: "Escolher um robô",
    simulated: "Robô simulado",
    simulatedShort: "Simulado",
    simulatedHint: "Ele vive na sala desta página, e nada pode quebrar.",
    free: "livre",
    has: who => `${who} está com ele`,
    domain: domain => `domínio ${domain} do ROS 2`,
    charge: percent => `bateria ${percent}%`,
    volts: volts => `bateria ${short(volts, 1)} V`,
    several: "vários robôs nos mesmos tópicos: dê a cada um um namespace",
    discovers: "Um robô no ROS 2 que é ligado nesta rede aparece aqui sozinho.",
    yours: "você está com ele",
    who: "O seu nome, para os outros verem",
    locked: "Os robôs estão bloqueados. A pessoa que iniciou o Rosy pode dizer o código a você.",
    code: "Código",
    unlock: "Abrir",
    take: "Pegar",
    leave: "Soltar",
    leaveHint: "O robô fica parado, e outras pessoas podem pegá-lo",
    link: {connecting: "Procurando…", connected: "Conectado", lost: "Perdido, procurando…"},
    safetyOn: "Recua sozinho",
    safetyOnHint: "Ele recua de paredes e buracos antes de o seu programa poder andar de novo.",
    safetyOff: "Não recua",
    safetyOffHint:
      "As regras de segurança estão desligadas: cuide do caminho dele. O escudo acima da sala as liga.",
    backing: "Recuando…",
    limits: speed => `no máximo ${short(speed, 2)} m/s`,
    estop: "Parada de emergência",
    estopHint: "Parar o robô na hora (Espaço)",
    stopped: "Ele foi parado e não anda.",
    letDrive: "Deixar andar de novo",
    region: name => `O robô ${name}`,
    floor: name => `O caminho do robô ${name}, como ele mesmo o mede; mais e menos mudam o zoom.`,
  },
  topics: {
    title: "Mensagens à mão",
    send: "Enviar",
    runFirst: "Aperte primeiro Executar: só um programa em execução recebe mensagens",
    ofRobot: topic => `O próprio robô envia as mensagens em ${topic}.`,
    computed: type =>
      `O programa calcula o nome do tópico de ${type}, por isso não há formulário para ele: escreva o nome como um só texto.`,
  },
  safety: {
    name: "Regras de segurança",
    on: "As regras de segurança estão ligadas: o robô recua de paredes e buracos antes de o seu programa continuar, aqui e em robôs de verdade",
    off: "As regras de segurança estão desligadas: só o seu programa dirige, aqui e em robôs de verdade",
    overrides: "Regras de segurança: recuando…",
    tookOver: "As regras de segurança assumem: recuando",
  },
  blocked: {
    pushes: "O robô está empurrando alguma coisa e não consegue seguir.",
    withBumper: "Uma função com Bumper como entrada pode desviá-lo.",
    withoutBumper: "Ele não tem para-choque desse lado: faça-o ir por outro caminho.",
  },
  goals: "Metas",
  goalStates: {open: "falta", done: "feita", missed: "perdida"},
  hands: "Tocar no robô",
  robotButton: n => `Apertar o botão ${n} do robô`,
  holdsThing: (kind, n) =>
    `${kind === "box" ? "Caixa" : "Tambor"} ${n}: as setas do teclado empurram. Esc pega o robô de novo.`,
  lift: "Levantar",
  liftHint: "Levantar o robô do chão, e pôr de volta",
  doing: {
    lookingBack: "Olhando para trás",
    standing: "Em pausa",
    ready: "Pronto",
    waiting: "Esperando",
    queued: "Esperando",
    compiling: "Começando",
    running: "Executando",
  },
  ended: {
    done: "Terminado",
    error: "Terminado por um problema",
    stuck: "Terminado por um problema",
    hole: "Parado em um lugar vazio",
    stopped: "Parado",
    time: "O tempo acabou",
    refused: "Não começou",
    lost: "Conexão perdida",
  },
  notices: {
    diverged: {
      message: time => `O seu programa mudado faz outra coisa a partir dos ${time}.`,
      hint: "Ele foi executado do começo até o momento que você escolheu.",
    },
    uncompared: {
      message: time => `Depois de ${time} não se sabe se o seu programa mudado faz outra coisa.`,
      hint: "Os comandos de uma execução ficam guardados por cerca de uma hora.",
    },
    notText: {
      message: name => `${name} não contém texto.`,
      hint: "O Rosy abre programas: arquivos que terminam em .rosy ou .hs.",
    },
    olderEncoding: {
      message: ({name, encoding, number, line}) =>
        `${name} está na codificação ${encoding}, não em UTF-8: veja a linha ${number}, “${line.trim()}”.`,
      hint: "Se a linha estiver certa, leia o arquivo assim. O Rosy o salva em UTF-8.",
      readAs: encoding => `Ler como ${encoding}`,
    },
    emptyFile: {
      message: name => `${name} está vazio.`,
      hint: "Não há nele nenhum programa para abrir.",
    },
    confusable: {
      message: (name, n, {character, plain, name: called}) =>
        `${name}: ${count(n, {one: "um caractere parece certo e não é", other: k => `${k} caracteres parecem certos e não são. O primeiro`})}: ${plain.trim() === "" ? `um que não se vê (${called})` : `‘${character}’ (${called}) no lugar de ‘${plain}’`}.`,
      hint: "Comentários e textos entre aspas ficam como estão.",
      repair: "Consertar",
    },
    severalPrograms: {
      message: (name, n) => `${name} tem ${n} programas.`,
      hint: unread =>
        unread === 0
          ? "Escolha um."
          : `Escolha um. ${count(unread, {one: "Mais um não pôde ser lido", other: n => `Mais ${n} não puderam ser lidos`})}.`,
    },
    noPrograms: name => `Não há programas em ${name}.`,
    tooManyFiles: {
      message: name => `${name} tem coisas demais.`,
      hint: "O Rosy olha no máximo 2.000 arquivos e 20 milhões de letras. Solte aqui a pasta em que está o seu programa.",
    },
    damagedArchive: {
      message: name => `${name} não pode ser descompactado.`,
      hint: "Está danificado ou tem senha. Descompacte-o no seu computador e solte aqui a pasta.",
    },
    notProgram: name => `${name} não é um programa.`,
    tooLarge: {
      message: name => `${name} é grande demais.`,
      hint: "Um programa tem no máximo 200.000 letras. O seu continua aberto.",
    },
    notWorld: name => `${name} não é uma sala que o Rosy possa usar.`,
    exampleMissing: {
      message: name => `Não existe o exemplo ${name}.`,
      hint: "Exemplos, no alto, mostra os que existem.",
    },
    noFilm: {
      message: "O filme está vazio.",
      hint: "Comece o filme enquanto o robô anda, e termine mais tarde.",
    },
    filmFailed: {
      message: "O filme não pôde ser feito.",
      hint: "Deixe o programa em execução um pouco ou tente o outro tipo de filme.",
    },
    noReader: {
      message: "Falta uma parte da página.",
      hint: "Recarregue a página; nada do que é seu se perde.",
    },
    notFormatted: {
      message: left =>
        count(left, {
          one: "Uma definição ficou como está.",
          other: n => `${n} definições ficaram como estão.`,
        }),
      hint: "Ainda não está tudo pronto, ou algo se perderia ao arrumar.",
    },
    otherMeaning: {
      message: name =>
        `O texto Haskell de ${name} não consegue dizer exatamente esta mudança nos blocos. A mudança não foi feita.`,
      hint: "Faça a mudança no texto Haskell ou monte este lugar de outro jeito.",
    },
    groupedOtherwise: {
      message: name =>
        `Depois dessa mudança, o compilador não agrupa o texto Haskell de ${name} como os blocos. O programa está de novo como antes.`,
    },
    unreadableEdit: {
      message: name =>
        `Depois dessa mudança, o compilador não consegue ler o texto Haskell de ${name}. O programa está de novo como antes.`,
    },
    unfinishedText: {
      message: name =>
        `Ainda não está completo no texto Haskell: ${name}. Esta mudança nos blocos não foi feita.`,
      hint: "Termine a linha no texto ou aperte Desfazer e depois mude os blocos. Os blocos que o texto já diz podem ser mudados.",
    },
    progressNotSaved: {
      message: "Este navegador não tem espaço para guardar o que você já fez na lição.",
      hint: "Apague programas em Meus programas e depois faça o próximo passo. Seu programa não é afetado.",
    },
    notSaved: {
      message: "Este navegador não tem espaço para guardar o seu programa.",
      hint: "Apague programas em Meus programas, ou salve este como arquivo pelo menu no alto à direita.",
    },
    madeWay: {
      message: names =>
        `Este navegador está cheio, por isso o Rosy removeu de vez estes programas apagados: ${names}.`,
      hint: "Apague os programas de que você não precisa mais e salve como arquivos o que quiser guardar.",
    },
    robotGone: {
      message: name => `Você não está mais com ${name}.`,
      hint: "Pegue-o de novo quando precisar dele.",
    },
    outOfSight: {
      message: name => `${name} foi parado porque esta página não estava à vista.`,
      hint: "Deixe a página à vista enquanto um robô de verdade anda.",
    },
    damagedLink: {
      message: "Este link está danificado.",
      hint: "Copie o link inteiro e abra de novo.",
    },
    becameTwo: {
      message: name => `${name === "" ? "O seu programa" : name} foi mudado em duas abas ao mesmo tempo.`,
      hint: copy => `Agora são dois: este se chama ${copy}.`,
    },
    noStorage: {
      message: "Este navegador não guarda nada para esta página.",
      hint: "Salve o seu programa como arquivo antes de fechar a página.",
    },
  },
}
